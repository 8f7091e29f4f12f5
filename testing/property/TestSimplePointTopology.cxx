#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include "Core/imaging/HomotopicGrowing.h"
#include "Core/imaging/Isosurface.h"
#include "Core/imaging/LatticeSurfaceTable.h"
#include "Core/imaging/SimplePoint.h"
#include "Core/mesh/SurfaceTopology.h"

using namespace authalic;

namespace {

using Cube = std::vector<char>;  // 3×3×3

std::size_t at(int i, int j, int k) {
  return static_cast<std::size_t>(i + 3 * (j + 3 * k));
}

bool neighbours(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  const std::array<int, 3> offset{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  return std::find(kLatticeNeighbours.begin(), kLatticeNeighbours.end(), offset) != kLatticeNeighbours.end();
}

// Euler number of the complex of all simplices (sets of mutual neighbours) on the voxels of one side.
int eulerNumber(const Cube& cube, char side) {
  std::vector<std::array<int, 3>> v;
  for (int n = 0; n < 27; ++n) {
    if (cube[static_cast<std::size_t>(n)] == side) v.push_back({n % 3, n / 3 % 3, n / 9});
  }
  int chi = static_cast<int>(v.size());
  for (std::size_t a = 0; a < v.size(); ++a) {
    for (std::size_t b = a + 1; b < v.size(); ++b) {
      if (!neighbours(v[a], v[b])) continue;
      --chi;
      for (std::size_t c = b + 1; c < v.size(); ++c) {
        if (!neighbours(v[a], v[c]) || !neighbours(v[b], v[c])) continue;
        ++chi;
        for (std::size_t d = c + 1; d < v.size(); ++d) {
          chi -= neighbours(v[a], v[d]) && neighbours(v[b], v[d]) && neighbours(v[c], v[d]);
        }
      }
    }
  }
  return chi;
}

// Components of one side among the neighbours of the centre.
int componentsAroundCentre(const Cube& cube, char side) {
  std::vector<std::array<int, 3>> v;
  for (const auto& o : kLatticeNeighbours) {
    if (cube[at(1 + o[0], 1 + o[1], 1 + o[2])] == side) v.push_back(o);
  }
  std::vector<std::size_t> id(v.size());
  for (std::size_t a = 0; a < v.size(); ++a) id[a] = a;
  for (std::size_t round = 0; round < v.size(); ++round) {
    for (std::size_t a = 0; a < v.size(); ++a) {
      for (std::size_t b = 0; b < v.size(); ++b) {
        if (neighbours(v[a], v[b])) id[a] = id[b] = std::min(id[a], id[b]);
      }
    }
  }
  int count = 0;
  for (std::size_t a = 0; a < v.size(); ++a) count += id[a] == a;
  return count;
}

bool edgesInOneFace(int e, int f) {
  const auto on = [](int edge, int axis, int side) {
    const auto& c = kCubeEdges[static_cast<std::size_t>(edge)];
    return (c[0] >> axis & 1) == side && (c[1] >> axis & 1) == side;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      if (on(e, axis, side) && on(f, axis, side)) return true;
    }
  }
  return false;
}

}  // namespace

TEST(SimplePoint, AgreesWithEulerNumbersAndComponentsOfRandomNeighbourhoods) {
  std::mt19937 random(7);
  int simple = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    Cube with(27);
    const unsigned density = 1 + static_cast<unsigned>(trial) % 9;
    for (char& c : with) c = random() % 10 < density;
    unsigned bits = 0;
    for (std::size_t k = 0; k < 14; ++k) {
      const auto& o = kLatticeNeighbours[k];
      bits |= static_cast<unsigned>(with[at(1 + o[0], 1 + o[1], 1 + o[2])]) << k;
    }
    Cube without = with;
    with[13] = 1;
    without[13] = 0;
    const bool expected = eulerNumber(with, 1) == eulerNumber(without, 1) &&
                          eulerNumber(with, 0) == eulerNumber(without, 0) &&
                          componentsAroundCentre(with, 1) == 1 && componentsAroundCentre(with, 0) == 1;
    ASSERT_EQ(isSimplePoint(static_cast<std::uint16_t>(bits)), expected) << "neighbourhood " << bits;
    simple += expected;
  }
  EXPECT_GT(simple, 200);
  EXPECT_LT(simple, 3800);
}

TEST(Isosurface, OfRandomNoiseIsAClosedManifoldWithTheEulerNumberOfItsObject) {
  std::mt19937 random(11);
  int checked = 0;
  for (int trial = 0; trial < 200; ++trial) {
    ScalarVolume field({7, 7, 7}, Eigen::Matrix4d::Identity(), -1.0f);
    Cube inside(27);
    for (int n = 0; n < 27; ++n) {
      inside[static_cast<std::size_t>(n)] = random() % 10 < 1u + static_cast<unsigned>(trial) % 9;
      if (!inside[static_cast<std::size_t>(n)]) continue;
      field.at(2 + n % 3, 2 + n / 3 % 3, 2 + n / 9) = 0.3f + 0.1f * static_cast<float>(random() % 10);
    }
    if (std::find(inside.begin(), inside.end(), 1) == inside.end()) continue;
    const TriangleMesh mesh = extractIsosurface(field);
    const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
    ASSERT_TRUE(topology.manifold());
    ASSERT_TRUE(topology.boundaryLoops().empty());
    ASSERT_EQ(topology.eulerCharacteristic(), 2 * eulerNumber(inside, 1)) << "trial " << trial;
    ++checked;
  }
  EXPECT_GT(checked, 150);
}

TEST(Isosurface, CellsShareOnlyArcsInTheFacesOfTheCube) {
  for (int signs = 0; signs < 256; ++signs) {
    std::map<std::pair<int, int>, int> uses;
    for (const auto& t : latticeSurfaceCell(signs).triangles) {
      for (std::size_t k = 0; k < 3; ++k) ++uses[std::minmax(t[k], t[(k + 1) % 3])];
    }
    for (const auto& [edge, count] : uses) {
      const bool arc = edge.second < 12 && edgesInOneFace(edge.first, edge.second);
      EXPECT_EQ(count, arc ? 1 : 2) << signs;
    }
  }
}

TEST(Segmentation, HomotopicGrowthInNoiseIsAlwaysASphere) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 30; ++trial) {
    VolumeOf<std::int16_t> priority({20, 20, 20}, Eigen::Matrix4d::Identity(), 0);
    for (auto& p : priority.values) {
      const int draw = static_cast<int>(random() % 100);
      p = static_cast<std::int16_t>(draw < 45 ? 1 + draw : draw < 70 ? -draw : 0);
    }
    priority.at(10, 10, 10) = 99;
    const HomotopicGrowth growth = growHomotopic(priority, {10, 10, 10});
    EXPECT_GT(growth.kept, 500u);
    ScalarVolume field(priority.dimensions, priority.voxelToWorld);
    for (std::size_t v = 0; v < field.size(); ++v) field.values[v] = growth.mask.values[v] ? 1.0f : -1.0f;
    const TriangleMesh mesh = extractIsosurface(field);
    const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
    ASSERT_TRUE(topology.manifold());
    ASSERT_EQ(topology.componentCount(), 1);
    ASSERT_EQ(topology.eulerCharacteristic(), 2);
  }
}
