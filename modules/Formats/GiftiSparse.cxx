#include <algorithm>
#include <limits>

#include "Core/base/Error.h"
#include "Formats/Gifti.h"

namespace authalic {

namespace {

bool isFlat(const GiftiArray& array) {
  return array.dimensions.size() == 1 || (array.dimensions.size() == 2 && array.dimensions[1] == 1);
}

/// Each index checked to be a vertex, and no vertex named twice.
std::vector<std::size_t> checkedIndices(const std::string& path, const GiftiArray& nodes, std::size_t vertexCount) {
  std::vector<std::size_t> indices;
  std::vector<bool> seen(vertexCount, false);
  for (const double number : nodes.values) {
    const bool valid = number >= 0 && number < static_cast<double>(vertexCount);
    const auto index = valid ? static_cast<std::size_t>(number) : 0;
    if (!valid || static_cast<double>(index) != number || seen[index]) {
      throw FormatError(path, "NODE_INDEX should list vertices of the surface (0 to " +
                                  std::to_string(vertexCount - 1) + "), each once, but lists " +
                                  std::to_string(number) + (valid ? " twice" : "") +
                                  "; the file is damaged or belongs to another surface.");
    }
    seen[index] = true;
    indices.push_back(index);
  }
  return indices;
}

}  // namespace

void spreadNodeIndex(const std::string& path, GiftiFile& file, std::size_t vertexCount) {
  const auto found = std::find_if(file.arrays.begin(), file.arrays.end(),
                                  [](const GiftiArray& a) { return a.intent == GiftiIntent::NodeIndex; });
  if (found == file.arrays.end()) {
    return;
  }
  if (vertexCount == 0) {
    throw FormatError(path, "One value per vertex is needed, but this file lists values for some vertices only "
                            "(NODE_INDEX); give the surface it belongs to.");
  }
  const auto indices = checkedIndices(path, *found, vertexCount);
  file.arrays.erase(found);
  for (GiftiArray& array : file.arrays) {
    if (!isFlat(array)) {
      continue;
    }
    if (array.values.size() != indices.size()) {
      throw FormatError(path, "NODE_INDEX lists " + std::to_string(indices.size()) + " vertices, but an array holds " +
                                  std::to_string(array.values.size()) + " values; the file is damaged.");
    }
    const double none = array.intent == GiftiIntent::Label ? -1 : std::numeric_limits<double>::quiet_NaN();
    std::vector<double> dense(vertexCount, none);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      dense[indices[i]] = array.values[i];
    }
    array.values = std::move(dense);
    array.dimensions = {static_cast<std::int64_t>(vertexCount)};
  }
}

}  // namespace authalic
