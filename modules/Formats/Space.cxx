#include "Formats/Space.h"

namespace authalic {

const char* coordinateSpaceName(CoordinateSpace space) noexcept {
  switch (space) {
    case CoordinateSpace::ScannerRAS:
      return "scanner-ras";
    case CoordinateSpace::TkRAS:
      return "tkras";
    case CoordinateSpace::LPS:
      return "lps";
    case CoordinateSpace::Voxel:
      return "voxel";
    case CoordinateSpace::Unknown:
      break;
  }
  return "unknown";
}

std::array<double, 16> VolumeGeometry::tkRasToScanner() const {
  const auto& d = directions;
  std::array<double, 16> matrix{};
  for (std::size_t row = 0; row < 3; ++row) {
    // D P⁻¹: the columns of P⁻¹ pick -xras, +zras, -yras.
    matrix[4 * row + 0] = -d[row];
    matrix[4 * row + 1] = d[6 + row];
    matrix[4 * row + 2] = -d[3 + row];
    matrix[4 * row + 3] = center[row];
  }
  matrix[15] = 1;
  return matrix;
}

std::array<double, 16> VolumeGeometry::voxelToScanner() const {
  std::array<double, 16> matrix{};
  for (std::size_t row = 0; row < 3; ++row) {
    matrix[4 * row + 3] = center[row];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      matrix[4 * row + axis] = directions[3 * axis + row] * voxelSize[axis];
      matrix[4 * row + 3] -= matrix[4 * row + axis] * dimensions[axis] / 2;
    }
  }
  matrix[15] = 1;
  return matrix;
}

}  // namespace authalic
