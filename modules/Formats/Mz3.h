/// @file
/// MZ3, the surface and overlay format of Surf Ice and niivue.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "Formats/Gifti.h"
#include "Formats/SurfaceFile.h"

namespace authalic {

/// What an MZ3 file holds; every part may be missing.
struct Mz3File {
  std::int64_t vertexCount = 0;
  std::vector<double> points;                       ///< 3n or empty
  std::vector<int> faces;                           ///< 3m or empty
  std::vector<std::array<std::uint8_t, 4>> colors;  ///< n or empty
  std::vector<std::vector<float>> layers;           ///< each n; NaN = no value; 64-bit numbers are rounded
};

/// Reads an MZ3 file, gzipped or not. Its table of colours (LUT) is passed over.
/// @throws FormatError when the file is missing, of another kind or truncated, or its overlays do not fill it
[[nodiscard]] Mz3File readMz3(const std::string& path);

/// Writes a surface with any number of overlays of 32-bit numbers, gzipped. Names of overlays, space and
/// metadata are lost; coordinates become 32-bit.
/// @throws FormatError when an overlay has not one value per vertex or the file cannot be written
void writeMz3(const std::string& path, const SurfaceFile& surface, const std::vector<NamedScalars>& layers = {});

}  // namespace authalic
