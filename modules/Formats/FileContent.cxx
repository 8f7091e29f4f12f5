#include "Formats/FileContent.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "Formats/ByteCursor.h"
#include "Formats/Cifti.h"
#include "Formats/InputFile.h"
#include "Formats/SurfaceParsers.h"

namespace authalic {

namespace {

/// Name without folder and .gz, in small letters.
std::string plainName(const std::string& path) {
  std::string name = path.substr(path.find_last_of('/') + 1);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (name.size() > 3 && name.compare(name.size() - 3, 3, ".gz") == 0) {
    name.resize(name.size() - 3);
  }
  return name;
}

template <std::size_t Count>
bool endsInOneOf(const std::string& name, const std::array<std::string_view, Count>& endings) {
  return std::any_of(endings.begin(), endings.end(), [&name](std::string_view end) {
    return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  });
}

/// A single row of voxels is one number per vertex.
FileContent contentOfImage(std::int64_t x, std::int64_t y, std::int64_t z) {
  const int wide = (x > 1 ? 1 : 0) + (y > 1 ? 1 : 0) + (z > 1 ? 1 : 0);
  return wide > 1 || x * y * z == 1 ? FileContent::Volume : FileContent::VertexData;
}

FileContent contentOfNifti(const FileBytes& bytes) {
  for (const ByteOrder order : {ByteOrder::Little, ByteOrder::Big}) {
    const auto size = decode<std::int32_t>(bytes.data(), order);
    if (size == 348 && bytes.size() >= 348) {
      const auto dim = [&](std::size_t i) { return decode<std::int16_t>(bytes.data() + 40 + 2 * i, order); };
      return contentOfImage(dim(1), dim(2), dim(3));
    }
    if (size == 540 && bytes.size() >= 540) {
      const auto dim = [&](std::size_t i) { return decode<std::int64_t>(bytes.data() + 16 + 8 * i, order); };
      return contentOfImage(dim(1), dim(2), dim(3));
    }
  }
  return FileContent::Volume;
}

FileContent contentOfMgh(const FileBytes& bytes) {
  if (bytes.size() < 16) {
    return FileContent::Volume;
  }
  const auto dim = [&](std::size_t i) { return decode<std::int32_t>(bytes.data() + 4 * i, ByteOrder::Big); };
  return contentOfImage(dim(1), dim(2), dim(3));
}

FileContent contentOfGifti(const FileBytes& bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.find("NIFTI_INTENT_POINTSET") == std::string_view::npos ? FileContent::VertexData
                                                                      : FileContent::Surface;
}

bool isNiftiHeader(const FileBytes& bytes) {
  const auto little = decode<std::int32_t>(bytes.data(), ByteOrder::Little);
  const auto big = decode<std::int32_t>(bytes.data(), ByteOrder::Big);
  return little == 348 || little == 540 || big == 348 || big == 540;
}

}  // namespace

FileContent contentOf(const std::string& path) {
  constexpr std::array<std::string_view, 3> meshes{".vtp", ".vtk", ".stl"};
  constexpr std::array<std::string_view, 3> mgh{".mgh", ".mgz", ".mgh.gz"};
  constexpr std::array<std::string_view, 3> nifti{".nii", ".hdr", ".img"};
  constexpr std::array<std::string_view, 4> lists{".annot", ".label", ".w", ".txt"};
  constexpr std::array<std::string_view, 4> numbers{".curv", ".thickness", ".sulc", ".area"};
  const std::string name = plainName(path);
  InputFile input(path);
  FileBytes bytes = input.readUpTo(540);
  if (endsInOneOf(name, meshes)) {
    return FileContent::Surface;
  }
  if (endsInOneOf(name, lists)) {
    return FileContent::VertexData;
  }
  if (bytes.size() < 4) {
    return FileContent::Surface;
  }
  if (endsInOneOf(name, nifti) || isNiftiHeader(bytes)) {
    return isCifti(path) ? FileContent::VertexData : contentOfNifti(bytes);
  }
  if (endsInOneOf(name, mgh)) {
    return contentOfMgh(bytes);
  }
  if (bytes[0] == 0xFF && bytes[1] == 0xFF) {
    bytes = readBytes(path);
  }
  switch (recognise(bytes)) {
    case FileKind::FreeSurferMorphometry:
      return FileContent::VertexData;
    case FileKind::FreeSurferPatch:
      return FileContent::Patch;
    case FileKind::Mz3:
      return (bytes[2] & 3U) == 3 ? FileContent::Surface : FileContent::VertexData;
    case FileKind::Gifti:
      return contentOfGifti(readBytes(path));
    case FileKind::Other:
      break;
    default:
      return FileContent::Surface;
  }
  if (name.find(".patch.") != std::string::npos) {
    return FileContent::Patch;
  }
  return endsInOneOf(name, numbers) ? FileContent::VertexData : FileContent::Surface;
}

}  // namespace authalic
