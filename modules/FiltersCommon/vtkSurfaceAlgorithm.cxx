#include "vtkSurfaceAlgorithm.h"

#include "FilterGuard.h"

int vtkSurfaceAlgorithm::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  return authalic::runGuarded(this, outputs, this->Threads, this->ErrorKind, [&](const authalic::Execution& execution) {
    this->Compute(inputs, outputs, execution);
  });
}

void vtkSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Threads: " << this->Threads << "\n";
  os << indent << "ErrorKind: " << this->ErrorKind << "\n";
}
