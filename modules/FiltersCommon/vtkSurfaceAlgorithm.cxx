#include "vtkSurfaceAlgorithm.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>

#include "WholeInputs.h"

int vtkSurfaceAlgorithm::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  return authalic::runOnWholeInputs(this, inputs, outputs, this->Threads, this->ErrorKind,
                                    [&](vtkInformationVector** whole, const authalic::Execution& execution) {
                                      this->Compute(whole, outputs, execution);
                                    });
}

int vtkSurfaceAlgorithm::RequestInformation(vtkInformation* request, vtkInformationVector** inputs,
                                            vtkInformationVector* outputs) {
  authalic::announcePieces(outputs);
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

int vtkSurfaceAlgorithm::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  authalic::requestWholeInputs(this, inputs);
  return 1;
}

void vtkSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Threads: " << this->Threads << "\n";
  os << indent << "ErrorKind: " << this->ErrorKind << "\n";
}
