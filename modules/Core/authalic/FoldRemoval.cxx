#include "Core/authalic/FoldRemoval.h"

#include <cmath>
#include <utility>

#include "Core/authalic/FoldoverFree.h"
#include "Core/authalic/Patches.h"

namespace authalic {
namespace {

constexpr int kMostSteps = 100;  // in a patch
constexpr int kMostStepsEverywhere = 200;

FaceFlags folded(const AreaFunctional& areas, const Coordinates& image) {
  return !(areas.areas(image).array() > 0);
}

// Whether the faces around each free vertex, none folded, go around it once: 2π, and not 4π.
bool goAroundOnce(const AreaFunctional& areas, const Coordinates& points) {
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(areas.vertexCount());
  for (int f = 0; f < static_cast<int>(areas.faces().rows()); ++f) {
    const AreaFunctional::Corners corners = areas.corners(points, f);
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector2d one = corners.row((k + 1) % 3) - corners.row(k),
                               other = corners.row((k + 2) % 3) - corners.row(k);
      angles[areas.faces()(f, k)] += std::atan2(std::abs(one[0] * other[1] - one[1] * other[0]), one.dot(other));
    }
  }
  for (int v = 0; v < areas.vertexCount(); ++v) {
    if (areas.freedom(v) > 0 && angles[v] > 3 * M_PI) return false;
  }
  return true;
}

// All folds, or none: then the image stays as it is. Its area does not change; without any nothing can be done.
void unfoldAll(const AreaFunctional& areas, Eigen::VectorXd targets, const Points3& surface, int mostSteps,
               SolverBackend backend, Coordinates& image) {
  const double area = areas.areas(image).sum();
  if (!(area > 0)) return;
  targets *= area / targets.sum();
  Coordinates unfolded = image;
  if (foldoverFree(areas, targets, surface, mostSteps, backend, unfolded) > 0) return;
  if (goAroundOnce(areas, unfolded)) image = std::move(unfolded);
}

}  // namespace

int removeFolds(const AreaFunctional& areas, const TargetMeasure& target, const Points3& surface,
                SolverBackend backend, Coordinates& image, const Execution& execution) {
  for (const int rings : {4, 2, 1, 0, 8, 16, 32}) {
    const FaceFlags chosen = folded(areas, image);
    if (!chosen.any() || execution.cancelled()) break;
    for (const Patch& patch : patchesAround(chosen, rings, areas)) {
      Coordinates points = image(patch.vertices, Eigen::all);
      unfoldAll(*areas.inPatch(patch, image), target.faces()(patch.faces), surface(patch.vertices, Eigen::all),
                kMostSteps, backend, points);
      image(patch.vertices, Eigen::all) = points;
    }
  }
  if (folded(areas, image).any() && !execution.cancelled()) {
    unfoldAll(areas, target.faces(), surface, kMostStepsEverywhere, backend, image);
  }
  return static_cast<int>(folded(areas, image).count());
}

}  // namespace authalic
