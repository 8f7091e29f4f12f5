#include "Core/authalic/SeamedPatches.h"

#include <vector>

#include "Core/authalic/FoldoverFree.h"
#include "Core/authalic/NarrowFaces.h"
#include "Core/authalic/Patches.h"

namespace authalic {
namespace {

constexpr int kMostSteps = 100;            // in a patch
constexpr int kMostStepsEverywhere = 200;

std::vector<char> conesOf(const SeamedAreas& areas) {
  std::vector<char> held(static_cast<std::size_t>(areas.vertexCount()));
  for (int v = 0; v < areas.vertexCount(); ++v) held[static_cast<std::size_t>(v)] = areas.freedom(v) == 0;
  return held;
}

// Calls change(areas of the patch, its targets, places on the surface and in the image) for every patch around the
// chosen faces.
template <class Change>
void inPatches(const HighGenusMesh& surface, const SeamedAreas& areas, const TargetMeasure& target,
               const FaceFlags& chosen, int rings, Points2& image, const Change& change) {
  const Faces& faces = areas.faces();
  const Parts parts = partsBetween(heldAround(faces, conesOf(areas), chosen, rings), faces);
  for (const Patch& patch : patchesOf(parts, faces)) {
    std::vector<RigidMotion> motions;
    for (const int f : patch.faces) {
      for (int k = 0; k < 3; ++k) motions.push_back(areas.motion(f, k));
    }
    Coordinates points = image(patch.vertices, Eigen::all);
    change(SeamedAreas(patch.corners, patch.freedom, motions), target.faces()(patch.faces),
           surface.mesh().points()(patch.vertices, Eigen::all), points);
    image(patch.vertices, Eigen::all) = points;
  }
}

FaceFlags folded(const SeamedAreas& areas, const Points2& image) { return !(areas.areas(image).array() > 0); }

}  // namespace

int removeFolds(const HighGenusMesh& surface, const SeamedAreas& areas, const TargetMeasure& target,
                SolverBackend backend, Points2& image, const Execution& execution) {
  const auto untanglePatch = [&](const SeamedAreas& patch, Eigen::VectorXd targets, const Points3& points,
                                 Coordinates& places) {
    const double area = patch.areas(places).sum();  // does not change
    if (!(area > 0)) return;
    targets *= area / targets.sum();
    (void)foldoverFree(patch, targets, points, kMostSteps, backend, places);
  };
  for (const int rings : {4, 8, 16, 32}) {
    const FaceFlags chosen = folded(areas, image);
    if (!chosen.any() || execution.cancelled()) break;
    inPatches(surface, areas, target, chosen, rings, image, untanglePatch);
  }
  if (!folded(areas, image).any() || execution.cancelled()) return static_cast<int>(folded(areas, image).count());
  Coordinates places = image;
  const Eigen::VectorXd targets = areas.areas(image).sum() * target.faces();
  const int left = foldoverFree(areas, targets, surface.mesh().points(), kMostStepsEverywhere, backend, places);
  image = places;
  return left;
}

void openNarrowFaces(const HighGenusMesh& surface, const SeamedAreas& areas, const TargetMeasure& target,
                     SolverBackend backend, Points2& image, const Execution& execution) {
  const auto open = [&](const SeamedAreas& patch, const Eigen::VectorXd& shares, const Points3& points,
                        Coordinates& places) { openPatch(patch, shares, points, backend, places); };
  for (const int rings : {4, 8, 16}) {
    const FaceFlags narrow = narrowFaces(areas.areas(image), target);
    if (!narrow.any() || execution.cancelled()) break;
    inPatches(surface, areas, target, narrow, rings, image, open);
  }
}

}  // namespace authalic
