#include "FileInfo.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include "Core/base/Error.h"
#include "Formats/Cifti.h"
#include "Formats/FreeSurferPatch.h"
#include "Formats/Gifti.h"
#include "Formats/Morphometry.h"

namespace authalic::cli {
namespace {

constexpr const char* spaceOfData = "that of the surface they belong to";

/// Range and number of NaN.
class Range {
 public:
  void add(double value) {
    if (std::isnan(value)) {
      ++none_;
      return;
    }
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
    some_ = true;
  }
  [[nodiscard]] std::string words() const {
    char text[80];
    std::snprintf(text, sizeof(text), "%.6g to %.6g", low_, high_);
    const std::string range = some_ ? text : "no numbers";
    return none_ == 0 ? range : range + ", " + std::to_string(none_) + " n/a";
  }

 private:
  double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
  long long none_ = 0;
  bool some_ = false;
};

std::string rangeOf(vtkDataArray* array) {
  Range range;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) range.add(array->GetComponent(i, 0));
  return range.words();
}

std::string rangeOf(const std::vector<float>& values) {
  Range range;
  for (const float value : values) range.add(value);
  return range.words();
}

/// "RAS", "LIA" …: where each axis points most.
std::string axisCodes(vtkImageData* volume) {
  const char* letters[3] = {"RL", "AP", "SI"};
  std::string codes;
  bool oblique = false;
  for (int axis = 0; axis < 3; ++axis) {
    int most = 0;
    const auto part = [&](int row) { return volume->GetDirectionMatrix()->GetElement(row, axis); };
    for (int row = 1; row < 3; ++row) {
      if (std::abs(part(row)) > std::abs(part(most))) most = row;
    }
    codes += letters[most][part(most) < 0 ? 1 : 0];
    oblique = oblique || std::abs(part(most)) < 1 - 1e-6;
  }
  return codes + (oblique ? " (oblique)" : "");
}

OrderedJson regionsInfo(vtkPolyData* surface, const std::string& array) {
  OrderedJson regions = OrderedJson::array();
  auto* names = vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray((array + "Names").c_str()));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i) regions.push_back(names->GetValue(i));
  return regions;
}

OrderedJson arraysInfo(const std::string& path, const Session& session) {
  const auto surface = readVertexData(nullptr, path, "", "", session).surface;
  OrderedJson info;
  info["vertices"] = surface->GetNumberOfPoints();
  const std::string structure = textField(surface, "AnatomicalStructurePrimary");
  if (!structure.empty()) info["structure"] = structure;
  vtkPointData* data = surface->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    const std::string name = data->GetArrayName(i);
    info["array " + name] = rangeOf(data->GetArray(i));
    const OrderedJson regions = regionsInfo(surface, name);
    if (!regions.empty()) info["regions of " + name] = regions;
  }
  return info;
}

OrderedJson ciftiInfo(const std::string& path) {
  const CiftiFile file = readCifti(path);
  OrderedJson info;
  for (const CiftiSurface& surface : file.surfaces) {
    info["surface " + surface.structure] = std::to_string(surface.vertices.size()) + " of " +
                                           std::to_string(surface.vertexCount) + " vertices";
  }
  info[file.labels ? "label maps" : "maps"] = file.maps.size();
  for (std::size_t i = 0; i < file.maps.size() && i < 8; ++i) {
    info["map " + std::to_string(i) + " " + file.maps[i].name] = rangeOf(file.maps[i].values);
  }
  return info;
}

OrderedJson sparseInfo(const SparseScalars& list) {
  OrderedJson info;
  info["vertices listed"] = list.vertices.size();
  info["largest number"] = list.vertices.empty() ? -1 : *std::max_element(list.vertices.begin(), list.vertices.end());
  info["values"] = rangeOf(list.values);
  return info;
}

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// A GIFTI file that lists some vertices only.
bool listsVertices(const std::string& path) {
  if (!endsWith(path, ".gii") && !endsWith(path, ".gii.gz")) return false;
  const GiftiFile file = readGifti(path);
  return std::any_of(file.arrays.begin(), file.arrays.end(),
                     [](const GiftiArray& array) { return array.intent == GiftiIntent::NodeIndex; });
}

OrderedJson giftiListInfo(const std::string& path) {
  OrderedJson info;
  for (const GiftiArray& array : readGifti(path).arrays) {
    const bool nodes = array.intent == GiftiIntent::NodeIndex;
    info[nodes ? "vertices listed" : "values"] =
        nodes ? OrderedJson(array.values.size()) : OrderedJson(rangeOf({array.values.begin(), array.values.end()}));
  }
  return info;
}

OrderedJson dataInfo(const std::string& path, const Session& session) {
  if (endsWith(path, ".nii") && isCifti(path)) return ciftiInfo(path);
  if (endsWith(path, ".label")) return sparseInfo(readLabel(path));
  if (endsWith(path, ".w")) return sparseInfo(readPaint(path));
  return listsVertices(path) ? giftiListInfo(path) : arraysInfo(path, session);
}

}  // namespace

OrderedJson volumeInfo(const std::string& path, const VolumeOption& option, const Session& session) {
  VolumeOption any = option;
  any.onlyWhatIsClear = false;
  const vtkSmartPointer<vtkImageData> volume = readVolume(path, Session{true, session.threads}, any);
  OrderedJson info;
  info["file"] = path;
  info["contents"] = "volume";
  int size[3];
  volume->GetDimensions(size);
  info["voxels"] = {size[0], size[1], size[2]};
  const double* spacing = volume->GetSpacing();
  info["voxel size"] = {spacing[0], spacing[1], spacing[2]};
  info["frames"] = static_cast<int>(numberField(volume, "Frames").value_or(1));
  info["stored as"] = textField(volume, "StoredType");
  info["values"] = rangeOf(volume->GetPointData()->GetScalars());
  info["axes"] = axisCodes(volume);
  const double* origin = volume->GetOrigin();
  for (int row = 0; row < 3; ++row) {
    OrderedJson numbers = OrderedJson::array();
    for (int k = 0; k < 3; ++k) numbers.push_back(volume->GetDirectionMatrix()->GetElement(row, k) * spacing[k]);
    numbers.push_back(origin[row]);
    info[std::string("affine ") + "xyz"[row]] = numbers;
  }
  info["space"] = textField(volume, "CoordinateSpace");
  info["space_reason"] = textField(volume, "CoordinateSpaceReason");
  auto* warnings = vtkStringArray::SafeDownCast(volume->GetFieldData()->GetAbstractArray("Warnings"));
  for (vtkIdType i = 0; warnings && i < warnings->GetNumberOfValues(); ++i) {
    info["warnings"].push_back(warnings->GetValue(i));
  }
  return info;
}

OrderedJson vertexDataInfo(const std::string& path, const Session& session) {
  OrderedJson info;
  info["file"] = path;
  info["contents"] = "per-vertex data";
  try {
    info.update(dataInfo(path, session));
  } catch (const Error& e) {
    throw Failure(FileProblem, e.what());
  }
  info["space"] = spaceOfData;
  return info;
}

OrderedJson patchInfo(const std::string& path) {
  OrderedJson info;
  info["file"] = path;
  info["contents"] = "FreeSurfer patch, whose faces are those of the surface it was cut from (--whole)";
  try {
    const PatchFile patch = readPatch(path);
    info["vertices"] = patch.vertices.size();
    info["border vertices"] = std::count(patch.border.begin(), patch.border.end(), true);
    bool flat = true;
    for (std::size_t i = 2; i < patch.points.size(); i += 3) flat = flat && patch.points[i] == 0;
    info["space"] = flat ? "unknown" : "that of the surface it was cut from";
    info["space_reason"] = flat ? "flat: every z is 0" : "a patch states none";
  } catch (const Error& e) {
    throw Failure(FileProblem, e.what());
  }
  return info;
}

void printInfo(const OrderedJson& info) {
  for (const auto& [name, value] : info.items()) {
    std::string label = name, text;
    if (name == "space_reason") continue;
    if (value.is_string()) text = value.get<std::string>();
    else if (value.is_array()) {
      for (const auto& part : value) {
        char number[40] = "";
        if (part.is_number()) std::snprintf(number, sizeof(number), "%.6g", part.get<double>());
        const bool words = part.is_string();
        text += (text.empty() ? "" : words ? ", " : "  ") + (words ? part.get<std::string>() : std::string(number));
      }
    } else text = value.dump();
    if (name == "space" && info.contains("space_reason")) {
      text += " (" + info["space_reason"].get<std::string>() + ")";
    }
    std::printf("%-18s %s\n", label.c_str(), text.c_str());
  }
}

}  // namespace authalic::cli
