/// @file
/// Volumes as they are stored: every frame, the type of the numbers, and what else the header says.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "Formats/VolumeFile.h"

namespace authalic {

enum class VoxelType { None, Uint8, Int8, Int16, Uint16, Int32, Uint32, Int64, Uint64, Float32, Float64 };

[[nodiscard]] int voxelSize(VoxelType type) noexcept;
/// "int16", "float32" …; and back, None for other words.
[[nodiscard]] const char* voxelTypeName(VoxelType type) noexcept;
[[nodiscard]] VoxelType voxelTypeNamed(const std::string& name) noexcept;

/// The numbers of a file, neither scaled nor rounded: value = slope * stored + inter.
struct StoredVolume : VolumeFacts {
  std::array<int, 3> dimensions{0, 0, 0};
  int framesHeld = 1;  ///< frames in `bytes`; `frames` counts those of the file
  Eigen::Matrix4d voxelToWorld = Eigen::Matrix4d::Identity();
  VoxelType type = VoxelType::None;
  double slope = 1;
  double inter = 0;
  std::vector<std::uint8_t> bytes;  ///< little endian, first axis fastest, frame after frame
  double timeStep = 0;              ///< s between frames, or the repetition time; 0 = not stated
  /// NIfTI: the header as NIfTI-1 (348 bytes in the order of this machine), then what lies between it and the voxels
  /// when that is a chain of extensions (little endian). MGH: what follows the voxels. Empty unless asked for.
  std::vector<std::uint8_t> niftiNotes;
  std::vector<std::uint8_t> mghNotes;

  [[nodiscard]] bool isScaled() const noexcept { return slope != 1 || inter != 0; }
  /// Whether the values are whole numbers of 32 bits as they are.
  [[nodiscard]] bool isInteger32() const;
};

/// What to take from a volume file.
struct VolumeRequest {
  int frame = 0;
  bool allFrames = false;  ///< then `frame` does not matter
  bool notes = false;      ///< niftiNotes and mghNotes
  VolumeTransform transform = VolumeTransform::Automatic;
};

/// Reads as readVolume() does, with its guarantees, but neither scales nor rounds.
/// @throws FormatError as readVolume() does
[[nodiscard]] StoredVolume readStoredVolume(const std::string& path, const VolumeRequest& request);

/// Whether a file of that name is given such numbers: MGH holds uint8, int16, int32 and float32 without scaling; its
/// uint16 is younger than many readers, so it is read but not written.
[[nodiscard]] bool holds(const std::string& path, VoxelType type, bool scaled);

/// Writes NIfTI-1 or MGH by the name, as writeVolume() does, with the notes that belong to the format.
/// @throws FormatError when a dimension exceeds 32767 (NIfTI), the file cannot be written, or not holds()
void writeStoredVolume(const std::string& path, const StoredVolume& volume);

}  // namespace authalic
