/// Repair of real surfaces: colon segments, and every other surface of the data folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "Core/base/Error.h"
#include "Core/mesh/AnnulusMesh.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/mesh/PolyAnnulusMesh.h"
#include "Core/topology/SurfaceRepair.h"
#include "Formats/SurfaceFile.h"
#include "support/LegacyVtkFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

const Eigen::RowVector3d kVoxel(0.808594, 0.808594, 0.7);

std::string colon(const std::string& segment) {
  return sharedData("colon/EdinGCA_3D_00020_CTC_inflated/large-intestine-" + segment + ".vtk");
}

double lengthOf(const TriangleMesh& mesh, const std::vector<int>& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += (mesh.point(loop[i]) - mesh.point(loop[(i + 1) % loop.size()])).norm();
  }
  return length;
}

/// Three handles are cut, each listed with the place and the length of its loop, and only their surroundings change.
SurfaceRepair expectThreeHandlesCut(const TriangleMesh& mesh) {
  EXPECT_EQ(inspect(mesh).genus, 3);
  SurfaceRepair repair = repairSurface(mesh.points(), mesh.faces());
  EXPECT_EQ(repair.count(RepairKind::Handle), 3);
  EXPECT_EQ(repair.changes.size(), 3u);
  std::set<int> onLoops;
  for (const RepairChange& change : repair.changes) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int v : change.ids) middle += mesh.point(v) / static_cast<double>(change.ids.size());
    EXPECT_NEAR(change.size, lengthOf(mesh, change.ids), 1e-9);
    EXPECT_NEAR((change.place - middle).norm(), 0, 1e-9);
    onLoops.insert(change.ids.begin(), change.ids.end());
  }
  EXPECT_EQ(repair.mesh.points().topRows(mesh.vertexCount()), mesh.points());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    EXPECT_EQ(repair.originalFaceIds[static_cast<std::size_t>(f)], f);
    const Eigen::RowVector3i before = mesh.faces().row(f), after = repair.mesh.faces().row(f);
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(after[k] == before[k] || onLoops.count(before[k]) > 0);
    }
  }
  EXPECT_EQ(repair.after.genus, 0);
  EXPECT_FALSE(repairSurface(repair.mesh.points(), repair.mesh.faces()).changed());
  return repair;
}

bool isSurface(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const auto contains = [&](const char* part) { return name.find(part) != std::string::npos; };
  const std::string ending = path.extension().string();
  if (ending == ".off" || ending == ".obj" || ending == ".ply" || ending == ".vtk") return true;
  if (contains(".surf.gii") || contains("conte69_32k_") || contains("conte69_5k_")) return !contains("thickness");
  return contains("pial") || contains(".white") || contains("white_") || contains("infl_") || contains("sphere_") ||
         contains("flat_left") || contains("flat_right");
}

TriangleMesh read(const std::filesystem::path& path) {
  if (path.extension() == ".vtk") return readLegacyVtk(path.string(), Eigen::RowVector3d::Ones());
  const SurfaceFile file = readSurface(path.string());
  return {Eigen::Map<const Points3>(file.points.data(), static_cast<Eigen::Index>(file.vertexCount()), 3),
          Eigen::Map<const Faces>(file.faces.data(), static_cast<Eigen::Index>(file.faceCount()), 3)};
}

/// Clean by the report of another piece of code: nothing that a repair with default options looks for.
bool clean(const MeshReport& report) {
  const double smallest = 0.1 * std::sqrt(report.area);
  return report.orientedManifold() && report.isolatedVertices.empty() && report.degenerateFaces.empty() &&
         report.duplicateFaces.empty() && report.genus == 0 && report.components.back().area >= 0.1 *
         report.components.front().area && (report.loops.empty() || report.loops.back().length > smallest) &&
         (!report.loops.empty() || report.volume > 0);
}

}  // namespace

TEST(SurfaceRepairOnColon, MakesADiskOfTheRectosigmoidOfGenusThree) {
  const std::string path = colon("A-DSJ");
  AUTHALIC_NEEDS(path);
  const SurfaceRepair repair = expectThreeHandlesCut(readLegacyVtk(path, kVoxel));
  EXPECT_NO_THROW((void)DiskMesh(repair.mesh));
}

TEST(SurfaceRepairOnColon, MakesAnAnnulusOfTheTransverseColonOfGenusThree) {
  const std::string path = colon("SF+-HF-");
  AUTHALIC_NEEDS(path);
  const SurfaceRepair repair = expectThreeHandlesCut(readLegacyVtk(path, kVoxel));
  EXPECT_NO_THROW((void)AnnulusMesh(repair.mesh));
}

TEST(SurfaceRepairOnColon, SplitsTheVertexWhereTheAscendingColonTouchesItself) {
  const std::string path = colon("HF+-ICVc");
  AUTHALIC_NEEDS(path);
  const TriangleMesh mesh = readLegacyVtk(path, kVoxel);
  const MeshReport before = inspect(mesh);
  ASSERT_EQ(before.nonManifoldVertices.size(), 1u);
  const SurfaceRepair repair = repairSurface(mesh.points(), mesh.faces());
  EXPECT_EQ(repair.count(RepairKind::NonManifoldVertex), 1);
  EXPECT_EQ(repair.count(RepairKind::TJunction), 1);
  EXPECT_EQ(repair.changes.size(), 2u);
  const auto split = std::find_if(repair.changes.begin(), repair.changes.end(),
                                  [](const auto& c) { return c.kind == RepairKind::NonManifoldVertex; });
  EXPECT_EQ(split->ids, before.nonManifoldVertices[0].ids);
  EXPECT_EQ(split->place, before.nonManifoldVertices[0].place);
  EXPECT_EQ(repair.after.loops.size(), 3u);
  EXPECT_EQ(repair.mesh.vertexCount(), mesh.vertexCount() + 1);
  EXPECT_NEAR(repair.after.area, before.area, 1e-3 * before.area);
  EXPECT_NO_THROW((void)PolyAnnulusMesh(repair.mesh));
}

TEST(SurfaceRepairOnColon, LeavesTheSoundSegmentsAsTheyAre) {
  for (const char* segment : {"DSJ-SF-", "SF-SF+", "HF-HF+"}) {
    const std::string path = colon(segment);
    AUTHALIC_NEEDS(path);
    const TriangleMesh mesh = readLegacyVtk(path, kVoxel);
    const SurfaceRepair repair = repairSurface(mesh.points(), mesh.faces());
    EXPECT_FALSE(repair.changed()) << segment;
    EXPECT_EQ(repair.mesh.points(), mesh.points());
    EXPECT_EQ(repair.mesh.faces(), mesh.faces());
  }
}

TEST(SurfaceRepairOnScansSlow, RepairsOrRefusesEverySurfaceAndLeavesCleanOnesAlone) {
  const std::string folder = sharedData("");
  AUTHALIC_NEEDS(folder + "meshes");
  int surfaces = 0, unchanged = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || !isSurface(entry.path())) continue;
    SCOPED_TRACE(entry.path().string());
    const TriangleMesh mesh = read(entry.path());
    ++surfaces;
    try {
      const SurfaceRepair repair = repairSurface(mesh.points(), mesh.faces());
      EXPECT_EQ(repair.status, Status::Converged);
      EXPECT_TRUE(repair.after.orientedManifold());
      EXPECT_EQ(repair.after.genus, 0);
      EXPECT_TRUE(repair.after.degenerateFaces.empty());
      EXPECT_FALSE(repairSurface(repair.mesh.points(), repair.mesh.faces()).changed());
      EXPECT_FALSE(repair.changed() && clean(inspect(mesh)));
      if (repair.changed()) continue;
      ++unchanged;
      EXPECT_EQ(repair.mesh.points(), mesh.points());
      EXPECT_EQ(repair.mesh.faces(), mesh.faces());
    } catch (const Error& error) {
      ++refused;
      EXPECT_EQ(entry.path().filename(), "moebius.obj") << error.what();
    }
  }
  EXPECT_EQ(refused, 1);
  EXPECT_GT(unchanged, surfaces / 2);
  RecordProperty("surfaces", surfaces);
  RecordProperty("unchanged", unchanged);
}
