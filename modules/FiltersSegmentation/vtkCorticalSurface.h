/**
 * @class vtkCorticalSurface
 * @brief From a T1 volume to one closed genus-0 white surface per hemisphere.
 *
 * Topology is right by construction (growing by simple points); smoothing keeps the enclosed volume. Labels, on any
 * grid, say what is hindbrain and what to fill; without them geometry decides and the T1 must be skull-stripped.
 * See authalic::extractCorticalSurfaces for the method and its references.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkImageData: T1, scanner RAS mm in origin, spacing and direction matrix; NaN = outside |
 * | input 1, optional | vtkImageData: region labels (see LabelConvention), scanner RAS mm |
 * | output 0, 1 | vtkPolyData: left and right white surface, mm, faces counter-clockwise seen from outside |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | MedialWall | 1 unsigned char | | 1 = comes from the midline cut or a filled structure |
 * | field | AnatomicalStructurePrimary | 1 string | | CortexLeft, CortexRight |
 * | field | CoordinateSpace | 1 string | | scanner-ras |
 * | field | SurfaceArea, EnclosedVolume, BrainVolume | 1 double | mm², mm³, mm³ | |
 * | field | MedialWallShare | 1 double | | of the area |
 * | field | GreyWhiteThreshold, GreyMean, WhiteMean | 1 double | of the T1 | as used |
 * | field | EulerCharacteristic, ExtractedFaces, PrunedSpikes, CutVoxels, SealedVoxels | 1 int | | |
 *
 * Doubts about the result (an implausible area, say) are warnings in words.
 *
 * @sa vtkCutToDisk vtkVolumeFileReader
 */
#ifndef vtkCorticalSurface_h
#define vtkCorticalSurface_h

#include "vtkAuthalicFiltersSegmentationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

namespace authalic
{
struct CorticalSurfaceOptions;
}

class VTKAUTHALICFILTERSSEGMENTATION_EXPORT vtkCorticalSurface : public vtkSurfaceAlgorithm
{
public:
  static vtkCorticalSurface* New();
  vtkTypeMacro(vtkCorticalSurface, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum LabelConventionType
  {
    AAL = 0,
    FREESURFER = 1
  };

  ///@{
  /** What the numbers of the labels mean: AAL, or FreeSurfer's aseg and aparc+aseg. Default AAL. */
  vtkSetClampMacro(LabelConvention, int, AAL, FREESURFER);
  vtkGetMacro(LabelConvention, int);
  void SetLabelConventionToAAL() { this->SetLabelConvention(AAL); }
  void SetLabelConventionToFreeSurfer() { this->SetLabelConvention(FREESURFER); }
  ///@}

  ///@{
  /** Grey-white threshold in units of the T1; 0 = from the histogram. Default: authalic::CorticalSurfaceOptions, as for
   * everything below. */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /** Width of the window of the local threshold, mm; 0 = one threshold everywhere. */
  vtkSetMacro(BiasScale, double);
  vtkGetMacro(BiasScale, double);
  ///@}

  ///@{
  /** Half width of the band in which the midline is decided by connection, mm. */
  vtkSetMacro(MidlineBand, double);
  vtkGetMacro(MidlineBand, double);
  ///@}

  ///@{
  /** Tunnels through white matter up to about twice this many voxels wide are sealed, 0 to 5. */
  vtkSetMacro(Sealing, double);
  vtkGetMacro(Sealing, double);
  ///@}

  ///@{
  /** Pairs of smoothing steps, 0 to 1000. */
  vtkSetMacro(SmoothingIterations, int);
  vtkGetMacro(SmoothingIterations, int);
  ///@}

  ///@{
  /** Spatial frequencies below this pass the smoothing, between 0 and 2. */
  vtkSetMacro(PassBand, double);
  vtkGetMacro(PassBand, double);
  ///@}

  ///@{
  /** Triangles per hemisphere after decimation; 0 = no decimation. */
  vtkSetMacro(TargetFaces, int);
  vtkGetMacro(TargetFaces, int);
  ///@}

  ///@{
  /** Distance from a cut or filled voxel at which a vertex belongs to the medial wall, mm. */
  vtkSetMacro(MedialWallReach, double);
  vtkGetMacro(MedialWallReach, double);
  ///@}

protected:
  vtkCorticalSurface();
  ~vtkCorticalSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int LabelConvention = AAL;
  double Threshold;
  double BiasScale;
  double MidlineBand;
  double Sealing;
  int SmoothingIterations;
  double PassBand;
  int TargetFaces;
  double MedialWallReach;

private:
  authalic::CorticalSurfaceOptions Options() const;

  vtkCorticalSurface(const vtkCorticalSurface&) = delete;
  void operator=(const vtkCorticalSurface&) = delete;
};

#endif
