/**
 * @class vtkLieFlowAlgorithm
 * @brief What the Lie flows of closed surfaces and of surfaces with holes share: tolerances, limits and the finish.
 *
 * See authalic::DiscreteLieFlowOptions. With a Finish other than NONE_AFTER_FLOW no face of the output is folded. Ports
 * and arrays: see vtkSurfaceMapAlgorithm, and
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | field | Residuals | 1 double each | | sqrt(sum m (r - 1)^2) over vertex stars before each step, and at the end |
 * | field | FinishIterations, FlippedBeforeFinish, EdgeFlips | 1 int | | |
 */
#ifndef vtkLieFlowAlgorithm_h
#define vtkLieFlowAlgorithm_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

namespace authalic
{
struct DiscreteLieFlowOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkLieFlowAlgorithm : public vtkSurfaceMapAlgorithm
{
public:
  vtkTypeMacro(vtkLieFlowAlgorithm, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FinishType
  {
    NONE_AFTER_FLOW = 0,
    UNFOLD = 1,
    MATCH = 2
  };

  ///@{
  /** Residual at which the map counts as area-preserving, > 0. Default: authalic::DiscreteLieFlowOptions, as below. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Most steps of the flow, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /** Residual of the flowing mesh at which the finish takes over, > 0. */
  vtkSetMacro(FlowTolerance, double);
  vtkGetMacro(FlowTolerance, double);
  ///@}

  ///@{
  /** Step as a part of the first flip of a triangle, between 0 and 1. */
  vtkSetMacro(StepRatio, double);
  vtkGetMacro(StepRatio, double);
  ///@}

  ///@{
  /** Above 0: this step instead of the adaptive one; may collapse the mesh. */
  vtkSetMacro(FixedStep, double);
  vtkGetMacro(FixedStep, double);
  ///@}

  ///@{
  /** What follows the flow on the connectivity of the input: nothing, unfolding, or unfolding and matching of areas. */
  vtkSetClampMacro(Finish, int, NONE_AFTER_FLOW, MATCH);
  vtkGetMacro(Finish, int);
  void SetFinishToNone() { this->SetFinish(NONE_AFTER_FLOW); }
  void SetFinishToUnfold() { this->SetFinish(UNFOLD); }
  void SetFinishToMatch() { this->SetFinish(MATCH); }
  ///@}

  ///@{
  /** Most steps of the finish, 0 or more. */
  vtkSetClampMacro(MaximumFinishIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumFinishIterations, int);
  ///@}

protected:
  vtkLieFlowAlgorithm();
  ~vtkLieFlowAlgorithm() override = default;

  /** The properties as options. @throws InvalidArgument */
  authalic::DiscreteLieFlowOptions Options() const;

  double Tolerance;
  int MaximumIterations;
  double FlowTolerance;
  double StepRatio;
  double FixedStep;
  int Finish;
  int MaximumFinishIterations;

private:
  vtkLieFlowAlgorithm(const vtkLieFlowAlgorithm&) = delete;
  void operator=(const vtkLieFlowAlgorithm&) = delete;
};

#endif
