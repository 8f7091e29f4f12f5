#include "vtkSurfaceFileWriter.h"

#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <map>

#include "Core/base/Error.h"
#include "ErrorCode.h"
#include "FieldArrays.h"
#include "FileNames.h"
#include "Formats/FreeSurferPatch.h"
#include "Formats/Gifti.h"
#include "Formats/Mz3.h"
#include "Losses.h"
#include "SurfaceConversion.h"
#include "VtkSurfaceFormats.h"

vtkStandardNewMacro(vtkSurfaceFileWriter);

vtkSurfaceFileWriter::~vtkSurfaceFileWriter() {
  this->SetFileName(nullptr);
}

namespace {

/// A FreeSurfer surface may have any ending but that of another kind of file.
void refuseForeignEnding(const std::string& path, const std::string& extension) {
  for (const char* foreign : {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".pdf", ".html", ".txt", ".tsv", ".csv",
                              ".json", ".xml", ".nii", ".mgh", ".mgz", ".img", ".hdr", ".annot", ".label",
                              ".w"}) {
    if (extension == foreign) {
      throw authalic::InvalidArgument(
          path + ": A name that ends as a surface does is required, but \"" + extension +
          "\" belongs to another kind of file; end it in .vtp, .surf.gii, .ply, .off, .obj, .stl, "
          ".mz3 or .vtk, or name it as FreeSurfer does (lh.white).");
    }
  }
}

/// GIFTI has a second ending that says what is in the file.
void refuseVertexDataEnding(const std::string& path) {
  for (const std::string foreign : {".func.gii", ".shape.gii", ".label.gii", ".time.gii"}) {
    if (path.size() > foreign.size() && path.compare(path.size() - foreign.size(), foreign.size(), foreign) == 0) {
      throw authalic::InvalidArgument(path + ": A name that ends as a surface does is required, but \"" + foreign +
                                      "\" belongs to per-vertex data; end it in .surf.gii, or write the data with "
                                      "vtkVertexDataWriter.");
    }
  }
}

/// The point arrays of one component, as MZ3 calls them overlays.
std::vector<authalic::NamedScalars> overlaysOf(vtkPolyData* surface) {
  std::vector<authalic::NamedScalars> overlays;
  for (int i = 0; i < surface->GetPointData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = surface->GetPointData()->GetArray(i);
    if (!array || !array->GetName() || array->GetNumberOfComponents() != 1) {
      continue;
    }
    const Eigen::VectorXd values = authalic::toVector(array);
    overlays.push_back({array->GetName(), {values.data(), values.data() + values.size()}});
  }
  return overlays;
}

/// From the array PatchBorder, or else from the edges that have one face.
std::vector<bool> borderOf(vtkPolyData* surface, const authalic::SurfaceFile& file) {
  std::vector<bool> border(file.vertexCount(), false);
  if (vtkDataArray* marks = surface->GetPointData()->GetArray("PatchBorder")) {
    for (std::size_t i = 0; i < border.size(); ++i) {
      border[i] = marks->GetComponent(static_cast<vtkIdType>(i), 0) != 0;
    }
    return border;
  }
  std::map<std::pair<int, int>, int> faces;
  for (std::size_t i = 0; i < file.faces.size(); ++i) {
    const int a = file.faces[i], b = file.faces[i % 3 == 2 ? i - 2 : i + 1];
    ++faces[{std::min(a, b), std::max(a, b)}];
  }
  for (const auto& [edge, count] : faces) {
    if (count == 1) {
      border[static_cast<std::size_t>(edge.first)] = border[static_cast<std::size_t>(edge.second)] = true;
    }
  }
  return border;
}

void writePatchOf(const std::string& path, vtkPolyData* surface, authalic::SurfaceFile file) {
  vtkDataArray* ids = surface->GetPointData()->GetArray("OriginalPointIds");
  if (!ids) {
    throw authalic::InvalidArgument(
        path +
        ": The numbers of the vertices in the surface that a patch was cut from are "
        "required (point array OriginalPointIds), but the surface has none; give what "
        "authalic cut or map made, or write another format.");
  }
  const std::vector<bool> border = borderOf(surface, file);
  double bounds[6];
  surface->GetBounds(bounds);
  if (bounds[4] != 0 || bounds[5] != 0) {
    authalic::toTkRas(file);
  }
  authalic::writePatch(path, {authalic::toIntegers(ids), border, file.points});
}

void writeSurface(const std::string& path, vtkPolyData* surface) {
  const std::string extension = authalic::extensionOf(path);
  refuseForeignEnding(path, extension);
  authalic::requireUncompressedName(path);
  if (authalic::isVtkSurfaceName(path)) {
    authalic::writeVtkSurface(path, surface);
    return;
  }
  const authalic::SurfaceFile file = authalic::toSurfaceFile(surface);
  if (authalic::isPatchName(path)) {
    writePatchOf(path, surface, file);
  } else if (extension == ".gii") {
    refuseVertexDataEnding(path);
    authalic::writeGiftiSurface(path, file);
  } else if (extension == ".off") {
    authalic::writeOff(path, file);
  } else if (extension == ".ply") {
    authalic::writePly(path, file);
  } else if (extension == ".obj") {
    authalic::writeObj(path, file);
  } else if (extension == ".mz3") {
    authalic::writeMz3(path, file, overlaysOf(surface));
  } else {
    authalic::writeFreeSurferSurface(path, file);
  }
}

/// A copy in LPS.
vtkSmartPointer<vtkPolyData> turnedToLps(const std::string& path, vtkPolyData* surface) {
  const std::string extension = authalic::extensionOf(path);
  if (!authalic::isVtkSurfaceName(path) && extension != ".ply" && extension != ".obj") {
    throw authalic::InvalidArgument(
        path +
        ": LPS is required to be written, but a file of that kind has a space of its "
        "own or cannot say so; end the name in .vtp, .vtk, .ply, .obj or .stl.");
  }
  authalic::SurfaceFile file = authalic::spaceFields(surface);
  if (file.space != authalic::CoordinateSpace::ScannerRAS) {
    throw authalic::InvalidArgument(path + ": Coordinates in scanner RAS are required to write LPS, but their space is "
                                           "unknown; state it when the surface is read (AssumeSpace, --space).");
  }
  authalic::copyPoints(surface, file);
  authalic::toLps(file);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface);
  authalic::setPoints(copy, file);
  authalic::mirrorVectors(copy);
  authalic::setSpaceFields(copy, file);
  return copy;
}

}  // namespace

const char* vtkSurfaceFileWriter::GetLoss(int index) const {
  return index >= 0 && index < this->GetNumberOfLosses() ? this->Losses[static_cast<std::size_t>(index)].c_str()
                                                         : nullptr;
}

void vtkSurfaceFileWriter::WriteData() {
  this->Losses.clear();
  authalic::runGuarded(this, nullptr, 0, this->ErrorKind, [this](const authalic::Execution&) {
    if (!this->FileName || !*this->FileName) {
      throw authalic::InvalidArgument("A name for the file to write is needed; call SetFileName.");
    }
    vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(this->GetInput());
    if (!surface || surface->GetNumberOfPoints() == 0) {
      throw authalic::GeometryError("A surface with vertices is needed to write a file; it is empty.");
    }
    if (this->WriteSpace == LPS) {
      surface = turnedToLps(this->FileName, surface);
    }
    writeSurface(this->FileName, surface);
    this->Losses = authalic::surfaceLosses(this->FileName, surface);
  });
  this->SetErrorCode(authalic::writerErrorCode(this->ErrorKind));
}

int vtkSurfaceFileWriter::Write() {
  this->ErrorKind = authalic::SolverFailure;  // stays when the pipeline above fails
  this->Superclass::Write();
  return this->ErrorKind == authalic::NoFailure ? 1 : 0;
}

int vtkSurfaceFileWriter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkSurfaceFileWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "WriteSpace: " << this->WriteSpace << "\n";
  for (const std::string& loss : this->Losses) {
    os << indent << "Loss: " << loss << "\n";
  }
  os << indent << "ErrorKind: " << this->ErrorKind << "\n";
}
