/**
 * @class vtkCurvatureFlowMapAlgorithm
 * @brief What the conformal maps by curvature flow share: the metric, the descent, and what becomes of folded faces.
 *
 * | port | what |
 * |---|---|
 * | input 0 | vtkPolyData: see vtkSurfaceMapAlgorithm |
 * | output 0 | vtkPolyData, the map: see vtkSurfaceMapAlgorithm |
 * | output 1 | vtkPolyData, with Refine: the common refinement of the surface and the flow's own triangulation, mapped without a fold; else empty |
 *
 * | output | association | name | components, type | unit | meaning |
 * |---|---|---|---|---|---|
 * | 0 | point | LogScale | 1 double | | u: a length l_ij becomes l_ij e^{(u_i + u_j)/2} where no edge was flipped; CIRCLE_PACKING: ln of the radii |
 * | 0 | field | CurvatureResidual | 1 double | radians | max of the absolute K − K̄ when the flow ended |
 * | 0 | field | Holonomy | 1 double | | largest mismatch of an edge in the layout, over the longest edge |
 * | 0 | field | EdgeFlips | 1 int | | flips of the intrinsic triangulation |
 * | 0 | field | FlippedBeforeUnfolding | 1 int | | faces of the input that the conformal map folds |
 * | 0 | field | Pockets | 1 int | | pieces at the boundary that were bulged out of it by unfolding |
 * | 0 | field | RefinementFlippedFaces | 1 int | | with Refine: folded faces of output 1 |
 * | 1 | points | | 3 double | | the image before unfolding; z = 0 |
 * | 1 | point | OriginalPoints | 3 double | mm | the surface |
 * | 1 | point | OriginalPointIds | 1 id | | vertex of the input; −1 where edges cross |
 * | 1 | cell | OriginalCellIds | 1 id | | face of the input that the face is part of |
 * | 1 | cell | AreaDistortion, AngleDistortion, Flipped … | | | as on a map, against surface areas |
 *
 * Both metrics and their references (luo2004, springborn2008, gu2018, su2016, gillespie2021):
 * docs/methods/yamabe-flow.md.
 */
#ifndef vtkCurvatureFlowMapAlgorithm_h
#define vtkCurvatureFlowMapAlgorithm_h

#include "vtkAuthalicFiltersParameterizationModule.h" // for export macro
#include "vtkSurfaceMapAlgorithm.h"

namespace authalic
{
class Json;
struct YamabeFlowOptions;
}

class VTKAUTHALICFILTERSPARAMETERIZATION_EXPORT vtkCurvatureFlowMapAlgorithm : public vtkSurfaceMapAlgorithm
{
public:
  vtkTypeMacro(vtkCurvatureFlowMapAlgorithm, vtkSurfaceMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MetricType
  {
    VERTEX_SCALING = 0,
    CIRCLE_PACKING = 1
  };
  enum RadiiType
  {
    TANGENT = 0,
    CIRCUMRADIUS = 1
  };

  ///@{
  /**
   * How lengths follow the factors: l e^{(u_i + u_j)/2} (Yamabe flow; every admissible curvature is reached), or
   * circles of radius e^u at constant inversive distance (Ricci flow; a solution need not exist). Default: that of
   * authalic::YamabeFlowOptions, as below.
   */
  vtkSetClampMacro(Metric, int, VERTEX_SCALING, CIRCLE_PACKING);
  vtkGetMacro(Metric, int);
  void SetMetricToVertexScaling() { this->SetMetric(VERTEX_SCALING); }
  void SetMetricToCirclePacking() { this->SetMetric(CIRCLE_PACKING); }
  ///@}

  ///@{
  /** First radii of a circle packing: circles of neighbours touch or keep apart, or circumradii.
   * CIRCLE_PACKING only. */
  vtkSetClampMacro(Radii, int, TANGENT, CIRCUMRADIUS);
  vtkGetMacro(Radii, int);
  void SetRadiiToTangent() { this->SetRadii(TANGENT); }
  void SetRadiiToCircumradius() { this->SetRadii(CIRCUMRADIUS); }
  ///@}

  ///@{
  /** Of max |K − K̄|, radians, > 0. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Most Newton steps, 0 or more. */
  vtkSetClampMacro(MaximumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /** Boundary vertex on the positive x axis; -1 = the one with the smallest id. Default -1. */
  vtkSetMacro(StartVertex, int);
  vtkGetMacro(StartVertex, int);
  ///@}

  ///@{
  /** Whether output 1 has the common refinement, on which nothing folds. Default off. */
  vtkSetMacro(Refine, bool);
  vtkGetMacro(Refine, bool);
  vtkBooleanMacro(Refine, bool);
  ///@}

  ///@{
  /** Whether small patches around folded faces are embedded anew; their boundary stays. Default on. */
  vtkSetMacro(Unfold, bool);
  vtkGetMacro(Unfold, bool);
  vtkBooleanMacro(Unfold, bool);
  ///@}

protected:
  vtkCurvatureFlowMapAlgorithm();
  ~vtkCurvatureFlowMapAlgorithm() override = default;

  /** Metric, radii, tolerance and steps. @throws InvalidArgument */
  authalic::YamabeFlowOptions FlowOptions() const;

  /** The options of this class and the measure, as those of a report. */
  authalic::Json DescribeOptions() const;

  int Metric;
  int Radii;
  double Tolerance;
  int MaximumIterations;
  int StartVertex;
  bool Refine;
  bool Unfold;

private:
  vtkCurvatureFlowMapAlgorithm(const vtkCurvatureFlowMapAlgorithm&) = delete;
  void operator=(const vtkCurvatureFlowMapAlgorithm&) = delete;
};

#endif
