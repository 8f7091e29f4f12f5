#include "Formats/FreeSurferPatch.h"

#include <algorithm>
#include <climits>
#include <unordered_map>

#include "Formats/AtomicFile.h"
#include "Formats/ByteCursor.h"
#include "Formats/InputFile.h"
#include "Formats/SurfaceParsers.h"

namespace authalic {

namespace {

/// ±(vertex + 1), negative on the border.
void readVertex(ByteCursor& cursor, PatchFile& patch) {
  const auto number = cursor.next<std::int32_t>("a vertex");
  if (number == 0 || number == INT_MIN) {
    cursor.fail("A patch numbers its vertices from 1 (from -1 on its border), but entry " +
                std::to_string(patch.vertices.size()) + " has " + std::to_string(number) +
                "; this is not a FreeSurfer patch or is damaged.");
  }
  patch.border.push_back(number < 0);
  patch.vertices.push_back(number < 0 ? -number - 1 : number - 1);
}

PatchFile parsePatch(const std::string& path, const FileBytes& bytes) {
  ByteCursor cursor(path, bytes);
  const auto first = cursor.next<std::int32_t>("the number of vertices");
  const bool oldLayout = first >= 0;
  const auto count = oldLayout ? first : cursor.next<std::int32_t>("the number of vertices");
  if (first < -1 || count < 1) {
    cursor.fail("The header claims " + std::to_string(count) + " vertices; this is not a FreeSurfer patch.");
  }
  const auto n = static_cast<std::size_t>(count);
  cursor.need(n, oldLayout ? 10 : 16, "the list of vertices");
  PatchFile patch;
  patch.vertices.reserve(n);
  patch.points.reserve(3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    readVertex(cursor, patch);
    for (int axis = 0; axis < 3; ++axis) {
      patch.points.push_back(oldLayout ? cursor.next<std::int16_t>("a vertex") / 100.0
                                       : cursor.next<float>("a vertex"));
    }
  }
  return patch;
}

void requireEachOnce(const std::string& path, const std::vector<int>& vertices) {
  std::vector<int> sorted = vertices;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    throw FormatError(path, "A patch has each vertex once, but vertex " + std::to_string(*twice) +
                                " comes twice; a surface torn along seams is no patch.");
  }
}

}  // namespace

PatchFile readPatch(const std::string& path) {
  const FileBytes bytes = readBytes(path);
  const FileKind kind = recognise(bytes);
  if (kind != FileKind::FreeSurferPatch && kind != FileKind::Other) {
    throw FormatError(path, std::string("A patch is needed, but the file is ") + fileKindName(kind) + ".");
  }
  PatchFile patch = parsePatch(path, bytes);
  requireEachOnce(path, patch.vertices);
  return patch;
}

SurfaceFile patchSurface(const std::string& path, const PatchFile& patch, const SurfaceFile& whole) {
  std::unordered_map<int, int> place;
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    if (static_cast<std::size_t>(patch.vertices[i]) >= whole.vertexCount()) {
      throw FormatError(path, "The patch names vertex " + std::to_string(patch.vertices[i]) +
                                  ", but its surface has " + std::to_string(whole.vertexCount()) +
                                  " vertices; give the surface that it was cut from.");
    }
    place.emplace(patch.vertices[i], static_cast<int>(i));
  }
  SurfaceFile surface;
  surface.points = patch.points;
  surface.metadata = whole.metadata;
  for (std::size_t f = 0; f + 2 < whole.faces.size(); f += 3) {
    const auto a = place.find(whole.faces[f]), b = place.find(whole.faces[f + 1]),
               c = place.find(whole.faces[f + 2]);
    if (a != place.end() && b != place.end() && c != place.end()) {
      surface.faces.insert(surface.faces.end(), {a->second, b->second, c->second});
    }
  }
  bool flat = true;
  for (std::size_t i = 2; i < surface.points.size(); i += 3) {
    flat = flat && surface.points[i] == 0;
  }
  if (flat) {
    surface.metadata["GeometricType"] = "Flat";
    surface.spaceReason = "flat FreeSurfer patch, which lies in no anatomical space";
  } else {
    surface.space = whole.space;
    surface.geometry = whole.geometry;
    surface.spaceReason = "FreeSurfer patch, in the space of the surface it was cut from: " + whole.spaceReason;
  }
  return surface;
}

void writePatch(const std::string& path, const PatchFile& patch) {
  requireEachOnce(path, patch.vertices);
  FileBytes bytes;
  bytes.reserve(8 + 16 * patch.vertices.size());
  encode(bytes, std::int32_t{-1}, ByteOrder::Big);
  encode(bytes, static_cast<std::int32_t>(patch.vertices.size()), ByteOrder::Big);
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    const std::int32_t number = patch.vertices[i] + 1;
    encode(bytes, patch.border[i] ? -number : number, ByteOrder::Big);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      encode(bytes, static_cast<float>(patch.points[3 * i + axis]), ByteOrder::Big);
    }
  }
  writeFileAtomically(path, bytes);
}

}  // namespace authalic
