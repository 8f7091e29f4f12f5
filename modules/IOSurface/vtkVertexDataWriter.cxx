#include "vtkVertexDataWriter.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

#include "Core/base/Error.h"
#include "ErrorCode.h"
#include "FieldArrays.h"
#include "Formats/AtomicFile.h"
#include "Formats/Gifti.h"
#include "Formats/TextNumbers.h"
#include "SurfaceConversion.h"
#include "VtkSurfaceFormats.h"

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

void writeArrays(const std::string& path, vtkPolyData* surface, const std::vector<std::string>& asked) {
  vtkPointData* data = surface->GetPointData();
  const auto names = arraysToWrite(data, asked);
  const bool metric = endsWith(path, ".gii") && !endsWith(path, ".label.gii");
  if (names.empty() || (!metric && names.size() > 1)) {
    throw authalic::InvalidArgument("One point array of one component is needed to write " + path +
                                    ", but there are " + std::to_string(names.size()) +
                                    "; name one with AddArrayName.");
  }
  const std::string structure = authalic::textField(surface, "AnatomicalStructurePrimary");
  vtkDataArray* first = authalic::requireArray(data, names[0], 1, "surface");
  if (metric) {
    std::vector<authalic::NamedScalars> arrays;
    for (const std::string& name : names) {
      arrays.push_back({name, floats(authalic::requireArray(data, name, 1, "surface"))});
    }
    authalic::writeGiftiScalars(path, arrays, structure);
  } else if (endsWith(path, ".label.gii")) {
    authalic::Annotation annotation;
    annotation.labels = authalic::toIntegers(first);
    annotation.regions = authalic::toRegions(surface, names[0]);
    authalic::writeGiftiLabels(path, annotation, structure);
  } else if (endsWith(path, ".txt")) {
    writeText(path, first);
  } else {
    authalic::writeMorphometry(path, floats(first), static_cast<int>(surface->GetNumberOfPolys()));
  }
}

}  // namespace

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
  authalic::runGuarded(this, nullptr, 0, this->ErrorKind, [this](const authalic::Execution&) {
    if (!this->FileName || !*this->FileName) {
      throw authalic::InvalidArgument("A name for the file to write is needed; call SetFileName.");
    }
    vtkPolyData* surface = vtkPolyData::SafeDownCast(this->GetInput());
    if (!surface || surface->GetNumberOfPoints() == 0) {
      throw authalic::GeometryError("A surface with vertices is needed to write their data; it is empty.");
    }
    writeArrays(this->FileName, surface, this->ArrayNames);
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
  os << "\n" << indent << "ErrorKind: " << this->ErrorKind << "\n";
}
