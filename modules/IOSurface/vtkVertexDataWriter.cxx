#include "vtkVertexDataWriter.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <set>

#include "Core/base/Error.h"
#include "ErrorCode.h"
#include "FieldArrays.h"
#include "FileNames.h"
#include "Formats/AtomicFile.h"
#include "Formats/Gifti.h"
#include "Formats/TextNumbers.h"
#include "Formats/VolumeFile.h"
#include "Losses.h"
#include "SurfaceConversion.h"

vtkStandardNewMacro(vtkVertexDataWriter);

vtkVertexDataWriter::~vtkVertexDataWriter() {
  this->SetFileName(nullptr);
}

namespace {

std::vector<std::string> arraysToWrite(vtkPointData* data, const std::vector<std::string>& asked) {
  if (!asked.empty()) {
    return asked;
  }
  std::vector<std::string> names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data->GetArray(i);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1) {
      names.emplace_back(array->GetName());
    }
  }
  return names;
}

std::vector<float> floats(vtkDataArray* array) {
  std::vector<float> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<float>(array->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return values;
}

void writeText(const std::string& path, vtkDataArray* array) {
  std::string text;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    const double value = array->GetComponent(i, 0);
    if (std::isnan(value)) {
      text += "n/a";
    } else {
      authalic::appendNumber(text, value);
    }
    text += '\n';
  }
  authalic::writeFileAtomically(path, text);
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Labels of vertices; NaN is no region.
std::vector<int> wholeNumbers(const std::string& path, vtkDataArray* array) {
  std::vector<int> numbers;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    const double value = array->GetComponent(i, 0);
    if (!std::isnan(value) && (value != std::floor(value) || std::abs(value) > 2147483647.0)) {
      throw authalic::InvalidArgument(path + ": Labels, which are whole numbers, are required, but vertex " +
                                      std::to_string(i) + " of " + array->GetName() + " has " + std::to_string(value) +
                                      "; write numbers as .shape.gii, .mgz or FreeSurfer's curv.");
    }
    numbers.push_back(std::isnan(value) ? -1 : static_cast<int>(value));
  }
  return numbers;
}

/// A table for numbers that have none: each its own name and colour.
std::vector<authalic::Region> numberedRegions(const std::vector<int>& labels) {
  std::vector<authalic::Region> regions;
  for (const int label : std::set<int>(labels.begin(), labels.end())) {
    if (label < 0) {
      continue;
    }
    // An odd factor permutes the colours: no two numbers below 2^24 - 1 share one, and none is black.
    const unsigned color = ((static_cast<unsigned>(label) + 1U) * 0x9E3779U) & 0xFFFFFFU;
    const auto part = [color](unsigned shift) { return static_cast<std::uint8_t>(color >> shift & 255U); };
    regions.push_back({label, std::to_string(label), {part(0), part(8), part(16), 255}});
  }
  return regions;
}

void writeRegions(const std::string& path, vtkPolyData* surface, vtkDataArray* array) {
  authalic::Annotation annotation;
  annotation.labels = wholeNumbers(path, array);
  annotation.regions = authalic::toRegions(surface, array->GetName());
  if (annotation.regions.empty()) {
    annotation.regions = numberedRegions(annotation.labels);
  }
  if (endsWith(path, ".annot")) {
    authalic::writeAnnot(path, annotation);
  } else {
    authalic::writeGiftiLabels(path, annotation, authalic::textField(surface, "AnatomicalStructurePrimary"));
  }
}

/// The vertices marked 1, in tkRAS where FreeSurfer expects them.
void writeLabelOf(const std::string& path, vtkPolyData* surface, vtkDataArray* array) {
  authalic::SurfaceFile file = authalic::spaceFields(surface);
  authalic::copyPoints(surface, file);
  authalic::toTkRas(file);
  vtkDataArray* numbers = surface->GetPointData()->GetArray((std::string(array->GetName()) + "Values").c_str());
  std::vector<int> vertices;
  std::vector<double> points;
  std::vector<float> values;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    const double mark = array->GetComponent(i, 0);
    if (mark != 0 && mark != 1) {
      throw authalic::InvalidArgument(path + ": A set of vertices (1 inside, 0 outside) is required to write a label, "
                                             "but vertex " + std::to_string(i) + " of " + array->GetName() + " has " +
                                      std::to_string(mark) + "; write .annot or .label.gii.");
    }
    if (mark == 1) {
      const auto at = file.points.begin() + 3 * static_cast<std::ptrdiff_t>(i);
      vertices.push_back(static_cast<int>(i));
      points.insert(points.end(), at, at + 3);
      values.push_back(numbers ? static_cast<float>(numbers->GetComponent(i, 0)) : 0.F);
    }
  }
  authalic::writeLabel(path, vertices, points, values, file.space);
}

void writeOverlay(const std::string& path, const std::vector<float>& values) {
  authalic::ScalarVolume volume({static_cast<int>(values.size()), 1, 1}, Eigen::Matrix4d::Identity());
  volume.values = values;
  authalic::writeVolume(path, volume);
}

/// A file with room for one array.
void writeOne(const std::string& path, vtkPolyData* surface, vtkDataArray* array) {
  const std::string extension = authalic::extensionOf(path);
  if (endsWith(path, ".label.gii") || extension == ".annot") {
    writeRegions(path, surface, array);
  } else if (extension == ".label") {
    writeLabelOf(path, surface, array);
  } else if (extension == ".w") {
    authalic::writePaint(path, floats(array));
  } else if (authalic::isMghName(path)) {
    writeOverlay(path, floats(array));
  } else if (extension == ".txt") {
    writeText(path, array);
  } else {
    authalic::writeMorphometry(path, floats(array), static_cast<int>(surface->GetNumberOfPolys()));
  }
}

/// Kinds of file that are not ours to write: an unknown ending is FreeSurfer's.
void refuseName(const std::string& path) {
  authalic::requireUncompressedName(path);
  if (authalic::isNiftiName(path)) {
    throw authalic::InvalidArgument(
        path +
        ": A name of per-vertex data that are written is required, but NIfTI and CIFTI "
        "files are read only; end it in .shape.gii, .label.gii or .mgz, and make CIFTI "
        "of these with wb_command -cifti-create-dense-scalar.");
  }
}

/// " (thickness, curv)"
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? " (" : ", ") + name;
  }
  return text.empty() ? text : text + ")";
}

/// Returns the arrays that were written.
std::vector<std::string> writeArrays(const std::string& path, vtkPolyData* surface,
                                     const std::vector<std::string>& asked) {
  refuseName(path);
  vtkPointData* data = surface->GetPointData();
  auto names = arraysToWrite(data, asked);
  const bool metric = endsWith(path, ".gii") && !endsWith(path, ".label.gii");
  if (names.empty() || (!metric && names.size() > 1)) {
    throw authalic::InvalidArgument("One point array of one component is needed to write " + path +
                                    ", but there are " + std::to_string(names.size()) + listed(names) +
                                    "; name one (AddArrayName, --array).");
  }
  if (!metric) {
    writeOne(path, surface, authalic::requireArray(data, names[0], 1, "surface"));
    return names;
  }
  std::vector<authalic::NamedScalars> arrays;
  for (const std::string& name : names) {
    arrays.push_back({name, floats(authalic::requireArray(data, name, 1, "surface"))});
  }
  authalic::writeGiftiScalars(path, arrays, authalic::textField(surface, "AnatomicalStructurePrimary"));
  return names;
}

}  // namespace

const char* vtkVertexDataWriter::GetLoss(int index) const {
  return index >= 0 && index < this->GetNumberOfLosses() ? this->Losses[static_cast<std::size_t>(index)].c_str()
                                                         : nullptr;
}

void vtkVertexDataWriter::AddArrayName(const char* name) {
  if (name) {
    this->ArrayNames.emplace_back(name);
    this->Modified();
  }
}

void vtkVertexDataWriter::ClearArrayNames() {
  this->ArrayNames.clear();
  this->Modified();
}

void vtkVertexDataWriter::WriteData() {
  this->Losses.clear();
  authalic::runGuarded(this, nullptr, 0, this->ErrorKind, [this](const authalic::Execution&) {
    if (!this->FileName || !*this->FileName) {
      throw authalic::InvalidArgument("A name for the file to write is needed; call SetFileName.");
    }
    vtkPolyData* surface = vtkPolyData::SafeDownCast(this->GetInput());
    if (!surface || surface->GetNumberOfPoints() == 0) {
      throw authalic::GeometryError("A surface with vertices is needed to write their data; it is empty.");
    }
    const auto written = writeArrays(this->FileName, surface, this->ArrayNames);
    this->Losses = authalic::vertexDataLosses(this->FileName, surface, written);
  });
  this->SetErrorCode(authalic::writerErrorCode(this->ErrorKind));
}

int vtkVertexDataWriter::Write() {
  this->ErrorKind = authalic::SolverFailure;  // stays when the pipeline above fails
  this->Superclass::Write();
  return this->ErrorKind == authalic::NoFailure ? 1 : 0;
}

int vtkVertexDataWriter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkVertexDataWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ArrayNames:";
  for (const std::string& name : this->ArrayNames) {
    os << " " << name;
  }
  for (const std::string& loss : this->Losses) {
    os << "\n" << indent << "Loss: " << loss;
  }
  os << "\n" << indent << "ErrorKind: " << this->ErrorKind << "\n";
}
