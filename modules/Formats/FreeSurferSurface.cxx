#include <algorithm>
#include <array>
#include <climits>
#include <cmath>

#include "Formats/AtomicFile.h"
#include "Formats/ByteCursor.h"
#include "Formats/SurfaceParsers.h"
#include "Formats/TextNumbers.h"

namespace authalic {

namespace {

constexpr std::int32_t kTagUseRealRas = 2;
constexpr std::int32_t kTagOldGeometry = 20;

/// Whether counts at `position` are such that the vertices and faces fit into what follows.
bool countsFit(const FileBytes& bytes, std::size_t position) {
  if (position + 8 > bytes.size()) {
    return false;
  }
  const auto vertices = decode<std::int32_t>(bytes.data() + position, ByteOrder::Big);
  const auto faces = decode<std::int32_t>(bytes.data() + position + 4, ByteOrder::Big);
  return vertices > 0 && faces >= 0 &&
         12LL * (static_cast<std::int64_t>(vertices) + faces) <=
             static_cast<std::int64_t>(bytes.size() - position - 8);
}

/// Normally a comment line and an empty line stand before the counts; some writers leave out either.
void passComment(ByteCursor& cursor, const FileBytes& bytes) {
  const std::size_t start = cursor.position();
  static_cast<void>(cursor.line());
  const std::size_t afterOne = cursor.position();
  static_cast<void>(cursor.line());
  const std::size_t afterTwo = cursor.position();
  const bool emptySecond = afterTwo == afterOne + 1;
  if (!emptySecond && !countsFit(bytes, afterTwo)) {
    cursor.seek(countsFit(bytes, afterOne) ? afterOne : (countsFit(bytes, start) ? start : afterTwo));
  }
}

/// Fills up to three numbers after "=".
template <class T, std::size_t N>
bool parseTriple(std::string_view text, std::array<T, N>& out, std::size_t from = 0) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parseNumber<T>(nextToken(text));
    if (!value) {
      return false;
    }
    out[from + i] = *value;
  }
  return true;
}

bool setGeometryField(VolumeGeometry& geometry, std::string_view key, std::string_view value) {
  if (key == "volume") return parseTriple(value, geometry.dimensions);
  if (key == "voxelsize") return parseTriple(value, geometry.voxelSize);
  if (key == "xras") return parseTriple(value, geometry.directions, 0);
  if (key == "yras") return parseTriple(value, geometry.directions, 3);
  if (key == "zras") return parseTriple(value, geometry.directions, 6);
  if (key == "cras") return parseTriple(value, geometry.center);
  return key == "filename";
}

bool isUsable(const VolumeGeometry& geometry) {
  const auto finite = [](double x) { return std::isfinite(x); };
  const auto& d = geometry.directions;
  const double determinant = d[0] * (d[4] * d[8] - d[5] * d[7]) - d[1] * (d[3] * d[8] - d[5] * d[6]) +
                             d[2] * (d[3] * d[7] - d[4] * d[6]);
  return std::all_of(d.begin(), d.end(), finite) &&
         std::all_of(geometry.center.begin(), geometry.center.end(), finite) && std::abs(determinant) > 1e-6;
}

/// "valid = 1  # volume info valid" and seven more lines.
VolumeGeometry parseGeometryText(ByteCursor& cursor) {
  VolumeGeometry geometry;
  bool complete = true;
  for (int i = 0; i < 8; ++i) {
    const std::string line = cursor.line();
    complete = complete && cursor.afterLineFeed();  // else the last number may be a part of one
    const auto equals = line.find('=');
    std::string_view head = std::string_view(line).substr(0, equals);
    const auto key = nextToken(head);
    std::string_view value = equals == std::string::npos ? "" : std::string_view(line).substr(equals + 1);
    if (key == "valid") {
      geometry.valid = nextToken(value) == "1";
    } else {
      complete = setGeometryField(geometry, key, value) && complete;
      if (key == "filename") {
        geometry.fileName = std::string(nextToken(value));
      }
    }
  }
  geometry.valid = geometry.valid && complete && isUsable(geometry);
  return geometry;
}

/// Tags after the faces. A footer that cannot be followed ends the reading; the geometry is kept.
void parseFooter(ByteCursor& cursor, SurfaceFile& surface) {
  bool realRas = false;
  int others = 0;
  while (cursor.remaining() >= 4) {
    const auto tag = cursor.next<std::int32_t>("a tag");
    if (tag == kTagUseRealRas && cursor.remaining() >= 4) {
      realRas = cursor.next<std::int32_t>("useRealRAS") == 1;
    } else if (tag == kTagOldGeometry) {
      surface.geometry = parseGeometryText(cursor);
    } else if (cursor.remaining() >= 8) {
      const auto length = cursor.next<std::int64_t>("the length of a tag");
      if (length < 0 || static_cast<std::uint64_t>(length) > cursor.remaining()) {
        break;
      }
      cursor.seek(cursor.position() + static_cast<std::size_t>(length));
      ++others;
    } else {
      break;
    }
  }
  surface.notRead = others == 0 ? "" : std::to_string(others) + (others == 1 ? " tag" : " tags") + " of the footer";
  if (realRas) {
    surface.space = CoordinateSpace::ScannerRAS;
    surface.spaceReason = "FreeSurfer surface marked useRealRAS";
  } else if (surface.geometry.valid) {
    surface.space = CoordinateSpace::TkRAS;
    surface.spaceReason = "FreeSurfer surface with volume geometry (c_ras in its footer)";
  } else {
    surface.spaceReason = "FreeSurfer surface without volume geometry, so its tkRAS cannot be placed";
  }
}

}  // namespace

SurfaceFile parseFreeSurferTriangles(const std::string& path, const FileBytes& bytes) {
  ByteCursor cursor(path, bytes);
  cursor.seek(3);
  passComment(cursor, bytes);
  const auto vertices = cursor.next<std::int32_t>("the number of vertices");
  const auto faces = cursor.next<std::int32_t>("the number of faces");
  if (vertices < 1 || faces < 0 || vertices > INT_MAX / 3 || faces > INT_MAX / 3) {
    cursor.fail("The header claims " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
                " faces, which no surface has; the file is damaged.");
  }
  SurfaceFile surface;
  cursor.need(static_cast<std::uint64_t>(vertices), 12, "the list of vertices");
  surface.points.resize(3 * static_cast<std::size_t>(vertices));
  for (double& x : surface.points) {
    x = cursor.next<float>("a vertex");
  }
  cursor.need(static_cast<std::uint64_t>(faces), 12, "the list of faces");
  surface.faces.resize(3 * static_cast<std::size_t>(faces));
  for (int& index : surface.faces) {
    index = cursor.next<std::int32_t>("a face");
  }
  parseFooter(cursor, surface);
  return surface;
}

SurfaceFile parseFreeSurferQuads(const std::string& path, const FileBytes& bytes) {
  ByteCursor cursor(path, bytes);
  const bool oldLayout = cursor.next24("the magic number") == 0xFFFFFF;
  const auto vertices = static_cast<std::size_t>(cursor.next24("the number of vertices"));
  const auto quads = static_cast<std::size_t>(cursor.next24("the number of faces"));
  SurfaceFile surface;
  cursor.need(3 * vertices, oldLayout ? 2 : 4, "the list of vertices");
  surface.points.resize(3 * vertices);
  for (double& x : surface.points) {
    x = oldLayout ? cursor.next<std::int16_t>("a vertex") / 100.0 : cursor.next<float>("a vertex");
  }
  cursor.need(quads, 12, "the list of faces");
  surface.faces.reserve(6 * quads);
  for (std::size_t i = 0; i < quads; ++i) {
    std::array<int, 4> q{};
    for (int& index : q) {
      index = cursor.next24("a face");
    }
    // The diagonal alternates with the parity of the first corner.
    if (q[0] % 2 == 0) {
      surface.faces.insert(surface.faces.end(), {q[0], q[1], q[3], q[2], q[3], q[1]});
    } else {
      surface.faces.insert(surface.faces.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
    }
  }
  parseFooter(cursor, surface);
  return surface;
}

namespace {

/// Scanner RAS → tkRAS: x_tk = (D P⁻¹)⁻¹ (x - c). D may be oblique but is a rotation up to rounding of its
/// text, hence a full inverse rather than the transpose.
std::vector<double> tkRasPoints(const SurfaceFile& surface) {
  const auto m = surface.geometry.tkRasToScanner();
  const auto minor = [&m](std::size_t r, std::size_t c) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[4 * r1 + c1] * m[4 * r2 + c2] - m[4 * r1 + c2] * m[4 * r2 + c1];
  };
  const double determinant = m[0] * minor(0, 0) + m[1] * minor(0, 1) + m[2] * minor(0, 2);
  constexpr double grid = 1099511627776.0;  // 2^40 per mm
  std::vector<double> points(surface.points.size());
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    for (std::size_t row = 0; row < 3; ++row) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += minor(k, row) * (surface.points[i + k] - m[4 * k + 3]);
      }
      // The change of space leaves noise of 1e-14 mm, which would show where the coordinate was 0.
      points[i + row] = std::round(sum / determinant * grid) / grid + 0.0;  // and no -0
    }
  }
  return points;
}

void encodeText(FileBytes& bytes, const std::string& text) {
  bytes.insert(bytes.end(), text.begin(), text.end());
}

template <class Numbers>
void appendLine(std::string& text, const char* key, const Numbers& numbers, std::size_t from = 0) {
  text += key;
  for (std::size_t i = from; i < from + 3; ++i) {
    text += ' ';
    appendNumber(text, numbers[i]);
  }
  text += '\n';
}

std::string geometryText(const VolumeGeometry& g) {
  std::string text = "valid = 1  # volume info valid\nfilename = ";
  text += (g.fileName.empty() ? "unknown.mgz" : g.fileName.substr(0, 255)) + "\n";
  appendLine(text, "volume =", g.dimensions);
  appendLine(text, "voxelsize =", g.voxelSize);
  appendLine(text, "xras   =", g.directions, 0);
  appendLine(text, "yras   =", g.directions, 3);
  appendLine(text, "zras   =", g.directions, 6);
  appendLine(text, "cras   =", g.center);
  return text;
}

}  // namespace

void toTkRas(SurfaceFile& surface) {
  if (surface.space == CoordinateSpace::ScannerRAS && surface.geometry.valid) {
    surface.points = tkRasPoints(surface);
    surface.space = CoordinateSpace::TkRAS;
  }
}

void writeFreeSurferSurface(const std::string& path, const SurfaceFile& original) {
  SurfaceFile surface = original;
  if (surface.space == CoordinateSpace::LPS) {
    toScannerRas(surface);
  }
  const bool geometry = surface.geometry.valid && surface.space != CoordinateSpace::Unknown;
  const bool convert = geometry && surface.space == CoordinateSpace::ScannerRAS;
  const std::vector<double> points = convert ? tkRasPoints(surface) : surface.points;
  FileBytes bytes;
  bytes.reserve(64 + 4 * (surface.points.size() + surface.faces.size()));
  encodeText(bytes,
             "\xFF\xFF\xFE"
             "created by Authalic\n\n");
  encode(bytes, static_cast<std::int32_t>(surface.vertexCount()), ByteOrder::Big);
  encode(bytes, static_cast<std::int32_t>(surface.faceCount()), ByteOrder::Big);
  for (const double x : points) {
    encode(bytes, static_cast<float>(x), ByteOrder::Big);
  }
  for (const int index : surface.faces) {
    encode(bytes, static_cast<std::int32_t>(index), ByteOrder::Big);
  }
  const bool realRas = surface.space == CoordinateSpace::ScannerRAS && !geometry;
  encode(bytes, kTagUseRealRas, ByteOrder::Big);
  encode(bytes, static_cast<std::int32_t>(realRas ? 1 : 0), ByteOrder::Big);
  if (geometry) {
    encode(bytes, kTagOldGeometry, ByteOrder::Big);
    encodeText(bytes, geometryText(surface.geometry));
  }
  writeFileAtomically(path, bytes);
}

}  // namespace authalic
