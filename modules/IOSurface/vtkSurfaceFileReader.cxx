#include "vtkSurfaceFileReader.h"

#include <vtkFieldData.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <optional>

#include "Core/base/Error.h"
#include "ErrorCode.h"
#include "FieldArrays.h"
#include "FileNames.h"
#include "Formats/FileContent.h"
#include "Formats/FreeSurferPatch.h"
#include "Formats/InputFile.h"
#include "Formats/Mz3.h"
#include "Formats/VolumeFile.h"
#include "SurfaceConversion.h"
#include "VtkSurfaceFormats.h"

vtkStandardNewMacro(vtkSurfaceFileReader);

vtkSurfaceFileReader::vtkSurfaceFileReader() {
  this->SetNumberOfInputPorts(0);
}

vtkSurfaceFileReader::~vtkSurfaceFileReader() {
  this->SetFileName(nullptr);
  this->SetWholeFileName(nullptr);
  this->SetVolumeFileName(nullptr);
}

namespace {

using authalic::CoordinateSpace;

std::optional<CoordinateSpace> asserted(int assumeSpace) {
  switch (assumeSpace) {
    case vtkSurfaceFileReader::SCANNER_RAS:
      return CoordinateSpace::ScannerRAS;
    case vtkSurfaceFileReader::TK_RAS:
      return CoordinateSpace::TkRAS;
    case vtkSurfaceFileReader::LPS:
      return CoordinateSpace::LPS;
    case vtkSurfaceFileReader::VOXEL:
      return CoordinateSpace::Voxel;
    default:
      return std::nullopt;
  }
}

/// What the user says of the coordinates.
struct Assertion {
  std::optional<CoordinateSpace> space;
  std::optional<authalic::VolumeGeometry> volume;
};

void toScannerRas(authalic::SurfaceFile& surface, const Assertion& assumed) {
  if (assumed.volume) surface.geometry = *assumed.volume;
  authalic::toScannerRas(surface, assumed.space);
}

/// What a file of VTK's own formats says in its field data, or as 3D Slicer does. Where they differ Slicer wrote last:
/// it turns the coordinates and leaves fields that it does not know.
authalic::SurfaceFile statedSpace(vtkPolyData* surface, const std::string& path) {
  authalic::SurfaceFile stated = authalic::spaceFields(surface);
  const CoordinateSpace said = authalic::takeSpaceOfFile(path, surface);
  if (said != CoordinateSpace::Unknown && said != stated.space) {
    stated.spaceReason = std::string(authalic::spaceComment(said)) + " in the file";
    if (stated.space != CoordinateSpace::Unknown) {
      stated.spaceReason += std::string(", which goes before its field CoordinateSpace, ") +
                            authalic::coordinateSpaceName(stated.space);
    }
    stated.space = said;
  } else if (stated.space == CoordinateSpace::Unknown) {
    stated.spaceReason = authalic::extensionOf(path) + " file without a field CoordinateSpace";
  } else if (stated.spaceReason.empty()) {
    stated.spaceReason = "field CoordinateSpace of the file";
  }
  return stated;
}

void requireFinitePoints(vtkPolyData* surface, const std::string& path) {
  double p[3];
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    surface->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
      throw authalic::GeometryError(path + ": Finite coordinates are required, but vertex " + std::to_string(i) +
                                    " has a NaN or infinite one; remove or repair that vertex.");
    }
  }
}

/// .vtp, .vtk and .stl.
void readWithVtk(const std::string& path, const Assertion& assumed, vtkPolyData* output) {
  authalic::readVtkSurface(path, output);
  requireFinitePoints(output, path);
  authalic::SurfaceFile surface = statedSpace(output, path);
  const CoordinateSpace space = assumed.space.value_or(surface.space);
  const bool moves = space != CoordinateSpace::Unknown && space != CoordinateSpace::ScannerRAS;
  if (moves) {
    authalic::copyPoints(output, surface);
  }
  toScannerRas(surface, assumed);
  if (moves) {
    authalic::setPoints(output, surface);
  }
  if (space == CoordinateSpace::LPS) {
    authalic::mirrorVectors(output);
  }
  authalic::setSpaceFields(output, surface);
}

/// The surface of a patch, in the space of the patch.
authalic::SurfaceFile wholeSurface(const std::string& path) {
  const bool vtk = authalic::isVtkSurfaceName(path);
  vtkNew<vtkPolyData> polyData;
  if (vtk) {
    readWithVtk(path, {}, polyData);
  }
  authalic::SurfaceFile whole = vtk ? authalic::toSurfaceFile(polyData) : authalic::readSurface(path);
  if (vtk || authalic::extensionOf(path) == ".gii") {
    authalic::toTkRas(whole);  // where FreeSurfer keeps patches of the surface that this one was made from
  }
  return whole;
}

void readPatchOf(const std::string& path, const char* whole, const Assertion& assumed, vtkPolyData* output) {
  if (!whole || !*whole) {
    throw authalic::InvalidArgument(
        path +
        ": The surface that a FreeSurfer patch was cut from is required, because the "
        "patch has no faces of its own; name it (WholeFileName, --whole).");
  }
  const authalic::PatchFile patch = authalic::readPatch(path);
  authalic::SurfaceFile surface = authalic::patchSurface(path, patch, wholeSurface(whole));
  toScannerRas(surface, assumed);
  authalic::setSurface(output, surface);
  authalic::addIds(output->GetPointData(), "OriginalPointIds", patch.vertices);
  authalic::addArray(output->GetPointData(), "PatchBorder",
                     std::vector<int>(patch.border.begin(), patch.border.end()));
}

void addMz3Arrays(const std::string& path, vtkPolyData* output) {
  const authalic::Mz3File file = authalic::readMz3(path);
  for (std::size_t i = 0; i < file.layers.size(); ++i) {
    authalic::addArray(output->GetPointData(), ("Overlay" + (i == 0 ? "" : std::to_string(i + 1))).c_str(),
                       file.layers[i]);
  }
  if (file.colors.empty()) {
    return;
  }
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(4);
  for (const auto& color : file.colors) {
    colors->InsertNextTypedTuple(color.data());
  }
  output->GetPointData()->AddArray(colors);
}

/// Metadata that the output has no field for.
std::string otherMetadata(const authalic::SurfaceFile& surface, vtkPolyData* output) {
  std::string names;
  for (const auto& entry : surface.metadata) {
    const bool geometry = entry.first.compare(0, 7, "VolGeom") == 0;
    if (!geometry && !output->GetFieldData()->HasArray(entry.first.c_str())) {
      names += (names.empty() ? "metadata " : ", ") + entry.first;
    }
  }
  return names;
}

/// Returns what was passed over.
std::string readAny(const std::string& path, const char* whole, const Assertion& assumed, vtkPolyData* output) {
  if (authalic::isVtkSurfaceName(path)) {
    readWithVtk(path, assumed, output);
    return "";
  }
  std::string notRead;
  if (authalic::contentOf(path) == authalic::FileContent::Patch) {
    readPatchOf(path, whole, assumed, output);
  } else {
    authalic::SurfaceFile surface = authalic::readSurface(path);
    toScannerRas(surface, assumed);
    authalic::setSurface(output, surface);
    const std::string metadata = otherMetadata(surface, output);
    notRead = surface.notRead + (surface.notRead.empty() || metadata.empty() ? "" : ", ") + metadata;
    if (authalic::extensionOf(path) == ".mz3") {
      addMz3Arrays(path, output);
    }
  }
  requireFinitePoints(output, path);
  return notRead;
}

}  // namespace

void vtkSurfaceFileReader::Compute(vtkInformationVector**, vtkInformationVector* outputs,
                                   const authalic::Execution&) {
  if (!this->FileName || !*this->FileName) {
    throw authalic::InvalidArgument("A file to read is needed; call SetFileName.");
  }
  this->NotRead.clear();
  Assertion assumed{asserted(this->AssumeSpace), std::nullopt};
  if (this->VolumeFileName && *this->VolumeFileName) {
    assumed.volume = authalic::readVolumeGeometry(this->VolumeFileName);
  }
  this->NotRead = readAny(this->FileName, this->WholeFileName, assumed, vtkPolyData::GetData(outputs));
}

int vtkSurfaceFileReader::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                      vtkInformationVector* outputs) {
  const int done = this->Superclass::RequestData(request, inputs, outputs);
  this->SetErrorCode(authalic::readerErrorCode(this->ErrorKind, this->FileName));
  return done;
}

void vtkSurfaceFileReader::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "WholeFileName: " << (this->WholeFileName ? this->WholeFileName : "(none)") << "\n";
  os << indent << "VolumeFileName: " << (this->VolumeFileName ? this->VolumeFileName : "(none)") << "\n";
  os << indent << "NotRead: " << this->NotRead << "\n";
  os << indent << "AssumeSpace: " << this->AssumeSpace << "\n";
}
