#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "Core/base/Error.h"
#include "Core/mesh/AnnulusMesh.h"
#include "Core/mesh/PolyAnnulusMesh.h"
#include "Core/mesh/SphereMesh.h"
#include "Core/mesh/SurfaceTopology.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

TEST(TriangleMesh, RefusesNaNCoordinatesAndNamesTheVertex) {
  Points3 points = gridMesh(2, 2).points();
  points(4, 1) = std::numeric_limits<double>::quiet_NaN();
  try {
    TriangleMesh(points, gridMesh(2, 2).faces());
    FAIL();
  } catch (const GeometryError& error) {
    EXPECT_NE(std::string(error.what()).find("vertex 4"), std::string::npos) << error.what();
  }
}

TEST(TriangleMesh, RefusesIndicesOutOfRangeAndRepeatedVertices) {
  const TriangleMesh grid = gridMesh(2, 2);
  Faces faces = grid.faces();
  faces(0, 0) = 9;
  EXPECT_THROW(TriangleMesh(grid.points(), faces), GeometryError);
  faces(0, 0) = faces(0, 1);
  EXPECT_THROW(TriangleMesh(grid.points(), faces), GeometryError);
  EXPECT_THROW(TriangleMesh(grid.points(), Faces(0, 3)), GeometryError);
}

TEST(SurfaceTopology, CountsADisk) {
  const TriangleMesh disk = diskMesh(5);
  const SurfaceTopology topology(disk.faces(), disk.vertexCount());
  EXPECT_EQ(topology.eulerCharacteristic(), 1);
  ASSERT_EQ(topology.boundaryLoops().size(), 1u);
  EXPECT_EQ(topology.boundaryLoops()[0].size(), 30u);
  EXPECT_TRUE(topology.manifold());
  EXPECT_EQ(topology.componentCount(), 1);
}

TEST(SurfaceTopology, CountsASphere) {
  const TriangleMesh sphere = sphereMesh(3);
  const SurfaceTopology topology(sphere.faces(), sphere.vertexCount());
  EXPECT_EQ(topology.eulerCharacteristic(), 2);
  EXPECT_TRUE(topology.boundaryLoops().empty());
}

TEST(SurfaceTopology, FindsNonManifoldPlaces) {
  Faces book(3, 3);  // three pages on one spine 0-1
  book << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  EXPECT_EQ(SurfaceTopology(book, 5).nonManifoldEdges().size(), 1u);
  Faces bowtie(2, 3);  // two triangles that touch in vertex 0
  bowtie << 0, 1, 2, 0, 3, 4;
  const SurfaceTopology topology(bowtie, 6);
  EXPECT_EQ(topology.nonManifoldVertices(), std::vector<int>{0});
  EXPECT_EQ(topology.isolatedVertices(), std::vector<int>{5});
  EXPECT_EQ(topology.componentCount(), 1);
  Faces twisted(2, 3);  // both run along 0->1
  twisted << 0, 1, 2, 0, 1, 3;
  EXPECT_EQ(SurfaceTopology(twisted, 4).inconsistentEdges().size(), 1u);
}

TEST(CheckedMeshes, TakeWhatTheirNamesSayAndRefuseTheRestInWords) {
  const auto reason = [](const auto& construct) {
    try {
      construct();
    } catch (const TopologyError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(SphereMesh(sphereMesh(2)).mesh().faceCount(), 128);
  EXPECT_EQ(PolyAnnulusMesh(diskMesh(3)).loops().size(), 1u);
  EXPECT_NE(reason([] { (void)SphereMesh(diskMesh(3)); }).find("too many near"), std::string::npos);
  EXPECT_NE(reason([] { (void)AnnulusMesh(diskMesh(3)); }).find("too few boundary loops"), std::string::npos);
  EXPECT_NE(reason([] { (void)PolyAnnulusMesh(sphereMesh(1)); }).find("no boundary"), std::string::npos);
}
