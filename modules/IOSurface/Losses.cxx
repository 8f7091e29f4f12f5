#include "Losses.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "FieldArrays.h"
#include "FileNames.h"
#include "Formats/StoredVolume.h"
#include "SurfaceConversion.h"
#include "VolumeValues.h"

namespace authalic {

namespace {

constexpr std::size_t kNiftiHeaderSize = 348;

/// What a format of surfaces keeps.
struct SurfaceRoom {
  bool arrays = false;       ///< every array
  bool overlays = false;     ///< point arrays of one component
  bool space = false;        ///< says that coordinates are scanner RAS
  bool geometry = false;     ///< of the volume
  bool metadata = false;     ///< structure and kind of surface
  bool doubles = false;      ///< all digits of the coordinates
  bool tkRas = false;        ///< coordinates are stored in tkRAS when the geometry is known
};

SurfaceRoom roomOf(const std::string& path) {
  const std::string extension = extensionOf(path);
  if (isPatchName(path)) {
    return {false, false, true, true, true, false, true};  // all but the points are those of the whole surface
  }
  if (extension == ".vtp" || extension == ".vtk") {
    return {true, true, true, true, true, true, false};
  }
  if (extension == ".gii") {
    return {false, false, true, true, true, false, false};
  }
  if (extension == ".ply" || extension == ".obj") {
    return {false, false, true, false, false, true, false};
  }
  if (extension == ".off") {
    return {false, false, false, false, false, true, false};
  }
  if (extension == ".stl") {
    return {false, false, true, false, false, false, false};
  }
  if (extension == ".mz3") {
    return {false, true, false, false, false, false, false};
  }
  return {false, false, true, true, false, false, true};
}

std::string shortest(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2g", value);
  return text;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

/// Arrays the file does not get. What a patch's numbering keeps is no loss.
std::vector<std::string> arraysLeftOut(const std::string& path, vtkPolyData* surface, const SurfaceRoom& room) {
  std::vector<std::string> names;
  if (room.arrays) {
    return names;
  }
  vtkPointData* points = surface->GetPointData();
  for (int i = 0; i < points->GetNumberOfArrays(); ++i) {
    vtkAbstractArray* array = points->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "(no name)";
    const bool numbering = isPatchName(path) && (name == "OriginalPointIds" || name == "PatchBorder");
    if (!numbering && !(room.overlays && points->GetArray(i) && array->GetNumberOfComponents() == 1)) {
      names.push_back(name);
    }
  }
  vtkCellData* cells = surface->GetCellData();
  for (int i = 0; i < cells->GetNumberOfArrays(); ++i) {
    names.emplace_back(cells->GetArrayName(i) ? cells->GetArrayName(i) : "(no name)");
  }
  return names;
}

std::vector<std::string> overlayNames(vtkPolyData* surface) {
  std::vector<std::string> names;
  for (int i = 0; i < surface->GetPointData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = surface->GetPointData()->GetArray(i);
    if (array && array->GetNumberOfComponents() == 1 && array->GetName()) {
      names.emplace_back(array->GetName());
    }
  }
  return names;
}

double coordinateRounding(vtkPolyData* surface, const SurfaceRoom& room) {
  if (room.doubles) {
    return 0;
  }
  SurfaceFile file = spaceFields(surface);
  copyPoints(surface, file);
  if (room.tkRas) {
    toTkRas(file);
  }
  double worst = 0, largest = 0;
  for (const double x : file.points) {
    worst = std::max(worst, std::abs(x - static_cast<double>(static_cast<float>(x))));
    largest = std::max(largest, std::abs(x));
  }
  return worst > 1e-12 * largest ? worst : 0;  // what is smaller comes from the change of space and rounds back
}

double valueRounding(vtkDataArray* array) {
  double worst = 0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    const double value = array->GetComponent(i, 0);
    const double error = std::abs(value - static_cast<double>(static_cast<float>(value)));
    worst = error > worst ? error : worst;
  }
  return worst;
}

void sayRounding(std::vector<std::string>& losses, const std::string& what, double error, const char* unit) {
  if (error > 0) {
    losses.push_back(what + " are rounded to 32 bits, by up to " + shortest(error) + unit + ".");
  }
}

void sayOverlayLosses(std::vector<std::string>& losses, vtkPolyData* surface) {
  const std::vector<std::string> names = overlayNames(surface);
  if (!names.empty()) {
    losses.push_back("Names of overlays are not kept: " + joined(names) + ".");
  }
  for (const std::string& name : names) {
    sayRounding(losses, "Values of " + name, valueRounding(surface->GetPointData()->GetArray(name.c_str())), "");
    if (!toRegions(surface, name).empty()) {
      losses.push_back("Names and colours of the regions of " + name + " are not kept.");
    }
  }
}

void sayStructureLost(std::vector<std::string>& losses, vtkPolyData* surface) {
  const std::string structure = textField(surface, "AnatomicalStructurePrimary");
  if (!structure.empty()) {
    losses.push_back("The structure is not kept: " + structure + ".");
  }
}

/// -1 has no counterpart in a GIFTI table.
void sayUnlabelled(std::vector<std::string>& losses, vtkDataArray* array) {
  const std::vector<int> labels = toIntegers(array);
  const auto none = std::count(labels.begin(), labels.end(), -1);
  if (none > 0) {
    losses.push_back(std::to_string(none) + " vertices without region (-1) become label 0.");
  }
}

void sayTableLosses(std::vector<std::string>& losses, const std::string& path, vtkPolyData* surface,
                    const std::string& name) {
  vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
  const bool regions = !toRegions(surface, name).empty();
  const std::string extension = extensionOf(path);
  const bool labels = path.size() > 10 && path.compare(path.size() - 10, 10, ".label.gii") == 0;
  if (labels) {
    sayUnlabelled(losses, array);
  }
  if ((labels || extension == ".annot") && !regions) {
    losses.push_back("The array " + name +
                     " has no table of regions; names and colours were made up from its numbers.");
  }
  if (!labels && extension != ".annot" && regions) {
    losses.push_back("Names and colours of the regions of " + name + " are not kept.");
  }
}

}  // namespace

std::vector<std::string> surfaceLosses(const std::string& path, vtkPolyData* surface) {
  const SurfaceRoom room = roomOf(path);
  const SurfaceFile fields = spaceFields(surface);
  std::vector<std::string> losses;
  const auto arrays = arraysLeftOut(path, surface, room);
  if (!arrays.empty()) {
    losses.push_back("Arrays are not kept: " + joined(arrays) + ".");
  }
  if (room.overlays && !room.arrays) {
    sayOverlayLosses(losses, surface);
  }
  if (!room.space && fields.space != CoordinateSpace::Unknown) {
    losses.push_back(std::string("The file does not say that its coordinates are ") +
                     coordinateSpaceName(fields.space) + ".");
  }
  if (!room.geometry && fields.geometry.valid) {
    losses.emplace_back("The volume geometry, and with it the way back to FreeSurfer's tkRAS, is not kept.");
  }
  std::vector<std::string> names;
  for (const auto& entry : fields.metadata) {
    names.push_back(entry.first);
  }
  if (!room.metadata && !names.empty()) {
    losses.push_back("Metadata are not kept: " + joined(names) + ".");
  }
  sayRounding(losses, "Coordinates", coordinateRounding(surface, room), " mm");
  if (extensionOf(path) == ".stl") {
    losses.emplace_back("The order of the vertices is not kept: STL holds faces by their corners.");
  }
  return losses;
}

std::vector<std::string> vertexDataLosses(const std::string& path, vtkPolyData* surface,
                                          const std::vector<std::string>& arrays) {
  std::vector<std::string> losses;
  const std::string extension = extensionOf(path);
  const bool metrics = extension == ".gii" && path.find(".label.gii") == std::string::npos;
  for (const std::string& name : arrays) {
    vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
    if (!metrics && arrayNameOf(path) != name) {
      losses.push_back("The name of the array is not kept: " + name + " (readers take it from the file's name).");
    }
    sayTableLosses(losses, path, surface, name);
    if (extension != ".annot" && extension != ".txt" && extension != ".label") {
      sayRounding(losses, "Values of " + name, valueRounding(array), "");
    }
  }
  if (extension != ".gii") {
    sayStructureLost(losses, surface);
  }
  return losses;
}

namespace {

/// What the header of the source says that a file of that name does not.
std::string notesLost(const std::string& path, vtkImageData* volume, const StoredVolume& written) {
  const std::string notRead = textField(volume, "NotRead");
  if (isMghName(path) ? !written.mghNotes.empty() : written.niftiNotes.size() > kNiftiHeaderSize) {
    return "";
  }
  if (!isMghName(path) && !written.niftiNotes.empty()) {  // all but what lies before the voxels
    return notRead.find("extensions") == std::string::npos ? "" : "extensions";
  }
  return notRead;
}

void sayPlaceLosses(std::vector<std::string>& losses, const std::string& path, vtkImageData* volume) {
  const Eigen::Matrix4d affine = affineOf(volume);
  std::array<int, 3> dimensions{};
  volume->GetDimensions(dimensions.data());
  const Eigen::Matrix4d stored = storedAffine(path, dimensions, affine);
  const Eigen::Vector4d far(dimensions[0] - 1, dimensions[1] - 1, dimensions[2] - 1, 1);
  const double moved = ((stored - affine).cwiseAbs() * far).head<3>().norm();
  constexpr double noise = 1e-9;
  sayRounding(losses, "Numbers of the affine", moved > noise ? moved : 0, " mm at the far corner");
  const int code = static_cast<int>(numberField(volume, "TransformCode", 1));
  if (code > 1 && !isNiftiName(path)) {
    losses.push_back(std::string("The file does not say that its space is ") + transformCodeName(code) + ".");
  }
  const double disagreement = numberField(volume, "TransformDisagreement", 0);
  if (disagreement > 0) {
    const bool sform = textField(volume, "CoordinateSpaceReason").rfind("NIfTI sform", 0) == 0;
    losses.push_back(std::string("The ") + (sform ? "qform" : "sform") + ", which puts voxels up to " +
                     shortest(disagreement) + " mm elsewhere, is not kept.");
  }
}

}  // namespace

std::vector<std::string> volumeLosses(const std::string& path, vtkImageData* volume, const VolumeToWrite& written) {
  std::vector<std::string> losses;
  sayRounding(losses, "Values", written.rounding, "");
  sayPlaceLosses(losses, path, volume);
  const std::string notes = notesLost(path, volume, written.volume);
  if (!notes.empty()) {
    losses.push_back("Parts of the header are not kept: " + notes + ".");
  }
  return losses;
}

}  // namespace authalic
