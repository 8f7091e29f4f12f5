#include "vtkVertexDataReader.h"

#include <algorithm>

#include <vtkDataArray.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Core/base/Error.h"
#include "ErrorCode.h"
#include "FieldArrays.h"
#include "Formats/Gifti.h"
#include "Formats/Morphometry.h"
#include "SurfaceConversion.h"
#include "VtkSurfaceFormats.h"

vtkStandardNewMacro(vtkVertexDataReader);

vtkVertexDataReader::~vtkVertexDataReader() {
  this->SetFileName(nullptr);
  this->SetArrayName(nullptr);
}

namespace {

/// lh.aparc.annot.gz → aparc
std::string nameFromFile(const std::string& path) {
  std::string name = path.substr(path.find_last_of('/') + 1);
  for (const char* end :
       {".gz", ".gii", ".func", ".shape", ".label", ".time", ".annot", ".mgh", ".mgz", ".txt"}) {
    const std::string extension(end);
    if (name.size() > extension.size() &&
        name.compare(name.size() - extension.size(), extension.size(), extension) == 0) {
      name.resize(name.size() - extension.size());
    }
  }
  const bool hemisphere =
      name.size() > 3 && (name.compare(0, 3, "lh.") == 0 || name.compare(0, 3, "rh.") == 0);
  return hemisphere ? name.substr(3) : name;
}

struct Target {
  std::string path;
  std::string name;  ///< asked for by the user; may be empty
  vtkPolyData* output;

  /// The vertices of the surface that `output` was cut from; empty when it was not.
  [[nodiscard]] std::vector<int> originals() const {
    vtkDataArray* ids = output->GetPointData()->GetArray("OriginalPointIds");
    return ids ? authalic::toIntegers(ids) : std::vector<int>();
  }
  /// One value for each vertex: those of the file, or of a cut surface those of its original vertices.
  template <class Value>
  [[nodiscard]] std::vector<Value> onVertices(const std::vector<Value>& values) const {
    const auto n = static_cast<std::size_t>(output->GetNumberOfPoints());
    if (values.size() == n) return values;
    const std::vector<int> ids = originals();
    if (ids.empty() || static_cast<std::size_t>(*std::max_element(ids.begin(), ids.end())) >= values.size()) {
      throw authalic::GeometryError(path + ": One value for each of the " + std::to_string(n) +
                                    " vertices of the surface is needed, but the file holds " +
                                    std::to_string(values.size()) + "; it belongs to another surface.");
    }
    std::vector<Value> result;
    for (const int id : ids) result.push_back(values[static_cast<std::size_t>(id)]);
    return result;
  }
  [[nodiscard]] std::string nameOr(const std::string& other) const {
    return !name.empty() ? name : (!other.empty() ? other : nameFromFile(path));
  }
  [[nodiscard]] std::string freeName(const std::string& wanted) const {
    std::string result = wanted;
    for (int number = 2; output->GetPointData()->HasArray(result.c_str()); ++number) {
      result = wanted + std::to_string(number);
    }
    return result;
  }
};

void addAnnotation(const Target& target, const authalic::Annotation& annotation,
                   const std::string& arrayName) {
  authalic::addArray(target.output->GetPointData(), arrayName.c_str(), target.onVertices(annotation.labels));
  authalic::setRegions(target.output, arrayName, annotation.regions);
}

void addLabel(const Target& target) {
  const auto vertices = authalic::readLabel(target.path);
  const std::vector<int> ids = target.originals();
  const int known = ids.empty() ? static_cast<int>(target.output->GetNumberOfPoints())
                                : *std::max_element(ids.begin(), ids.end()) + 1;
  std::vector<int> inside(static_cast<std::size_t>(known), 0);
  for (const int vertex : vertices) {
    if (vertex < known) {
      inside[static_cast<std::size_t>(vertex)] = 1;
    } else if (ids.empty()) {
      throw authalic::GeometryError(target.path + ": The label names vertex " + std::to_string(vertex) +
                                    ", but the surface has " + std::to_string(known) +
                                    " vertices; it belongs to another surface.");
    }
  }
  std::vector<int> flags;
  for (const int id : ids) flags.push_back(inside[static_cast<std::size_t>(id)]);
  authalic::addArray(target.output->GetPointData(), target.nameOr("").c_str(), ids.empty() ? inside : flags);
}

bool isFlat(const authalic::GiftiArray& array) {
  return array.dimensions.size() == 1 || (array.dimensions.size() == 2 && array.dimensions[1] == 1);
}

void addGifti(const Target& target) {
  const authalic::GiftiFile file = authalic::readGifti(target.path);
  bool labels = false;
  int added = 0;
  for (const authalic::GiftiArray& array : file.arrays) {
    labels = labels || (array.intent == authalic::GiftiIntent::Label && isFlat(array));
    if (!isFlat(array) || array.intent == authalic::GiftiIntent::Label) {
      continue;
    }
    if (array.intent == authalic::GiftiIntent::NodeIndex) {
      throw authalic::FormatError(target.path,
                                  "One value per vertex is needed, but this file lists values for some "
                                  "vertices only (NODE_INDEX), which is not read.");
    }
    const auto named = array.metadata.find("Name");
    const std::string name = target.nameOr(named == array.metadata.end() ? "" : named->second);
    authalic::addArray(target.output->GetPointData(), (added == 0 ? name : target.freeName(name)).c_str(),
                       target.onVertices(std::vector<float>(array.values.begin(), array.values.end())));
    ++added;
  }
  if (labels) {
    addAnnotation(target, authalic::readAnnot(target.path), target.nameOr(""));
  } else if (added == 0) {
    throw authalic::FormatError(target.path,
                                "One value per vertex is needed, but no array of the file has that shape.");
  }
}

}  // namespace

void vtkVertexDataReader::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                  const authalic::Execution&) {
  if (!this->FileName || !*this->FileName) {
    throw authalic::InvalidArgument("A file to read is needed; call SetFileName.");
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(vtkPolyData::GetData(inputs[0]));
  authalic::passFields(vtkPolyData::GetData(inputs[0]), output);
  const Target target{this->FileName, this->ArrayName ? this->ArrayName : "", output};
  const std::string extension = authalic::extensionOf(this->FileName);
  if (extension == ".gii") {
    addGifti(target);
  } else if (extension == ".annot") {
    addAnnotation(target, authalic::readAnnot(target.path), target.nameOr(""));
  } else if (extension == ".label") {
    addLabel(target);
  } else {
    authalic::addArray(output->GetPointData(), target.nameOr("").c_str(),
                       target.onVertices(authalic::readVertexScalars(target.path)));
  }
}

int vtkVertexDataReader::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                     vtkInformationVector* outputs) {
  const int done = this->Superclass::RequestData(request, inputs, outputs);
  this->SetErrorCode(authalic::readerErrorCode(this->ErrorKind, this->FileName));
  return done;
}

void vtkVertexDataReader::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ArrayName: " << (this->ArrayName ? this->ArrayName : "(from the file)") << "\n";
}
