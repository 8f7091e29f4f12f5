#include "vtkVolumeFileReader.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>

#include "Core/base/Error.h"
#include "ErrorCode.h"
#include "FieldArrays.h"
#include "Formats/StoredVolume.h"
#include "SurfaceConversion.h"
#include "VolumeValues.h"

vtkStandardNewMacro(vtkVolumeFileReader);

vtkVolumeFileReader::vtkVolumeFileReader() {
  this->SetNumberOfInputPorts(0);
}

vtkVolumeFileReader::~vtkVolumeFileReader() {
  this->SetFileName(nullptr);
}

namespace {

/// Lattice of the volume, as the pipeline wants it told before any data are there.
void describe(const authalic::StoredVolume& file, int scalarType, vtkInformation* information) {
  const Eigen::Matrix4d& affine = file.voxelToWorld;
  const auto& d = file.dimensions;
  const int extent[6] = {0, d[0] - 1, 0, d[1] - 1, 0, d[2] - 1};
  double spacing[3], origin[3], direction[9];
  for (int axis = 0; axis < 3; ++axis) {
    spacing[axis] = affine.col(axis).head<3>().norm();
    origin[axis] = affine(axis, 3);
    for (int row = 0; row < 3; ++row) {
      direction[3 * row + axis] = affine(row, axis) / spacing[axis];
    }
  }
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  information->Set(vtkDataObject::SPACING(), spacing, 3);
  information->Set(vtkDataObject::ORIGIN(), origin, 3);
  information->Set(vtkDataObject::DIRECTION(), direction, 9);
  vtkDataObject::SetPointDataActiveScalarInfo(information, scalarType, file.framesHeld);
}

void addFields(const authalic::StoredVolume& file, vtkImageData* output) {
  authalic::addField(output, "CoordinateSpace", std::string(authalic::coordinateSpaceName(file.space)));
  authalic::addField(output, "CoordinateSpaceReason", file.spaceReason);
  authalic::addField(output, "Frames", file.frames);
  authalic::addField(output, "TransformCode", file.transformCode);
  authalic::addField(output, "StoredType", file.storedType);
  if (file.disagreement > 0) {
    authalic::addField(output, "TransformDisagreement", file.disagreement);
  }
  if (!file.notRead.empty()) {
    authalic::addField(output, "NotRead", file.notRead);
  }
  if (file.warnings.empty()) {
    return;
  }
  vtkNew<vtkStringArray> warnings;
  warnings->SetName("Warnings");
  for (const std::string& warning : file.warnings) {
    warnings->InsertNextValue(warning);
  }
  output->GetFieldData()->AddArray(warnings);
}

}  // namespace

void vtkVolumeFileReader::ReadFile() {
  if (!this->FileName || !*this->FileName) {
    throw authalic::InvalidArgument("A file to read is needed; call SetFileName.");
  }
  if (!this->File || this->ReadTime < this->GetMTime()) {
    this->File.reset();
    const authalic::VolumeRequest request{this->Frame, this->AllFrames, this->KeepNumbers,
                                          static_cast<authalic::VolumeTransform>(this->Transform)};
    this->File = std::make_shared<const authalic::StoredVolume>(
        authalic::readStoredVolume(this->FileName, request));
    this->ReadTime = this->GetMTime();
  }
}

int vtkVolumeFileReader::RequestInformation(vtkInformation*, vtkInformationVector**,
                                            vtkInformationVector* outputs) {
  const int done = authalic::runGuarded(this, outputs, 0, this->ErrorKind, [&](const authalic::Execution&) {
    this->ReadFile();
    describe(*this->File, authalic::scalarTypeOf(*this->File, this->KeepNumbers), outputs->GetInformationObject(0));
  });
  this->SetErrorCode(authalic::readerErrorCode(this->ErrorKind, this->FileName));
  return done;
}

int vtkVolumeFileReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  const int done = authalic::runGuarded(this, outputs, 0, this->ErrorKind, [&](const authalic::Execution&) {
    this->ReadFile();
    vtkImageData* output = vtkImageData::GetData(outputs);
    authalic::setLattice(output, this->File->dimensions, this->File->voxelToWorld);
    output->GetPointData()->SetScalars(authalic::valuesOf(*this->File, this->KeepNumbers));
    addFields(*this->File, output);
    if (this->KeepNumbers) {
      authalic::setNotes(output, *this->File);
    }
    this->File.reset();
  });
  this->SetErrorCode(authalic::readerErrorCode(this->ErrorKind, this->FileName));
  return done;
}

void vtkVolumeFileReader::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Frame: " << this->Frame << "\n";
  os << indent << "AllFrames: " << this->AllFrames << "\n";
  os << indent << "KeepNumbers: " << this->KeepNumbers << "\n";
  os << indent << "Transform: " << this->Transform << "\n";
  os << indent << "ErrorKind: " << this->ErrorKind << "\n";
}
