/// @file
/// Files in and out, through the readers and writers of IOSurface; failures carry their exit code.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <vtkSmartPointer.h>

#include "Formats/FileContent.h"
#include "Pipeline.h"

class vtkDataObject;
class vtkImageData;
class vtkPolyData;

namespace authalic::cli {

using OrderedJson = nlohmann::ordered_json;

/// The options that say how a surface is to be read, and what they were given.
struct SpaceOption {
  std::string name = "stated";
  std::string volume;  ///< whose tkRAS or voxels the coordinates are
  std::string whole;  ///< the surface that a patch was cut from
  void declare(CLI::App* verb);
};

/// The options that say what is to be taken from a volume, and what they were given.
struct VolumeOption {
  std::string transform = "automatic";
  std::optional<int> frame;
  bool allFrames = false, keepNumbers = false;  ///< for writing the volume again
  /// Several frames, and transforms that put voxels elsewhere, are refused unless one was chosen.
  bool onlyWhatIsClear = true;
  void declareTransform(CLI::App* verb);
  void declareFrame(CLI::App* verb);
};

/// @throws Failure
vtkSmartPointer<vtkPolyData> readSurface(const std::string& path, const Session& session, const SpaceOption& space);
vtkSmartPointer<vtkImageData> readVolume(const std::string& path, const Session& session, const VolumeOption& option);

/// What a reader gave, and in words what else the file holds.
struct ReadSurface {
  vtkSmartPointer<vtkPolyData> surface;
  std::string notRead;
};
ReadSurface readWholeSurface(const std::string& path, const Session& session, const SpaceOption& space);
/// Per-vertex data added to a surface, or alone when `surface` is none.
/// @param structure  of a CIFTI file; empty = that of the surface
ReadSurface readVertexData(vtkPolyData* surface, const std::string& path, const std::string& structure,
                           const std::string& arrayName, const Session& session);

/// Adds the per-vertex data of a file; returns the name of the (first) array it became.
std::string addVertexData(vtkSmartPointer<vtkPolyData>& surface, const std::string& path, const std::string& arrayName,
                          const Session& session, const std::string& structure = "");
/// `arrayOrFile` is the name of a point or cell array that is there, or a file to add.
std::string arrayOf(vtkSmartPointer<vtkPolyData>& surface, const std::string& arrayOrFile, const Session& session);

/// Sees, before anything is computed, that every file named can be written and that no two are the same; empty names
/// are options that were not given.
/// @throws Failure
void requireWritable(const std::vector<std::string>& paths);
/// Sees that a map's file is of a format that keeps its arrays.
/// @throws Failure
void requireArrayFormat(const std::string& option, const std::string& path);
/// Sees that a folder is there, or can be made, and can be written to.
/// @throws Failure
void requireFolder(const std::string& path);

/// What kind of thing a file holds.
/// @throws Failure
[[nodiscard]] FileContent contentOfInput(const std::string& path);

/// What a format had no room for, one sentence each.
using Losses = std::vector<std::string>;

/// Whether the ending is one of per-vertex data; .mgh and .mgz are where no volume is meant.
[[nodiscard]] bool isDataFile(const std::string& path);
/// Point arrays as a file of per-vertex data when its ending says so, else the whole surface.
Losses writeSurfaceOrData(const std::string& path, vtkPolyData* surface, const std::vector<std::string>& arrays);
Losses writeVertexData(const std::string& path, vtkPolyData* surface, const std::vector<std::string>& arrays);
Losses writeSurface(const std::string& path, vtkPolyData* surface, bool lps = false);
Losses writeVolume(const std::string& path, vtkImageData* volume);
void writeText(const std::string& path, const std::string& text);
/// Indented, with a line break at the end; nothing when `path` is empty.
void writeJson(const std::string& path, const OrderedJson& json);

/// Value of a text field of the data object, or empty.
[[nodiscard]] std::string textField(vtkDataObject* object, const char* name);
/// The number of a field of the data object.
[[nodiscard]] std::optional<double> numberField(vtkDataObject* object, const char* name);
/// Every field array of the data object, names in snake_case.
[[nodiscard]] OrderedJson fieldsAsJson(vtkDataObject* object);

/// Throws a usage failure unless the surface is in scanner RAS.
void requireScannerSpace(vtkDataObject* object, const std::string& path, const std::string& remedy);

/// Rows of numbers of a text file; # starts a comment.
[[nodiscard]] std::vector<std::vector<double>> readNumbers(const std::string& path);

}  // namespace authalic::cli
