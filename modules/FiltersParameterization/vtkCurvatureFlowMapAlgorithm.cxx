#include "vtkCurvatureFlowMapAlgorithm.h"

#include "Core/conformal/YamabeMap.h"
#include "Reports/Json.h"

static_assert(static_cast<int>(authalic::ConformalMetric::CirclePacking) ==
              vtkCurvatureFlowMapAlgorithm::CIRCLE_PACKING);
static_assert(static_cast<int>(authalic::PackingRadii::Circumradius) == vtkCurvatureFlowMapAlgorithm::CIRCUMRADIUS);

vtkCurvatureFlowMapAlgorithm::vtkCurvatureFlowMapAlgorithm() {
  this->SetNumberOfOutputPorts(2);
  const authalic::YamabeMapOptions defaults;
  this->Metric = static_cast<int>(defaults.flow.metric);
  this->Radii = static_cast<int>(defaults.flow.radii);
  this->Tolerance = defaults.flow.tolerance;
  this->MaximumIterations = defaults.flow.maxIterations;
  this->StartVertex = defaults.startVertex;
  this->Refine = defaults.refine;
  this->Unfold = defaults.unfold;
}

authalic::YamabeFlowOptions vtkCurvatureFlowMapAlgorithm::FlowOptions() const {
  authalic::YamabeFlowOptions options;
  options.metric = static_cast<authalic::ConformalMetric>(this->Metric);
  options.radii = static_cast<authalic::PackingRadii>(this->Radii);
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  options.validate();
  return options;
}

authalic::Json vtkCurvatureFlowMapAlgorithm::DescribeOptions() const {
  const authalic::YamabeFlowOptions flow = this->FlowOptions();
  authalic::Json options = authalic::Json::object();
  options.set("metric", authalic::conformalMetricName(flow.metric));
  if (flow.metric == authalic::ConformalMetric::CirclePacking) {
    options.set("radii", authalic::packingRadiiName(flow.radii));
  }
  options.set("tolerance", flow.tolerance);
  options.set("max_iterations", flow.maxIterations);
  options.set("start_vertex", this->StartVertex);
  options.set("refine", this->Refine);
  options.set("unfold", this->Unfold);
  options.set("measure", this->MeasureArrayName);
  return options;
}

void vtkCurvatureFlowMapAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Metric: " << this->Metric << "\n";
  os << indent << "Radii: " << this->Radii << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "StartVertex: " << this->StartVertex << "\n";
  os << indent << "Refine: " << this->Refine << "\n";
  os << indent << "Unfold: " << this->Unfold << "\n";
}
