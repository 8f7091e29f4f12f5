#include "StlReader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <string_view>
#include <unordered_map>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "Core/base/Error.h"
#include "Formats/ByteCursor.h"
#include "Formats/TextNumbers.h"

namespace authalic {

namespace {

using Corner = std::array<float, 3>;

struct CornerHash {
  std::size_t operator()(const Corner& corner) const noexcept {
    std::size_t hash = 0;
    for (const float x : corner) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &x, sizeof(bits));
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

std::vector<Corner> binaryCorners(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  ByteCursor cursor(path, bytes, ByteOrder::Little);
  cursor.seek(80);
  const auto triangles = cursor.next<std::uint32_t>("the number of triangles");
  cursor.need(triangles, 50, "the list of triangles");
  std::vector<Corner> corners;
  corners.reserve(3 * static_cast<std::size_t>(triangles));
  for (std::uint32_t t = 0; t < triangles; ++t) {
    cursor.seek(cursor.position() + 12);
    for (int k = 0; k < 3; ++k) {
      Corner& corner = corners.emplace_back();
      for (float& x : corner) {
        x = cursor.next<float>("a triangle");
      }
    }
    cursor.seek(cursor.position() + 2);
  }
  return corners;
}

/// Walks the words of a text file.
class TextReader {
 public:
  TextReader(const std::string& path, const std::vector<std::uint8_t>& bytes)
      : path_(path), rest_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

  std::vector<Corner> corners() {
    std::vector<Corner> found;
    std::size_t inLoop = 0;
    bool open = true;
    for (std::string word = next(); !word.empty(); word = next()) {
      if (word == "solid" || word == "endsolid") {
        open = word == "solid";
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));  // a name of any words
      } else if (word == "vertex") {
        found.push_back({number(), number(), number()});
        ++inLoop;
      } else if (word == "normal") {
        static_cast<void>(number() + number() + number());
      } else if (word == "outer") {
        inLoop = 0;
      } else if (word == "endloop" && inLoop != 3) {
        fail("a triangle with " + std::to_string(inLoop) + " corners");
      } else if (word != "endloop" && word != "loop" && word != "facet" && word != "endfacet") {
        fail("the word \"" + word.substr(0, 24) + "\"");
      }
    }
    if (open || found.size() % 3 != 0) {
      fail("no endsolid after the last");
    }
    return found;
  }

 private:
  /// In small letters; empty at the end.
  std::string next() {
    std::string word(nextToken(rest_));
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return word;
  }
  float number() {
    const std::string word = next();
    const auto value = parseNumber<double>(word);
    if (!value) {
      fail("\"" + word.substr(0, 24) + "\" for a number");
    }
    return static_cast<float>(*value);
  }
  [[noreturn]] void fail(std::string what) const {
    std::replace_if(
        what.begin(), what.end(), [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }, ' ');
    throw FormatError(path_, "An STL file holds triangles of three vertices, but this one has " + what +
                                 "; it is damaged or of another kind.");
  }

  const std::string& path_;
  std::string_view rest_;
};

bool isText(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() >= 84) {
    const std::uint64_t triangles = decode<std::uint32_t>(bytes.data() + 80, ByteOrder::Little);
    if (bytes.size() == 84 + 50 * triangles) {
      return false;
    }
  }
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), std::min<std::size_t>(bytes.size(), 1024));
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  std::string start(text.substr(0, 5));
  std::transform(start.begin(), start.end(), start.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return start == "solid";
}

}  // namespace

void readStl(const std::string& path, const std::vector<std::uint8_t>& bytes, vtkPolyData* output) {
  const std::vector<Corner> corners = isText(bytes) ? TextReader(path, bytes).corners() : binaryCorners(path, bytes);
  std::unordered_map<Corner, vtkIdType, CornerHash> ids;
  ids.reserve(corners.size() / 4);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (std::size_t first = 0; first < corners.size(); first += 3) {
    vtkIdType triangle[3];
    for (std::size_t k = 0; k < 3; ++k) {
      Corner corner = corners[first + k];
      for (float& x : corner) {
        x += 0.F;  // -0 and 0 are one place
      }
      const auto [entry, added] = ids.emplace(corner, points->GetNumberOfPoints());
      if (added) {
        points->InsertNextPoint(corners[first + k].data());
      }
      triangle[k] = entry->second;
    }
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
      triangles->InsertNextCell(3, triangle);
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
}

}  // namespace authalic
