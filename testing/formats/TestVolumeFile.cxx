#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>

#include "Core/base/Error.h"
#include "Formats/Morphometry.h"
#include "Formats/VolumeFile.h"
#include "support/SharedData.h"
#include "support/TemporaryFolder.h"

namespace {

using namespace authalic;
using authalic::testing::sharedData;
using authalic::testing::TemporaryFolder;

Eigen::Matrix4d obliqueAffine() {
  Eigen::Matrix4d affine;
  affine << -0.8, 1.2, 0, 10, 0.6, 1.6, 0, -20, 0, 0, 1.5, 30, 0, 0, 0, 1;
  return affine;
}

std::string bytesOf(const std::string& path) {
  std::ifstream input(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

/// A small valid NIfTI-1 file: 3 × 4 × 5, float.
std::string niftiBytes() {
  const TemporaryFolder folder;
  ScalarVolume volume({3, 4, 5}, obliqueAffine(), 1.5F);
  writeVolume(folder / "v.nii", volume);
  return bytesOf(folder / "v.nii");
}

template <class T>
std::string with(std::string bytes, std::size_t offset, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  return bytes.replace(offset, sizeof(T), raw, sizeof(T));
}

std::string messageOf(const std::string& bytes, const char* name = "v.nii") {
  const TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary) << bytes;
  try {
    static_cast<void>(readVolume(folder / name));
  } catch (const FormatError& error) {
    return error.what();
  }
  return "";
}

VolumeFile readBytesAsVolume(const std::string& bytes) {
  const TemporaryFolder folder;
  std::ofstream(folder / "v.nii", std::ios::binary) << bytes;
  return readVolume(folder / "v.nii");
}

}  // namespace

TEST(VolumeFile, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  ScalarVolume scalars({3, 4, 5}, obliqueAffine());
  LabelVolume labels({3, 4, 5}, obliqueAffine());
  for (std::size_t i = 0; i < scalars.size(); ++i) {
    scalars.values[i] = 0.1F * static_cast<float>(i);
    labels.values[i] = 70000000 + static_cast<std::int32_t>(i);
  }
  scalars.values[7] = std::nanf("");
  for (const char* name : {"a.nii", "a.nii.gz"}) {
    writeVolume(folder / name, scalars);
    const VolumeFile back = readVolume(folder / name);
    EXPECT_FALSE(back.isInteger());
    EXPECT_TRUE(std::isnan(back.scalars().values[7]));
    EXPECT_EQ(back.scalars().values[59], scalars.values[59]);
    EXPECT_LT((back.voxelToWorld() - obliqueAffine()).norm(), 1e-5);
    EXPECT_TRUE(back.warnings.empty());
    EXPECT_EQ(back.space, CoordinateSpace::ScannerRAS);
    writeVolume(folder / name, labels);
    EXPECT_TRUE(readVolume(folder / name).isInteger());
    EXPECT_EQ(readVolume(folder / name).labels().values, labels.values);
  }
}

TEST(VolumeFile, LabelsMustBeWholeNumbers) {
  VolumeFile file;
  ScalarVolume volume({2, 1, 1}, Eigen::Matrix4d::Identity());
  volume.values = {3.F, -2.F};
  file.volume = volume;
  EXPECT_EQ(file.labels().values, (std::vector<std::int32_t>{3, -2}));
  for (const float bad : {0.5F, 3e9F, std::nanf("")}) {
    volume.values[1] = bad;
    file.volume = volume;
    EXPECT_THROW(static_cast<void>(file.labels()), FormatError) << bad;
  }
}

TEST(NiftiGate, RefusesHeadersThatCannotBeTrue) {
  const std::string good = niftiBytes();
  ASSERT_EQ(messageOf(good), "");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::pair<std::string, const char*> cases[] = {
      {with(good, 0, 12345), "348 or 540"},
      {with(good, 344, 'x'), "Analyze"},
      {with(good, 40, std::int16_t{0}), "dimensions"},
      {with(good, 40, std::int16_t{99}), "dimensions"},
      {with(good, 42, std::int16_t{0}), "extent"},
      {with(good, 42, std::int16_t{-3}), "extent"},
      {with(with(with(good, 42, std::int16_t{32767}), 44, std::int16_t{32767}), 46, std::int16_t{32767}), "extent"},
      {with(with(good, 42, std::int16_t{32767}), 44, std::int16_t{32767}), "truncated"},
      {with(good, 70, std::int16_t{9999}), "type code 9999"},
      {with(good, 70, std::int16_t{0}), "type code 0"},
      {with(good, 70, std::int16_t{1}), "type code 1"},
      {with(good, 70, std::int16_t{1536}), "type code 1536"},
      {with(good, 70, std::int16_t{128}), "RGB"},
      {with(good, 70, std::int16_t{32}), "complex"},
      {with(good, 108, -5.F), "begin"},
      {with(good, 108, 1e12F), "truncated"},
      {with(good, 108, 348.F), "begin"},
      {with(good, 108, nan), "begin"},
      {with(good, 112, nan), "scl_slope"},
      {with(good, 116, std::numeric_limits<float>::infinity()), "scl_slope"},
      {with(good, 68, std::int16_t{3006}), "CIFTI"},
      {good.substr(0, 100), "truncated"},
      {good.substr(0, good.size() - 1), "truncated"}};
  for (const auto& [bytes, words] : cases) {
    EXPECT_NE(messageOf(bytes).find(words), std::string::npos) << words << ": " << messageOf(bytes);
  }
}

TEST(NiftiGate, FallsBackFromABrokenSformWithAWarning) {
  const std::string good = niftiBytes();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const VolumeFile toQform = readBytesAsVolume(with(good, 280, nan));
  EXPECT_LT((toQform.voxelToWorld() - obliqueAffine()).norm(), 1e-4);
  EXPECT_NE(toQform.spaceReason.find("qform"), std::string::npos);
  ASSERT_EQ(toQform.warnings.size(), 1U);
  const VolumeFile neither = readBytesAsVolume(with(with(good, 280, nan), 252, std::int16_t{0}));
  EXPECT_EQ(neither.space, CoordinateSpace::Unknown);
  EXPECT_NEAR(neither.voxelToWorld()(1, 1), 2.0, 1e-5);
}

TEST(NiftiGate, WarnsWhenSformAndQformDisagree) {
  const VolumeFile file = readBytesAsVolume(with(niftiBytes(), 292, 12.F));
  ASSERT_EQ(file.warnings.size(), 1U);
  EXPECT_NE(file.warnings[0].find("disagree"), std::string::npos);
  EXPECT_NEAR(file.voxelToWorld()(0, 3), 12, 1e-6) << "the sform is used";
}

TEST(NiftiGate, ConvertsUnitsAndAppliesScaling) {
  const std::string good = niftiBytes();
  const VolumeFile metres = readBytesAsVolume(with(good, 123, char{1}));
  EXPECT_LT((metres.voxelToWorld().topRows<3>() - 1000 * obliqueAffine().topRows<3>()).norm(), 0.1);
  const VolumeFile scaled = readBytesAsVolume(with(with(good, 112, 2.F), 116, -1.F));
  EXPECT_EQ(scaled.scalars().values[0], 2.F);
  const VolumeFile unscaled = readBytesAsVolume(with(with(good, 112, 0.F), 116, -1.F));
  EXPECT_EQ(unscaled.scalars().values[0], 1.5F);
}

TEST(VolumeFile, RefusesDamagedCompression) {
  const TemporaryFolder folder;
  LabelVolume labels({40, 40, 40}, Eigen::Matrix4d::Identity());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels.values[i] = static_cast<std::int32_t>(i * 2654435761U);
  }
  writeVolume(folder / "v.nii.gz", labels);
  std::string bytes = bytesOf(folder / "v.nii.gz");
  EXPECT_NE(messageOf(bytes.substr(0, bytes.size() / 2), "v.nii.gz"), "");
  EXPECT_NE(messageOf(bytes.substr(0, bytes.size() - 4), "v.nii.gz"), "") << "the checksum is missing";
  bytes[bytes.size() - 6] = static_cast<char>(~bytes[bytes.size() - 6]);
  EXPECT_NE(messageOf(bytes, "v.nii.gz").find("damaged"), std::string::npos) << "the checksum is wrong";
}

TEST(VolumeFile, RefusesFramesThatAreNotThereAndPairsWithoutImage) {
  const std::string functional = sharedData("volumes/edge/functional.nii");
  AUTHALIC_NEEDS(functional);
  EXPECT_EQ(readVolume(functional).frames, 20);
  EXPECT_THROW(static_cast<void>(readVolume(functional, 20)), FormatError);
  EXPECT_THROW(static_cast<void>(readVolume(functional, -1)), FormatError);
  EXPECT_THROW(static_cast<void>(readVolume(sharedData("volumes/edge/nifti1.hdr"))), FormatError);
  EXPECT_THROW(static_cast<void>(readVolume(sharedData("volumes/edge/analyze.hdr"))), FormatError);
  EXPECT_THROW(static_cast<void>(readVolume(sharedData("volumes/edge/example_rgb.nii.gz"))), FormatError);
}

TEST(VolumeFile, PairsAreFoundFromEitherNameGzippedOrNot) {
  const std::string header = sharedData("volumes/edge/ras.hdr");
  AUTHALIC_NEEDS(header);
  const TemporaryFolder folder;
  for (const char* end : {".hdr", ".img"}) {
    std::filesystem::copy_file(sharedData(std::string("volumes/edge/ras") + end), folder / (std::string("a") + end));
  }
  const auto expected = readVolume(folder / "a.hdr").scalars().values;
  EXPECT_EQ(readVolume(folder / "a.img").scalars().values, expected);
  ASSERT_EQ(std::system(("gzip " + (folder / "a.img")).c_str()), 0);
  EXPECT_EQ(readVolume(folder / "a.hdr").scalars().values, expected);
  ASSERT_EQ(std::system(("gzip " + (folder / "a.hdr")).c_str()), 0);
  EXPECT_EQ(readVolume(folder / "a.img.gz").scalars().values, expected);
}

TEST(VolumeFile, BigAndLittleEndianTwinsAreEqual) {
  AUTHALIC_NEEDS(sharedData("volumes/edge/big.nii.gz"));
  const VolumeFile big = readVolume(sharedData("volumes/edge/big.nii.gz"));
  const VolumeFile little = readVolume(sharedData("volumes/edge/little.nii.gz"));
  EXPECT_EQ(big.scalars().values, little.scalars().values);
  EXPECT_EQ(big.voxelToWorld(), little.voxelToWorld());
}

TEST(Morphometry, GivesBackWhatWasWrittenAndReadsText) {
  const TemporaryFolder folder;
  const std::vector<float> values{1.5F, -2.F, 1e-30F};
  writeMorphometry(folder / "lh.curv", values, 7);
  EXPECT_EQ(readVertexScalars(folder / "lh.curv"), values);
  std::ofstream(folder / "a.txt") << "# measure\n1.5\n\n-2\r\nn/a\nnan\n";
  const auto text = readVertexScalars(folder / "a.txt");
  ASSERT_EQ(text.size(), 4U);
  EXPECT_EQ(text[1], -2.F);
  EXPECT_TRUE(std::isnan(text[2]) && std::isnan(text[3]));
  std::ofstream(folder / "b.txt") << "1\n2 3\n";
  EXPECT_THROW(static_cast<void>(readVertexScalars(folder / "b.txt")), FormatError);
}

TEST(Morphometry, NanOfTheMedialWallIsKept) {
  const std::string path = sharedData("cortex/conte69_gifti/lh.conte69_32k_thickness");
  AUTHALIC_NEEDS(path);
  const auto values = readVertexScalars(path);
  EXPECT_EQ(values.size(), 32492U);
  EXPECT_EQ(std::count_if(values.begin(), values.end(), [](float x) { return std::isnan(x); }), 3221);
}

TEST(Annotation, PlacesVerticesByNumberAndReadsBothTables) {
  const TemporaryFolder folder;
  const auto word = [](std::string& bytes, std::int32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      bytes += static_cast<char>(value >> shift & 255);
    }
  };
  for (const bool old : {false, true}) {
    std::string bytes;
    for (const std::int32_t value : {3, 2, 0x030201, 0, 0x060504, 1, 0, 1}) {
      word(bytes, value);
    }
    for (const std::int32_t value : old ? std::vector<std::int32_t>{2} : std::vector<std::int32_t>{-2, 10}) {
      word(bytes, value);
    }
    word(bytes, 4);
    bytes += std::string("ctb\0", 4);
    if (!old) {
      word(bytes, 2);
    }
    for (const int region : {0, 1}) {
      if (!old) {
        word(bytes, region == 0 ? 7 : 9);
      }
      word(bytes, 2);
      bytes += std::string(region == 0 ? "a" : "b") + '\0';
      for (const std::int32_t part : {1 + 3 * region, 2 + 3 * region, 3 + 3 * region, 55}) {
        word(bytes, part);
      }
    }
    std::ofstream(folder / "lh.annot", std::ios::binary) << bytes;
    const Annotation annotation = readAnnot(folder / "lh.annot");
    EXPECT_EQ(annotation.labels, (old ? std::vector<std::int32_t>{1, -1, 0} : std::vector<std::int32_t>{9, -1, 7}));
    EXPECT_EQ(annotation.regions[1].name, "b");
    EXPECT_EQ(annotation.regions[1].rgba[3], 200);
  }
}
