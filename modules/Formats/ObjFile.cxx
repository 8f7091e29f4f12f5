#include <climits>

#include "Core/base/Error.h"
#include "Formats/AtomicFile.h"
#include "Formats/ByteCursor.h"
#include "Formats/SurfaceParsers.h"
#include "Formats/TextNumbers.h"

namespace authalic {

namespace {

/// "7", "7/1", "7//3" or "-1" (relative to the vertices so far) → 0-based index.
std::optional<int> parseCorner(std::string_view token, std::size_t vertices) {
  const auto number = parseNumber<std::int64_t>(token.substr(0, token.find('/')));
  if (!number || *number == 0) {
    return std::nullopt;
  }
  const std::int64_t index = *number > 0 ? *number - 1 : static_cast<std::int64_t>(vertices) + *number;
  return index < 0 || index > INT_MAX ? std::nullopt : std::optional<int>(static_cast<int>(index));
}

/// Polygons become fans of triangles from their first corner.
bool parseObjFace(std::string_view rest, std::size_t vertices, std::vector<int>& faces) {
  int corners = 0;
  int first = 0;
  int previous = 0;
  for (auto token = nextToken(rest); !token.empty(); token = nextToken(rest), ++corners) {
    const auto index = parseCorner(token, vertices);
    if (!index) {
      return false;
    }
    if (corners == 0) {
      first = *index;
    } else if (corners >= 2) {
      faces.insert(faces.end(), {first, previous, *index});
    }
    previous = *index;
  }
  return corners >= 3;
}

bool parseObjVertex(std::string_view rest, std::vector<double>& points) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = parseNumber<double>(nextToken(rest));
    if (!value) {
      return false;
    }
    points.push_back(*value);
  }
  return true;
}

}  // namespace

SurfaceFile parseObj(const std::string& path, const FileBytes& bytes) {
  ByteCursor cursor(path, bytes);
  SurfaceFile surface;
  while (cursor.remaining() > 0) {
    const std::size_t start = cursor.position();
    const std::string line = cursor.line();
    std::string_view rest = line;
    const auto word = nextToken(rest);
    const bool good = word == "v"   ? parseObjVertex(rest, surface.points)
                      : word == "f" ? parseObjFace(rest, surface.points.size() / 3, surface.faces)
                                    : true;
    if (!good) {
      cursor.seek(start);
      cursor.fail(
          "A line of a Wavefront OBJ file should be \"v x y z\" or \"f a b c …\" with whole numbers from 1, "
          "but "
          "reads \"" +
          line.substr(0, 60) + "\".");
    }
    if (surface.points.size() > INT_MAX || surface.faces.size() > INT_MAX) {
      cursor.fail("The file holds more vertices or faces than 32-bit indices can count.");
    }
  }
  if (surface.points.empty()) {
    throw FormatError(
        path, "A Wavefront OBJ file with vertices (lines \"v x y z\") is needed, but this one has none.");
  }
  surface.spaceReason = "OBJ files state no space";
  return surface;
}

void writeObj(const std::string& path, const SurfaceFile& surface) {
  const std::string comment = spaceComment(surface.space);
  std::string text = comment.empty() ? "" : "# " + comment + "\n";
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    text += i % 3 == 0 ? "v " : " ";
    appendNumber(text, surface.points[i]);
    text += i % 3 == 2 ? "\n" : "";
  }
  for (std::size_t i = 0; i < surface.faces.size(); ++i) {
    text += (i % 3 == 0 ? "f " : " ") + std::to_string(surface.faces[i] + 1) + (i % 3 == 2 ? "\n" : "");
  }
  writeFileAtomically(path, text);
}

}  // namespace authalic
