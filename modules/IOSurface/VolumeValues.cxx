#include "VolumeValues.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTypeTraits.h>
#include <vtkUnsignedCharArray.h>

#include "FieldArrays.h"
#include "Formats/ByteCursor.h"
#include "SurfaceConversion.h"

namespace authalic {

namespace {

constexpr const char* kNiftiNotes = "NiftiNotes";
constexpr const char* kMghNotes = "MghNotes";

/// Calls work(T()) with the C++ type of the stored numbers.
template <class Work>
void withType(VoxelType type, Work work) {
  switch (type) {
    case VoxelType::Uint8:
      return work(std::uint8_t());
    case VoxelType::Int8:
      return work(std::int8_t());
    case VoxelType::Int16:
      return work(std::int16_t());
    case VoxelType::Uint16:
      return work(std::uint16_t());
    case VoxelType::Int32:
      return work(std::int32_t());
    case VoxelType::Uint32:
      return work(std::uint32_t());
    case VoxelType::Int64:
      return work(std::int64_t());
    case VoxelType::Uint64:
      return work(std::uint64_t());
    case VoxelType::Float32:
      return work(float());
    case VoxelType::Float64:
      return work(double());
    case VoxelType::None:
      break;
  }
}

template <class Stored, class Value>
void fill(const StoredVolume& volume, Value* to) {
  const auto frames = static_cast<std::size_t>(volume.framesHeld);
  const std::size_t voxels = volume.bytes.size() / sizeof(Stored) / frames;
  const std::uint8_t* from = volume.bytes.data();
  const bool scaled = volume.isScaled();
  for (std::size_t frame = 0; frame < frames; ++frame) {
    for (std::size_t i = 0; i < voxels; ++i, from += sizeof(Stored)) {
      const auto stored = decode<Stored>(from, ByteOrder::Little);
      to[i * frames + frame] = scaled ? static_cast<Value>(volume.slope * static_cast<double>(stored) + volume.inter)
                                      : static_cast<Value>(stored);
    }
  }
}

/// How numbers are to be stored.
struct Coding {
  VoxelType type = VoxelType::None;
  double slope = 1, inter = 0;
  [[nodiscard]] bool isScaled() const { return slope != 1 || inter != 0; }
};

VoxelType typeOf(vtkDataArray* array) {
  const int size = array->GetDataTypeSize();
  if (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE) {
    return size == 4 ? VoxelType::Float32 : VoxelType::Float64;
  }
  const bool negative = array->GetDataTypeMin() < 0;
  switch (size) {
    case 1:
      return negative ? VoxelType::Int8 : VoxelType::Uint8;
    case 2:
      return negative ? VoxelType::Int16 : VoxelType::Uint16;
    case 4:
      return negative ? VoxelType::Int32 : VoxelType::Uint32;
    default:
      return negative ? VoxelType::Int64 : VoxelType::Uint64;
  }
}

/// The stored number that comes nearest to giving `value`; 0 where the type has none.
template <class Stored>
Stored nearest(double value, const Coding& coding) {
  const double number = coding.isScaled() ? (value - coding.inter) / coding.slope : value;
  if constexpr (std::is_floating_point_v<Stored>) {
    return static_cast<Stored>(number);
  } else {
    const double whole = std::round(number);
    const double end = std::ldexp(1.0, std::numeric_limits<Stored>::digits);
    const double begin = std::is_signed_v<Stored> ? -end : 0.0;
    return whole >= begin && whole < end ? static_cast<Stored>(whole) : Stored(0);
  }
}

/// Appends every value; returns how far the farthest comes back from itself.
template <class Stored>
double store(vtkDataArray* array, const Coding& coding, bool mayRound, std::vector<std::uint8_t>& bytes) {
  const bool same = array->HasStandardMemoryLayout() && typeOf(array) == coding.type && !coding.isScaled();
  const auto* own = same ? static_cast<const Stored*>(array->GetVoidPointer(0)) : nullptr;
  const int frames = array->GetNumberOfComponents();
  double worst = 0;
  for (int frame = 0; frame < frames; ++frame) {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
      if (own) {
        encode(bytes, own[i * frames + frame], ByteOrder::Little);
        continue;
      }
      const double value = array->GetComponent(i, frame);
      const auto stored = nearest<Stored>(value, coding);
      const double back = coding.slope * static_cast<double>(stored) + coding.inter;
      const bool exact = back == value || (std::isnan(back) && std::isnan(value));
      worst = exact ? worst : std::max(worst, std::isnan(back - value) ? HUGE_VAL : std::abs(back - value));
      if (worst > 0 && !mayRound) {
        return worst;
      }
      encode(bytes, stored, ByteOrder::Little);
    }
  }
  return worst;
}

/// What a reader noted of the file's own coding.
Coding notedCoding(vtkImageData* image) {
  const std::string words = textField(image, "StoredType");
  Coding coding;
  coding.type = voxelTypeNamed(words.substr(0, words.find(' ')));
  if (words.find(' ') != std::string::npos) {
    coding.slope = numberField(image, "Slope", 0);
    coding.inter = numberField(image, "Intercept", 0);
    coding.type = coding.slope == 0 ? VoxelType::None : coding.type;
  }
  return coding;
}

std::vector<Coding> codingsToTry(vtkImageData* image, vtkDataArray* array) {
  std::vector<Coding> codings{notedCoding(image)};
  const VoxelType own = typeOf(array);
  if (own == VoxelType::Float64) {
    codings.push_back({VoxelType::Float32});
  } else if (own != VoxelType::Float32 && array->GetDataTypeSize() >= 4) {
    codings.push_back({VoxelType::Int32});
  }
  codings.push_back({own});
  codings.push_back({VoxelType::Int32});
  return codings;
}

std::vector<std::uint8_t> bytesField(vtkImageData* image, const char* name) {
  auto* array = vtkUnsignedCharArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(name));
  if (!array) {
    return {};
  }
  return {array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues()};
}

void addBytes(vtkImageData* image, const char* name, const std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) {
    return;
  }
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), array->GetPointer(0));
  image->GetFieldData()->AddArray(array);
}

}  // namespace

int scalarTypeOf(const StoredVolume& volume, bool keepNumbers) {
  if (!keepNumbers) {
    return volume.isInteger32() ? VTK_INT : VTK_FLOAT;
  }
  int type = VTK_DOUBLE;
  if (!volume.isScaled()) {
    withType(volume.type, [&type](auto number) { type = vtkTypeTraits<decltype(number)>::VTK_TYPE_ID; });
  }
  return type;
}

vtkSmartPointer<vtkDataArray> valuesOf(const StoredVolume& volume, bool keepNumbers) {
  const int type = scalarTypeOf(volume, keepNumbers);
  auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  values->SetName("Values");
  values->SetNumberOfComponents(volume.framesHeld);
  const std::size_t numbers = volume.bytes.size() / static_cast<std::size_t>(voxelSize(volume.type));
  values->SetNumberOfTuples(static_cast<vtkIdType>(numbers / static_cast<std::size_t>(volume.framesHeld)));
  void* to = values->GetVoidPointer(0);
  withType(volume.type, [&](auto number) {
    using Stored = decltype(number);
    if (type == VTK_DOUBLE) {
      fill<Stored>(volume, static_cast<double*>(to));
    } else if (type == VTK_FLOAT) {
      fill<Stored>(volume, static_cast<float*>(to));
    } else if (type == VTK_INT) {
      fill<Stored>(volume, static_cast<int*>(to));
    } else {
      fill<Stored>(volume, static_cast<Stored*>(to));
    }
  });
  return values;
}

void setNotes(vtkImageData* output, const StoredVolume& volume) {
  if (volume.isScaled()) {
    addField(output, "Slope", volume.slope);
    addField(output, "Intercept", volume.inter);
  }
  if (volume.timeStep > 0) {
    addField(output, "TimeStep", volume.timeStep);
  }
  addBytes(output, kNiftiNotes, volume.niftiNotes);
  addBytes(output, kMghNotes, volume.mghNotes);
}

VolumeToWrite toStored(const std::string& path, vtkImageData* volume) {
  vtkDataArray* array = volume->GetPointData()->GetScalars();
  VolumeToWrite result;
  StoredVolume& stored = result.volume;
  volume->GetDimensions(stored.dimensions.data());
  stored.framesHeld = array->GetNumberOfComponents();
  stored.voxelToWorld = affineOf(volume);
  stored.transformCode = static_cast<int>(numberField(volume, "TransformCode", 1));
  stored.timeStep = numberField(volume, "TimeStep", 0);
  stored.niftiNotes = bytesField(volume, kNiftiNotes);
  stored.mghNotes = bytesField(volume, kMghNotes);
  const auto tryCoding = [&](const Coding& coding, bool mayRound) {
    stored.bytes.clear();
    stored.bytes.reserve(static_cast<std::size_t>(array->GetNumberOfValues()) *
                         static_cast<std::size_t>(voxelSize(coding.type)));
    withType(coding.type, [&](auto number) {
      result.rounding = store<decltype(number)>(array, coding, mayRound, stored.bytes);
    });
    stored.type = coding.type;
    stored.slope = coding.slope;
    stored.inter = coding.inter;
    return result.rounding == 0;
  };
  for (const Coding& coding : codingsToTry(volume, array)) {
    if (holds(path, coding.type, coding.isScaled()) && tryCoding(coding, false)) {
      return result;
    }
  }
  tryCoding({VoxelType::Float32}, true);
  return result;
}

}  // namespace authalic
