/**
 * @class vtkMapDistortion
 * @brief How much a map to the plane or to a sphere changes areas and angles, per face, per vertex and as a whole.
 *
 * With both total areas normalised to 1, r = image share / target share of a face and σ1, σ2 the singular values of
 * its Jacobian: see authalic::DistortionSummary for every definition. Measured on the connectivity of the input.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the map: triangles in the plane z = 0, or with corners on a sphere of any radius around 0 |
 * | input 1, optional | vtkPolyData, the surface (mm), same triangles in the same order; without it the map's point array `OriginalPoints` is the surface |
 * | output 0 | the map with everything it had and the arrays below |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | cell | AreaDistortion | 1 double | log2 | log2 of r; 0 = area preserved; NaN where the target share is 0 |
 * | cell | AngleDistortion | 1 double | | σ1/σ2 + σ2/σ1; 2 = angles preserved |
 * | cell | Flipped | 1 unsigned char | | 1 where the face is folded or has no area |
 * | cell | BeltramiCoefficient | 2 double | | real and imaginary part, z along the first edge of the face |
 * | cell | SigmaMax, SigmaMin, with Details | 1 double | | singular values; SigmaMin < 0 where folded |
 * | point | VertexAreaDistortion | 1 double | log2 | of one-third stars |
 * | point | OriginalPoints | 3 double | mm | the surface |
 * | field | TotalAreaDistortion … | 1 | | one number per metric of authalic::DistortionSummary, spreads and histograms: see vtkSurfaceMapAlgorithm |
 * | field | Coverage, FlatAreaDistortion, SphericalAngleError, on a sphere | 1 double | –, –, degrees | see vtkSphericalConformalMap |
 *
 * @sa vtkBarycentricMap vtkDiscreteLieFlow
 */
#ifndef vtkMapDistortion_h
#define vtkMapDistortion_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for MeasureArrayName and Report

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkMapDistortion : public vtkSurfaceAlgorithm
{
public:
  static vtkMapDistortion* New();
  vtkTypeMacro(vtkMapDistortion, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Cell array of target measures (any scale, at least 0); empty = the surface areas. Default empty. */
  vtkSetMacro(MeasureArrayName, std::string);
  vtkGetMacro(MeasureArrayName, std::string);
  ///@}

  ///@{
  /** Whether SigmaMax and SigmaMin are added. Default off. */
  vtkSetMacro(Details, bool);
  vtkGetMacro(Details, bool);
  vtkBooleanMacro(Details, bool);
  ///@}

  /** Every metric of the last execution as JSON, named as in reports of maps; empty before it and after an error. */
  vtkGetMacro(Report, std::string);

protected:
  vtkMapDistortion();
  ~vtkMapDistortion() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  std::string MeasureArrayName;
  std::string Report;
  bool Details = false;

private:
  vtkMapDistortion(const vtkMapDistortion&) = delete;
  void operator=(const vtkMapDistortion&) = delete;
};

#endif
