#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "Core/base/Error.h"
#include "Formats/ByteCursor.h"
#include "Formats/Cifti.h"
#include "Formats/FreeSurferPatch.h"
#include "Formats/Gifti.h"
#include "Formats/Morphometry.h"
#include "Formats/Mz3.h"
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

/// Two maps on a surface of ten vertices, of which four have values.
void writeSmallCifti(const std::string& path) {
  const std::string xml =
      "<CIFTI Version=\"2\"><Matrix><MatrixIndicesMap AppliesToMatrixDimension=\"0\" "
      "IndicesMapToDataType=\"CIFTI_INDEX_TYPE_SCALARS\"><NamedMap><MapName>a</MapName></NamedMap>"
      "<NamedMap><MapName>b</MapName></NamedMap></MatrixIndicesMap><MatrixIndicesMap AppliesToMatrixDimension=\"1\" "
      "IndicesMapToDataType=\"CIFTI_INDEX_TYPE_BRAIN_MODELS\"><BrainModel IndexOffset=\"0\" IndexCount=\"4\" "
      "ModelType=\"CIFTI_MODEL_TYPE_SURFACE\" BrainStructure=\"CIFTI_STRUCTURE_CORTEX_LEFT\" "
      "SurfaceNumberOfVertices=\"10\"><VertexIndices>1 4 5 9</VertexIndices></BrainModel></MatrixIndicesMap></Matrix>"
      "</CIFTI>";
  std::vector<std::uint8_t> bytes;
  const auto at = [&bytes](std::size_t offset, auto value) {
    bytes.resize(offset, 0);
    encode(bytes, value, ByteOrder::Little);
  };
  const auto extension = static_cast<std::int32_t>(8 + xml.size());
  at(0, std::int32_t{540});
  for (const char c : {'n', '+', '2', '\0', '\r', '\n', '\x1A', '\n'}) {
    bytes.push_back(static_cast<std::uint8_t>(c));
  }
  at(12, std::int16_t{16});
  at(14, std::int16_t{32});
  for (const std::int64_t d : {6, 1, 1, 1, 1, 2, 4, 1}) {
    encode(bytes, d, ByteOrder::Little);
  }
  at(168, static_cast<std::int64_t>(544 + extension));
  at(504, std::int32_t{3006});
  at(540, std::uint8_t{1});
  at(544, extension);
  at(548, std::int32_t{32});
  bytes.insert(bytes.end(), xml.begin(), xml.end());
  for (int i = 0; i < 8; ++i) {
    encode(bytes, static_cast<float>(i), ByteOrder::Little);
  }
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()),
                                              static_cast<std::streamsize>(bytes.size()));
}

void readConsistentCifti(const std::string& path) {
  const CiftiFile file = readCifti(path);
  for (const CiftiSurface& surface : file.surfaces) {
    for (const CiftiMap& map : file.maps) {
      const auto values = onCiftiSurface(surface, map, -1);
      require(values.size() == static_cast<std::size_t>(surface.vertexCount), "values for other vertices");
    }
  }
}

void readConsistentPatch(const std::string& path) {
  const SurfaceFile surface = patchSurface(path, readPatch(path), sphere());
  for (const int index : surface.faces) {
    require(static_cast<std::size_t>(index) < surface.vertexCount(), "index out of range");
  }
}

void readConsistentMz3(const std::string& path) {
  const Mz3File file = readMz3(path);
  for (const auto& layer : file.layers) {
    require(layer.size() == static_cast<std::size_t>(file.vertexCount), "an overlay of another length");
  }
  readConsistentSurface(path);
}

std::vector<HostileCase> newerCases() {
  return {
      {"lh.patch.flat",
       [](const auto& path) { writePatch(path, {{4, 1, 7}, {true, false, true}, {1, 2, 0, 3, 4, 0, 5, 6, 0}}); },
       readConsistentPatch},
      {"s.mz3",
       [](const auto& path) {
         const SurfaceFile surface = sphere();
         writeMz3(path, surface, {{"a", std::vector<float>(surface.vertexCount(), 1.F)}});
       },
       readConsistentMz3},
      {"plain.mz3",
       [](const auto& path) {  // one triangle with colours and one overlay, not compressed
         std::vector<std::uint8_t> bytes{'M', 'Z', 15, 0, 1, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0};
         for (const int index : {0, 1, 2}) {
           encode(bytes, index, ByteOrder::Little);
         }
         bytes.resize(bytes.size() + 36 + 12 + 12, 63);
         std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()),
                                                     static_cast<std::streamsize>(bytes.size()));
       },
       readConsistentMz3},
      {"lh.w", [](const auto& path) { writePaint(path, {1.F, std::nanf(""), 3.F}); },
       [](const auto& path) { require(readVertexScalars(path, 42).size() == 42, "not one value per vertex"); }},
      {"m.dscalar.nii", writeSmallCifti, readConsistentCifti},
      {"full.annot",
       [](const auto& path) { writeAnnot(path, {{0, 1, -1}, {{0, "a", {1, 2, 3, 255}}, {1, "b", {4, 5, 6, 9}}}, {}}); },
       [](const auto& path) { static_cast<void>(readAnnot(path)); }},
  };
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
         for (const int vertex : readLabel(path).vertices) {
           require(vertex >= 0, "negative vertex");
         }
       }},
  };
}

const std::vector<HostileCase>& allCases() {
  static const std::vector<HostileCase> all = [] {
    std::vector<HostileCase> joined = cases();
    for (HostileCase& newer : newerCases()) {
      joined.push_back(std::move(newer));
    }
    return joined;
  }();
  return all;
}

class HostileFiles : public ::testing::TestWithParam<int> {
 protected:
  const HostileCase hostile = allCases()[static_cast<std::size_t>(GetParam())];
  const TemporaryFolder folder;
  const std::string path = folder / hostile.name;

  std::string whole() const {
    hostile.write(path);
    std::ifstream input(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), {}};
  }
  /// Only a FormatError may leave a reader. Returns whether the file was accepted.
  bool accepts(const std::string& bytes) const {
    std::filesystem::remove(path);  // some file systems wait for the disk when a file is cut and written again
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
  void alter(unsigned seed, int mutations) const {
    const std::string original = whole();
    std::mt19937 random(seed);
    for (int i = 0; i < mutations; ++i) {
      std::string bytes = original;
      // Every other mutation hits the header, where the counts are.
      const std::size_t range = i % 2 == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 400);
      for (int k = 0; k <= i % 3; ++k) {
        bytes[random() % range] = static_cast<char>(i % 5 == 0 ? 0xFF : random());
      }
      accepts(bytes);
    }
  }
};

class HostileFilesSlow : public HostileFiles {};

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
  alter(static_cast<unsigned>(GetParam()) + 1, 1000);
}

TEST_P(HostileFilesSlow, TenThousandAlteredFilesAreRefusedOrConsistent) {
  alter(static_cast<unsigned>(GetParam()) + 1001, 10000);
}

TEST_P(HostileFiles, OtherKindsAreRefused) {
  for (const std::string& junk : {std::string(5000, '\0'), std::string(5000, '\xFF'), std::string("PK\3\4 not this"),
                                 std::string("\x1F\x8B\x08 broken gzip"), std::string(3, '\xFF')}) {
    EXPECT_FALSE(accepts(junk)) << hostile.name << " of " << junk.size();
  }
}

namespace {

std::string caseName(const ::testing::TestParamInfo<int>& hostile) {
  std::string name = allCases()[static_cast<std::size_t>(hostile.param)].name;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Readers, HostileFiles, ::testing::Range(0, static_cast<int>(allCases().size())), caseName);
INSTANTIATE_TEST_SUITE_P(Readers, HostileFilesSlow, ::testing::Range(0, static_cast<int>(allCases().size())), caseName);
