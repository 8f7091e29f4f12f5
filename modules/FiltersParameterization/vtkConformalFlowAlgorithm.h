/**
 * @class vtkConformalFlowAlgorithm
 * @brief What the conformal maps by curvature flow share: the metric, the tolerance, and what is done about folds.
 *
 * Ports and arrays: see vtkSurfaceMapAlgorithm, and
 *
 * | association | name | components, type | meaning |
 * |---|---|---|---|
 * | field | Residuals | 1 double each | max of the absolute K - target K before each Newton step, and at the end (radians) |
 * | field | Holonomy | 1 double | how far the flat metric is from closing when it is laid out |
 * | field | EdgeFlips | 1 int | of the intrinsic triangulation |
 * | field | FlippedBeforeUnfolding | 1 int | faces that the conformal map itself folds |
 */
#ifndef vtkConformalFlowAlgorithm_h
#define vtkConformalFlowAlgorithm_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

namespace authalic
{
class Json;
struct YamabeFlowOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkConformalFlowAlgorithm : public vtkSurfaceMapAlgorithm
{
public:
  vtkTypeMacro(vtkConformalFlowAlgorithm, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MetricType
  {
    VERTEX_SCALING = 0,
    CIRCLE_PACKING = 1
  };
  enum PackingRadiiType
  {
    TANGENT = 0,
    CIRCUMRADIUS = 1
  };

  ///@{
  /**
   * How lengths follow the scale factors: discrete Yamabe flow (a solution exists and is found), or inversive-distance
   * circle packing (Ricci flow; it need not exist). Default VERTEX_SCALING.
   */
  vtkSetClampMacro(Metric, int, VERTEX_SCALING, CIRCLE_PACKING);
  vtkGetMacro(Metric, int);
  void SetMetricToVertexScaling() { this->SetMetric(VERTEX_SCALING); }
  void SetMetricToCirclePacking() { this->SetMetric(CIRCLE_PACKING); }
  ///@}

  ///@{
  /** First radii of a circle packing. Default TANGENT: circles of neighbours never overlap. */
  vtkSetClampMacro(PackingRadii, int, TANGENT, CIRCUMRADIUS);
  vtkGetMacro(PackingRadii, int);
  void SetPackingRadiiToTangent() { this->SetPackingRadii(TANGENT); }
  void SetPackingRadiiToCircumradius() { this->SetPackingRadii(CIRCUMRADIUS); }
  ///@}

  ///@{
  /** Of max |K - target K| in radians, > 0. Default: authalic::YamabeFlowOptions, as below. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Most Newton steps, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /** Whether small patches around folded faces are embedded again. Default on. */
  vtkSetMacro(Unfold, bool);
  vtkGetMacro(Unfold, bool);
  vtkBooleanMacro(Unfold, bool);
  ///@}

protected:
  vtkConformalFlowAlgorithm();
  ~vtkConformalFlowAlgorithm() override = default;

  authalic::YamabeFlowOptions FlowOptions() const;

  /** Measure and flow as the options of a report. */
  authalic::Json DescribeFlow(const char* domain) const;

  int Metric = VERTEX_SCALING;
  int PackingRadii = TANGENT;
  double Tolerance;
  int MaximumIterations;
  bool Unfold = true;

private:
  vtkConformalFlowAlgorithm(const vtkConformalFlowAlgorithm&) = delete;
  void operator=(const vtkConformalFlowAlgorithm&) = delete;
};

#endif
