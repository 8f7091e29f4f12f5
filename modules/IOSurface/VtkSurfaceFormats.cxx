#include "VtkSurfaceFormats.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLWriter.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>

#include "Core/base/Error.h"
#include "Formats/AtomicFile.h"
#include "Formats/InputFile.h"
#include "Formats/SurfaceFile.h"
#include "FieldArrays.h"
#include "FileNames.h"
#include "LegacyVtkGate.h"
#include "StlReader.h"
#include "VtpReader.h"

namespace authalic {

namespace {

/// Keeps what VTK would print.
class ErrorListener : public vtkCommand {
 public:
  static ErrorListener* New() { return new ErrorListener; }
  void Execute(vtkObject*, unsigned long, void* data) override {
    if (words_.empty() && data) {
      words_ = static_cast<const char*>(data);
    }
    heard_ = true;
  }
  [[nodiscard]] bool heard() const noexcept { return heard_; }
  /// The first message, without VTK's place in the source.
  [[nodiscard]] std::string words() const {
    const auto colon = words_.rfind("): ");
    std::string text = colon == std::string::npos ? words_ : words_.substr(colon + 3);
    std::replace(text.begin(), text.end(), '\n', ' ');
    const auto end = text.find_last_not_of(" .");
    return text.substr(0, end == std::string::npos ? 0 : end + 1);
  }

 private:
  std::string words_;
  bool heard_ = false;
};

void observe(vtkAlgorithm* algorithm, ErrorListener* listener) {
  algorithm->AddObserver(vtkCommand::ErrorEvent, listener);
  algorithm->AddObserver(vtkCommand::WarningEvent, listener);
  algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, listener);
}

/// The bytes of the file, after the gate of its kind.
std::vector<std::uint8_t> checkedBytes(const std::string& path, const std::string& extension) {
  auto bytes = readBytes(path);
  if (bytes.size() >= 2 && InputFile(path).compressed()) {
    throw FormatError(path, "Compressed " + extension + " files are not read; unpack it with gunzip first.");
  }
  if (extension == ".vtk") {
    checkLegacyVtk(path, bytes);
  }
  return bytes;
}

template <class Reader>
void run(Reader* reader, const std::string& path, vtkPolyData* output) {
  vtkNew<ErrorListener> listener;
  observe(reader, listener);
  reader->SetFileName(path.c_str());
  reader->Update();
  if (listener->heard() || reader->GetErrorCode() != vtkErrorCode::NoError) {
    const std::string words = listener->words();
    throw FormatError(
        path, "VTK cannot read the surface (" +
                  (words.empty() ? vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()) : words) +
                  ").");
  }
  output->ShallowCopy(reader->GetOutput());
}

void readByExtension(const std::string& path, const std::string& extension, vtkPolyData* output) {
  const auto bytes = checkedBytes(path, extension);
  if (extension == ".vtp") {
    readVtp(path, bytes, output);
  } else if (extension == ".vtk") {
    vtkNew<vtkPolyDataReader> reader;
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllFieldsOn();
    reader->ReadAllNormalsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllTCoordsOn();
    reader->ReadAllColorScalarsOn();
    run(reader.Get(), path, output);
  } else {
    readStl(path, bytes, output);
  }
}

void checkCells(const std::string& path, vtkCellArray* cells, vtkIdType points) {
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType k = 0; k < size; ++k) {
      if (ids[k] < 0 || ids[k] >= points) {
        throw FormatError(path, "Cell " + std::to_string(cell->GetCurrentCellId()) + " names point " +
                                    std::to_string(ids[k]) + ", but the file holds " +
                                    std::to_string(points) + " points; it is damaged.");
      }
    }
  }
}

bool hasOnlyTriangles(vtkPolyData* surface) {
  const bool others =
      surface->GetNumberOfVerts() + surface->GetNumberOfLines() + surface->GetNumberOfStrips() > 0;
  return !others && (surface->GetNumberOfPolys() == 0 || surface->GetPolys()->IsHomogeneous() == 3);
}

void triangulate(const std::string& path, vtkPolyData* surface) {
  if (hasOnlyTriangles(surface)) {
    return;
  }
  vtkNew<ErrorListener> listener;
  vtkNew<vtkTriangleFilter> filter;
  observe(filter.Get(), listener);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->SetInputData(surface);
  filter->Update();
  if (listener->heard()) {
    throw FormatError(
        path, "The polygons of the surface cannot be made into triangles (" + listener->words() + ").");
  }
  surface->ShallowCopy(filter->GetOutput());
}

void toDoublePoints(vtkPolyData* surface) {
  if (!surface->GetPoints() || surface->GetPoints()->GetDataType() == VTK_DOUBLE) {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(surface->GetPoints());
  surface->SetPoints(points);
}

template <class Writer>
void runWriter(Writer* writer, const std::string& path, vtkPolyData* surface) {
  AtomicFile file(path);
  vtkNew<ErrorListener> listener;
  observe(writer, listener);
  writer->SetInputData(surface);
  writer->SetFileName(file.temporaryPath().c_str());
  writer->Write();
  if (listener->heard() || writer->GetErrorCode() != vtkErrorCode::NoError) {
    throw FormatError(path, "The surface cannot be written (" + listener->words() + ").");
  }
  file.commit();
}

}  // namespace

bool isVtkSurfaceName(const std::string& path) {
  const std::string extension = extensionOf(path);
  return extension == ".vtp" || extension == ".vtk" || extension == ".stl";
}

void readVtkSurface(const std::string& path, vtkPolyData* output) {
  const std::string extension = extensionOf(path);
  readByExtension(path, extension, output);
  if (output->GetNumberOfPoints() == 0) {
    throw FormatError(path, "A surface with vertices is needed, but the file holds none that VTK can read.");
  }
  for (vtkCellArray* cells :
       {output->GetPolys(), output->GetStrips(), output->GetLines(), output->GetVerts()}) {
    checkCells(path, cells, output->GetNumberOfPoints());
  }
  triangulate(path, output);
  toDoublePoints(output);
}

namespace {

constexpr const char* kSlicerField = "SPACE";

/// "SPACE=RAS" or "SPACE=LPS", else empty.
std::string commentOf(vtkPolyData* surface) {
  const std::string name = textField(surface, "CoordinateSpace");
  for (const CoordinateSpace space : {CoordinateSpace::ScannerRAS, CoordinateSpace::LPS}) {
    if (name == coordinateSpaceName(space)) return spaceComment(space);
  }
  return "";
}

/// The surface with the field SPACE of its space.
vtkSmartPointer<vtkPolyData> withSlicerField(vtkPolyData* surface) {
  const std::string comment = commentOf(surface);
  if (comment.empty()) return surface;
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface);
  addField(copy, kSlicerField, comment.substr(comment.find('=') + 1));
  return copy;
}

}  // namespace

CoordinateSpace takeSpaceOfFile(const std::string& path, vtkPolyData* surface) {
  if (extensionOf(path) == ".vtp") {
    const CoordinateSpace space = spaceComment("SPACE=" + textField(surface, kSlicerField));
    surface->GetFieldData()->RemoveArray(kSlicerField);
    return space;
  }
  const auto start = InputFile(path).readUpTo(256);
  return spaceComment(std::string(start.begin(), start.end()));
}

void writeVtkSurface(const std::string& path, vtkPolyData* surface) {
  const std::string extension = extensionOf(path);
  if (extension == ".vtp") {
    vtkNew<vtkXMLPolyDataWriter> writer;
    runWriter(writer.Get(), path, withSlicerField(surface));
  } else if (extension == ".vtk") {
    vtkNew<vtkPolyDataWriter> writer;
    writer->SetFileVersion(vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_4_2);
    writer->SetFileTypeToBinary();
    writer->SetHeader(("Authalic. " + commentOf(surface)).c_str());
    runWriter(writer.Get(), path, surface);
  } else {
    vtkNew<vtkSTLWriter> writer;
    writer->SetFileTypeToBinary();
    writer->SetHeader(("Authalic. " + commentOf(surface)).c_str());
    runWriter(writer.Get(), path, surface);
  }
}

}  // namespace authalic
