#include "Core/authalic/FoldRemoval.h"

#include <memory>

#include "Core/authalic/FoldoverFree.h"
#include "Core/authalic/Patches.h"

namespace authalic {
namespace {

constexpr int kMostSteps = 100;            // in a patch
constexpr int kMostStepsEverywhere = 200;

FaceFlags folded(const AreaFunctional& areas, const Coordinates& image) {
  return !(areas.areas(image).array() > 0);
}

// The area of a patch does not change; one without any is left as it is.
void unfoldPatch(const AreaFunctional& areas, Eigen::VectorXd targets, const Points3& surface, SolverBackend backend,
                 Coordinates& points) {
  const double area = areas.areas(points).sum();
  if (!(area > 0)) return;
  targets *= area / targets.sum();
  (void)foldoverFree(areas, targets, surface, kMostSteps, backend, points);
}

}  // namespace

int removeFolds(const AreaFunctional& areas, const TargetMeasure& target, const Points3& surface,
                SolverBackend backend, Coordinates& image, const Execution& execution) {
  for (const int rings : {4, 8, 16, 32}) {
    const FaceFlags chosen = folded(areas, image);
    if (!chosen.any() || execution.cancelled()) break;
    for (const Patch& patch : patchesAround(chosen, rings, areas)) {
      Coordinates points = image(patch.vertices, Eigen::all);
      unfoldPatch(*areas.inPatch(patch, image), target.faces()(patch.faces), surface(patch.vertices, Eigen::all),
                  backend, points);
      image(patch.vertices, Eigen::all) = points;
    }
  }
  const auto left = static_cast<int>(folded(areas, image).count());
  if (left == 0 || execution.cancelled()) return left;
  const Eigen::VectorXd targets = areas.areas(image).sum() * target.faces();
  return foldoverFree(areas, targets, surface, kMostStepsEverywhere, backend, image);
}

}  // namespace authalic
