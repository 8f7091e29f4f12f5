/// @file
/// Coordinate spaces of surfaces and the full tkRAS formula.
#pragma once

#include <array>
#include <string>

namespace authalic {

/// Where coordinates live. Everything inside Authalic is ScannerRAS in mm.
enum class CoordinateSpace {
  Unknown,     ///< the file does not say; sampling a volume is refused unless the caller asserts a space
  ScannerRAS,  ///< millimetres; x right, y anterior, z superior
  TkRAS,       ///< FreeSurfer "surface RAS"; needs the volume geometry to become ScannerRAS
  LPS,         ///< scanner millimetres with x to the left and y to the back, as ITK and 3D Slicer write
  Voxel,       ///< indices of a volume, whole numbers at the middles of voxels; needs the volume geometry
};

/// "unknown", "scanner-ras", "tkras", "lps", "voxel".
[[nodiscard]] const char* coordinateSpaceName(CoordinateSpace space) noexcept;

/// FreeSurfer's volume geometry: the footer of a surface, VolGeom of GIFTI, the header of MGH.
struct VolumeGeometry {
  bool valid = false;
  std::array<int, 3> dimensions{0, 0, 0};
  std::array<double, 3> voxelSize{1, 1, 1};   ///< mm
  std::array<double, 9> directions{-1, 0, 0, 0, 0, -1, 0, 1, 0};  ///< xras, yras, zras, three numbers each
  std::array<double, 3> center{0, 0, 0};      ///< c_ras, mm
  std::string fileName;

  /// Row-major 4×4 that takes tkRAS to scanner RAS: x_scanner = D P⁻¹ x_tk + c_ras, D = [xras yras zras]
  /// as columns, P⁻¹ = [[-1,0,0],[0,0,-1],[0,1,0]]. Correct for oblique volumes, where adding c_ras is not.
  [[nodiscard]] std::array<double, 16> tkRasToScanner() const;
  /// Row-major 4×4 that takes voxel indices to scanner RAS: x_scanner = D S (x_voxel − n/2) + c_ras, S the voxel sizes
  /// and n the dimensions.
  [[nodiscard]] std::array<double, 16> voxelToScanner() const;
};

}  // namespace authalic
