/// @file
/// What the NIfTI and MGH readers share: types of voxels and their conversion. Private to Formats/.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "Formats/ByteCursor.h"
#include "Formats/VolumeFile.h"

namespace authalic {

enum class VoxelType { None, Uint8, Int8, Int16, Uint16, Int32, Uint32, Int64, Uint64, Float32, Float64 };

[[nodiscard]] int voxelSize(VoxelType type) noexcept;

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

[[nodiscard]] VolumeFile readNifti(const std::string& path, int frame);
[[nodiscard]] VolumeFile readMgh(const std::string& path, int frame);

void writeMgh(const std::string& path, const ScalarVolume& volume);
void writeMgh(const std::string& path, const LabelVolume& volume);

/// The affine as the single-precision fields of an MGH header give it back.
[[nodiscard]] Eigen::Matrix4d mghAffine(const std::array<int, 3>& dimensions, const Eigen::Matrix4d& affine);

/// @throws FormatError unless 0 ≤ frame < frames
void checkFrame(const std::string& path, int frame, std::int64_t frames);

}  // namespace authalic
