#include <climits>

#include "Core/base/Error.h"
#include "Formats/AtomicFile.h"
#include "Formats/ByteCursor.h"
#include "Formats/SurfaceParsers.h"
#include "Formats/TextNumbers.h"

namespace authalic {

namespace {

/// The next line that holds anything but blanks and comment.
std::string contentLine(ByteCursor& cursor, const char* what) {
  while (cursor.remaining() > 0) {
    std::string line = cursor.line();
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r\f\v") != std::string::npos) {
      return line;
    }
  }
  cursor.fail(std::string("The file ends where ") + what + " should follow; it is truncated.");
}

struct OffCounts {
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
};

/// First lines: a header such as OFF or COFF, then the counts, which may share its line.
OffCounts parseOffHeader(ByteCursor& cursor) {
  std::string line = contentLine(cursor, "the OFF header");
  std::string_view rest = line;
  const auto word = nextToken(rest);
  const auto second = std::string(nextToken(rest));
  if (word.find("4OFF") != std::string_view::npos || word.find("nOFF") != std::string_view::npos ||
      second == "BINARY") {
    cursor.fail(
        "A three-dimensional ASCII OFF file is needed, but this is a binary or higher-dimensional one.");
  }
  if (second.empty()) {
    line = contentLine(cursor, "the number of vertices and faces");
    rest = line;
  } else {
    line = second + " " + std::string(rest);
    rest = line;
  }
  const auto vertices = parseNumber<std::int64_t>(nextToken(rest));
  const auto faces = parseNumber<std::int64_t>(nextToken(rest));
  if (!vertices || !faces || *vertices < 0 || *faces < 0) {
    cursor.fail("The line after OFF should hold the number of vertices and faces, but reads \"" +
                line.substr(0, 60) + "\".");
  }
  // A vertex takes at least the six bytes "0 0 0\n", a face the four of "1 0\n".
  cursor.need(static_cast<std::uint64_t>(*vertices), 5, "the list of vertices");
  cursor.need(static_cast<std::uint64_t>(*faces), 2, "the list of faces");
  return {*vertices, *faces};
}

void parseOffVertex(ByteCursor& cursor, std::vector<double>& points) {
  const std::string line = contentLine(cursor, "a vertex");
  std::string_view rest = line;
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = parseNumber<double>(nextToken(rest));
    if (!value) {
      cursor.fail("A vertex needs three numbers, but vertex " + std::to_string(points.size() / 3) +
                  " reads \"" + line.substr(0, 60) + "\".");
    }
    points.push_back(*value);
  }
}

/// Polygons become fans of triangles from their first corner; points and edges are passed over.
void parseOffFace(ByteCursor& cursor, std::int64_t number, std::vector<int>& faces) {
  const std::string line = contentLine(cursor, "a face");
  std::string_view rest = line;
  const auto corners = parseNumber<int>(nextToken(rest));
  const auto complain = [&] {
    cursor.fail("A face needs its number of corners and as many vertex numbers, but face " +
                std::to_string(number) + " reads \"" + line.substr(0, 60) + "\".");
  };
  if (!corners || *corners < 1) {
    complain();
  }
  int first = 0;
  int previous = 0;
  for (int k = 0; k < *corners; ++k) {
    const auto vertex = parseNumber<int>(nextToken(rest));
    if (!vertex) {
      complain();
    }
    if (k == 0) {
      first = *vertex;
    } else if (k >= 2) {
      faces.insert(faces.end(), {first, previous, *vertex});
    }
    previous = *vertex;
  }
}

}  // namespace

SurfaceFile parseOff(const std::string& path, const FileBytes& bytes) {
  ByteCursor cursor(path, bytes);
  const OffCounts counts = parseOffHeader(cursor);
  if (counts.vertices > INT_MAX / 3 || counts.faces > INT_MAX / 3) {
    cursor.fail("The file claims more vertices or faces than 32-bit indices can hold.");
  }
  SurfaceFile surface;
  surface.points.reserve(static_cast<std::size_t>(3 * counts.vertices));
  surface.faces.reserve(static_cast<std::size_t>(3 * counts.faces));
  for (std::int64_t i = 0; i < counts.vertices; ++i) {
    parseOffVertex(cursor, surface.points);
  }
  for (std::int64_t i = 0; i < counts.faces; ++i) {
    parseOffFace(cursor, i, surface.faces);
  }
  surface.spaceReason = "OFF files state no space";
  return surface;
}

void writeOff(const std::string& path, const SurfaceFile& surface) {
  std::string text =
      "OFF\n" + std::to_string(surface.vertexCount()) + " " + std::to_string(surface.faceCount()) + " 0\n";
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    appendNumber(text, surface.points[i]);
    text += i % 3 == 2 ? '\n' : ' ';
  }
  for (std::size_t i = 0; i + 2 < surface.faces.size(); i += 3) {
    text += "3 " + std::to_string(surface.faces[i]) + " " + std::to_string(surface.faces[i + 1]) + " " +
            std::to_string(surface.faces[i + 2]) + "\n";
  }
  writeFileAtomically(path, text);
}

}  // namespace authalic
