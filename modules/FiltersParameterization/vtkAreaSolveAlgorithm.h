/**
 * @class vtkAreaSolveAlgorithm
 * @brief What the exact authalic maps of closed surfaces and of surfaces with holes share: the limits of the solve.
 *
 * Ports and arrays: see vtkSurfaceMapAlgorithm, and
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | FaceResidual | 1 double | (Σ m (r + 1/r − 2))^½ over faces, r = image share / target share |
 * | field | VertexResidual | 1 double | max of the absolute logarithm of r over vertex stars |
 */
#ifndef vtkAreaSolveAlgorithm_h
#define vtkAreaSolveAlgorithm_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

namespace authalic
{
struct AuthalicMapOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkAreaSolveAlgorithm : public vtkSurfaceMapAlgorithm
{
public:
  vtkTypeMacro(vtkAreaSolveAlgorithm, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Of the face residual (Σ m (r + 1/r − 2))^½ = (D_area − 2)^½, > 0. Default: authalic::AuthalicMapOptions,
   * as below. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Of max |ln r| over vertex stars, > 0. */
  vtkSetMacro(VertexTolerance, double);
  vtkGetMacro(VertexTolerance, double);
  ///@}

  ///@{
  /** Most steps of both kinds, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

protected:
  vtkAreaSolveAlgorithm();
  ~vtkAreaSolveAlgorithm() override = default;

  /** The limits as options. @throws InvalidArgument */
  authalic::AuthalicMapOptions Options() const;

  double Tolerance;
  double VertexTolerance;
  int MaximumIterations;

private:
  vtkAreaSolveAlgorithm(const vtkAreaSolveAlgorithm&) = delete;
  void operator=(const vtkAreaSolveAlgorithm&) = delete;
};

#endif
