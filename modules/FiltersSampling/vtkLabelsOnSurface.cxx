#include "vtkLabelsOnSurface.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/imaging/SurfaceLabels.h"
#include "FieldArrays.h"

vtkStandardNewMacro(vtkLabelsOnSurface);

vtkLabelsOnSurface::vtkLabelsOnSurface() { this->SetNumberOfInputPorts(2); }

int vtkLabelsOnSurface::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 1 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

void vtkLabelsOnSurface::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                 const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (this->ArrayName.empty()) throw authalic::InvalidArgument("ArrayName must name the array to make; it is empty.");
  const authalic::TriangleMesh surface = authalic::surfaceOf(input);
  const authalic::LabelVolume labels = authalic::toLabelVolume(vtkImageData::GetData(inputs[1]));
  const std::vector<int> found = authalic::labelsOnSurface(surface, labels, this->MaximumDistance, execution);
  output->ShallowCopy(input);
  authalic::addArray(output->GetPointData(), this->ArrayName.c_str(), found);
}

void vtkLabelsOnSurface::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumDistance: " << this->MaximumDistance << " mm\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
}
