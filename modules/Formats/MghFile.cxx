#include <Eigen/LU>
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

}  // namespace

VolumeFile readMgh(const std::string& path, int frame) {
  InputFile input(path);
  const auto bytes = input.read(kHeaderSize, "the MGH header");
  const MghHeader header = parseHeader(path, bytes);
  checkFrame(path, frame, header.frames);
  const auto size = static_cast<std::uint64_t>(voxelSize(header.coding.type));
  const auto plane =
      static_cast<std::uint64_t>(header.dimensions[0]) * static_cast<std::uint64_t>(header.dimensions[1]);
  const auto depth = static_cast<std::uint64_t>(header.dimensions[2]);
  // plane < 2^48 and size ≤ 4, so only the last factors can overflow.
  if (plane > (1ULL << 40) / depth / static_cast<std::uint64_t>(header.frames)) {
    throw FormatError(path, "The header claims more voxels than any volume has.", 4);
  }
  const std::uint64_t frameBytes = plane * depth * size;
  const auto before = static_cast<std::uint64_t>(frame) * frameBytes;
  const auto after = static_cast<std::uint64_t>(header.frames - 1 - frame) * frameBytes;
  input.skip(before, "the frames before the one asked for");
  const auto voxels = input.read(frameBytes, "the voxels");
  input.skip(after, "the frames after the one asked for");
  const std::uint64_t end = kHeaderSize + before + frameBytes + after;
  constexpr std::uint64_t scanParameters = 20;  // TR, flip angle, TE, TI, field of view
  const bool tagged = input.drain() > end + scanParameters;

  VolumeFile file;
  file.storedType = codingName(header.coding);
  file.notRead = tagged ? "tags" : "";
  file.transformCode = header.goodRas ? 1 : 0;
  file.volume = decodeVoxels(voxels, header.coding, header.dimensions, header.voxelToWorld);
  file.frames = static_cast<int>(header.frames);
  file.space = header.goodRas ? CoordinateSpace::ScannerRAS : CoordinateSpace::Unknown;
  file.spaceReason = header.goodRas ? "MGH direction cosines and centre (goodRAS)"
                                    : "MGH without goodRAS: FreeSurfer's coronal default, true place unknown";
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

template <class T>
void writeMghAs(const std::string& path, const VolumeOf<T>& volume, std::int32_t type) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(kHeaderSize + volume.values.size() * sizeof(T));
  const auto put = [&bytes](auto value) { encode(bytes, value, ByteOrder::Big); };
  put(std::int32_t{1});
  for (const int extent : volume.dimensions) {
    put(static_cast<std::int32_t>(extent));
  }
  put(std::int32_t{1});
  put(type);
  put(std::int32_t{0});
  put(std::int16_t{1});
  for (const float number : placeOf(volume.dimensions, volume.voxelToWorld)) {
    put(number);
  }
  bytes.resize(kHeaderSize, 0);
  for (const T value : volume.values) {
    put(value);
  }
  const bool packed = path.back() == 'z';
  writeFileAtomically(path, packed ? gzipped(path, bytes) : bytes);
}

}  // namespace

Eigen::Matrix4d mghAffine(const std::array<int, 3>& dimensions, const Eigen::Matrix4d& affine) {
  std::vector<std::uint8_t> bytes;
  for (const float number : placeOf(dimensions, affine)) {
    encode(bytes, number, ByteOrder::Big);
  }
  const std::string path;
  ByteCursor cursor(path, bytes);
  return orientation(cursor, dimensions, true);
}

void writeMgh(const std::string& path, const ScalarVolume& volume) { writeMghAs(path, volume, 3); }
void writeMgh(const std::string& path, const LabelVolume& volume) { writeMghAs(path, volume, 1); }

}  // namespace authalic
