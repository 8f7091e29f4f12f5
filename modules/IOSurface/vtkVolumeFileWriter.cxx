#include "vtkVolumeFileWriter.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include "Core/base/Error.h"
#include "ErrorCode.h"
#include "FieldArrays.h"
#include "Formats/AtomicFile.h"
#include "Formats/StoredVolume.h"
#include "Losses.h"
#include "SurfaceConversion.h"
#include "VolumeValues.h"

vtkStandardNewMacro(vtkVolumeFileWriter);

vtkVolumeFileWriter::~vtkVolumeFileWriter() {
  this->SetFileName(nullptr);
}

namespace {

/// The place is looked at before the name.
void requireName(const std::string& path) {
  static_cast<void>(authalic::AtomicFile(path));
  const bool pair = path.find(".hdr") != std::string::npos || path.find(".img") != std::string::npos;
  if (pair || (!authalic::isNiftiName(path) && !authalic::isMghName(path))) {
    throw authalic::InvalidArgument(path + ": A name that ends as a volume does is required; end it in .nii, .nii.gz, "
                                           ".mgh or .mgz.");
  }
}

void requireVoxels(const std::string& path, vtkImageData* volume) {
  vtkDataArray* voxels = volume ? volume->GetPointData()->GetScalars() : nullptr;
  if (!voxels || voxels->GetNumberOfTuples() == 0) {
    throw authalic::GeometryError(path + ": A volume with voxels is required to write a file; it is empty.");
  }
  const int frames = static_cast<int>(authalic::numberField(volume, "Frames", 1));
  if (voxels->GetNumberOfComponents() != 1 && voxels->GetNumberOfComponents() != frames) {
    throw authalic::InvalidArgument(path + ": One number per voxel is required, but there are " +
                                    std::to_string(voxels->GetNumberOfComponents()) +
                                    "; take one component, or say that they are frames (field Frames).");
  }
  const std::string reason = authalic::textField(volume, "CoordinateSpaceReason");
  if (authalic::textField(volume, "CoordinateSpace") == "unknown") {
    throw authalic::InvalidArgument(path + ": A volume in scanner RAS is required, but its space is unknown" +
                                    (reason.empty() ? "" : " (" + reason + ")") +
                                    "; where you know that its axes are scanner RAS, say so (--space scanner-ras, or "
                                    "field CoordinateSpace).");
  }
}

}  // namespace

const char* vtkVolumeFileWriter::GetLoss(int index) const {
  return index >= 0 && index < this->GetNumberOfLosses() ? this->Losses[static_cast<std::size_t>(index)].c_str()
                                                         : nullptr;
}

void vtkVolumeFileWriter::WriteData() {
  this->Losses.clear();
  authalic::runGuarded(this, nullptr, 0, this->ErrorKind, [this](const authalic::Execution&) {
    if (!this->FileName || !*this->FileName) {
      throw authalic::InvalidArgument("A name for the file to write is needed; call SetFileName.");
    }
    const std::string path = this->FileName;
    requireName(path);
    vtkImageData* volume = vtkImageData::SafeDownCast(this->GetInput());
    requireVoxels(path, volume);
    const authalic::VolumeToWrite written = authalic::toStored(path, volume);
    authalic::writeStoredVolume(path, written.volume);
    this->Losses = authalic::volumeLosses(path, volume, written);
  });
  this->SetErrorCode(authalic::writerErrorCode(this->ErrorKind));
}

int vtkVolumeFileWriter::Write() {
  this->ErrorKind = authalic::SolverFailure;  // stays when the pipeline above fails
  this->Superclass::Write();
  return this->ErrorKind == authalic::NoFailure ? 1 : 0;
}

int vtkVolumeFileWriter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkVolumeFileWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  for (const std::string& loss : this->Losses) {
    os << indent << "Loss: " << loss << "\n";
  }
  os << indent << "ErrorKind: " << this->ErrorKind << "\n";
}
