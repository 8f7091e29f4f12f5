#include "vtkSurfaceAlgorithm.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include "FilterGuard.h"

int vtkSurfaceAlgorithm::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  return authalic::runGuarded(this, outputs, this->Threads, this->ErrorKind, [&](const authalic::Execution& execution) {
    this->Compute(inputs, outputs, execution);
  });
}

int vtkSurfaceAlgorithm::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port) {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i) {
      vtkInformation* input = inputs[port]->GetInformationObject(i);
      if (!input->Has(Pipeline::WHOLE_EXTENT())) continue;
      int extent[6];
      input->Get(Pipeline::WHOLE_EXTENT(), extent);
      input->Set(Pipeline::UPDATE_EXTENT(), extent, 6);
    }
  }
  return 1;
}

void vtkSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Threads: " << this->Threads << "\n";
  os << indent << "ErrorKind: " << this->ErrorKind << "\n";
}
