/**
 * @class vtkCurvatureDensity
 * @brief A density for maps that gives places where the surface bends a larger share: part area, part |curvature|.
 *
 * The measure is (1 - Weight) A / sum A + Weight A |k| / sum A |k|, with the areas A of vertex stars and a
 * curvature k per vertex: an array, or the Gaussian curvature from the angle defects.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData: triangles, mm |
 * | output 0 | the input with the array below |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | point | CurvatureDensity | 1 double | | density relative to the native area, > 0, mean 1 |
 *
 * See su2019remeshing in docs/references.bib, authalic::curvatureDensity, and docs/methods/measure-control.md.
 *
 * @sa vtkRegionDensity
 */
#ifndef vtkCurvatureDensity_h
#define vtkCurvatureDensity_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceAlgorithm.h"

#include <string> // for CurvatureArrayName

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkCurvatureDensity : public vtkSurfaceAlgorithm
{
public:
  static vtkCurvatureDensity* New();
  vtkTypeMacro(vtkCurvatureDensity, vtkSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Point array with a curvature of any sign and unit. Empty = Gaussian curvature. Default empty. */
  vtkSetMacro(CurvatureArrayName, std::string);
  vtkGetMacro(CurvatureArrayName, std::string);
  ///@}

  ///@{
  /** Part of the curvature in the measure, 0 to below 1. Default 0.5. */
  vtkSetMacro(Weight, double);
  vtkGetMacro(Weight, double);
  ///@}

protected:
  vtkCurvatureDensity() = default;
  ~vtkCurvatureDensity() override = default;

  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  std::string CurvatureArrayName;
  double Weight = 0.5;

private:
  vtkCurvatureDensity(const vtkCurvatureDensity&) = delete;
  void operator=(const vtkCurvatureDensity&) = delete;
};

#endif
