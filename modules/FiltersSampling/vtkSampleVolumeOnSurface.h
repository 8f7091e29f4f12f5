/**
 * @class vtkSampleVolumeOnSurface
 * @brief Reads a volume at, below, or between surfaces: one number per vertex.
 *
 * Surface and volume must both be in scanner RAS mm. A sample outside the field of view, or on a voxel without data
 * (NaN), is left out and lowers the coverage; a vertex without any valid sample is NaN (n/a), never 0.
 * A map (the output of a map filter) may be given as the surface: then its `OriginalPoints` are sampled, and the output
 * is the map with the sampled array.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData: triangles, mm; or a map with the point array `OriginalPoints` |
 * | input 1 | vtkImageData, with origin, spacing and direction matrix in scanner RAS mm |
 * | input 2, mode BETWEEN_SURFACES | vtkPolyData: the other surface, same vertices in the same order, mm |
 * | output 0 | input 0 with the arrays below |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | the value of ArrayName | 1 double | of the volume | the samples of the vertex, reduced; NaN = n/a |
 * | point | the value of ArrayName + "Coverage" | 1 double | | valid samples / all samples, 0 to 1 |
 * | field | VerticesWithoutValue | 1 int | | |
 *
 * Along the normal x - d N, d from 0 to 10 mm, the mean: zou2011 in docs/references.bib.
 */
#ifndef vtkSampleVolumeOnSurface_h
#define vtkSampleVolumeOnSurface_h

#include "vtkAuthalicFiltersSamplingModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for ArrayName

namespace authalic
{
struct VolumeSamplingOptions;
}

class VTKAUTHALICFILTERSSAMPLING_EXPORT vtkSampleVolumeOnSurface : public vtkSurfaceAlgorithm
{
public:
  static vtkSampleVolumeOnSurface* New();
  vtkTypeMacro(vtkSampleVolumeOnSurface, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModeType
  {
    AT_VERTEX = 0,
    ALONG_NORMAL = 1,
    BETWEEN_SURFACES = 2
  };
  enum ReducerType
  {
    MEAN = 0,
    MEDIAN = 1,
    MAXIMUM = 2,
    MINIMUM = 3,
    MODE = 4
  };
  enum InterpolationType
  {
    TRILINEAR = 0,
    NEAREST = 1
  };

  ///@{
  /** Where the samples of a vertex lie. Default: authalic::VolumeSamplingOptions, as for everything below. */
  vtkSetClampMacro(Mode, int, AT_VERTEX, BETWEEN_SURFACES);
  vtkGetMacro(Mode, int);
  void SetModeToAtVertex() { this->SetMode(AT_VERTEX); }
  void SetModeToAlongNormal() { this->SetMode(ALONG_NORMAL); }
  void SetModeToBetweenSurfaces() { this->SetMode(BETWEEN_SURFACES); }
  ///@}

  ///@{
  /** How the samples of a vertex become one number; MODE (the most frequent) is for labels. */
  vtkSetClampMacro(Reducer, int, MEAN, MODE);
  vtkGetMacro(Reducer, int);
  void SetReducerToMean() { this->SetReducer(MEAN); }
  void SetReducerToMedian() { this->SetReducer(MEDIAN); }
  void SetReducerToMaximum() { this->SetReducer(MAXIMUM); }
  void SetReducerToMinimum() { this->SetReducer(MINIMUM); }
  void SetReducerToMode() { this->SetReducer(MODE); }
  ///@}

  ///@{
  /** Between voxels: trilinear, or the nearest voxel (labels). */
  vtkSetClampMacro(Interpolation, int, TRILINEAR, NEAREST);
  vtkGetMacro(Interpolation, int);
  void SetInterpolationToTrilinear() { this->SetInterpolation(TRILINEAR); }
  void SetInterpolationToNearest() { this->SetInterpolation(NEAREST); }
  ///@}

  ///@{
  /** Depths along the inward normal, mm: from, from + step … to (mode ALONG_NORMAL). Step > 0. */
  vtkSetMacro(DepthFrom, double);
  vtkGetMacro(DepthFrom, double);
  vtkSetMacro(DepthTo, double);
  vtkGetMacro(DepthTo, double);
  vtkSetMacro(DepthStep, double);
  vtkGetMacro(DepthStep, double);
  ///@}

  ///@{
  /** Fractions of the way to the other surface (mode BETWEEN_SURFACES): 0 = the surface, 1 = the other. Step > 0. */
  vtkSetMacro(FractionFrom, double);
  vtkGetMacro(FractionFrom, double);
  vtkSetMacro(FractionTo, double);
  vtkGetMacro(FractionTo, double);
  vtkSetMacro(FractionStep, double);
  vtkGetMacro(FractionStep, double);
  ///@}

  ///@{
  /** Whether a sample of exactly 0 is background and counts as n/a (label volumes). */
  vtkSetMacro(SkipZero, bool);
  vtkGetMacro(SkipZero, bool);
  vtkBooleanMacro(SkipZero, bool);
  ///@}

  ///@{
  /** Name of the point array that is made. Default "Sample". */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

protected:
  vtkSampleVolumeOnSurface();
  ~vtkSampleVolumeOnSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int Mode;
  int Reducer;
  int Interpolation;
  double DepthFrom, DepthTo, DepthStep;
  double FractionFrom, FractionTo, FractionStep;
  bool SkipZero;
  std::string ArrayName = "Sample";

private:
  authalic::VolumeSamplingOptions Options() const;

  vtkSampleVolumeOnSurface(const vtkSampleVolumeOnSurface&) = delete;
  void operator=(const vtkSampleVolumeOnSurface&) = delete;
};

#endif
