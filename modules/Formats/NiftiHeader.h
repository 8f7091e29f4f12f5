/// @file
/// The gate before libnifti2: everything in a NIfTI header that must hold before it is believed. Private to Formats/.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "Formats/VolumeData.h"

namespace authalic {

/// A checked header.
struct NiftiHeader {
  int version = 1;
  bool pair = false;  ///< voxels in a separate .img
  std::array<int, 3> dimensions{1, 1, 1};
  std::int64_t frames = 1;
  VoxelCoding coding;
  std::uint64_t dataOffset = 0;
  Eigen::Matrix4d voxelToWorld = Eigen::Matrix4d::Identity();
  CoordinateSpace space = CoordinateSpace::Unknown;
  std::string spaceReason;
  int transformCode = 0;
  double disagreement = 0;              ///< mm between sform and qform at the farthest corner; 0 up to 1e-3
  double timeStep = 0;                  ///< s between frames; 0 = not stated
  /// The header as NIfTI-1 in the order of this machine; empty when it does not fit.
  std::vector<std::uint8_t> asNifti1;
  std::string notes;                    ///< what it says beyond place, type and time: "description, intent"
  std::vector<std::string> warnings;
};

/// Length of the header that the first four bytes announce: 348 or 540.
/// @throws FormatError when they announce neither
[[nodiscard]] std::uint64_t niftiHeaderSize(const std::string& path,
                                            const std::vector<std::uint8_t>& firstFour);

/// The type of a NIfTI code.
/// @throws FormatError when it is complex, RGB, binary, quadruple or unknown
[[nodiscard]] VoxelType niftiVoxelType(const std::string& path, int code);

/// Checks and interprets the bytes of a header.
///
/// Rejected: a magic other than n+1, ni1, n+2, ni2 (an Analyze header, for instance); vox_offset that is not
/// finite or lies inside the header; dim[0] outside 1 to 7; a dimension below 1 or beyond 32 bits; a product
/// beyond 2^40; a type that is not read; a slope or intercept that is not finite; CIFTI; a transform that is asked for
/// and not there.
/// @throws FormatError
[[nodiscard]] NiftiHeader parseNiftiHeader(const std::string& path, const std::vector<std::uint8_t>& bytes,
                                           VolumeTransform transform);

}  // namespace authalic
