#include "Formats/NiftiHeader.h"

#include <nifti2_io.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <memory>

namespace authalic {

namespace {

/// The fields that are checked, whatever the version.
struct RawHeader {
  std::array<std::int64_t, 8> dim{};
  int datatype = 0;
  int intent = 0;
  int qformCode = 0;
  int sformCode = 0;
  int units = 0;
  double voxOffset = 0;
  double slope = 0;
  double inter = 0;
};

class Fields {
 public:
  Fields(const std::vector<std::uint8_t>& bytes, ByteOrder order) : bytes_(bytes), order_(order) {}
  template <class T>
  [[nodiscard]] T at(std::size_t offset) const {
    return decode<T>(bytes_.data() + offset, order_);
  }

 private:
  const std::vector<std::uint8_t>& bytes_;
  ByteOrder order_;
};

RawHeader rawHeader1(const Fields& f) {
  RawHeader raw;
  for (std::size_t i = 0; i < 8; ++i) {
    raw.dim[i] = f.at<std::int16_t>(40 + 2 * i);
  }
  raw.intent = f.at<std::int16_t>(68);
  raw.datatype = f.at<std::int16_t>(70);
  raw.voxOffset = f.at<float>(108);
  raw.slope = f.at<float>(112);
  raw.inter = f.at<float>(116);
  raw.units = f.at<std::uint8_t>(123);
  raw.qformCode = f.at<std::int16_t>(252);
  raw.sformCode = f.at<std::int16_t>(254);
  return raw;
}

RawHeader rawHeader2(const Fields& f) {
  RawHeader raw;
  for (std::size_t i = 0; i < 8; ++i) {
    raw.dim[i] = f.at<std::int64_t>(16 + 8 * i);
  }
  raw.datatype = f.at<std::int16_t>(12);
  raw.voxOffset = static_cast<double>(f.at<std::int64_t>(168));
  raw.slope = f.at<double>(176);
  raw.inter = f.at<double>(184);
  raw.qformCode = f.at<std::int32_t>(344);
  raw.sformCode = f.at<std::int32_t>(348);
  raw.units = f.at<std::int32_t>(500);
  raw.intent = f.at<std::int32_t>(504);
  return raw;
}

ByteOrder byteOrderOf(const std::string& path, const std::uint8_t* firstFour) {
  for (const ByteOrder order : {ByteOrder::Little, ByteOrder::Big}) {
    const auto size = decode<std::int32_t>(firstFour, order);
    if (size == 348 || size == 540) {
      return order;
    }
  }
  throw FormatError(path,
                    "A NIfTI header begins with its length of 348 or 540, but this file begins with " +
                        std::to_string(decode<std::int32_t>(firstFour, ByteOrder::Little)) +
                        "; it is not NIfTI.",
                    0);
}

/// Whether voxels follow in the same file.
bool isPair(const std::string& path, const std::vector<std::uint8_t>& bytes, int version) {
  const char* magic = reinterpret_cast<const char*>(bytes.data()) + (version == 1 ? 344 : 4);
  const char digit = version == 1 ? '1' : '2';
  const char single[4] = {'n', '+', digit, 0};
  const char pair[4] = {'n', 'i', digit, 0};
  if (std::memcmp(magic, single, 4) == 0) {
    return false;
  }
  if (std::memcmp(magic, pair, 4) == 0) {
    return true;
  }
  throw FormatError(
      path,
      "The header lacks NIfTI's magic word; if it is an Analyze file, convert it to NIfTI first, because "
      "Analyze does not say how the image is oriented.",
      version == 1 ? 344 : 4);
}

void checkDimensions(const std::string& path, const RawHeader& raw, NiftiHeader& header) {
  const std::int64_t rank = raw.dim[0];
  const std::int64_t at = header.version == 1 ? 40 : 16;
  if (rank < 1 || rank > 7) {
    throw FormatError(path, "The header claims " + std::to_string(rank) + " dimensions; 1 to 7 are possible.",
                      at);
  }
  std::int64_t total = 1;
  for (std::int64_t d = 1; d <= rank; ++d) {
    const std::int64_t extent = raw.dim[static_cast<std::size_t>(d)];
    if (extent < 1 || extent > 0x7FFFFFFF || total > (std::int64_t{1} << 40) / extent) {
      throw FormatError(path,
                        "The header claims an extent of " + std::to_string(extent) + " along dimension " +
                            std::to_string(d) +
                            ", which is below 1 or makes more voxels than any volume has.",
                        at);
    }
    total *= extent;
    if (d <= 3) {
      header.dimensions[static_cast<std::size_t>(d - 1)] = static_cast<int>(extent);
    } else {
      header.frames *= extent;
    }
  }
  if (header.frames > 0x7FFFFFFF) {
    throw FormatError(path, "The header claims more frames than any volume has.", at);
  }
}

void setOffsetAndScaling(const std::string& path, const RawHeader& raw, NiftiHeader& header) {
  const double least = header.pair ? 0 : (header.version == 1 ? 352 : 544);
  if (!std::isfinite(raw.voxOffset) || raw.voxOffset < least || raw.voxOffset > 1e15) {
    throw FormatError(path,
                      "The voxels are said to begin at byte " + std::to_string(raw.voxOffset) +
                          ", which lies inside the header or nowhere.",
                      header.version == 1 ? 108 : 168);
  }
  header.dataOffset = static_cast<std::uint64_t>(raw.voxOffset);
  if (!std::isfinite(raw.slope) || !std::isfinite(raw.inter)) {
    throw FormatError(
        path, "The scaling of the voxels (scl_slope, scl_inter) should be finite numbers, but is not.",
        header.version == 1 ? 112 : 176);
  }
  if (raw.slope != 0) {
    header.coding.slope = raw.slope;
    header.coding.inter = raw.inter;
  }
}

using NiftiImage = std::unique_ptr<nifti_image, decltype(&nifti_image_free)>;

/// libnifti2's reading of the orientation fields.
NiftiImage interpret(const std::string& path, const std::vector<std::uint8_t>& bytes, int version) {
  static const int silenced = (nifti_set_debug_level(0), 0);
  static_cast<void>(silenced);
  nifti_image* image = nullptr;
  if (version == 1) {
    nifti_1_header raw;
    std::memcpy(&raw, bytes.data(), sizeof(raw));
    image = nifti_convert_n1hdr2nim(raw, nullptr);
  } else {
    nifti_2_header raw;
    std::memcpy(&raw, bytes.data(), sizeof(raw));
    image = nifti_convert_n2hdr2nim(raw, nullptr);
  }
  if (image == nullptr) {
    throw FormatError(path, "The header contradicts itself and is refused by the NIfTI library.");
  }
  return {image, &nifti_image_free};
}

double unitOfLength(int units) {
  switch (units & 7) {
    case 1:
      return 1000.0;
    case 3:
      return 0.001;
    default:
      return 1.0;
  }
}

/// An affine in mm; not valid when it is not finite or singular.
struct Affine {
  bool valid = false;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
};

Affine checkedAffine(const nifti_dmat44& m, double unit) {
  Eigen::Matrix4d affine;
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      affine(r, c) = m.m[r][c] * (r < 3 ? unit : 1.0);
    }
  }
  const double determinant = affine.topLeftCorner<3, 3>().determinant();
  return {affine.allFinite() && std::abs(determinant) > 1e-12, affine};
}

}  // namespace

const char* transformCodeName(int code) noexcept {
  switch (code) {
    case 1:
      return "scanner";
    case 2:
      return "aligned";
    case 3:
      return "Talairach";
    case 4:
      return "MNI 152";
    case 5:
      return "template";
    default:
      return "unnamed";
  }
}

namespace {

/// Largest distance in mm between where two affines put a corner of the volume.
double disagreement(const Eigen::Matrix4d& a, const Eigen::Matrix4d& b,
                    const std::array<int, 3>& dimensions) {
  double worst = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Eigen::Vector4d ijk(0, 0, 0, 1);
    for (unsigned axis = 0; axis < 3; ++axis) {
      ijk[axis] = (corner >> axis & 1U) != 0 ? dimensions[axis] - 1 : 0;
    }
    worst = std::max(worst, ((a - b) * ijk).head<3>().norm());
  }
  return worst;
}

/// Whether the spatial voxel sizes are all there; the library puts 1 where they are not.
bool hasVoxelSizes(const Fields& fields, int version) {
  bool all = true;
  for (std::size_t axis = 1; axis <= 3; ++axis) {
    const double size = version == 1 ? fields.at<float>(76 + 4 * axis) : fields.at<double>(104 + 8 * axis);
    all = all && std::isfinite(size) && size != 0;
  }
  return all;
}

std::string inWords(const char* form, int code) {
  return std::string(form) + " (code " + std::to_string(code) + ", " + transformCodeName(code) + ")";
}

/// What is said when both transforms are there and differ.
void compare(const RawHeader& raw, const Affine& sform, const Affine& qform, bool takeSform, NiftiHeader& header) {
  const double distance = disagreement(sform.matrix, qform.matrix, header.dimensions);
  if (distance <= 1e-3) {
    return;
  }
  header.disagreement = distance;
  const char* taken = takeSform ? "sform" : "qform";
  const char* other = takeSform ? "qform" : "sform";
  header.warnings.push_back("The " + inWords("sform", raw.sformCode) + " and the " + inWords("qform", raw.qformCode) +
                            " disagree by up to " + std::to_string(distance) + " mm; the " + taken + " is used, " +
                            "--transform " + other + " takes the other.");
}

/// Voxel sizes alone.
void orientBySizes(const std::string& path, const nifti_image& image, double unit, NiftiHeader& header) {
  nifti_dmat44 sizes{};
  const double spacing[3] = {image.dx, image.dy, image.dz};
  for (int i = 0; i < 3; ++i) {
    sizes.m[i][i] = std::abs(spacing[i]);
  }
  sizes.m[3][3] = 1;
  const Affine fallback = checkedAffine(sizes, unit);
  if (!fallback.valid) {
    throw FormatError(path, "The header holds no usable orientation and no usable voxel sizes.");
  }
  header.voxelToWorld = fallback.matrix;
  header.spaceReason = "NIfTI without sform and qform: voxel sizes only, orientation and place unknown";
}

void orient(const std::string& path, const RawHeader& raw, const nifti_image& image, VolumeTransform asked,
            NiftiHeader& header) {
  const double unit = unitOfLength(raw.units);
  const auto sform = raw.sformCode > 0 ? checkedAffine(image.sto_xyz, unit) : Affine();
  const auto qform = raw.qformCode > 0 ? checkedAffine(image.qto_xyz, unit) : Affine();
  if (raw.sformCode > 0 && !sform.valid) {
    header.warnings.emplace_back("The sform is not finite or singular and was passed over.");
  }
  if (raw.qformCode > 0 && !qform.valid) {
    header.warnings.emplace_back("The qform is not finite or singular and was passed over.");
  }
  const bool wantsQform = asked == VolumeTransform::Qform;
  if ((asked == VolumeTransform::Sform && !sform.valid) || (wantsQform && !qform.valid)) {
    const char* name = wantsQform ? "qform" : "sform";
    throw FormatError(path, std::string("A usable ") + name + " is asked for, but its code is 0 or it is singular; " +
                                "leave the choice out to take what is there.");
  }
  const bool takeSform = sform.valid && !wantsQform;
  if (sform.valid && qform.valid) {
    compare(raw, sform, qform, takeSform, header);
  }
  if (!sform.valid && !qform.valid) {
    return orientBySizes(path, image, unit, header);
  }
  header.voxelToWorld = takeSform ? sform.matrix : qform.matrix;
  header.space = CoordinateSpace::ScannerRAS;
  header.transformCode = takeSform ? raw.sformCode : raw.qformCode;
  header.spaceReason = std::string("NIfTI ") + (takeSform ? "sform" : "qform") + ", code " +
                       std::to_string(header.transformCode) + " (" + transformCodeName(header.transformCode) + ")";
}

/// Whether the whole numbers of a NIfTI-2 header are within those of NIfTI-1; the library prints what is not.
bool fitsNifti1(const nifti_image& image) {
  const std::int64_t others[] = {image.intent_code, image.qform_code, image.sform_code, image.slice_start,
                                 image.slice_end};
  const auto fits = [](std::int64_t number) { return number >= INT16_MIN && number <= INT16_MAX; };
  return std::all_of(std::begin(image.dim), std::end(image.dim), fits) &&
         std::all_of(std::begin(others), std::end(others), fits);
}

/// What the header says beyond place, type and time.
void note(const nifti_image& image, NiftiHeader& header) {
  const auto named = [](bool there, const char* name) { return std::string(there ? name : ""); };
  header.notes = listed({named(image.descrip[0] != 0, "description"), named(image.aux_file[0] != 0, "name of a file"),
                         named(image.intent_code != 0 || image.intent_name[0] != 0, "intent"),
                         named(image.cal_min != 0 || image.cal_max != 0, "display range"),
                         named(image.slice_code != 0 || image.slice_duration != 0, "times of slices")});
  const double unit = image.time_units == NIFTI_UNITS_MSEC   ? 1e-3
                      : image.time_units == NIFTI_UNITS_USEC ? 1e-6
                                                             : 1;
  const bool timed = image.time_units == NIFTI_UNITS_SEC || unit < 1;
  header.timeStep = timed && std::isfinite(image.dt) && image.dt > 0 ? image.dt * unit : 0;
  nifti_1_header plain{};
  if (fitsNifti1(image) && nifti_convert_nim2n1hdr(&image, &plain) == 0) {
    header.asNifti1.resize(sizeof(plain));
    std::memcpy(header.asNifti1.data(), &plain, sizeof(plain));
  }
}

}  // namespace

VoxelType niftiVoxelType(const std::string& path, int code) {
  switch (code) {
    case 2:
      return VoxelType::Uint8;
    case 4:
      return VoxelType::Int16;
    case 8:
      return VoxelType::Int32;
    case 16:
      return VoxelType::Float32;
    case 64:
      return VoxelType::Float64;
    case 256:
      return VoxelType::Int8;
    case 512:
      return VoxelType::Uint16;
    case 768:
      return VoxelType::Uint32;
    case 1024:
      return VoxelType::Int64;
    case 1280:
      return VoxelType::Uint64;
    case 128:
    case 2304:
      throw FormatError(path,
                        "A volume with one number per voxel is needed, but this one holds RGB colours; "
                        "give the image that the colours were made from.");
    case 32:
    case 1792:
    case 2048:
      throw FormatError(path,
                        "A volume of real numbers is needed, but this one is complex; give its magnitude.");
    default:
      break;
  }
  throw FormatError(path, "The NIfTI type code " + std::to_string(code) +
                              " is not read; integers and floating-point numbers of 8 to 64 bits are.");
}

std::uint64_t niftiHeaderSize(const std::string& path, const std::vector<std::uint8_t>& firstFour) {
  const ByteOrder order = byteOrderOf(path, firstFour.data());
  return static_cast<std::uint64_t>(decode<std::int32_t>(firstFour.data(), order));
}

NiftiHeader parseNiftiHeader(const std::string& path, const std::vector<std::uint8_t>& bytes,
                             VolumeTransform transform) {
  NiftiHeader header;
  header.version = bytes.size() == 348 ? 1 : 2;
  header.coding.order = byteOrderOf(path, bytes.data());
  header.pair = isPair(path, bytes, header.version);
  const Fields fields(bytes, header.coding.order);
  const RawHeader raw = header.version == 1 ? rawHeader1(fields) : rawHeader2(fields);
  if (raw.intent >= 3000 && raw.intent < 3100) {
    throw FormatError(
        path, "A volume is needed, but this is a CIFTI file, which belongs to surfaces; give it as per-vertex data.");
  }
  checkDimensions(path, raw, header);
  header.coding.type = niftiVoxelType(path, raw.datatype);
  setOffsetAndScaling(path, raw, header);
  if (!hasVoxelSizes(fields, header.version)) {
    header.warnings.emplace_back(
        "A voxel size is 0 or not finite; 1 was put in its place where the sform does not say.");
  }
  if ((raw.units & 7) == 0) {
    header.warnings.emplace_back("The unit of length is not stated; millimetres were assumed.");
  }
  const NiftiImage image = interpret(path, bytes, header.version);
  orient(path, raw, *image, transform, header);
  note(*image, header);
  return header;
}

}  // namespace authalic
