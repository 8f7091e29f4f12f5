/// @file
/// The bytes of a small NIfTI-2 file up to its voxels, for tests of the readers of volumes and CIFTI.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace authalic::testing {

/// What the tests set; voxels of 1 mm, everything else 0.
struct Nifti2Fields {
  std::int16_t datatype = 2, bitsPerVoxel = 8;
  std::array<std::int64_t, 8> dimensions{3, 2, 2, 2, 1, 1, 1, 1};
  std::int32_t qformCode = 0, intentCode = 0;
  std::int32_t extensionCode = 0;
  std::string extension;  ///< none when empty; with its 8 bytes of size and code a multiple of 16 in a legal file
};

/// Header and extension, little endian; the voxels follow at once.
inline std::vector<std::uint8_t> nifti2Bytes(const Nifti2Fields& fields) {
  const std::size_t extended = fields.extension.empty() ? 0 : 8 + fields.extension.size();
  std::vector<std::uint8_t> bytes(544 + extended, 0);
  const auto put = [&bytes](std::size_t at, auto number) { std::memcpy(bytes.data() + at, &number, sizeof(number)); };
  put(0, std::int32_t{540});
  std::memcpy(bytes.data() + 4, "n+2\0\r\n\x1A\n", 8);
  put(12, fields.datatype);
  put(14, fields.bitsPerVoxel);
  for (std::size_t axis = 0; axis < 8; ++axis) {
    put(16 + 8 * axis, fields.dimensions[axis]);
    put(104 + 8 * axis, 1.0);
  }
  put(168, static_cast<std::int64_t>(bytes.size()));
  put(344, fields.qformCode);
  put(504, fields.intentCode);
  if (extended > 0) {
    bytes[540] = 1;
    put(544, static_cast<std::int32_t>(extended));
    put(548, fields.extensionCode);
    std::memcpy(bytes.data() + 552, fields.extension.data(), fields.extension.size());
  }
  return bytes;
}

}  // namespace authalic::testing
