#include "Core/authalic/NarrowFaces.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/FaceMatch.h"
#include "Core/authalic/Patches.h"
#include "Core/authalic/PlanarAreas.h"
#include "Core/authalic/SolidAngles.h"

namespace authalic {
namespace {

constexpr double kCollapsed = 1e-4;         // share of its target from where a face does not open by itself
constexpr Narrowness kWhileMatching{0, 0.6};
constexpr int kMostSteps = 60;              // in a patch
constexpr double kGoal = 0.1;               // residual of a patch, by far smaller than that of an open one
constexpr double kFar = 0.7;                // |ln r| of a face
constexpr double kFew = 0.02, kMuch = 0.7;  // of the faces, and of D_area − 2 that is theirs
constexpr int kRingsAroundFar = 8;
constexpr double kHelps = 0.8;              // times D_area − 2 before

Eigen::ArrayXd ratios(const AreaFunctional& areas, const Eigen::VectorXd& targets, const Coordinates& image) {
  const Eigen::ArrayXd a = areas.areas(image).array();
  return a / (a.sum() * targets.array());
}

// What each face adds to D_area − 2.
Eigen::ArrayXd excess(const AreaFunctional& areas, const Eigen::VectorXd& targets, const Coordinates& image) {
  const Eigen::ArrayXd r = ratios(areas, targets, image);
  return targets.array() * (r + 1 / r - 2);
}

// Face steps in one patch, at most 60, until each of its faces is open; targets of any sum, no face folded.
void openPatch(const AreaFunctional& areas, Eigen::VectorXd shares, const Points3& surface, SolverBackend backend,
               Coordinates& points, const Narrowness& narrowness, Shapes shapes) {
  shares /= shares.sum();
  AnalysedSystems systems;
  FaceMatch match(areas, shares, cotangentWeights(surface, areas.faces()), backend, shapes, systems);
  match.restart(kGoal);
  const auto narrowest = [&] { return ratios(areas, shares, points).minCoeff(); };
  for (int k = 0; k < kMostSteps && !match.stalled() && narrowest() < narrowness.open; ++k) match.advance(points);
}

// openPatch() in the patches of some rings around the chosen faces.
void openAround(const FaceFlags& chosen, int rings, const AreaFunctional& areas, const Eigen::VectorXd& targets,
                const Points3& surface, SolverBackend backend, const Narrowness& narrowness, Shapes shapes,
                Coordinates& image) {
  for (const Patch& patch : patchesAround(chosen, rings, areas)) {
    Coordinates points = image(patch.vertices, Eigen::all);
    openPatch(*areas.inPatch(patch, image), targets(patch.faces), surface(patch.vertices, Eigen::all), backend, points,
              narrowness, shapes);
    image(patch.vertices, Eigen::all) = points;
  }
}

}  // namespace

void openNarrowFaces(const AreaFunctional& areas, const TargetMeasure& target, const Points3& surface,
                     SolverBackend backend, Coordinates& image, const Narrowness& narrowness,
                     const Execution& execution) {
  for (const int rings : {4, 8, 16}) {
    const FaceFlags narrow = ratios(areas, target.faces(), image) < narrowness.narrow;
    if (!narrow.any() || execution.cancelled()) break;
    openAround(narrow, rings, areas, target.faces(), surface, backend, narrowness, Shapes::Free, image);
  }
}

UnfoldResult openNarrowFaces(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                             SolverBackend backend, const Execution& execution) {
  const Faces& faces = disk.mesh().faces();
  UnfoldResult result =
      unfold(disk.topology(), reviveCollapsedFaces(disk, image, target, backend, kCollapsed), execution);
  if (result.flippedFaces > 0) return result;
  result.image = reviveCollapsedFaces(disk, result.image, target, backend, kCollapsed);
  std::vector<char> freedom = disk.topology().onBoundary();
  for (char& free : freedom) free = free ? 0 : 2;
  Coordinates opened = result.image;
  openNarrowFaces(PlanarPatchAreas(faces, std::move(freedom)), target, disk.mesh().points(), backend, opened,
                  Narrowness(), execution);
  result.image = opened;
  return result;
}

void openNarrowFacesOnSphere(const SphereMesh& sphere, const TargetMeasure& target, SolverBackend backend,
                             Points3& image) {
  Coordinates opened = image;
  openNarrowFaces(SolidAngles(sphere.mesh().faces(), sphere.mesh().vertexCount()), target, sphere.mesh().points(),
                  backend, opened, kCollapsing);
  image = opened;
}

FaceFlags farFaces(const AreaFunctional& areas, const Eigen::VectorXd& targets, const Coordinates& image) {
  const Eigen::ArrayXd errors = excess(areas, targets, image);
  FaceFlags far = ratios(areas, targets, image).log().abs() > kFar;
  const bool few = static_cast<double>(far.count()) <= kFew * static_cast<double>(far.size());
  if (!few || !(far.select(errors, 0).sum() >= kMuch * errors.sum())) far.setConstant(false);
  return far;
}

bool matchFarFaces(const FaceFlags& far, const AreaFunctional& areas, const Eigen::VectorXd& targets,
                   const Points3& surface, SolverBackend backend, Shapes shapes, Coordinates& image) {
  Coordinates matched = image;
  openAround(far, kRingsAroundFar, areas, targets, surface, backend, kWhileMatching, shapes, matched);
  if (!(excess(areas, targets, matched).sum() < kHelps * excess(areas, targets, image).sum())) return false;
  image = std::move(matched);
  return true;
}

}  // namespace authalic
