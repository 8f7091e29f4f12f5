#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "Core/base/Error.h"
#include "Formats/ByteCursor.h"
#include "Formats/FreeSurferPatch.h"
#include "Formats/Gifti.h"
#include "Formats/Morphometry.h"
#include "Formats/Mz3.h"
#include "Formats/VolumeFile.h"
#include "support/TemporaryFolder.h"

namespace {

using namespace authalic;
using authalic::testing::TemporaryFolder;

SurfaceFile twoTriangles() {
  SurfaceFile surface;
  surface.points = {0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
  surface.faces = {0, 1, 2, 0, 2, 3};
  surface.space = CoordinateSpace::TkRAS;
  surface.geometry.valid = true;
  return surface;
}

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const FormatError& error) {
    return error.what();
  }
  return "";
}

void writeBytes(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

TEST(FreeSurferPatch, KeepsVerticesBordersAndPoints) {
  const TemporaryFolder folder;
  writePatch(folder / "p.patch.3d", {{3, 0, 2}, {true, false, true}, {1, 2, 3, 4, 5, 6, 7, 8, 9}});
  const PatchFile patch = readPatch(folder / "p.patch.3d");
  EXPECT_EQ(patch.vertices, (std::vector<int>{3, 0, 2}));
  EXPECT_EQ(patch.border, (std::vector<bool>{true, false, true}));
  const SurfaceFile surface = patchSurface("p", patch, twoTriangles());
  EXPECT_EQ(surface.faces, (std::vector<int>{1, 2, 0}));
  EXPECT_EQ(surface.space, CoordinateSpace::TkRAS);
}

TEST(FreeSurferPatch, AFlatOneIsOfNoSpaceAndMarkedFlat) {
  const SurfaceFile surface =
      patchSurface("p", {{0, 1, 2}, {true, true, true}, {0, 0, 0, 1, 0, 0, 1, 1, 0}}, twoTriangles());
  EXPECT_EQ(surface.space, CoordinateSpace::Unknown);
  EXPECT_EQ(surface.metadata.at("GeometricType"), "Flat");
}

TEST(FreeSurferPatch, TheLayoutBefore2003IsRead) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> bytes;
  encode(bytes, std::int32_t{1}, ByteOrder::Big);
  encode(bytes, std::int32_t{-2}, ByteOrder::Big);
  for (const int hundredths : {150, -25, 0}) {
    encode(bytes, static_cast<std::int16_t>(hundredths), ByteOrder::Big);
  }
  writeBytes(folder / "old.patch.flat", bytes);
  const PatchFile patch = readPatch(folder / "old.patch.flat");
  EXPECT_EQ(patch.vertices, std::vector<int>{1});
  EXPECT_TRUE(patch.border[0]);
  EXPECT_EQ(patch.points, (std::vector<double>{1.5, -0.25, 0}));
}

TEST(FreeSurferPatch, ForeignSurfacesAndTornOnesAreRefused) {
  const TemporaryFolder folder;
  const PatchFile foreign{{9}, {false}, {0, 0, 0}};
  EXPECT_NE(messageOf([&] { static_cast<void>(patchSurface("p", foreign, twoTriangles())); }).find("vertex 9"),
            std::string::npos);
  EXPECT_NE(messageOf([&] { writePatch(folder / "t", {{1, 1}, {false, false}, {0, 0, 0, 1, 1, 1}}); }).find("twice"),
            std::string::npos);
}

TEST(Mz3, SurfaceAndOverlaysComeBack) {
  const TemporaryFolder folder;
  writeMz3(folder / "s.mz3", twoTriangles(), {{"a", {1, 2, 3, 4}}, {"b", {5, std::nanf(""), 7, 8}}});
  const Mz3File file = readMz3(folder / "s.mz3");
  EXPECT_EQ(file.points, twoTriangles().points);
  EXPECT_EQ(file.faces, twoTriangles().faces);
  ASSERT_EQ(file.layers.size(), 2U);
  EXPECT_EQ(file.layers[0], (std::vector<float>{1, 2, 3, 4}));
  EXPECT_TRUE(std::isnan(file.layers[1][1]));
  EXPECT_EQ(readSurface(folder / "s.mz3").space, CoordinateSpace::Unknown);
  EXPECT_EQ(readVertexScalars(folder / "s.mz3"), file.layers[0]);
}

TEST(Annotations, ComeBackWithTableAndVerticesWithoutRegion) {
  const TemporaryFolder folder;
  const Annotation original{{2, -1, 5}, {{2, "two", {1, 2, 3, 255}}, {5, "five", {4, 5, 6, 100}}}, {}};
  writeAnnot(folder / "a.annot", original);
  const Annotation copy = readAnnot(folder / "a.annot");
  EXPECT_EQ(copy.labels, original.labels);
  ASSERT_EQ(copy.regions.size(), 2U);
  EXPECT_EQ(copy.regions[1].name, "five");
  EXPECT_EQ(copy.regions[1].rgba, original.regions[1].rgba);
}

TEST(Annotations, WithoutTheirTableAreReadAndRefusedWhereItIsCut) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> bytes;
  for (const std::int32_t number : {1, 0, 5, 0}) {  // a vertex and its colour; no table
    encode(bytes, number, ByteOrder::Big);
  }
  for (std::size_t length = bytes.size(); length >= 12; --length) {
    std::ofstream(folder / "a.annot", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(length));
    if (length == 16 || length == 12) {
      EXPECT_EQ(readAnnot(folder / "a.annot").labels, (std::vector<std::int32_t>{5}));
    } else {
      EXPECT_THROW(static_cast<void>(readAnnot(folder / "a.annot")), FormatError) << length;
    }
  }
}

TEST(Annotations, WhatColoursCannotTellApartIsRefused) {
  const TemporaryFolder folder;
  const Region black{0, "black", {0, 0, 0, 255}}, red{1, "red", {255, 0, 0, 255}}, alsoRed{2, "also", {255, 0, 0, 9}};
  EXPECT_NE(messageOf([&] { writeAnnot(folder / "a", {{1}, {red, alsoRed}, {}}); }).find("also"), std::string::npos);
  EXPECT_NE(messageOf([&] { writeAnnot(folder / "a", {{1, -1}, {black, red}, {}}); }).find("black"), std::string::npos);
  EXPECT_NE(messageOf([&] { writeAnnot(folder / "a", {{7}, {red}, {}}); }).find("label 7"), std::string::npos);
}

TEST(VertexLists, LabelsAndSparseValuesComeBack) {
  const TemporaryFolder folder;
  writeLabel(folder / "l.label", {3, 1}, {0, 1, 2, 3, 4, 5}, {0.5F, 1}, CoordinateSpace::TkRAS);
  EXPECT_EQ(readLabel(folder / "l.label").vertices, (std::vector<int>{3, 1}));
  EXPECT_EQ(readLabel(folder / "l.label").values, (std::vector<float>{0.5F, 1}));
  std::ofstream(folder / "cut.label") << "#!ascii label\n2\n1 0.5 1 2 3\n2 1 2 3";  // before its last value
  EXPECT_NE(messageOf([&] { static_cast<void>(readLabel(folder / "cut.label")); }).find("entry 1"), std::string::npos);
  writePaint(folder / "v.w", {1, std::nanf(""), 3});
  EXPECT_EQ(readPaint(folder / "v.w").vertices, (std::vector<int>{0, 2}));
  EXPECT_NE(messageOf([&] { static_cast<void>(readVertexScalars(folder / "v.w")); }).find("give the surface"),
            std::string::npos);
  EXPECT_NE(messageOf([&] { static_cast<void>(readVertexScalars(folder / "v.w", 2)); }).find("vertex 2"),
            std::string::npos);
}

TEST(MghFile, ObliqueVolumesComeBack) {
  const TemporaryFolder folder;
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  affine.topLeftCorner<3, 3>() << -0.5, 0, 1.5, 0.75, 0, 1, 0, -2, 0;
  affine.topRightCorner<3, 1>() << 3, -4, 5;
  ScalarVolume volume({2, 3, 4}, affine);
  for (std::size_t i = 0; i < volume.values.size(); ++i) {
    volume.values[i] = static_cast<float>(i) / 3;
  }
  for (const char* name : {"v.mgh", "v.mgz"}) {
    writeVolume(folder / name, volume);
    const VolumeFile copy = readVolume(folder / name);
    EXPECT_LT((copy.voxelToWorld() - affine).cwiseAbs().maxCoeff(), 1e-5);
    EXPECT_EQ(copy.scalars().values, volume.values);
    EXPECT_EQ(copy.space, CoordinateSpace::ScannerRAS);
  }
}

TEST(HostileSizes, ASmallFileThatClaimsThirtyTwoThousandCubedIsRefusedWithoutTheMemory) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> mgh;
  for (const int number : {1, 32767, 32767, 32767, 1, 3}) {
    encode(mgh, static_cast<std::int32_t>(number), ByteOrder::Big);
  }
  mgh.resize(1024, 0);
  writeBytes(folder / "v.mgh", mgh);
  writeVolume(folder / "v.nii", ScalarVolume({5, 5, 5}, Eigen::Matrix4d::Identity()));
  std::fstream nifti(folder / "v.nii", std::ios::binary | std::ios::in | std::ios::out);
  nifti.seekp(42);
  nifti.write("\xFF\x7F\xFF\x7F\xFF\x7F", 6);
  nifti.close();
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  for (const char* name : {"v.mgh", "v.nii"}) {
    EXPECT_NE(messageOf([&] { static_cast<void>(readVolume(folder / name)); }), "") << name;
  }
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 32 * 1024) << "KiB more than before";
}
