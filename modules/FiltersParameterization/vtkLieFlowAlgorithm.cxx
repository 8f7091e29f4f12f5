#include "vtkLieFlowAlgorithm.h"

#include "Core/authalic/DiscreteLieFlow.h"

static_assert(static_cast<int>(authalic::LieFlowFinish::Match) == vtkLieFlowAlgorithm::MATCH);

vtkLieFlowAlgorithm::vtkLieFlowAlgorithm() {
  const authalic::DiscreteLieFlowOptions defaults;
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
  this->FlowTolerance = defaults.flowTolerance;
  this->StepRatio = defaults.stepRatio;
  this->FixedStep = defaults.fixedStep;
  this->Finish = static_cast<int>(defaults.finish);
  this->MaximumFinishIterations = defaults.maxFinishIterations;
}

authalic::DiscreteLieFlowOptions vtkLieFlowAlgorithm::Options() const {
  authalic::DiscreteLieFlowOptions options;
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  options.flowTolerance = this->FlowTolerance;
  options.stepRatio = this->StepRatio;
  options.fixedStep = this->FixedStep;
  options.finish = static_cast<authalic::LieFlowFinish>(this->Finish);
  options.maxFinishIterations = this->MaximumFinishIterations;
  options.validate();
  return options;
}

void vtkLieFlowAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "FlowTolerance: " << this->FlowTolerance << "\n";
  os << indent << "StepRatio: " << this->StepRatio << "\n";
  os << indent << "FixedStep: " << this->FixedStep << "\n";
  os << indent << "Finish: " << this->Finish << "\n";
  os << indent << "MaximumFinishIterations: " << this->MaximumFinishIterations << "\n";
}
