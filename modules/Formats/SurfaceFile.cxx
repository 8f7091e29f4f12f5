#include "Formats/SurfaceFile.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "Core/base/Error.h"
#include "Formats/ByteCursor.h"
#include "Formats/InputFile.h"
#include "Formats/SurfaceParsers.h"

namespace authalic {

namespace {

bool contains(const FileBytes& bytes, std::string_view word) {
  const std::size_t length = bytes.size() < 2048 ? bytes.size() : 2048;
  return std::string_view(reinterpret_cast<const char*>(bytes.data()), length).find(word) !=
         std::string_view::npos;
}

FileKind recogniseMagicFfffff(const FileBytes& bytes) {
  if (bytes.size() >= 15) {
    const auto vertices = decode<std::int32_t>(bytes.data() + 3, ByteOrder::Big);
    const auto values = decode<std::int32_t>(bytes.data() + 11, ByteOrder::Big);
    const auto numbers = static_cast<std::int64_t>((bytes.size() - 15) / 4);
    const bool whole = bytes.size() % 4 == 15 % 4;
    // Divided, because the product of two counts from a file need not fit.
    if (vertices > 0 && values > 0 && whole && numbers % vertices == 0 && numbers / vertices == values) {
      return FileKind::FreeSurferMorphometry;
    }
  }
  if (bytes.size() >= 8 && bytes[3] == 0xFF) {
    return FileKind::FreeSurferPatch;
  }
  if (bytes.size() >= 9) {
    const int vertices = bytes[3] << 16 | bytes[4] << 8 | bytes[5];
    const int quads = bytes[6] << 16 | bytes[7] << 8 | bytes[8];
    if (bytes.size() >= 9 + 6ULL * vertices + 12ULL * quads && vertices > 0 && quads > 0) {
      return FileKind::FreeSurferQuads;
    }
  }
  return FileKind::FreeSurferMorphometry;
}

bool isObjName(const std::string& path) {
  const auto dot = path.find_last_of("./");
  const std::string end = dot == std::string::npos ? "" : path.substr(dot);
  return end == ".obj" || end == ".OBJ";
}

}  // namespace

FileKind recognise(const FileBytes& bytes) {
  if (bytes.size() >= 3 && bytes[0] == 0xFF && bytes[1] == 0xFF) {
    switch (bytes[2]) {
      case 0xFE:
        return FileKind::FreeSurferTriangles;
      case 0xFD:
        return FileKind::FreeSurferQuads;
      case 0xFF:
        return recogniseMagicFfffff(bytes);
      default:
        return FileKind::Other;
    }
  }
  if (bytes.size() >= 16 && bytes[0] == 'M' && bytes[1] == 'Z' && bytes[3] == 0) {
    return FileKind::Mz3;
  }
  if (contains(bytes, "<GIFTI") || contains(bytes, "<!DOCTYPE GIFTI")) {
    return FileKind::Gifti;
  }
  const auto line = ByteCursor("", bytes).line();
  const auto word = line.substr(0, line.find_first_of(" \t\r"));
  if (word == "ply") {
    return FileKind::Ply;
  }
  const bool off = word.size() >= 3 && word.size() <= 7 && word.compare(word.size() - 3, 3, "OFF") == 0;
  return off ? FileKind::Off : FileKind::Other;
}

const char* fileKindName(FileKind kind) noexcept {
  switch (kind) {
    case FileKind::FreeSurferTriangles:
      return "a FreeSurfer surface";
    case FileKind::FreeSurferQuads:
      return "a FreeSurfer quadrangle surface";
    case FileKind::FreeSurferMorphometry:
      return "a FreeSurfer morphometry file";
    case FileKind::FreeSurferPatch:
      return "a FreeSurfer patch, which has no faces of its own";
    case FileKind::Gifti:
      return "a GIFTI file";
    case FileKind::Off:
      return "an OFF file";
    case FileKind::Ply:
      return "a PLY file";
    case FileKind::Mz3:
      return "an MZ3 file";
    case FileKind::Other:
      break;
  }
  return "of none of the known kinds";
}

void checkFaceIndices(const std::string& path, const SurfaceFile& surface) {
  const auto n = static_cast<int>(surface.vertexCount());
  if (n == 0) {
    throw FormatError(path, "A surface with vertices is needed, but the file holds none.");
  }
  for (std::size_t i = 0; i < surface.faces.size(); ++i) {
    if (surface.faces[i] < 0 || surface.faces[i] >= n) {
      throw FormatError(path, "Face " + std::to_string(i / 3) + " names vertex " +
                                  std::to_string(surface.faces[i]) + ", but the file holds " +
                                  std::to_string(n) +
                                  " vertices; it is damaged or belongs to another surface.");
    }
  }
}

CoordinateSpace spaceComment(const std::string& header) {
  for (const CoordinateSpace space : {CoordinateSpace::ScannerRAS, CoordinateSpace::LPS}) {
    if (header.find(spaceComment(space)) != std::string::npos) {
      return space;
    }
  }
  return CoordinateSpace::Unknown;
}

const char* spaceComment(CoordinateSpace space) noexcept {
  switch (space) {
    case CoordinateSpace::ScannerRAS:
      return "SPACE=RAS";
    case CoordinateSpace::LPS:
      return "SPACE=LPS";
    default:
      return "";
  }
}

namespace {

/// The comment stands in the first lines.
void readSpaceComment(const FileBytes& bytes, SurfaceFile& surface) {
  constexpr std::ptrdiff_t header = 400;
  const auto length = std::min(static_cast<std::ptrdiff_t>(bytes.size()), header);
  const CoordinateSpace space = spaceComment(std::string(bytes.begin(), bytes.begin() + length));
  if (space != CoordinateSpace::Unknown) {
    surface.space = space;
    surface.spaceReason = std::string("comment ") + spaceComment(space) + " in the header";
  }
}

}  // namespace

SurfaceFile readSurface(const std::string& path) {
  const FileBytes bytes = readBytes(path);
  const FileKind kind = recognise(bytes);
  SurfaceFile surface;
  switch (kind) {
    case FileKind::FreeSurferTriangles:
      surface = parseFreeSurferTriangles(path, bytes);
      break;
    case FileKind::FreeSurferQuads:
      surface = parseFreeSurferQuads(path, bytes);
      break;
    case FileKind::Gifti:
      surface = parseGiftiSurface(path, bytes);
      break;
    case FileKind::Off:
      surface = parseOff(path, bytes);
      break;
    case FileKind::Ply:
      surface = parsePly(path, bytes);
      break;
    case FileKind::Mz3:
      surface = parseMz3Surface(path, bytes);
      break;
    case FileKind::FreeSurferPatch:
      throw FormatError(path,
                        "A surface with faces is needed, but this is a FreeSurfer patch, which takes them from the "
                        "surface it was cut from; name that surface too (--whole, WholeFileName).");
    default:
      if (kind != FileKind::Other || !isObjName(path)) {
        throw FormatError(
            path, std::string("A surface (FreeSurfer, GIFTI, MZ3, OFF, PLY or OBJ) is needed, but the file is ") +
                      fileKindName(kind) + ".");
      }
      surface = parseObj(path, bytes);
  }
  if (kind == FileKind::Off || kind == FileKind::Ply || kind == FileKind::Other) {
    readSpaceComment(bytes, surface);
  }
  checkFaceIndices(path, surface);
  return surface;
}

namespace {

/// x and y to the other side: LPS to RAS and back.
void mirrorTwice(std::vector<double>& points) {
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    points[i] = -points[i];
    points[i + 1] = -points[i + 1];
  }
}

void movePoints(const std::array<double, 16>& m, std::vector<double>& points) {
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const std::array<double, 3> p{points[i], points[i + 1], points[i + 2]};
    for (std::size_t row = 0; row < 3; ++row) {
      points[i + row] = m[4 * row] * p[0] + m[4 * row + 1] * p[1] + m[4 * row + 2] * p[2] + m[4 * row + 3];
    }
  }
}

}  // namespace

void toLps(SurfaceFile& surface) {
  if (surface.space == CoordinateSpace::ScannerRAS) {
    mirrorTwice(surface.points);
    surface.space = CoordinateSpace::LPS;
  }
}

void toScannerRas(SurfaceFile& surface, std::optional<CoordinateSpace> assume) {
  const CoordinateSpace space = assume.value_or(surface.space);
  if (space == CoordinateSpace::Unknown) {
    return;
  }
  if (space == CoordinateSpace::TkRAS || space == CoordinateSpace::Voxel) {
    if (!surface.geometry.valid) {
      throw FormatError("surface", std::string(space == CoordinateSpace::TkRAS ? "tkRAS needs" : "Voxel indices need") +
                                       " the volume geometry to become scanner RAS, but the file carries none; name "
                                       "the volume (--volume, VolumeFileName), give a file with geometry, or assert "
                                       "scanner RAS if that is what it holds.");
    }
    movePoints(space == CoordinateSpace::TkRAS ? surface.geometry.tkRasToScanner() : surface.geometry.voxelToScanner(),
               surface.points);
  }
  if (space == CoordinateSpace::LPS) {
    mirrorTwice(surface.points);
  }
  if (assume) {
    surface.spaceReason = std::string("asserted by the user as ") + coordinateSpaceName(space);
  }
  surface.space = CoordinateSpace::ScannerRAS;
}

}  // namespace authalic
