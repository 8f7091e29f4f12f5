#include "vtkSurfaceFileReader.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <cmath>
#include <optional>

#include "Core/base/Error.h"
#include "ErrorCode.h"
#include "SurfaceConversion.h"
#include "VtkSurfaceFormats.h"

vtkStandardNewMacro(vtkSurfaceFileReader);

vtkSurfaceFileReader::vtkSurfaceFileReader() {
  this->SetNumberOfInputPorts(0);
}

vtkSurfaceFileReader::~vtkSurfaceFileReader() {
  this->SetFileName(nullptr);
}

namespace {

using authalic::CoordinateSpace;

std::optional<CoordinateSpace> asserted(int assumeSpace) {
  switch (assumeSpace) {
    case vtkSurfaceFileReader::SCANNER_RAS:
      return CoordinateSpace::ScannerRAS;
    case vtkSurfaceFileReader::TK_RAS:
      return CoordinateSpace::TkRAS;
    default:
      return std::nullopt;
  }
}

/// What a file of VTK's own formats says in its field data; other formats say nothing.
authalic::SurfaceFile statedSpace(vtkPolyData* surface, const std::string& path) {
  authalic::SurfaceFile stated = authalic::spaceFields(surface);
  if (stated.space == CoordinateSpace::Unknown) {
    stated.spaceReason = authalic::extensionOf(path) + " file without a field CoordinateSpace";
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

}  // namespace

void vtkSurfaceFileReader::Compute(vtkInformationVector**, vtkInformationVector* outputs,
                                   const authalic::Execution&) {
  if (!this->FileName || !*this->FileName) {
    throw authalic::InvalidArgument("A file to read is needed; call SetFileName.");
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const auto space = asserted(this->AssumeSpace);
  if (!authalic::isVtkSurfaceName(this->FileName)) {
    authalic::SurfaceFile surface = authalic::readSurface(this->FileName);
    authalic::toScannerRas(surface, space);
    authalic::setSurface(output, surface);
    requireFinitePoints(output, this->FileName);
    return;
  }
  authalic::readVtkSurface(this->FileName, output);
  requireFinitePoints(output, this->FileName);
  authalic::SurfaceFile surface = statedSpace(output, this->FileName);
  const bool moves = space.value_or(surface.space) == CoordinateSpace::TkRAS;
  if (moves) {
    authalic::copyPoints(output, surface);
  }
  authalic::toScannerRas(surface, space);
  if (moves) {
    authalic::setPoints(output, surface);
  }
  authalic::setSpaceFields(output, surface);
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
  os << indent << "AssumeSpace: " << this->AssumeSpace << "\n";
}
