#include <nifti2_io.h>

#include <Eigen/LU>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "Formats/AtomicFile.h"
#include "Formats/Gzip.h"
#include "Formats/InputFile.h"
#include "Formats/NiftiHeader.h"
#include "Formats/VolumeData.h"

namespace authalic {

namespace {

/// name.img → name.hdr and back, keeping .gz; the other spelling of compression is tried too.
std::string partner(const std::string& path, const std::string& from, const std::string& to) {
  std::string stem = path;
  const bool packed = stem.size() > 3 && stem.compare(stem.size() - 3, 3, ".gz") == 0;
  stem.resize(stem.size() - (packed ? 3 : 0));
  if (stem.size() < from.size() || stem.compare(stem.size() - from.size(), from.size(), from) != 0) {
    return path;
  }
  stem.replace(stem.size() - from.size(), from.size(), to);
  const std::string first = stem + (packed ? ".gz" : "");
  const std::string second = stem + (packed ? "" : ".gz");
  return !std::filesystem::exists(first) && std::filesystem::exists(second) ? second : first;
}

std::vector<std::uint8_t> readHeaderBytes(InputFile& input) {
  auto bytes = input.read(4, "the NIfTI header");
  const auto rest = input.read(niftiHeaderSize(input.path(), bytes) - 4, "the NIfTI header");
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  return bytes;
}

}  // namespace

VolumeFile readNifti(const std::string& path, int frame) {
  const std::string headerPath = partner(path, ".img", ".hdr");
  InputFile input(headerPath);
  NiftiHeader header = parseNiftiHeader(headerPath, readHeaderBytes(input));
  checkFrame(path, frame, header.frames);
  if (header.pair) {
    const std::string imagePath = partner(headerPath, ".hdr", ".img");
    if (imagePath == headerPath || !std::filesystem::exists(imagePath)) {
      throw FormatError(
          path, "The header says that its voxels are in a separate .img file, but there is none beside it.");
    }
    input = InputFile(imagePath);
  }
  const std::uint64_t frameBytes = static_cast<std::uint64_t>(header.dimensions[0]) *
                                   static_cast<std::uint64_t>(header.dimensions[1]) *
                                   static_cast<std::uint64_t>(header.dimensions[2]) *
                                   static_cast<std::uint64_t>(voxelSize(header.coding.type));
  input.skip(header.dataOffset - input.position(), "the part before the voxels");
  input.skip(static_cast<std::uint64_t>(frame) * frameBytes, "the frames before the one asked for");
  const auto voxels = input.read(frameBytes, "the voxels");
  input.skip(static_cast<std::uint64_t>(header.frames - 1 - frame) * frameBytes,
             "the frames after the one asked for");
  input.drain();

  VolumeFile file;
  file.volume = decodeVoxels(voxels, header.coding, header.dimensions, header.voxelToWorld);
  file.frames = static_cast<int>(header.frames);
  file.space = header.space;
  file.spaceReason = std::move(header.spaceReason);
  file.warnings = std::move(header.warnings);
  file.transformCode = header.transformCode;
  file.storedType = codingName(header.coding);
  const bool extended = !header.pair && header.dataOffset > (header.version == 1 ? 352U : 544U);
  file.notRead = std::string(header.described ? "description" : "") + (header.described && extended ? ", " : "") +
                 (extended ? "extensions" : "");
  return file;
}

namespace {

/// qform when the axes are orthogonal, which is all it can say.
void setQform(nifti_1_header& header, const Eigen::Matrix4d& affine) {
  const Eigen::Matrix3d m = affine.topLeftCorner<3, 3>();
  const Eigen::Matrix3d unit = m * m.colwise().norm().cwiseInverse().asDiagonal();
  if (!(unit.transpose() * unit).isIdentity(1e-6)) {
    return;
  }
  nifti_dmat44 matrix{};
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      matrix.m[r][c] = affine(r, c);
    }
  }
  double b, c, d, x, y, z, dx, dy, dz, qfac;
  nifti_dmat44_to_quatern(matrix, &b, &c, &d, &x, &y, &z, &dx, &dy, &dz, &qfac);
  header.qform_code = header.sform_code;
  header.quatern_b = static_cast<float>(b);
  header.quatern_c = static_cast<float>(c);
  header.quatern_d = static_cast<float>(d);
  header.qoffset_x = static_cast<float>(x);
  header.qoffset_y = static_cast<float>(y);
  header.qoffset_z = static_cast<float>(z);
  header.pixdim[0] = static_cast<float>(qfac);
}

nifti_1_header makeHeader(const std::string& path, const std::array<int, 3>& dimensions,
                          const Eigen::Matrix4d& affine, int datatype, int transformCode) {
  nifti_1_header header{};
  header.sizeof_hdr = 348;
  header.regular = 'r';
  header.dim[0] = 3;
  for (int axis = 0; axis < 3; ++axis) {
    const int extent = dimensions[static_cast<std::size_t>(axis)];
    if (extent < 1 || extent > 32767) {
      throw FormatError(path, "NIfTI-1 holds 1 to 32767 voxels along an axis, but the volume to write has " +
                                  std::to_string(extent) + ".");
    }
    header.dim[axis + 1] = static_cast<short>(extent);
    header.pixdim[axis + 1] = static_cast<float>(affine.col(axis).head<3>().norm());
  }
  for (int axis = 4; axis < 8; ++axis) {
    header.dim[axis] = 1;
    header.pixdim[axis] = 1;
  }
  header.pixdim[0] = 1;
  header.datatype = static_cast<short>(datatype);
  header.bitpix = 32;
  header.vox_offset = 352;
  header.scl_slope = 1;
  header.xyzt_units = NIFTI_UNITS_MM;
  header.sform_code = static_cast<short>(transformCode);
  for (int c = 0; c < 4; ++c) {
    header.srow_x[c] = static_cast<float>(affine(0, c));
    header.srow_y[c] = static_cast<float>(affine(1, c));
    header.srow_z[c] = static_cast<float>(affine(2, c));
  }
  setQform(header, affine);
  std::memcpy(header.magic, "n+1", 4);
  return header;
}

template <class T>
void writeNifti(const std::string& path, const VolumeOf<T>& volume, int datatype, int transformCode) {
  const nifti_1_header header =
      makeHeader(path, volume.dimensions, volume.voxelToWorld, datatype, transformCode);
  std::vector<std::uint8_t> bytes(352 + volume.values.size() * sizeof(T), 0);
  std::memcpy(bytes.data(), &header, sizeof(header));
  std::memcpy(bytes.data() + 352, volume.values.data(), volume.values.size() * sizeof(T));
  const bool packed = path.size() > 3 && path.compare(path.size() - 3, 3, ".gz") == 0;
  writeFileAtomically(path, packed ? gzipped(path, bytes) : bytes);
}

}  // namespace

void writeVolume(const std::string& path, const ScalarVolume& volume, int transformCode) {
  return isMghName(path) ? writeMgh(path, volume) : writeNifti(path, volume, DT_FLOAT32, transformCode);
}
void writeVolume(const std::string& path, const LabelVolume& volume, int transformCode) {
  return isMghName(path) ? writeMgh(path, volume) : writeNifti(path, volume, DT_INT32, transformCode);
}

}  // namespace authalic
