/// @file
/// What the NIfTI and MGH readers share: types of voxels and their conversion. Private to Formats/.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "Formats/ByteCursor.h"
#include "Formats/StoredVolume.h"

namespace authalic {

/// How stored numbers become values: value = slope * stored + inter.
struct VoxelCoding {
  VoxelType type = VoxelType::None;
  ByteOrder order = ByteOrder::Little;
  double slope = 1;
  double inter = 0;
};

/// "int16", "uint8 with scaling" …
[[nodiscard]] std::string codingName(const VoxelCoding& coding);

/// Converts bytes to a volume, a LabelVolume when that is exact.
[[nodiscard]] std::variant<ScalarVolume, LabelVolume> decodeVoxels(const std::vector<std::uint8_t>& bytes,
                                                                   const VoxelCoding& coding,
                                                                   const std::array<int, 3>& dimensions,
                                                                   const Eigen::Matrix4d& voxelToWorld);

[[nodiscard]] StoredVolume readNifti(const std::string& path, const VolumeRequest& request);
[[nodiscard]] StoredVolume readMgh(const std::string& path, const VolumeRequest& request);

void writeNifti(const std::string& path, const StoredVolume& volume);
void writeMgh(const std::string& path, const StoredVolume& volume);

/// Turns the bytes of each number round: big endian becomes little endian and back.
void turnRound(std::vector<std::uint8_t>& bytes, VoxelType type);

/// "a, b" of the words that are not empty.
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

/// The affine as the single-precision fields of an MGH header give it back.
[[nodiscard]] Eigen::Matrix4d mghAffine(const std::array<int, 3>& dimensions, const Eigen::Matrix4d& affine);

/// @throws FormatError unless 0 ≤ frame < frames
void checkFrame(const std::string& path, int frame, std::int64_t frames);

}  // namespace authalic
