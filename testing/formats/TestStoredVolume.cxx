#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>

#include "Core/base/Error.h"
#include "Formats/ByteCursor.h"
#include "Formats/InputFile.h"
#include "Formats/StoredVolume.h"
#include "support/Nifti2Bytes.h"
#include "support/TemporaryFolder.h"

namespace {

using namespace authalic;
using authalic::testing::nifti2Bytes;
using authalic::testing::Nifti2Fields;
using authalic::testing::TemporaryFolder;

StoredVolume counting(VoxelType type, int frames) {
  StoredVolume volume;
  volume.dimensions = {2, 3, 4};
  volume.framesHeld = frames;
  volume.voxelToWorld.diagonal() << 2, 3, 4, 1;
  volume.type = type;
  volume.bytes.resize(static_cast<std::size_t>(24 * frames * voxelSize(type)));
  for (std::size_t i = 0; i < volume.bytes.size(); ++i) {
    volume.bytes[i] = static_cast<std::uint8_t>(i % 120);  // no NaN
  }
  return volume;
}

/// The file again with every number of the header and the voxels turned round, as a big-endian machine writes it.
std::vector<std::uint8_t> turned(std::vector<std::uint8_t> bytes, std::size_t voxelSizeInBytes) {
  const auto turn = [&bytes](std::size_t at, std::size_t size) {
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    std::reverse(first, first + static_cast<std::ptrdiff_t>(size));
  };
  for (const std::size_t at : {0U, 32U}) {
    turn(at, 4);
  }
  for (const std::size_t at : {36U, 40U, 42U, 44U, 46U, 48U, 50U, 52U, 54U, 68U, 70U, 72U, 74U, 120U, 252U, 254U}) {
    turn(at, 2);
  }
  for (std::size_t at = 56; at < 68; at += 4) {
    turn(at, 4);
  }
  for (std::size_t at = 76; at < 120; at += 4) {
    turn(at, 4);
  }
  for (std::size_t at = 124; at < 148; at += 4) {
    turn(at, 4);
  }
  for (std::size_t at = 256; at < 328; at += 4) {
    turn(at, 4);
  }
  for (std::size_t at = 352; at < bytes.size(); at += voxelSizeInBytes) {
    turn(at, voxelSizeInBytes);
  }
  return bytes;
}

void write(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

constexpr VolumeRequest everything{0, true, true, VolumeTransform::Automatic};

}  // namespace

TEST(StoredVolume, EveryTypeComesBackByteForByteInEitherOrder) {
  const TemporaryFolder folder;
  for (const VoxelType type : {VoxelType::Uint8, VoxelType::Int8, VoxelType::Int16, VoxelType::Uint16, VoxelType::Int32,
                               VoxelType::Uint32, VoxelType::Int64, VoxelType::Uint64, VoxelType::Float32,
                               VoxelType::Float64}) {
    for (const char* name : {"v.nii", "v.nii.gz", "v.mgh", "v.mgz"}) {
      const StoredVolume volume = counting(type, 3);
      if (!holds(name, type, false)) {
        EXPECT_THROW(writeStoredVolume(folder / name, volume), FormatError);
        continue;
      }
      writeStoredVolume(folder / name, volume);
      const StoredVolume back = readStoredVolume(folder / name, everything);
      EXPECT_EQ(back.type, type);
      EXPECT_EQ(back.framesHeld, 3);
      EXPECT_EQ(back.bytes, volume.bytes) << name << " " << voxelTypeName(type);
      const StoredVolume one = readStoredVolume(folder / name, {1, false, false, VolumeTransform::Automatic});
      const auto size = static_cast<std::ptrdiff_t>(volume.bytes.size() / 3);
      EXPECT_EQ(one.bytes, std::vector<std::uint8_t>(volume.bytes.begin() + size, volume.bytes.begin() + 2 * size));
    }
    writeStoredVolume(folder / "v.nii", counting(type, 2));
    write(folder / "big.nii", turned(readBytes(folder / "v.nii"), static_cast<std::size_t>(voxelSize(type))));
    const StoredVolume big = readStoredVolume(folder / "big.nii", everything);
    EXPECT_EQ(big.bytes, counting(type, 2).bytes) << voxelTypeName(type);
    writeStoredVolume(folder / "again.nii", big);
    EXPECT_EQ(readBytes(folder / "again.nii"), readBytes(folder / "v.nii"));
  }
}

TEST(StoredVolume, ExtensionsAreKeptOrNamed) {
  const TemporaryFolder folder;
  writeStoredVolume(folder / "v.nii", counting(VoxelType::Int16, 1));
  auto bytes = readBytes(folder / "v.nii");
  std::vector<std::uint8_t> extension{1, 0, 0, 0, 16, 0, 0, 0, 6, 0, 0, 0, 'w', 'o', 'r', 'd', 's', 0, 0, 0};
  const float offset = 368;
  std::memcpy(bytes.data() + 108, &offset, 4);
  bytes.erase(bytes.begin() + 348, bytes.begin() + 352);
  bytes.insert(bytes.begin() + 348, extension.begin(), extension.end());
  write(folder / "e.nii", bytes);
  const StoredVolume kept = readStoredVolume(folder / "e.nii", everything);
  EXPECT_EQ(kept.notRead, "extensions");
  EXPECT_EQ(kept.niftiNotes.size(), 368U);
  writeStoredVolume(folder / "again.nii", kept);
  EXPECT_EQ(readBytes(folder / "again.nii"), bytes);
  bytes[352] = 200;  // longer than what is there
  write(folder / "bad.nii", bytes);
  const StoredVolume damaged = readStoredVolume(folder / "bad.nii", everything);
  EXPECT_EQ(damaged.niftiNotes.size(), 348U);
  EXPECT_EQ(damaged.bytes, kept.bytes);
}

TEST(StoredVolume, TheTransformAskedForIsTakenOrRefused) {
  const TemporaryFolder folder;
  writeStoredVolume(folder / "v.nii", counting(VoxelType::Int16, 1));
  auto bytes = readBytes(folder / "v.nii");
  const float moved = 7;
  std::memcpy(bytes.data() + 268, &moved, 4);  // qoffset_x
  write(folder / "q.nii", bytes);
  for (const auto& [transform, x] : {std::pair(VolumeTransform::Automatic, 0.0), std::pair(VolumeTransform::Sform, 0.0),
                                     std::pair(VolumeTransform::Qform, 7.0)}) {
    const VolumeFile file = readVolume(folder / "q.nii", 0, transform);
    EXPECT_EQ(file.voxelToWorld()(0, 3), x);
    EXPECT_NEAR(file.disagreement, 7, 1e-6);
  }
  bytes[252] = bytes[254] = 0;  // neither
  write(folder / "none.nii", bytes);
  EXPECT_EQ(readVolume(folder / "none.nii").space, CoordinateSpace::Unknown);
  for (const VolumeTransform transform : {VolumeTransform::Sform, VolumeTransform::Qform}) {
    EXPECT_THROW(static_cast<void>(readVolume(folder / "none.nii", 0, transform)), FormatError);
  }
}

TEST(StoredVolume, NotesThatNifti1CannotHoldAreNotKeptAndNothingIsPrinted) {
  const TemporaryFolder folder;
  Nifti2Fields fields;
  fields.intentCode = 768000;  // beyond 16 bits
  std::vector<std::uint8_t> bytes = nifti2Bytes(fields);
  bytes.resize(bytes.size() + 8, 0);
  write(folder / "v.nii", bytes);
  ::testing::internal::CaptureStderr();
  const StoredVolume file = readStoredVolume(folder / "v.nii", everything);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(file.niftiNotes.empty());
  EXPECT_EQ(file.notRead, "intent");
}
