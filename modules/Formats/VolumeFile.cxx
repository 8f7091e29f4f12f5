#include "Formats/VolumeFile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "Core/base/Error.h"
#include "Formats/VolumeData.h"

namespace authalic {

namespace {

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The numbers of one type, each passed to `put(index, stored)`.
template <class T, class Put>
void decodeEach(const std::vector<std::uint8_t>& bytes, ByteOrder order, Put put) {
  const std::size_t count = bytes.size() / sizeof(T);
  for (std::size_t i = 0; i < count; ++i) {
    put(i, decode<T>(bytes.data() + i * sizeof(T), order));
  }
}

template <class Put>
void decodeEach(const std::vector<std::uint8_t>& bytes, const VoxelCoding& coding, Put put) {
  switch (coding.type) {
    case VoxelType::Uint8:
      return decodeEach<std::uint8_t>(bytes, coding.order, put);
    case VoxelType::Int8:
      return decodeEach<std::int8_t>(bytes, coding.order, put);
    case VoxelType::Int16:
      return decodeEach<std::int16_t>(bytes, coding.order, put);
    case VoxelType::Uint16:
      return decodeEach<std::uint16_t>(bytes, coding.order, put);
    case VoxelType::Int32:
      return decodeEach<std::int32_t>(bytes, coding.order, put);
    case VoxelType::Uint32:
      return decodeEach<std::uint32_t>(bytes, coding.order, put);
    case VoxelType::Int64:
      return decodeEach<std::int64_t>(bytes, coding.order, put);
    case VoxelType::Uint64:
      return decodeEach<std::uint64_t>(bytes, coding.order, put);
    case VoxelType::Float32:
      return decodeEach<float>(bytes, coding.order, put);
    case VoxelType::Float64:
      return decodeEach<double>(bytes, coding.order, put);
    case VoxelType::None:
      break;
  }
}

/// Whether every stored number is a whole number of 32 bits and stays as it is.
bool staysInteger(const std::vector<std::uint8_t>& bytes, const VoxelCoding& coding) {
  if (coding.slope != 1 || coding.inter != 0) {
    return false;
  }
  switch (coding.type) {
    case VoxelType::Float32:
    case VoxelType::Float64:
    case VoxelType::None:
      return false;
    case VoxelType::Uint32:
    case VoxelType::Int64:
    case VoxelType::Uint64:
      break;
    default:
      return true;
  }
  bool fits = true;
  decodeEach(bytes, coding, [&fits](std::size_t, auto stored) {
    const auto value = static_cast<double>(stored);
    fits = fits && value >= std::numeric_limits<std::int32_t>::min() &&
           value <= std::numeric_limits<std::int32_t>::max();
  });
  return fits;
}

}  // namespace

std::string codingName(const VoxelCoding& coding) {
  const bool scaled = coding.slope != 1 || coding.inter != 0;
  return std::string(voxelTypeName(coding.type)) + (scaled ? " with scaling" : "");
}

Eigen::Matrix4d storedAffine(const std::string& path, const std::array<int, 3>& dimensions,
                             const Eigen::Matrix4d& affine) {
  return isMghName(path) ? mghAffine(dimensions, affine) : affine.cast<float>().cast<double>();
}

std::variant<ScalarVolume, LabelVolume> decodeVoxels(const std::vector<std::uint8_t>& bytes,
                                                     const VoxelCoding& coding,
                                                     const std::array<int, 3>& dimensions,
                                                     const Eigen::Matrix4d& voxelToWorld) {
  if (staysInteger(bytes, coding)) {
    LabelVolume labels(dimensions, voxelToWorld);
    decodeEach(bytes, coding, [&labels](std::size_t i, auto stored) {
      labels.values[i] = static_cast<std::int32_t>(stored);
    });
    return labels;
  }
  ScalarVolume scalars(dimensions, voxelToWorld);
  if (coding.slope == 1 && coding.inter == 0) {
    decodeEach(bytes, coding,
               [&](std::size_t i, auto stored) { scalars.values[i] = static_cast<float>(stored); });
  } else {
    decodeEach(bytes, coding, [&](std::size_t i, auto stored) {
      scalars.values[i] = static_cast<float>(coding.slope * static_cast<double>(stored) + coding.inter);
    });
  }
  return scalars;
}

void checkFrame(const std::string& path, int frame, std::int64_t frames) {
  if (frame < 0 || frame >= frames) {
    throw FormatError(path, "Frame " + std::to_string(frame) + " is asked for, but the file holds " +
                                std::to_string(frames) + (frames == 1 ? " frame" : " frames") +
                                ", numbered from 0.");
  }
}

const std::array<int, 3>& VolumeFile::dimensions() const {
  return std::visit([](const auto& v) -> const std::array<int, 3>& { return v.dimensions; }, volume);
}

const Eigen::Matrix4d& VolumeFile::voxelToWorld() const {
  return std::visit([](const auto& v) -> const Eigen::Matrix4d& { return v.voxelToWorld; }, volume);
}

ScalarVolume VolumeFile::scalars() const {
  if (const auto* scalars = std::get_if<ScalarVolume>(&volume)) {
    return *scalars;
  }
  const auto& labels = std::get<LabelVolume>(volume);
  ScalarVolume result;
  result.dimensions = labels.dimensions;
  result.voxelToWorld = labels.voxelToWorld;
  result.values.assign(labels.values.begin(), labels.values.end());
  return result;
}

LabelVolume VolumeFile::labels(const std::string& path) const {
  if (const auto* labels = std::get_if<LabelVolume>(&volume)) {
    return *labels;
  }
  const auto& scalars = std::get<ScalarVolume>(volume);
  LabelVolume result(scalars.dimensions, scalars.voxelToWorld);
  for (std::size_t i = 0; i < scalars.values.size(); ++i) {
    const float value = scalars.values[i];
    // 2^31 is a float; the largest float below it fits.
    if (!(value >= -2147483648.0F && value < 2147483648.0F) || value != std::floor(value)) {
      throw FormatError(path, "A label volume of whole numbers is needed, but voxel " + std::to_string(i) +
                                  " is " + std::to_string(value) + "; give the labels, not an image.");
    }
    result.values[i] = static_cast<std::int32_t>(value);
  }
  return result;
}

bool isMghName(const std::string& path) {
  return endsWith(path, ".mgz") || endsWith(path, ".mgh") || endsWith(path, ".mgh.gz");
}

bool isNiftiName(const std::string& path) {
  const std::array<const char*, 6> endings{".nii", ".nii.gz", ".hdr", ".img", ".hdr.gz", ".img.gz"};
  return std::any_of(endings.begin(), endings.end(), [&path](const char* end) { return endsWith(path, end); });
}

bool StoredVolume::isInteger32() const { return staysInteger(bytes, {type, ByteOrder::Little, slope, inter}); }

VolumeFile readVolume(const std::string& path, int frame, VolumeTransform transform) {
  StoredVolume stored = readStoredVolume(path, {frame, false, false, transform});
  VolumeFile file;
  static_cast<VolumeFacts&>(file) = static_cast<VolumeFacts&>(stored);
  file.volume = decodeVoxels(stored.bytes, {stored.type, ByteOrder::Little, stored.slope, stored.inter},
                             stored.dimensions, stored.voxelToWorld);
  return file;
}

namespace {

template <class T>
void writeValues(const std::string& path, const VolumeOf<T>& volume, VoxelType type, int transformCode) {
  StoredVolume stored;
  stored.dimensions = volume.dimensions;
  stored.voxelToWorld = volume.voxelToWorld;
  stored.type = type;
  stored.transformCode = transformCode;
  stored.bytes.reserve(volume.values.size() * sizeof(T));
  for (const T value : volume.values) {
    encode(stored.bytes, value, ByteOrder::Little);
  }
  writeStoredVolume(path, stored);
}

}  // namespace

void writeVolume(const std::string& path, const ScalarVolume& volume, int transformCode) {
  writeValues(path, volume, VoxelType::Float32, transformCode);
}
void writeVolume(const std::string& path, const LabelVolume& volume, int transformCode) {
  writeValues(path, volume, VoxelType::Int32, transformCode);
}

VolumeGeometry readVolumeGeometry(const std::string& path) {
  const VolumeFile file = readVolume(path);
  const Eigen::Matrix3d axes = file.voxelToWorld().topLeftCorner<3, 3>();
  const Eigen::Vector3d sizes = axes.colwise().norm();
  if (file.space == CoordinateSpace::Unknown) {
    throw FormatError(path, "A volume that says where it is, is needed to place a surface, but the space of this one "
                            "is unknown; convert it with --space scanner-ras first if that is what it is in.");
  }
  if (file.disagreement > sizes.minCoeff() / 2) {
    throw FormatError(path, "One place is needed for the voxels, but sform and qform put them over half a voxel apart; "
                            "convert it with --transform sform or --transform qform first.");
  }
  VolumeGeometry geometry;
  geometry.valid = true;
  geometry.dimensions = file.dimensions();
  Eigen::Vector3d middle;
  for (int axis = 0; axis < 3; ++axis) middle[axis] = 0.5 * file.dimensions()[static_cast<std::size_t>(axis)];
  Eigen::Map<Eigen::Vector3d>(geometry.voxelSize.data()) = sizes;
  Eigen::Map<Eigen::Matrix3d>(geometry.directions.data()) = axes * sizes.cwiseInverse().asDiagonal();
  Eigen::Map<Eigen::Vector3d>(geometry.center.data()) = axes * middle + file.voxelToWorld().topRightCorner<3, 1>();
  geometry.fileName = path;
  return geometry;
}

}  // namespace authalic
