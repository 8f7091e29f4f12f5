#include "vtkAreaSolveAlgorithm.h"

#include "Core/authalic/AuthalicMap.h"

vtkAreaSolveAlgorithm::vtkAreaSolveAlgorithm() {
  const authalic::AuthalicMapOptions defaults;
  this->Tolerance = defaults.tolerance;
  this->VertexTolerance = defaults.vertexTolerance;
  this->MaximumIterations = defaults.maxIterations;
}

authalic::AuthalicMapOptions vtkAreaSolveAlgorithm::Options() const {
  authalic::AuthalicMapOptions options;
  options.tolerance = this->Tolerance;
  options.vertexTolerance = this->VertexTolerance;
  options.maxIterations = this->MaximumIterations;
  options.validate();
  return options;
}

void vtkAreaSolveAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "VertexTolerance: " << this->VertexTolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
}
