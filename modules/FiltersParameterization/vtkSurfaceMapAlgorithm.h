/**
 * @class vtkSurfaceMapAlgorithm
 * @brief What every map of a surface shares: the measure, the report, the arrays of the output, and its two forms.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData: triangles, mm; the topology that the method asks for |
 * | output 0 | vtkPolyData, the map: triangles and vertices in the order of the input, every array of the input, and the arrays below |
 *
 * As MAP the points of the output are the image (double precision; z = 0 in the plane). As TEXTURE_COORDINATES they
 * stay the surface, and the image is the active array of texture coordinates, moved and scaled (by one factor) into
 * [0, 1]² or [0, 1]³, so that a texture is neither stretched nor repeated.
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | OriginalPoints (as MAP) | 3 double | mm | the surface |
 * | point | TCoords (as TEXTURE_COORDINATES) | 2 float, 3 on the sphere | | the image in [0, 1] |
 * | point | VertexAreaDistortion | 1 double | log2 | log2 of image share / target share of one-third stars |
 * | cell | AreaDistortion | 1 double | log2 | log2 of image share / target share |
 * | cell | AngleDistortion | 1 double | | σ1/σ2 + σ2/σ1; 2 = angles preserved |
 * | cell | BeltramiCoefficient | 2 double | | real and imaginary part of μ = f_z̄/f_z, z along the first edge of the face; modulus 0 = angles preserved, above 1 = folded |
 * | cell | Flipped | 1 unsigned char | | 1 where the face is folded or has no area in the image |
 * | field | Method | 1 string | | name of the method, as on the command line |
 * | field | Status | 1 string | | converged, not-converged, stalled, cancelled |
 * | field | Iterations | 1 int | | |
 * | field | Residuals | 1 double each | | history of what the method drives to 0 |
 * | field | TotalAreaDistortion … | 1 | | one number per metric of authalic::DistortionSummary |
 * | field | AngleErrorStandardDeviation, QuasiConformal…, Beltrami… | 1 double | degrees, –, – | over corners, faces, faces |
 * | field | AngleErrorPercentiles, QuasiConformal…, Beltrami… | 1 double, 7 tuples | degrees, –, – | 5, 25, 50, 75, 95, 99 %, maximum |
 * | field | VertexAreaHistogram, FaceAreaHistogram, AngleRatioHistogram, AngleErrorHistogram, BeltramiHistogram | 3 double, a tuple per bin | | lower edge, upper edge, count: see authalic::DistortionHistograms; then the values below, above, undefined |
 *
 * Where the input has regions of interest (vtkRegionDensity), the fields RegionSourceShares, RegionTargetShares and
 * RegionImageShares (1 double each) hold their shares of the surface, the measure and the image, and the report has
 * `regions`.
 */
#ifndef vtkSurfaceMapAlgorithm_h
#define vtkSurfaceMapAlgorithm_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for MeasureArrayName

namespace authalic
{
struct MapReport;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSurfaceMapAlgorithm : public vtkSurfaceAlgorithm
{
public:
  vtkTypeMacro(vtkSurfaceMapAlgorithm, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OutputModeType
  {
    MAP = 0,
    TEXTURE_COORDINATES = 1
  };

  ///@{
  /**
   * Whether the points of the output are the image, or the surface with the image as texture coordinates. Default MAP.
   */
  vtkSetClampMacro(OutputMode, int, MAP, TEXTURE_COORDINATES);
  vtkGetMacro(OutputMode, int);
  void SetOutputModeToMap() { this->SetOutputMode(MAP); }
  void SetOutputModeToTextureCoordinates() { this->SetOutputMode(TEXTURE_COORDINATES); }
  ///@}

  ///@{
  /**
   * Target measure: a density relative to the native area, one number per point or per cell, above 0; a region
   * with 4 gets four times the share that its area has. Methods that do not control areas are measured against it. The
   * point array of that name is taken before the cell array. Empty = 1 everywhere. Default empty.
   */
  vtkSetMacro(MeasureArrayName, std::string);
  vtkGetMacro(MeasureArrayName, std::string);
  ///@}

  ///@{
  /**
   * What the last execution left in field data: how the method ended (converged, not-converged, stalled, cancelled),
   * iterations, D_area and D_angle (2 = preserved), and folded faces. Empty or 0 before it and after an error.
   */
  std::string GetStatus();
  int GetIterations();
  double GetTotalAreaDistortion();
  double GetTotalAngleDistortion();
  int GetFlippedFaces();
  ///@}

  /**
   * What the last execution did, as JSON: status, iterations, residual history, seconds per stage, metrics, flips,
   * histograms of both distortions, topology, options, version. Empty before it and after an error.
   */
  vtkGetMacro(Report, std::string);

protected:
  vtkSurfaceMapAlgorithm() = default;
  ~vtkSurfaceMapAlgorithm() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /** Arrays from `report` (method, status, residuals), Report and ErrorKind; the image is on `map` already. */
  void Publish(vtkPolyData* map, const authalic::MapReport& report);

  int OutputMode = MAP;
  std::string MeasureArrayName;
  std::string Report;

private:
  vtkSurfaceMapAlgorithm(const vtkSurfaceMapAlgorithm&) = delete;
  void operator=(const vtkSurfaceMapAlgorithm&) = delete;
};

#endif
