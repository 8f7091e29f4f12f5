#include "vtkVertexDataReader.h"

#include <algorithm>
#include <cmath>

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Core/base/Error.h"
#include "ErrorCode.h"
#include "FieldArrays.h"
#include "FileNames.h"
#include "Formats/Cifti.h"
#include "Formats/Gifti.h"
#include "Formats/Morphometry.h"
#include "Formats/Mz3.h"
#include "SurfaceConversion.h"

vtkStandardNewMacro(vtkVertexDataReader);

vtkVertexDataReader::~vtkVertexDataReader() {
  this->SetFileName(nullptr);
  this->SetArrayName(nullptr);
  this->SetStructure(nullptr);
}

namespace {

struct Target {
  std::string path;
  std::string name;       ///< asked for by the user; may be empty
  std::string structure;  ///< of a CIFTI file; may be empty
  vtkPolyData* output;
  bool alone;  ///< there is no surface

  /// The vertices of the surface that `output` was cut from; empty when it was not.
  [[nodiscard]] std::vector<int> originals() const {
    vtkDataArray* ids = output->GetPointData()->GetArray("OriginalPointIds");
    return ids ? authalic::toIntegers(ids) : std::vector<int>();
  }
  /// Of the surface that the file is for; 0 when there is none.
  [[nodiscard]] std::size_t vertexCount() const {
    const std::vector<int> ids = originals();
    return ids.empty() ? static_cast<std::size_t>(output->GetNumberOfPoints())
                       : static_cast<std::size_t>(*std::max_element(ids.begin(), ids.end())) + 1;
  }
  /// Without a surface there is one point for each value.
  void makeRoom(std::size_t values) const {
    if (alone && output->GetNumberOfPoints() == 0) {
      authalic::SurfaceFile points;
      points.points.assign(3 * values, 0.0);
      authalic::setPoints(output, points);
    }
  }
  /// One value for each vertex: those of the file, or of a cut surface those of its original vertices.
  template <class Value>
  [[nodiscard]] std::vector<Value> onVertices(const std::vector<Value>& values) const {
    makeRoom(values.size());
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
    return !name.empty() ? name : (!other.empty() ? other : authalic::arrayNameOf(path));
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
  const authalic::SparseScalars label = authalic::readLabel(target.path);
  const std::size_t known = target.vertexCount();
  if (known == 0) {
    throw authalic::InvalidArgument(target.path +
                                    ": A label lists some vertices only; give the surface it belongs to.");
  }
  const bool cut = !target.originals().empty();
  std::vector<int> inside(known, 0);
  std::vector<float> values(known, std::nanf(""));
  for (std::size_t i = 0; i < label.vertices.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(label.vertices[i]);
    if (vertex < known) {
      inside[vertex] = 1;
      values[vertex] = label.values[i];
    } else if (!cut) {
      throw authalic::GeometryError(target.path + ": The label names vertex " + std::to_string(vertex) +
                                    ", but the surface has " + std::to_string(known) +
                                    " vertices; it belongs to another surface.");
    }
  }
  const std::string name = target.nameOr("");
  authalic::addArray(target.output->GetPointData(), name.c_str(), target.onVertices(inside));
  if (std::any_of(label.values.begin(), label.values.end(), [](float value) { return value != 0; })) {
    authalic::addArray(target.output->GetPointData(), (name + "Values").c_str(), target.onVertices(values));
  }
}

/// Numbered arrays of one name.
void addScalars(const Target& target, const std::vector<std::vector<float>>& layers) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string name = target.nameOr("");
    authalic::addArray(target.output->GetPointData(), (i == 0 ? name : target.freeName(name)).c_str(),
                       target.onVertices(layers[i]));
  }
}

/// Labels of a CIFTI map, which are whole numbers.
authalic::Annotation annotationOf(const authalic::CiftiSurface& surface, const authalic::CiftiMap& map) {
  authalic::Annotation annotation;
  for (const float value : authalic::onCiftiSurface(surface, map, -1)) {
    annotation.labels.push_back(static_cast<int>(std::lround(value)));
  }
  annotation.regions = map.regions;
  return annotation;
}

/// The other surfaces of the file and its voxels.
std::string restOf(const authalic::CiftiFile& file, const authalic::CiftiSurface& taken) {
  std::string names;
  std::size_t onSurfaces = 0;
  for (const authalic::CiftiSurface& surface : file.surfaces) {
    onSurfaces += surface.vertices.size();
    if (&surface != &taken) {
      names += (names.empty() ? "" : ", ") + surface.structure;
    }
  }
  const std::size_t rows = file.maps.empty() ? 0 : file.maps[0].values.size();
  const std::size_t voxels = rows - std::min(rows, onSurfaces);
  return names + (names.empty() || voxels == 0 ? "" : ", ") + (voxels == 0 ? "" : std::to_string(voxels) + " voxels");
}

/// Returns what was passed over.
std::string addCifti(const Target& target) {
  const authalic::CiftiFile file = authalic::readCifti(target.path);
  const std::string structure =
      !target.structure.empty() ? target.structure : authalic::textField(target.output, "AnatomicalStructurePrimary");
  const authalic::CiftiSurface& surface =
      authalic::ciftiSurface(target.path, file, structure, target.vertexCount());
  if (target.alone) {
    authalic::addField(target.output, "AnatomicalStructurePrimary", surface.structure);
  }
  for (std::size_t i = 0; i < file.maps.size(); ++i) {
    const authalic::CiftiMap& map = file.maps[i];
    const std::string wanted = target.nameOr(map.name);
    const std::string name = i == 0 ? wanted : target.freeName(wanted);
    if (file.labels) {
      addAnnotation(target, annotationOf(surface, map), name);
    } else {
      authalic::addArray(target.output->GetPointData(), name.c_str(),
                         target.onVertices(authalic::onCiftiSurface(surface, map, std::nanf(""))));
    }
  }
  return restOf(file, surface);
}

bool isFlat(const authalic::GiftiArray& array) {
  return array.dimensions.size() == 1 || (array.dimensions.size() == 2 && array.dimensions[1] == 1);
}

/// Without a surface the structure comes from the file.
void noteStructure(const Target& target, const authalic::GiftiFile& file) {
  const auto structure = file.metadata.find("AnatomicalStructurePrimary");
  if (target.alone && structure != file.metadata.end()) {
    authalic::addField(target.output, "AnatomicalStructurePrimary", structure->second);
  }
}

void addGifti(const Target& target) {
  authalic::GiftiFile file = authalic::readGifti(target.path);
  authalic::spreadNodeIndex(target.path, file, target.vertexCount());
  noteStructure(target, file);
  bool labels = false;
  int added = 0;
  for (const authalic::GiftiArray& array : file.arrays) {
    labels = labels || (array.intent == authalic::GiftiIntent::Label && isFlat(array));
    if (!isFlat(array) || array.intent == authalic::GiftiIntent::Label) {
      continue;
    }
    const auto named = array.metadata.find("Name");
    const std::string name = target.nameOr(named == array.metadata.end() ? "" : named->second);
    authalic::addArray(target.output->GetPointData(), (added == 0 ? name : target.freeName(name)).c_str(),
                       target.onVertices(std::vector<float>(array.values.begin(), array.values.end())));
    ++added;
  }
  if (labels) {
    addAnnotation(target, authalic::giftiAnnotation(target.path, file), target.nameOr(""));
  } else if (added == 0) {
    throw authalic::FormatError(target.path,
                                "One value per vertex is needed, but no array of the file has that shape.");
  }
}

/// Returns what was passed over.
std::string addFile(const Target& target) {
  const std::string extension = authalic::extensionOf(target.path);
  if (extension == ".nii" && authalic::isCifti(target.path)) {
    return addCifti(target);
  }
  if (extension == ".gii") {
    addGifti(target);
  } else if (extension == ".annot") {
    addAnnotation(target, authalic::readAnnot(target.path), target.nameOr(""));
  } else if (extension == ".label") {
    addLabel(target);
  } else if (extension == ".mz3") {
    addScalars(target, authalic::readMz3(target.path).layers);
  } else if (extension == ".nii" || extension == ".mgh" || extension == ".mgz") {
    addScalars(target, authalic::readVertexFrames(target.path));
  } else {
    addScalars(target, {authalic::readVertexScalars(target.path, target.vertexCount())});
  }
  return "";
}

}  // namespace

void vtkVertexDataReader::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                  const authalic::Execution&) {
  if (!this->FileName || !*this->FileName) {
    throw authalic::InvalidArgument("A file to read is needed; call SetFileName.");
  }
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (input) {
    output->ShallowCopy(input);
    authalic::passFields(input, output);
  }
  this->NotRead.clear();
  this->NotRead = addFile({this->FileName, this->ArrayName ? this->ArrayName : "",
                           this->Structure ? this->Structure : "", output, input == nullptr});
}

int vtkVertexDataReader::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
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
  os << indent << "NotRead: " << this->NotRead << "\n";
  os << indent << "Structure: " << (this->Structure ? this->Structure : "(that of the surface)") << "\n";
  os << indent << "ArrayName: " << (this->ArrayName ? this->ArrayName : "(from the file)") << "\n";
}
