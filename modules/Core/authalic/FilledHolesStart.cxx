#include "Core/authalic/FilledHolesStart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/FaceMatch.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"
#include "Core/topology/LoopLength.h"

namespace authalic {
namespace {

constexpr double kNear = 0.1;    // residual of the faces, with holes
constexpr int kMostSteps = 30, kRoundingSteps = 12;
constexpr double kStiff = 100;   // cones against the surface

// Faces their targets, cones the areas of their holes, in mm².
TargetMeasure withHoles(const PolyAnnulusMesh& surface, const TriangleMesh& whole, const TargetMeasure& target,
                        const std::vector<double>& holeAreas, int outer) {
  const Eigen::VectorXd areas = faceAreas(whole).cwiseMax(1e-300);
  const Eigen::Index faces = surface.mesh().faceCount();
  const double ground = areas.head(faces).sum();
  Eigen::VectorXd density(areas.size());
  density.head(faces) = ground * target.faces().cwiseQuotient(areas.head(faces));
  Eigen::Index face = faces;
  std::size_t hole = 0;
  for (std::size_t k = 0; k < surface.loops().size(); ++k) {
    if (static_cast<int>(k) == outer) continue;
    const auto count = static_cast<Eigen::Index>(surface.loops()[k].size());
    density.segment(face, count).setConstant(holeAreas[hole++] / areas.segment(face, count).sum());
    face += count;
  }
  return TargetMeasure::fromFaceDensity(whole, density);
}

// Cotangents of the surface; cones are flat, round and stiff.
HalfEdgeWeights withRoundCones(const PolyAnnulusMesh& surface, const TriangleMesh& whole, int outer) {
  HalfEdgeWeights weights = cotangentWeights(whole);
  Eigen::Index face = surface.mesh().faceCount();
  for (std::size_t k = 0; k < surface.loops().size(); ++k) {
    if (static_cast<int>(k) == outer) continue;
    const std::vector<int>& loop = surface.loops()[k];
    const double around = loopLength(surface.mesh(), loop);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double edge = (surface.mesh().point(loop[(i + 1) % loop.size()]) - surface.mesh().point(loop[i])).norm();
      const double half = std::clamp(M_PI * edge / around, 1e-6, 1.0);  // of the angle at the tip
      weights.row(face++) << kStiff * 0.5 / std::tan(2 * half), kStiff * 0.5 * std::tan(half),
          kStiff * 0.5 * std::tan(half);
    }
  }
  return weights;
}

// A few face steps of the disk with round cones, from its map.
Points2 rounder(const DiskMesh& disk, const TargetMeasure& targets, const HalfEdgeWeights& weights, Points2 start,
                SolverBackend backend, const Execution& execution) {
  std::vector<LoopOnCircle> circle(1);
  circle[0].vertices = disk.boundary();
  const CircleDomainAreas areas(disk.mesh().faces(), circle, disk.mesh().vertexCount());
  AnalysedSystems systems(execution.threads());
  FaceMatch match(areas, targets.faces(), weights, backend, Shapes::Kept, systems);
  match.restart(kNear);
  Coordinates image = std::move(start);
  for (int step = 0; step < kRoundingSteps && !match.stalled() && !execution.cancelled(); ++step) {
    (void)match.advance(image);
  }
  return image;
}

}  // namespace

TriangleMesh closedByCones(const PolyAnnulusMesh& surface, int outer) {
  const TriangleMesh& mesh = surface.mesh();
  Eigen::Index points = mesh.vertexCount(), faces = mesh.faceCount();
  for (std::size_t k = 0; k < surface.loops().size(); ++k) {
    if (static_cast<int>(k) != outer) ++points, faces += static_cast<Eigen::Index>(surface.loops()[k].size());
  }
  Points3 places = Points3::Zero(points, 3);
  Faces corners(faces, 3);
  places.topRows(mesh.vertexCount()) = mesh.points();
  corners.topRows(mesh.faceCount()) = mesh.faces();
  Eigen::Index tip = mesh.vertexCount(), face = mesh.faceCount();
  for (std::size_t k = 0; k < surface.loops().size(); ++k) {
    if (static_cast<int>(k) == outer) continue;
    const std::vector<int>& loop = surface.loops()[k];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      places.row(tip) += mesh.points().row(loop[i]) / static_cast<double>(loop.size());
      corners.row(face++) << loop[(i + 1) % loop.size()], loop[i], static_cast<int>(tip);
    }
    ++tip;
  }
  return TriangleMesh(std::move(places), std::move(corners));
}

RoundedHoles filledHolesStart(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                              const std::vector<double>& holeAreas, int outer, SolverBackend backend,
                              const Execution& execution) {
  const DiskMesh disk(closedByCones(surface, outer));
  AuthalicMapOptions near;
  near.tolerance = kNear;
  near.vertexTolerance = std::numeric_limits<double>::infinity();
  near.maxIterations = kMostSteps;
  near.solver = backend;
  const TargetMeasure targets = withHoles(surface, disk.mesh(), target, holeAreas, outer);
  const AuthalicMapResult map = authalicMap(disk, targets, near, {}, execution.part(0, 0.7));
  double whole = faceAreas(surface.mesh()).sum();
  for (const double area : holeAreas) whole += area;
  std::vector<double> shares;
  for (const double area : holeAreas) shares.push_back(area / whole);
  const HalfEdgeWeights cotangents = withRoundCones(surface, disk.mesh(), outer);
  const Points2 image = rounder(disk, targets, cotangents, map.image, backend, execution);
  return roundHoles(surface, image.topRows(surface.mesh().vertexCount()), shares, outer, backend,
                    execution.part(0.7, 1));
}

}  // namespace authalic
