/**
 * @class vtkSphericalLieAdvection
 * @brief Area-preserving, or measure-controlled, map of a topological sphere by Lie advection in a given number of
 * steps.
 *
 * As vtkLieAdvection, with solid angles as the areas of the image; start and rotation as vtkSphericalLieFlow. A
 * method of the literature: vtkSphericalAuthalicMap is exact. See zou2011 in docs/references.bib and
 * authalic::sphericalLieAdvection. Status is converged when every step was taken in full and nothing is folded.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData, the surface: closed, connected, oriented, manifold, genus 0 |
 * | input 1, optional | vtkPolyData, an initial map to the unit sphere: same vertices in the same order |
 * | output 0 | vtkPolyData, the map on the unit sphere: see vtkSurfaceMapAlgorithm |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | field | Residuals | 1 double each | | sqrt(sum m (r - 1)^2) over vertex stars before each step, and at the end |
 * | field | ShortenedSteps, FlippedBeforeUnfolding, EdgeFlips | 1 int | | |
 * | field | Coverage | 1 double | | Σ solid angles / 4π; 1 for a homeomorphism |
 * | field | FlatAreaDistortion | 1 double | | D_area of the flat triangles through the image's points |
 * | field | SphericalAngleError | 1 double | degrees | mean over corners of the spherical triangles |
 *
 * @sa vtkSphericalAuthalicMap
 */
#ifndef vtkSphericalLieAdvection_h
#define vtkSphericalLieAdvection_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkSphericalLieAdvection : public vtkSurfaceMapAlgorithm
{
public:
  static vtkSphericalLieAdvection* New();
  vtkTypeMacro(vtkSphericalLieAdvection, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Steps, 1 or more. Default: authalic::LieAdvectionOptions, as below. */
  vtkSetClampMacro(NumberOfSteps, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /** Whether faces of the input that are folded at the end are unfolded. */
  vtkSetMacro(Unfold, bool);
  vtkGetMacro(Unfold, bool);
  vtkBooleanMacro(Unfold, bool);
  ///@}

protected:
  vtkSphericalLieAdvection();
  ~vtkSphericalLieAdvection() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int NumberOfSteps;
  bool Unfold;

private:
  vtkSphericalLieAdvection(const vtkSphericalLieAdvection&) = delete;
  void operator=(const vtkSphericalLieAdvection&) = delete;
};

#endif
