/// @file
/// Volumes in files: NIfTI-1, NIfTI-2 and MGH.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "Core/imaging/Volume.h"
#include "Formats/Space.h"

namespace authalic {

/// Which transform of a NIfTI file places its voxels.
enum class VolumeTransform {
  Automatic,  ///< the sform if its code is above 0, else the qform, else the voxel sizes alone
  Sform,
  Qform,
};

/// What a volume file says beside its numbers.
struct VolumeFacts {
  int frames = 1;  ///< in the file
  CoordinateSpace space =
      CoordinateSpace::Unknown;  ///< ScannerRAS, or Unknown when the file does not orient itself
  std::string spaceReason;
  int transformCode = 1;    ///< NIfTI's: 1 scanner, 2 aligned, 3 Talairach, 4 MNI 152, 5 template; 0 unknown
  double disagreement = 0;  ///< mm between where sform and qform put the farthest corner; 0 up to 1e-3
  std::string storedType;   ///< "int16", "float32", "uint8 with scaling" …
  std::string notRead;      ///< what else is in the file: "description, extensions"; empty when there is nothing
  std::vector<std::string> warnings;  ///< sform and qform disagree, no units, …
};

/// One frame of a volume file, values scaled, with its place in space.
struct VolumeFile : VolumeFacts {
  /// Whole numbers without scaling stay exact as a LabelVolume when each fits 32 bits; everything else is
  /// 32-bit floating point, NaN kept. StoredVolume.h gives the numbers as they are.
  std::variant<ScalarVolume, LabelVolume> volume;

  [[nodiscard]] bool isInteger() const noexcept { return std::holds_alternative<LabelVolume>(volume); }
  [[nodiscard]] const std::array<int, 3>& dimensions() const;
  /// Voxel centre (i, j, k, 1) → scanner RAS mm.
  [[nodiscard]] const Eigen::Matrix4d& voxelToWorld() const;
  /// The values as 32-bit floating point; whole numbers beyond 2^24 are rounded.
  [[nodiscard]] ScalarVolume scalars() const;
  /// The values as whole numbers.
  /// @throws FormatError when one is not a whole number of 32 bits, naming its voxel and `path`
  [[nodiscard]] LabelVolume labels(const std::string& path = "volume") const;
};

/// Reads one frame of a NIfTI-1 or NIfTI-2 file (.nii, .hdr/.img, either gzipped) or of an .mgh/.mgz.
///
/// NIfTI: affine from the sform if its code is > 0, else the qform, else the voxel sizes alone (space Unknown), unless
/// `transform` names one; a non-finite or singular one is passed over with a warning, and a disagreement of both of
/// more than 1e-3 mm is a warning. Units of length are converted to mm; scl_slope and scl_inter are applied, slope
/// 0 meaning none. Orientation is interpreted by libnifti2; voxels are read here, because libnifti2 turns NaN
/// into 0. MGH: affine from the direction cosines and the centre at dims/2; without goodRAS FreeSurfer's
/// coronal default, space Unknown.
///
/// Memory grows with the data that are really there, never with what a header claims.
/// @param frame  0-based among the third and higher dimensions
/// @throws FormatError when the file is missing, of another kind, truncated, compressed data are damaged, the header
///         contradicts itself, the frame or the transform asked for is not there, or the type is RGB, complex, binary
///         or quadruple
[[nodiscard]] VolumeFile readVolume(const std::string& path, int frame = 0,
                                    VolumeTransform transform = VolumeTransform::Automatic);

/// The geometry of a volume for a surface in its tkRAS or in its voxels (VolumeGeometry), with the name of the file.
/// @throws FormatError when it cannot be read, its space is unknown, or its sform and qform put voxels over half a
///         voxel apart
[[nodiscard]] VolumeGeometry readVolumeGeometry(const std::string& path);

/// A name that ends in .mgh or .mgz (gzipped): MGH, float32 or int32, goodRAS set, the axes as direction cosines.
/// Any other: NIfTI-1, gzipped when the name ends in .gz; float32 or int32; sform, and qform when the axes are
/// orthogonal, both with `transformCode`. Affines become 32-bit. Written whole or not at all.
/// @throws FormatError when a dimension exceeds 32767 (NIfTI) or the file cannot be written
void writeVolume(const std::string& path, const ScalarVolume& volume, int transformCode = 1);
void writeVolume(const std::string& path, const LabelVolume& volume, int transformCode = 1);

/// The affine that a reader gets back from a file of that name.
[[nodiscard]] Eigen::Matrix4d storedAffine(const std::string& path, const std::array<int, 3>& dimensions,
                                           const Eigen::Matrix4d& affine);
/// Whether the name is that of a NIfTI file: .nii, .hdr or .img, gzipped or not.
[[nodiscard]] bool isNiftiName(const std::string& path);
/// Whether the name ends in .mgh, .mgz or .mgh.gz.
[[nodiscard]] bool isMghName(const std::string& path);
/// "scanner", "MNI 152" … for a NIfTI transform code.
[[nodiscard]] const char* transformCodeName(int code) noexcept;

}  // namespace authalic
