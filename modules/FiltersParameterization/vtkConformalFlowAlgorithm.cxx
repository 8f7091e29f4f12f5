#include "vtkConformalFlowAlgorithm.h"

#include "Core/conformal/YamabeFlow.h"
#include "Reports/Json.h"

static_assert(static_cast<int>(authalic::ConformalMetric::CirclePacking) == vtkConformalFlowAlgorithm::CIRCLE_PACKING);
static_assert(static_cast<int>(authalic::PackingRadii::Circumradius) == vtkConformalFlowAlgorithm::CIRCUMRADIUS);

vtkConformalFlowAlgorithm::vtkConformalFlowAlgorithm() {
  const authalic::YamabeFlowOptions defaults;
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
}

authalic::YamabeFlowOptions vtkConformalFlowAlgorithm::FlowOptions() const {
  authalic::YamabeFlowOptions options;
  options.metric = static_cast<authalic::ConformalMetric>(this->Metric);
  options.radii = static_cast<authalic::PackingRadii>(this->PackingRadii);
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  return options;
}

authalic::Json vtkConformalFlowAlgorithm::DescribeFlow(const char* domain) const {
  authalic::Json options = authalic::Json::object();
  options.set("domain", domain).set("measure", this->MeasureArrayName);
  options.set("metric", authalic::conformalMetricName(static_cast<authalic::ConformalMetric>(this->Metric)));
  if (this->Metric == CIRCLE_PACKING) {
    options.set("packing_radii", this->PackingRadii == TANGENT ? "tangent" : "circumradius");
  }
  return options.set("tolerance", this->Tolerance)
      .set("max_iterations", this->MaximumIterations)
      .set("unfold", this->Unfold);
}

void vtkConformalFlowAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Metric: " << this->Metric << "\n";
  os << indent << "PackingRadii: " << this->PackingRadii << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Unfold: " << (this->Unfold ? "On" : "Off") << "\n";
}
