#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <random>

#include "Core/base/Error.h"
#include "Formats/Gifti.h"
#include "Formats/Morphometry.h"
#include "Formats/SurfaceFile.h"
#include "Formats/VolumeFile.h"
#include "support/TemporaryFolder.h"
#include "support/TestMeshes.h"

namespace {

using namespace authalic;
using authalic::testing::TemporaryFolder;

struct HostileCase {
  const char* name;
  std::function<void(const std::string&)> write;
  /// Reads and throws std::logic_error when the result contradicts itself.
  std::function<void(const std::string&)> read;
};

void require(bool holds, const char* what) {
  if (!holds) {
    throw std::logic_error(what);
  }
}

SurfaceFile sphere() {
  const TriangleMesh mesh = authalic::testing::sphereMesh(1);
  SurfaceFile surface;
  surface.points.assign(mesh.points().data(), mesh.points().data() + mesh.points().size());
  surface.faces.assign(mesh.faces().data(), mesh.faces().data() + mesh.faces().size());
  surface.space = CoordinateSpace::TkRAS;
  surface.geometry.valid = true;
  surface.geometry.center = {1, 2, 3};
  return surface;
}

void readConsistentSurface(const std::string& path) {
  SurfaceFile surface = readSurface(path);
  require(surface.points.size() % 3 == 0 && surface.faces.size() % 3 == 0, "not whole vertices or faces");
  for (const int index : surface.faces) {
    require(index >= 0 && static_cast<std::size_t>(index) < surface.vertexCount(), "index out of range");
  }
  toScannerRas(surface);
}

void readConsistentVolume(const std::string& path) {
  const VolumeFile file = readVolume(path);
  const auto& d = file.dimensions();
  const auto scalars = file.scalars();
  require(scalars.values.size() == static_cast<std::size_t>(d[0]) * d[1] * d[2], "wrong number of voxels");
  require(scalars.values.size() < 100000, "voxels from nowhere");
  require(file.voxelToWorld().allFinite() && std::abs(file.voxelToWorld().determinant()) > 0, "affine");
}

std::vector<HostileCase> cases() {
  const auto scalars = [](const std::string& path) { require(!readVertexScalars(path).empty(), "no values"); };
  return {
      {"lh.white", [](const auto& path) { writeFreeSurferSurface(path, sphere()); }, readConsistentSurface},
      {"s.off", [](const auto& path) { writeOff(path, sphere()); }, readConsistentSurface},
      {"s.obj", [](const auto& path) { writeObj(path, sphere()); }, readConsistentSurface},
      {"s.ply", [](const auto& path) { writePly(path, sphere()); }, readConsistentSurface},
      {"s.surf.gii", [](const auto& path) { writeGiftiSurface(path, sphere()); }, readConsistentSurface},
      {"lh.curv", [](const auto& path) { writeMorphometry(path, std::vector<float>(42, 1.5F)); }, scalars},
      {"t.txt", [](const auto& path) { std::ofstream(path) << "1\n2\n3.5\nnan\n-4e-3\n"; }, scalars},
      {"m.func.gii", [](const auto& path) { writeGiftiScalars(path, {{"a", std::vector<float>(42, 2.F)}}); }, scalars},
      {"l.label.gii",
       [](const auto& path) { writeGiftiLabels(path, {{0, 1, 1}, {{1, "one", {1, 2, 3, 4}}}, {}}); },
       [](const auto& path) { require(!readAnnot(path).labels.empty(), "no labels"); }},
      {"v.nii", [](const auto& path) { writeVolume(path, LabelVolume({3, 4, 5}, Eigen::Matrix4d::Identity(), 7)); },
       readConsistentVolume},
      {"v.nii.gz", [](const auto& path) { writeVolume(path, ScalarVolume({3, 4, 5}, Eigen::Matrix4d::Identity(), 7)); },
       readConsistentVolume},
      {"v.mgh",
       [](const auto& path) {
         std::string bytes(284 + 60 * 4, '\0');
         const unsigned char start[] = {0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0, 5, 0, 0, 0, 1, 0, 0, 0, 3};
         std::copy(std::begin(start), std::end(start), bytes.begin());
         std::ofstream(path, std::ios::binary) << bytes;
       },
       readConsistentVolume},
      {"lh.annot",
       [](const auto& path) {
         std::string bytes(4 + 42 * 8 + 4, '\0');
         bytes[3] = 42;
         for (int i = 0; i < 42; ++i) {
           bytes[static_cast<std::size_t>(7 + 8 * i)] = static_cast<char>(i);
         }
         std::ofstream(path, std::ios::binary) << bytes;
       },
       [](const auto& path) { static_cast<void>(readAnnot(path)); }},
      {"lh.label",
       [](const auto& path) { std::ofstream(path) << "#!ascii label\n3\n1 0.5 1 2 0\n2 1 2 3 0\n7 0 0 0 1\n"; },
       [](const auto& path) {
         for (const int vertex : readLabel(path)) {
           require(vertex >= 0, "negative vertex");
         }
       }},
  };
}

class HostileFiles : public ::testing::TestWithParam<int> {
 protected:
  const HostileCase hostile = cases()[static_cast<std::size_t>(GetParam())];
  const TemporaryFolder folder;
  const std::string path = folder / hostile.name;

  std::string whole() const {
    hostile.write(path);
    std::ifstream input(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), {}};
  }
  /// Only a FormatError may leave a reader. Returns whether the file was accepted.
  bool accepts(const std::string& bytes) const {
    std::ofstream(path, std::ios::binary) << bytes;
    try {
      hostile.read(path);
      return true;
    } catch (const FormatError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(error.path(), 0), 0U);
      return false;
    } catch (const std::exception& error) {
      ADD_FAILURE() << hostile.name << ": " << error.what();
    }
    return false;
  }
};

}  // namespace

TEST_P(HostileFiles, TruncatedAnywhereAreRefusedOrConsistent) {
  const std::string bytes = whole();
  ASSERT_TRUE(accepts(bytes)) << hostile.name;
  for (std::size_t part = 0; part < 37; ++part) {
    accepts(bytes.substr(0, bytes.size() * part / 37));
  }
  EXPECT_FALSE(accepts(""));
}

TEST_P(HostileFiles, AlteredBytesAreRefusedOrConsistent) {
  const std::string original = whole();
  std::mt19937 random(static_cast<unsigned>(GetParam()) + 1);
  for (int i = 0; i < 400; ++i) {
    std::string bytes = original;
    // Every other mutation hits the header, where the counts are.
    const std::size_t range = i % 2 == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 400);
    for (int k = 0; k <= i % 3; ++k) {
      bytes[random() % range] = static_cast<char>(i % 5 == 0 ? 0xFF : random());
    }
    accepts(bytes);
  }
}

TEST_P(HostileFiles, OtherKindsAreRefused) {
  for (const std::string& junk : {std::string(5000, '\0'), std::string(5000, '\xFF'), std::string("PK\3\4 not this"),
                                 std::string("\x1F\x8B\x08 broken gzip"), std::string(3, '\xFF')}) {
    EXPECT_FALSE(accepts(junk)) << hostile.name << " of " << junk.size();
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, HostileFiles, ::testing::Range(0, 14),
                         [](const auto& hostile) {
                           std::string name = cases()[static_cast<std::size_t>(hostile.param)].name;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });
