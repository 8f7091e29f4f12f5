/**
 * @class vtkDiscreteLieFlow
 * @brief Area-preserving, or measure-controlled, map of a topological disk by the discrete Lie flow.
 *
 * Flows an initial map until every vertex star has its target share of the domain: L h = A_image - A_target, move by
 * the gradient of h, keep the flowing mesh Delaunay; then, on the connectivity of the input, unfold folded faces and
 * match areas. Vertices on the boundary slide along it. The domain may be a polygon that is not convex; the output
 * has no folded face unless Finish is NONE, and a mesh with no such map is refused. When the tolerance is not
 * reached the best iterate is the output, with a warning and the status in words. See su2019 in docs/references.bib
 * and authalic::discreteLieFlow. Ports and arrays: vtkDiskMapAlgorithm, and
 *
 * | port | what |
 * |---|---|
 * | input 1, optional | vtkPolyData: an initial map to the same domain, vertices in the order of input 0 |
 *
 * | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|
 * | field | Residuals | 1 double each | | sqrt(sum m (r - 1)^2) over vertex stars before each step, and at the end |
 * | field | FinishIterations, FlippedBeforeFinish, EdgeFlips | 1 int | | |
 *
 * @sa vtkSphericalLieFlow vtkCircleDomainLieFlow vtkBarycentricMap vtkElementGrid vtkMapDistortion
 */
#ifndef vtkDiscreteLieFlow_h
#define vtkDiscreteLieFlow_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkDiskMapAlgorithm.h"

namespace authalic
{
struct DiscreteLieFlowOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkDiscreteLieFlow : public vtkDiskMapAlgorithm
{
public:
  static vtkDiscreteLieFlow* New();
  vtkTypeMacro(vtkDiscreteLieFlow, vtkDiskMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InitialMethodType
  {
    TUTTE = 0,
    HARMONIC = 1,
    MEAN_VALUE = 2
  };
  enum FinishType
  {
    NONE_AFTER_FLOW = 0,
    UNFOLD = 1,
    MATCH = 2
  };

  ///@{
  /** The initial map when input port 1 is empty. Default TUTTE: its faces are the farthest from degenerate. */
  vtkSetClampMacro(InitialMethod, int, TUTTE, MEAN_VALUE);
  vtkGetMacro(InitialMethod, int);
  void SetInitialMethodToTutte() { this->SetInitialMethod(TUTTE); }
  void SetInitialMethodToHarmonic() { this->SetInitialMethod(HARMONIC); }
  void SetInitialMethodToMeanValue() { this->SetInitialMethod(MEAN_VALUE); }
  ///@}

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
  /** Whether to flow from the initial map however far off it is: nearer to optimal transport, and slower. */
  vtkSetMacro(KeepInitial, bool);
  vtkGetMacro(KeepInitial, bool);
  vtkBooleanMacro(KeepInitial, bool);
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
  vtkDiscreteLieFlow();
  ~vtkDiscreteLieFlow() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Compute(vtkInformationVector**, vtkInformationVector*, const authalic::Execution&) override;

  int InitialMethod = TUTTE;
  double Tolerance;
  int MaximumIterations;
  double FlowTolerance;
  double StepRatio;
  double FixedStep;
  bool KeepInitial;
  int Finish;
  int MaximumFinishIterations;

private:
  authalic::DiscreteLieFlowOptions Options() const;
  authalic::Json DescribeAllOptions(bool initialMapGiven) const;

  vtkDiscreteLieFlow(const vtkDiscreteLieFlow&) = delete;
  void operator=(const vtkDiscreteLieFlow&) = delete;
};

#endif
