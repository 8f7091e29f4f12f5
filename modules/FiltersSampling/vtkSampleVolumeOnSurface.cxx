#include "vtkSampleVolumeOnSurface.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/sampling/VolumeSampling.h"
#include "FieldArrays.h"

vtkStandardNewMacro(vtkSampleVolumeOnSurface);

static_assert(static_cast<int>(authalic::SamplingMode::BetweenSurfaces) == vtkSampleVolumeOnSurface::BETWEEN_SURFACES);
static_assert(static_cast<int>(authalic::SamplingReducer::Mode) == vtkSampleVolumeOnSurface::MODE);
static_assert(static_cast<int>(authalic::Interpolation::Nearest) == vtkSampleVolumeOnSurface::NEAREST);

vtkSampleVolumeOnSurface::vtkSampleVolumeOnSurface() {
  this->SetNumberOfInputPorts(3);
  const authalic::VolumeSamplingOptions defaults;
  this->Mode = static_cast<int>(defaults.mode);
  this->Reducer = static_cast<int>(defaults.reducer);
  this->Interpolation = static_cast<int>(defaults.interpolation);
  this->DepthFrom = defaults.depthFrom;
  this->DepthTo = defaults.depthTo;
  this->DepthStep = defaults.depthStep;
  this->FractionFrom = defaults.fractionFrom;
  this->FractionTo = defaults.fractionTo;
  this->FractionStep = defaults.fractionStep;
  this->SkipZero = defaults.skipZero;
}

int vtkSampleVolumeOnSurface::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 1 ? "vtkImageData" : "vtkPolyData");
  if (port == 2) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

authalic::VolumeSamplingOptions vtkSampleVolumeOnSurface::Options() const {
  authalic::VolumeSamplingOptions options;
  options.mode = static_cast<authalic::SamplingMode>(this->Mode);
  options.reducer = static_cast<authalic::SamplingReducer>(this->Reducer);
  options.interpolation = static_cast<authalic::Interpolation>(this->Interpolation);
  options.depthFrom = this->DepthFrom;
  options.depthTo = this->DepthTo;
  options.depthStep = this->DepthStep;
  options.fractionFrom = this->FractionFrom;
  options.fractionTo = this->FractionTo;
  options.fractionStep = this->FractionStep;
  options.skipZero = this->SkipZero;
  return options;
}

void vtkSampleVolumeOnSurface::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                       const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* other = vtkPolyData::GetData(inputs[2]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (this->ArrayName.empty()) throw authalic::InvalidArgument("ArrayName must name the array to make; it is empty.");
  if (this->Mode == BETWEEN_SURFACES && !other) {
    throw authalic::InvalidArgument(
        "Sampling between surfaces needs the other surface on input port 2; none is there.");
  }
  const authalic::TriangleMesh surface = authalic::surfaceOf(input);
  const authalic::ScalarVolume volume = authalic::toScalarVolume(vtkImageData::GetData(inputs[1]));
  const authalic::VolumeSamples samples =
      this->Mode == BETWEEN_SURFACES
          ? authalic::sampleVolumeBetween(surface, authalic::surfaceOf(other).points(), volume, this->Options(),
                                          execution)
          : authalic::sampleVolume(surface, volume, this->Options(), execution);
  output->ShallowCopy(input);
  authalic::addArray(output->GetPointData(), this->ArrayName.c_str(), samples.values);
  authalic::addArray(output->GetPointData(), (this->ArrayName + "Coverage").c_str(), samples.coverage);
  authalic::addField(output, "VerticesWithoutValue", samples.verticesWithoutValue);
}

void vtkSampleVolumeOnSurface::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "Reducer: " << this->Reducer << "\n";
  os << indent << "Interpolation: " << this->Interpolation << "\n";
  os << indent << "Depths: " << this->DepthFrom << " to " << this->DepthTo << " by " << this->DepthStep << " mm\n";
  os << indent << "Fractions: " << this->FractionFrom << " to " << this->FractionTo << " by " << this->FractionStep
     << "\n";
  os << indent << "SkipZero: " << (this->SkipZero ? "On" : "Off") << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
}
