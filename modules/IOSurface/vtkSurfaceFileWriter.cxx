#include "vtkSurfaceFileWriter.h"

#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Core/base/Error.h"
#include "ErrorCode.h"
#include "Formats/Gifti.h"
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
                              ".json", ".xml", ".nii", ".mgh", ".mgz", ".img", ".hdr", ".annot", ".label"}) {
    if (extension == foreign) {
      throw authalic::InvalidArgument(
          path + ": A name that ends as a surface does is required, but \"" + extension +
          "\" belongs to another kind of file; end it in .vtp, .surf.gii, .ply, .off, .obj, .stl or "
          ".vtk, or name it as FreeSurfer does (lh.white).");
    }
  }
}

void writeSurface(const std::string& path, vtkPolyData* surface) {
  if (authalic::isVtkSurfaceName(path)) {
    authalic::writeVtkSurface(path, surface);
    return;
  }
  const authalic::SurfaceFile file = authalic::toSurfaceFile(surface);
  const std::string extension = authalic::extensionOf(path);
  if (extension == ".gii") {
    authalic::writeGiftiSurface(path, file);
  } else if (extension == ".off") {
    authalic::writeOff(path, file);
  } else if (extension == ".ply") {
    authalic::writePly(path, file);
  } else if (extension == ".obj") {
    authalic::writeObj(path, file);
  } else {
    refuseForeignEnding(path, extension);
    authalic::writeFreeSurferSurface(path, file);
  }
}

}  // namespace

void vtkSurfaceFileWriter::WriteData() {
  authalic::runGuarded(this, nullptr, 0, this->ErrorKind, [this](const authalic::Execution&) {
    if (!this->FileName || !*this->FileName) {
      throw authalic::InvalidArgument("A name for the file to write is needed; call SetFileName.");
    }
    vtkPolyData* surface = vtkPolyData::SafeDownCast(this->GetInput());
    if (!surface || surface->GetNumberOfPoints() == 0) {
      throw authalic::GeometryError("A surface with vertices is needed to write a file; it is empty.");
    }
    writeSurface(this->FileName, surface);
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
  os << indent << "ErrorKind: " << this->ErrorKind << "\n";
}
