#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "Core/base/Error.h"
#include "Formats/ByteCursor.h"
#include "Formats/Gifti.h"
#include "Formats/SurfaceFile.h"
#include "support/SharedData.h"
#include "support/TemporaryFolder.h"
#include "support/TestMeshes.h"

namespace {

using namespace authalic;
using authalic::testing::sharedData;
using authalic::testing::TemporaryFolder;

SurfaceFile sphere() {
  const TriangleMesh mesh = authalic::testing::sphereMesh(2);
  SurfaceFile surface;
  surface.points.assign(mesh.points().data(), mesh.points().data() + mesh.points().size());
  surface.faces.assign(mesh.faces().data(), mesh.faces().data() + mesh.faces().size());
  return surface;
}

/// An oblique, anisotropic volume.
VolumeGeometry obliqueGeometry() {
  VolumeGeometry geometry;
  geometry.valid = true;
  geometry.dimensions = {256, 192, 128};
  geometry.voxelSize = {0.8, 1.1, 1.7};
  geometry.directions = {-0.6, 0.8, 0, 0, 0, -1, 0.8, 0.6, 0};
  geometry.center = {3.5, -21.25, 14};
  geometry.fileName = "orig.mgz";
  return geometry;
}

std::string messageOf(const std::string& path) {
  try {
    static_cast<void>(readSurface(path));
  } catch (const FormatError& error) {
    return error.what();
  }
  return "";
}

void writeBytes(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()),
                                              static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

TEST(SurfaceFile, TextFormatsGiveBackTheSameDoubles) {
  const TemporaryFolder folder;
  const SurfaceFile original = sphere();
  writeOff(folder / "s.off", original);
  writeObj(folder / "s.obj", original);
  writePly(folder / "s.ply", original);
  for (const char* name : {"s.off", "s.obj", "s.ply"}) {
    const SurfaceFile back = readSurface(folder / name);
    EXPECT_EQ(back.points, original.points) << name;
    EXPECT_EQ(back.faces, original.faces) << name;
    EXPECT_EQ(back.space, CoordinateSpace::Unknown) << name;
  }
}

TEST(SurfaceFile, FreeSurferGivesBackSpaceAndObliqueGeometry) {
  const TemporaryFolder folder;
  SurfaceFile original = sphere();
  original.geometry = obliqueGeometry();
  original.space = CoordinateSpace::ScannerRAS;
  writeFreeSurferSurface(folder / "lh.white", original);
  SurfaceFile back = readSurface(folder / "lh.white");
  EXPECT_EQ(back.space, CoordinateSpace::TkRAS);
  EXPECT_EQ(back.geometry.directions, original.geometry.directions);
  EXPECT_EQ(back.geometry.center, original.geometry.center);
  EXPECT_EQ(back.geometry.fileName, "orig.mgz");
  toScannerRas(back);
  EXPECT_EQ(back.space, CoordinateSpace::ScannerRAS);
  for (std::size_t i = 0; i < back.points.size(); ++i) {
    ASSERT_NEAR(back.points[i], original.points[i], 2e-5);
  }
}

TEST(SurfaceFile, FreeSurferWithoutGeometryIsMarkedRealRasOrStaysUnknown) {
  const TemporaryFolder folder;
  SurfaceFile original = sphere();
  writeFreeSurferSurface(folder / "lh.unknown", original);
  EXPECT_EQ(readSurface(folder / "lh.unknown").space, CoordinateSpace::Unknown);
  original.space = CoordinateSpace::ScannerRAS;
  writeFreeSurferSurface(folder / "lh.real", original);
  const SurfaceFile back = readSurface(folder / "lh.real");
  EXPECT_EQ(back.space, CoordinateSpace::ScannerRAS);
  EXPECT_NE(back.spaceReason.find("useRealRAS"), std::string::npos);
}

TEST(SurfaceFile, AddingTheCentreAloneIsWrongForObliqueVolumes) {
  SurfaceFile surface = sphere();
  surface.geometry = obliqueGeometry();
  surface.space = CoordinateSpace::TkRAS;
  const std::vector<double> tk = surface.points;
  toScannerRas(surface);
  // x = D P⁻¹ t + c with the columns -xras, zras, -yras.
  EXPECT_NEAR(surface.points[0], 0.6 * tk[0] + 0.8 * tk[1] + 3.5, 1e-12);
  EXPECT_NEAR(surface.points[1], -0.8 * tk[0] + 0.6 * tk[1] - 21.25, 1e-12);
  EXPECT_NEAR(surface.points[2], tk[2] + 14, 1e-12);
  EXPECT_GT(std::abs(surface.points[0] - (tk[0] + 3.5)) + std::abs(surface.points[1] - (tk[1] - 21.25)), 0.1);
}

TEST(SurfaceFile, UnknownSpaceIsNeverGuessed) {
  SurfaceFile surface = sphere();
  const auto before = surface.points;
  toScannerRas(surface);
  EXPECT_EQ(surface.space, CoordinateSpace::Unknown);
  EXPECT_EQ(surface.points, before);
  EXPECT_THROW(toScannerRas(surface, CoordinateSpace::TkRAS), FormatError);
  toScannerRas(surface, CoordinateSpace::ScannerRAS);
  EXPECT_EQ(surface.space, CoordinateSpace::ScannerRAS);
  EXPECT_EQ(surface.points, before);
}

TEST(SurfaceFile, ToleratesACommentWithoutEmptyLine) {
  const TemporaryFolder folder;
  for (const std::string comment : {"created by x\n\n", "created by x\n", "", "one\ntwo\n"}) {
    std::vector<std::uint8_t> bytes{0xFF, 0xFF, 0xFE};
    bytes.insert(bytes.end(), comment.begin(), comment.end());
    encode(bytes, std::int32_t{3}, ByteOrder::Big);
    encode(bytes, std::int32_t{1}, ByteOrder::Big);
    for (int i = 0; i < 9; ++i) {
      encode(bytes, static_cast<float>(i * i), ByteOrder::Big);
    }
    for (const std::int32_t corner : {0, 1, 2}) {
      encode(bytes, corner, ByteOrder::Big);
    }
    writeBytes(folder / "s", bytes);
    EXPECT_EQ(readSurface(folder / "s").points[8], 64) << "comment \"" << comment << '"';
  }
}

TEST(SurfaceFile, SplitsQuadranglesByTheParityOfTheirFirstCorner) {
  const TemporaryFolder folder;
  for (const bool old : {true, false}) {
    std::vector<std::uint8_t> bytes{0xFF, 0xFF, static_cast<std::uint8_t>(old ? 0xFF : 0xFD), 0, 0, 5, 0, 0, 2};
    for (int i = 0; i < 15; ++i) {
      old ? encode(bytes, static_cast<std::int16_t>(100 * i), ByteOrder::Big)
          : encode(bytes, static_cast<float>(i), ByteOrder::Big);
    }
    for (const int corner : {0, 1, 2, 3, 1, 2, 3, 4}) {
      bytes.insert(bytes.end(), {0, 0, static_cast<std::uint8_t>(corner)});
    }
    writeBytes(folder / "q", bytes);
    const SurfaceFile surface = readSurface(folder / "q");
    EXPECT_EQ(surface.points[7], 7);
    EXPECT_EQ(surface.faces, (std::vector<int>{0, 1, 3, 2, 3, 1, 1, 2, 3, 1, 3, 4}));
  }
}

namespace {

/// The bytes of a FreeSurfer surface in tkRAS whose footer has a geometry.
std::string withObliqueGeometry(const std::string& path) {
  SurfaceFile surface = sphere();
  surface.geometry = obliqueGeometry();
  surface.space = CoordinateSpace::TkRAS;
  writeFreeSurferSurface(path, surface);
  std::ifstream input(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

}  // namespace

TEST(SurfaceFile, FollowsUnknownTagsAndKeepsGeometryWhenTheyLeadNowhere) {
  const TemporaryFolder folder;
  const std::string whole = withObliqueGeometry(folder / "a");
  std::ofstream(folder / "b", std::ios::binary) << whole << std::string("\0\0\0\3\0\0\0\0\0\0\0\4abc\0", 16)
                                                << std::string("\0\0\0\x21\x7F\0\0\0\0\0\0\4", 12);
  EXPECT_EQ(readSurface(folder / "b").space, CoordinateSpace::TkRAS);
}

TEST(SurfaceFile, AFooterThatEndsAnywhereInItsGeometryPlacesNothing) {
  const TemporaryFolder folder;
  std::string bytes = withObliqueGeometry(folder / "a");
  bytes.resize(bytes.rfind("cras"));
  bytes += "cras   = 1.5 -2 35.25\n";
  const std::size_t text = bytes.rfind("valid = 1");
  for (std::size_t length = bytes.size(); length > text - 8; --length) {
    std::ofstream(folder / "b", std::ios::binary) << bytes.substr(0, length);
    EXPECT_EQ(readSurface(folder / "b").space,
              length == bytes.size() ? CoordinateSpace::TkRAS : CoordinateSpace::Unknown)
        << length;
  }
}

TEST(SurfaceFile, GzipIsUndoneWhateverTheKind) {
  const TemporaryFolder folder;
  const SurfaceFile original = sphere();
  writeFreeSurferSurface(folder / "lh.white", original);
  writeOff(folder / "s.off", original);
  ASSERT_EQ(std::system(("gzip " + (folder / "lh.white") + " " + (folder / "s.off")).c_str()), 0);
  EXPECT_EQ(readSurface(folder / "lh.white.gz").faces, original.faces);
  EXPECT_EQ(readSurface(folder / "s.off.gz").points, original.points);
}

TEST(SurfaceFile, OffWithNormalsKeepsItsCoordinates) {
  const TemporaryFolder folder;
  std::ofstream(folder / "n.off") << "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n";
  EXPECT_EQ(readSurface(folder / "n.off").points, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST(SurfaceFile, OffAcceptsCommentsColoursAndPolygons) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.off")
      << "COFF # colours\n# comment\n4 2 0\n\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n1 1 0 0 0 0 0\n"
         "0 1 +1e0 0 0 0 0\n4 0 1 2 3 0.5 0.5 0.5\n2 0 1\n";
  const SurfaceFile surface = readSurface(folder / "a.off");
  EXPECT_EQ(surface.faces, (std::vector<int>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(surface.points[11], 1);
}

TEST(SurfaceFile, ObjWithTextureSeamsStaysOneSurface) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.obj") << "mtllib x\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
                                     "f 1/1/1 2/2/1 3/1/1\nf -4//1 -2//1 -1//1\n";
  const SurfaceFile surface = readSurface(folder / "a.obj");
  EXPECT_EQ(surface.vertexCount(), 4U);
  EXPECT_EQ(surface.faces, (std::vector<int>{0, 1, 2, 0, 2, 3}));
}

TEST(SurfaceFile, PlyIsReadInTextAndBothByteOrders) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.ply")
      << "ply\nformat ascii 1.0\ncomment x\nelement vertex 3\nproperty uchar red\nproperty float x\n"
         "property float y\nproperty float z\nelement face 1\n"
         "property list uchar int vertex_index\nend_header\n9 0 0 0\n9 1 0 0\n9 0 1 2.5\n3 0 1 2\n";
  std::string header = "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                       "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n";
  std::vector<std::uint8_t> bytes(header.begin(), header.end());
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 2.5F}) {
    encode(bytes, x, ByteOrder::Big);
  }
  bytes.push_back(3);
  for (const std::int32_t corner : {0, 1, 2}) {
    encode(bytes, corner, ByteOrder::Big);
  }
  writeBytes(folder / "b.ply", bytes);
  for (const char* name : {"a.ply", "b.ply"}) {
    const SurfaceFile surface = readSurface(folder / name);
    EXPECT_EQ(surface.points, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 2.5})) << name;
    EXPECT_EQ(surface.faces, (std::vector<int>{0, 1, 2})) << name;
  }
}

TEST(SurfaceFile, SaysWhatIsWrongInOneSentence) {
  const TemporaryFolder folder;
  std::ofstream(folder / "empty");
  std::ofstream(folder / "words.txt") << "hello\n";
  std::ofstream(folder / "far.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n";
  std::ofstream(folder / "binary.off") << "OFF BINARY\n";
  std::ofstream(folder / "patch") << std::string("\xFF\xFF\xFF\xFF\0\0\0\1", 8) << std::string(16, 'x');
  EXPECT_NE(messageOf(folder / "missing").find("does not exist"), std::string::npos);
  EXPECT_NE(messageOf(folder / "").find("folder"), std::string::npos);
  EXPECT_NE(messageOf(folder / "empty").find("empty"), std::string::npos);
  EXPECT_NE(messageOf(folder / "words.txt").find("none of the known kinds"), std::string::npos);
  EXPECT_NE(messageOf(folder / "far.off").find("names vertex 9"), std::string::npos);
  EXPECT_NE(messageOf(folder / "binary.off").find("binary"), std::string::npos);
  EXPECT_NE(messageOf(folder / "patch").find("patch"), std::string::npos);
  EXPECT_NE(messageOf("/dev/zero").find("device"), std::string::npos);
}

TEST(SurfaceFile, FactsOfTheRealSurfaces) {
  const struct {
    const char* path;
    std::size_t vertices, faces;
    CoordinateSpace space;
  } facts[] = {{"cortex/fsaverage5_gifti/pial_left.gii.gz", 10242, 20480, CoordinateSpace::Unknown},
               {"cortex/fsaverage3_fs/lh.white", 642, 1280, CoordinateSpace::Unknown},
               {"cortex/fsaverage6_fs/rh.pial", 40962, 81920, CoordinateSpace::Unknown},
               {"cortex/subject1_fs/lh.pialsurface6", 40962, 81920, CoordinateSpace::TkRAS},
               {"cortex/conte69_gifti/conte69_32k_lh.gii", 32492, 64980, CoordinateSpace::Unknown},
               {"cortex/gifti_encodings/external.gii", 8, 12, CoordinateSpace::Unknown},
               {"meshes/open_disk/human_brain.off", 48463, 96811, CoordinateSpace::Unknown},
               {"meshes/bad/moebius.obj", 0, 0, CoordinateSpace::Unknown}};
  for (const auto& fact : facts) {
    AUTHALIC_NEEDS(sharedData(fact.path));
    const SurfaceFile surface = readSurface(sharedData(fact.path));
    EXPECT_GT(surface.faceCount(), 0U);
    EXPECT_TRUE(fact.vertices == 0 || surface.vertexCount() == fact.vertices) << fact.path << surface.vertexCount();
    EXPECT_TRUE(fact.faces == 0 || surface.faceCount() == fact.faces) << fact.path << surface.faceCount();
    EXPECT_EQ(surface.space, fact.space) << fact.path << ": " << surface.spaceReason;
  }
}

TEST(SurfaceFile, EncodingsOfOneGiftiSurfaceAgree) {
  const std::string base = sharedData("cortex/gifti_encodings/");
  AUTHALIC_NEEDS(base);
  const SurfaceFile expected = readSurface(base + "gzip.surf.gii");
  for (const char* name : {"ascii.surf.gii", "base64.surf.gii", "ColumnMajorOrder.gii", "cortex_5124.surf.gii"}) {
    const SurfaceFile surface = readSurface(base + name);
    EXPECT_EQ(surface.faces, expected.faces) << name;
    ASSERT_EQ(surface.points.size(), expected.points.size()) << name;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
      ASSERT_NEAR(surface.points[i], expected.points[i], 1e-4) << name;
    }
  }
}
