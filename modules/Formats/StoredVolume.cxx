#include "Formats/StoredVolume.h"

#include <algorithm>

#include "Core/base/Error.h"
#include "Formats/InputFile.h"
#include "Formats/VolumeData.h"

namespace authalic {

namespace {

struct TypeRow {
  VoxelType type;
  const char* name;
  int size;
};

constexpr std::array<TypeRow, 11> kTypes{{{VoxelType::None, "none", 0},
                                          {VoxelType::Uint8, "uint8", 1},
                                          {VoxelType::Int8, "int8", 1},
                                          {VoxelType::Int16, "int16", 2},
                                          {VoxelType::Uint16, "uint16", 2},
                                          {VoxelType::Int32, "int32", 4},
                                          {VoxelType::Uint32, "uint32", 4},
                                          {VoxelType::Int64, "int64", 8},
                                          {VoxelType::Uint64, "uint64", 8},
                                          {VoxelType::Float32, "float32", 4},
                                          {VoxelType::Float64, "float64", 8}}};

}  // namespace

int voxelSize(VoxelType type) noexcept { return kTypes[static_cast<std::size_t>(type)].size; }

const char* voxelTypeName(VoxelType type) noexcept { return kTypes[static_cast<std::size_t>(type)].name; }

VoxelType voxelTypeNamed(const std::string& name) noexcept {
  const auto* row = std::find_if(kTypes.begin(), kTypes.end(), [&name](const TypeRow& r) { return name == r.name; });
  return row == kTypes.end() ? VoxelType::None : row->type;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() || word.empty() ? "" : ", ") + word;
  }
  return text;
}

void turnRound(std::vector<std::uint8_t>& bytes, VoxelType type) {
  const int size = voxelSize(type);
  for (auto number = bytes.begin(); size > 1 && number != bytes.end(); number += size) {
    std::reverse(number, number + size);
  }
}

StoredVolume readStoredVolume(const std::string& path, const VolumeRequest& request) {
  bool mgh = isMghName(path);
  if (!mgh && !isNiftiName(path)) {
    const auto start = InputFile(path).read(4, "the header of a volume");
    mgh = decode<std::int32_t>(start.data(), ByteOrder::Big) == 1;
  }
  if (mgh && request.transform != VolumeTransform::Automatic) {
    throw FormatError(path, "A NIfTI file is needed to choose between sform and qform, but this one is MGH, which has "
                            "one transform; leave the choice out.");
  }
  return mgh ? readMgh(path, request) : readNifti(path, request);
}

bool holds(const std::string& path, VoxelType type, bool scaled) {
  if (!isMghName(path)) {
    return type != VoxelType::None;
  }
  constexpr std::array<VoxelType, 4> known{VoxelType::Uint8, VoxelType::Int16, VoxelType::Int32, VoxelType::Float32};
  return !scaled && std::find(known.begin(), known.end(), type) != known.end();
}

void writeStoredVolume(const std::string& path, const StoredVolume& volume) {
  if (!holds(path, volume.type, volume.isScaled())) {
    throw FormatError(path, std::string("Numbers that the format holds are needed, but they are ") +
                                voxelTypeName(volume.type) + (volume.isScaled() ? " with scaling" : "") +
                                "; write .nii or .nii.gz, or convert them to float32.");
  }
  isMghName(path) ? writeMgh(path, volume) : writeNifti(path, volume);
}

}  // namespace authalic
