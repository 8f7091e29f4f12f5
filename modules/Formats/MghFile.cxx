#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "Formats/AtomicFile.h"
#include "Formats/Gzip.h"
#include "Formats/InputFile.h"
#include "Formats/VolumeData.h"

namespace authalic {

namespace {

constexpr std::uint64_t kHeaderSize = 284;

VoxelType voxelTypeOf(const std::string& path, std::int32_t code) {
  switch (code) {
    case 0:
      return VoxelType::Uint8;
    case 1:
      return VoxelType::Int32;
    case 3:
      return VoxelType::Float32;
    case 4:
      return VoxelType::Int16;
    case 10:
      return VoxelType::Uint16;
    default:
      break;
  }
  throw FormatError(
      path, "The MGH type code " + std::to_string(code) + " is not one of 0, 1, 3, 4 and 10 that are read.",
      20);
}

struct MghHeader {
  std::array<int, 3> dimensions{};
  std::int64_t frames = 0;
  VoxelCoding coding;
  bool goodRas = false;
  Eigen::Matrix4d voxelToWorld = Eigen::Matrix4d::Identity();
};

/// M = Mdc diag(delta); translation = c_ras - M dims/2, with dims/2 rather than (dims-1)/2.
Eigen::Matrix4d orientation(ByteCursor& cursor, const std::array<int, 3>& dimensions, bool goodRas) {
  Eigen::Vector3d delta(1, 1, 1);
  Eigen::Vector3d center(0, 0, 0);
  Eigen::Matrix3d directions;
  directions << -1, 0, 0, 0, 0, 1, 0, -1, 0;
  if (goodRas) {
    for (int i = 0; i < 3; ++i) {
      delta[i] = cursor.next<float>("the voxel sizes");
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (int row = 0; row < 3; ++row) {
        directions(row, axis) = cursor.next<float>("the direction cosines");
      }
    }
    for (int i = 0; i < 3; ++i) {
      center[i] = cursor.next<float>("the centre");
    }
  }
  const Eigen::Matrix3d m = directions * delta.asDiagonal();
  if (!m.allFinite() || !center.allFinite() || !(std::abs(m.determinant()) > 1e-12)) {
    cursor.fail(
        "The direction cosines and voxel sizes should be finite and span space, but do not; the header is "
        "damaged.");
  }
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  affine.topLeftCorner<3, 3>() = m;
  affine.topRightCorner<3, 1>() =
      center - m * Eigen::Vector3d(dimensions[0], dimensions[1], dimensions[2]) / 2;
  return affine;
}

MghHeader parseHeader(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  ByteCursor cursor(path, bytes);
  if (cursor.next<std::int32_t>("the version") != 1) {
    cursor.seek(0);
    cursor.fail("An MGH volume begins with version 1, but this file does not; it is of another kind.");
  }
  MghHeader header;
  for (int& d : header.dimensions) {
    d = cursor.next<std::int32_t>("the dimensions");
    if (d < 1 || d > 1 << 24) {
      cursor.fail("The header claims a dimension of " + std::to_string(d) + ", which no volume has.");
    }
  }
  header.frames = cursor.next<std::int32_t>("the number of frames");
  if (header.frames < 1) {
    cursor.fail("The header claims " + std::to_string(header.frames) + " frames; at least one is needed.");
  }
  header.coding.type = voxelTypeOf(path, cursor.next<std::int32_t>("the type"));
  header.coding.order = ByteOrder::Big;
  static_cast<void>(cursor.next<std::int32_t>("the degrees of freedom"));
  header.goodRas = cursor.next<std::int16_t>("goodRAS") != 0;
  header.voxelToWorld = orientation(cursor, header.dimensions, header.goodRas);
  return header;
}


constexpr std::size_t kScanParameters = 20;  // TR (ms), flip angle, TE, TI, field of view
constexpr std::uint64_t kMostNotes = 1ULL << 26;

/// Repetition time in s, 0 where it is not stated.
double timeStepOf(const std::vector<std::uint8_t>& notes) {
  const double step = notes.size() < 4 ? 0 : 1e-3 * static_cast<double>(decode<float>(notes.data(), ByteOrder::Big));
  return std::isfinite(step) && step > 0 ? step : 0;
}

/// What follows the voxels, beyond the repetition time.
std::string namesOf(const std::vector<std::uint8_t>& notes) {
  bool scan = false;
  for (std::size_t at = 4; at < std::min(notes.size(), kScanParameters); ++at) {
    scan = scan || notes[at] != 0;
  }
  return listed({scan ? "scan parameters" : "", notes.size() > kScanParameters ? "tags" : ""});
}

std::uint64_t bytesOfFrame(const std::string& path, const MghHeader& header) {
  const auto size = static_cast<std::uint64_t>(voxelSize(header.coding.type));
  const auto plane =
      static_cast<std::uint64_t>(header.dimensions[0]) * static_cast<std::uint64_t>(header.dimensions[1]);
  const auto depth = static_cast<std::uint64_t>(header.dimensions[2]);
  // plane < 2^48 and size ≤ 4, so only the last factors can overflow.
  if (plane > (1ULL << 40) / depth / static_cast<std::uint64_t>(header.frames)) {
    throw FormatError(path, "The header claims more voxels than any volume has.", 4);
  }
  return plane * depth * size;
}

}  // namespace

StoredVolume readMgh(const std::string& path, const VolumeRequest& request) {
  InputFile input(path);
  const auto bytes = input.read(kHeaderSize, "the MGH header");
  const MghHeader header = parseHeader(path, bytes);
  const int frame = request.allFrames ? 0 : request.frame;
  checkFrame(path, frame, header.frames);
  const std::int64_t held = request.allFrames ? header.frames : 1;
  const std::uint64_t frameBytes = bytesOfFrame(path, header);
  input.skip(static_cast<std::uint64_t>(frame) * frameBytes, "the frames before the one asked for");
  StoredVolume file;
  file.bytes = input.read(static_cast<std::uint64_t>(held) * frameBytes, "the voxels");
  input.skip(static_cast<std::uint64_t>(header.frames - held - frame) * frameBytes,
             "the frames after the one asked for");
  std::vector<std::uint8_t> notes = input.readRest(kMostNotes);

  turnRound(file.bytes, header.coding.type);
  file.type = header.coding.type;
  file.dimensions = header.dimensions;
  file.voxelToWorld = header.voxelToWorld;
  file.framesHeld = static_cast<int>(held);
  file.frames = static_cast<int>(header.frames);
  file.storedType = codingName(header.coding);
  file.notRead = namesOf(notes);
  file.timeStep = timeStepOf(notes);
  file.transformCode = header.goodRas ? 1 : 0;
  file.space = header.goodRas ? CoordinateSpace::ScannerRAS : CoordinateSpace::Unknown;
  file.spaceReason = header.goodRas ? "MGH direction cosines and centre (goodRAS)"
                                    : "MGH without goodRAS: FreeSurfer's coronal default, true place unknown";
  if (request.notes) {
    file.mghNotes = std::move(notes);
  }
  return file;
}

namespace {

/// Voxel sizes, direction cosines of x, y and z, and the centre, as the header holds them.
std::array<float, 15> placeOf(const std::array<int, 3>& d, const Eigen::Matrix4d& affine) {
  const Eigen::Matrix3d m = affine.topLeftCorner<3, 3>();
  const Eigen::Vector3d delta = m.colwise().norm().transpose();
  const Eigen::Vector3d center = affine.topRightCorner<3, 1>() + m * Eigen::Vector3d(d[0], d[1], d[2]) / 2;
  std::array<float, 15> place{};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    place[at] = static_cast<float>(delta[axis]);
    place[12 + at] = static_cast<float>(center[axis]);
    for (Eigen::Index row = 0; row < 3; ++row) {
      place[3 + 3 * at + static_cast<std::size_t>(row)] = static_cast<float>(m(row, axis) / delta[axis]);
    }
  }
  return place;
}

std::int32_t codeOf(VoxelType type) {
  switch (type) {
    case VoxelType::Uint8:
      return 0;
    case VoxelType::Int32:
      return 1;
    case VoxelType::Int16:
      return 4;
    default:
      return 3;
  }
}

}  // namespace

void writeMgh(const std::string& path, const StoredVolume& volume) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(kHeaderSize + volume.bytes.size() + volume.mghNotes.size() + kScanParameters);
  const auto put = [&bytes](auto value) { encode(bytes, value, ByteOrder::Big); };
  put(std::int32_t{1});
  for (const int extent : volume.dimensions) {
    put(static_cast<std::int32_t>(extent));
  }
  put(static_cast<std::int32_t>(volume.framesHeld));
  put(codeOf(volume.type));
  put(std::int32_t{0});
  put(std::int16_t{1});
  for (const float number : placeOf(volume.dimensions, volume.voxelToWorld)) {
    put(number);
  }
  bytes.resize(kHeaderSize, 0);
  std::vector<std::uint8_t> voxels = volume.bytes;
  turnRound(voxels, volume.type);
  bytes.insert(bytes.end(), voxels.begin(), voxels.end());
  if (!volume.mghNotes.empty()) {
    bytes.insert(bytes.end(), volume.mghNotes.begin(), volume.mghNotes.end());
  } else if (volume.timeStep > 0) {
    put(static_cast<float>(1e3 * volume.timeStep));
    bytes.resize(bytes.size() + kScanParameters - 4, 0);
  }
  const bool packed = path.back() == 'z';
  writeFileAtomically(path, packed ? gzipped(path, bytes) : bytes);
}

Eigen::Matrix4d mghAffine(const std::array<int, 3>& dimensions, const Eigen::Matrix4d& affine) {
  std::vector<std::uint8_t> bytes;
  for (const float number : placeOf(dimensions, affine)) {
    encode(bytes, number, ByteOrder::Big);
  }
  const std::string path;
  ByteCursor cursor(path, bytes);
  return orientation(cursor, dimensions, true);
}

}  // namespace authalic
