#include <nifti2_io.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
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

/// What lies between header and voxels, little endian, when it is a chain of extensions; empty otherwise.
std::vector<std::uint8_t> extensionsIn(const std::vector<std::uint8_t>& between, ByteOrder order) {
  if (between.size() < 12 || between[0] == 0) {
    return {};
  }
  std::vector<std::uint8_t> chain{1, 0, 0, 0};
  for (std::size_t at = 4; at < between.size();) {
    if (between.size() - at < 8) {
      return {};
    }
    const auto size = decode<std::int32_t>(between.data() + at, order);
    if (size < 8 || size % 16 != 0 || static_cast<std::size_t>(size) > between.size() - at) {
      return {};
    }
    encode(chain, size, ByteOrder::Little);
    encode(chain, decode<std::int32_t>(between.data() + at + 4, order), ByteOrder::Little);
    const auto first = between.begin() + static_cast<std::ptrdiff_t>(at);
    chain.insert(chain.end(), first + 8, first + size);
    at += static_cast<std::size_t>(size);
  }
  return chain;
}

/// The header's notes and the extensions, for writing them again; what cannot be is named in `notRead`.
void keepNotes(const NiftiHeader& header, const std::vector<std::uint8_t>& between, bool wanted, StoredVolume& file) {
  const bool extended = !header.pair && header.dataOffset > (header.version == 1 ? 352U : 544U);
  file.notRead = listed({header.notes, extended ? "extensions" : ""});
  if (!wanted || header.asNifti1.empty()) {
    return;
  }
  file.niftiNotes = header.asNifti1;
  const auto chain = extensionsIn(between, header.coding.order);
  file.niftiNotes.insert(file.niftiNotes.end(), chain.begin(), chain.end());
}

StoredVolume factsOf(NiftiHeader& header, std::int64_t held) {
  StoredVolume file;
  file.type = header.coding.type;
  file.slope = header.coding.slope;
  file.inter = header.coding.inter;
  file.dimensions = header.dimensions;
  file.voxelToWorld = header.voxelToWorld;
  file.framesHeld = static_cast<int>(held);
  file.frames = static_cast<int>(header.frames);
  file.timeStep = header.timeStep;
  file.space = header.space;
  file.spaceReason = std::move(header.spaceReason);
  file.warnings = std::move(header.warnings);
  file.transformCode = header.transformCode;
  file.disagreement = header.disagreement;
  file.storedType = codingName(header.coding);
  return file;
}

}  // namespace

StoredVolume readNifti(const std::string& path, const VolumeRequest& request) {
  const std::string headerPath = partner(path, ".img", ".hdr");
  InputFile input(headerPath);
  NiftiHeader header = parseNiftiHeader(headerPath, readHeaderBytes(input), request.transform);
  const int frame = request.allFrames ? 0 : request.frame;
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
  const std::int64_t held = request.allFrames ? header.frames : 1;
  const std::uint64_t before = header.dataOffset - input.position();
  const bool keep = request.notes && !header.pair;
  if (!keep) {
    input.skip(before, "the part before the voxels");
  }
  const auto between = keep ? input.read(before, "the part before the voxels") : std::vector<std::uint8_t>();
  input.skip(static_cast<std::uint64_t>(frame) * frameBytes, "the frames before the one asked for");
  auto voxels = input.read(static_cast<std::uint64_t>(held) * frameBytes, "the voxels");
  input.skip(static_cast<std::uint64_t>(header.frames - held - frame) * frameBytes,
             "the frames after the one asked for");
  input.drain();
  if (header.coding.order == ByteOrder::Big) {
    turnRound(voxels, header.coding.type);
  }
  StoredVolume file = factsOf(header, held);
  file.bytes = std::move(voxels);
  keepNotes(header, between, request.notes, file);
  return file;
}

namespace {

/// qform when the axes are orthogonal, which is all it can say.
void setQform(nifti_1_header& header, const Eigen::Matrix4d& affine) {
  const Eigen::Matrix3d m = affine.topLeftCorner<3, 3>();
  const Eigen::Matrix3d unit = m * m.colwise().norm().cwiseInverse().asDiagonal();
  header.qform_code = 0;
  header.quatern_b = header.quatern_c = header.quatern_d = 0;
  header.qoffset_x = header.qoffset_y = header.qoffset_z = 0;
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

struct Coding {
  VoxelType type;
  short code;
};

constexpr std::array<Coding, 10> kCodes{{{VoxelType::Uint8, DT_UINT8},
                                         {VoxelType::Int8, DT_INT8},
                                         {VoxelType::Int16, DT_INT16},
                                         {VoxelType::Uint16, DT_UINT16},
                                         {VoxelType::Int32, DT_INT32},
                                         {VoxelType::Uint32, DT_UINT32},
                                         {VoxelType::Int64, DT_INT64},
                                         {VoxelType::Uint64, DT_UINT64},
                                         {VoxelType::Float32, DT_FLOAT32},
                                         {VoxelType::Float64, DT_FLOAT64}}};

short codeOf(VoxelType type) {
  return std::find_if(kCodes.begin(), kCodes.end(), [type](const Coding& c) { return c.type == type; })->code;
}

/// The frames, as the notes arrange them where that fits, and the time between them.
void setFrames(const std::string& path, nifti_1_header& header, const StoredVolume& volume) {
  std::int64_t arranged = header.dim[0] > 0 ? 1 : 0;  // 0: no notes
  for (int axis = 4; axis <= header.dim[0] && axis < 8; ++axis) {
    arranged *= header.dim[axis];
  }
  if (arranged == volume.framesHeld) {
    for (int axis = header.dim[0] + 1; axis < 8; ++axis) {  // unused, however the notes fill them
      header.dim[axis] = axis <= 3 ? header.dim[axis] : short{1};
      header.pixdim[axis] = axis <= 3 || (axis == 4 && volume.timeStep > 0) ? header.pixdim[axis] : 1.F;
    }
    return;
  }
  if (volume.framesHeld > 32767) {
    throw FormatError(path, "NIfTI-1 holds 1 to 32767 frames, but the volume to write has " +
                                std::to_string(volume.framesHeld) + ".");
  }
  header.dim[0] = volume.framesHeld > 1 ? 4 : 3;
  header.dim[4] = static_cast<short>(volume.framesHeld);
  for (int axis = 5; axis < 8; ++axis) {
    header.dim[axis] = 1;
    header.pixdim[axis] = 1;
  }
  header.pixdim[4] = volume.timeStep > 0 ? static_cast<float>(volume.timeStep) : 1.F;
  header.xyzt_units = static_cast<char>((header.xyzt_units & 7) | (volume.timeStep > 0 ? NIFTI_UNITS_SEC : 0));
}

nifti_1_header makeHeader(const std::string& path, const StoredVolume& volume) {
  nifti_1_header header{};
  if (volume.niftiNotes.size() >= sizeof(header)) {
    std::memcpy(&header, volume.niftiNotes.data(), sizeof(header));
  }
  header.sizeof_hdr = 348;
  header.regular = 'r';
  for (int axis = 0; axis < 3; ++axis) {
    const int extent = volume.dimensions[static_cast<std::size_t>(axis)];
    if (extent < 1 || extent > 32767) {
      throw FormatError(path, "NIfTI-1 holds 1 to 32767 voxels along an axis, but the volume to write has " +
                                  std::to_string(extent) + ".");
    }
    header.dim[axis + 1] = static_cast<short>(extent);
    header.pixdim[axis + 1] = static_cast<float>(volume.voxelToWorld.col(axis).head<3>().norm());
  }
  header.xyzt_units = static_cast<char>(NIFTI_UNITS_MM | (header.xyzt_units & 0x38));
  setFrames(path, header, volume);
  header.pixdim[0] = 1;
  header.datatype = codeOf(volume.type);
  header.bitpix = static_cast<short>(8 * voxelSize(volume.type));
  header.scl_slope = static_cast<float>(volume.slope);
  header.scl_inter = static_cast<float>(volume.inter);
  header.sform_code = static_cast<short>(volume.transformCode);
  for (int c = 0; c < 4; ++c) {
    header.srow_x[c] = static_cast<float>(volume.voxelToWorld(0, c));
    header.srow_y[c] = static_cast<float>(volume.voxelToWorld(1, c));
    header.srow_z[c] = static_cast<float>(volume.voxelToWorld(2, c));
  }
  setQform(header, volume.voxelToWorld);
  std::memcpy(header.magic, "n+1", 4);
  return header;
}

}  // namespace

void writeNifti(const std::string& path, const StoredVolume& volume) {
  nifti_1_header header = makeHeader(path, volume);
  const std::size_t notes = std::max(volume.niftiNotes.size(), sizeof(header) + 4);
  std::vector<std::uint8_t> bytes((notes + 15) / 16 * 16, 0);
  std::copy(volume.niftiNotes.begin(), volume.niftiNotes.end(), bytes.begin());
  header.vox_offset = static_cast<float>(bytes.size());
  std::memcpy(bytes.data(), &header, sizeof(header));
  bytes.insert(bytes.end(), volume.bytes.begin(), volume.bytes.end());
  const bool packed = path.size() > 3 && path.compare(path.size() - 3, 3, ".gz") == 0;
  writeFileAtomically(path, packed ? gzipped(path, bytes) : bytes);
}

}  // namespace authalic
