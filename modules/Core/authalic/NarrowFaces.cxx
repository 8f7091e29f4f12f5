#include "Core/authalic/NarrowFaces.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/FaceMatch.h"
#include "Core/authalic/Patches.h"
#include "Core/authalic/PlanarAreas.h"
#include "Core/authalic/SolidAngles.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"

namespace authalic {
namespace {

constexpr double kCollapsed = 1e-4;           // share of its target from where a face does not open by itself
constexpr Narrowness kOnSphere{0.01, 0.03};
constexpr int kMostSteps = 60;                // in a patch
constexpr double kGoal = 0.1;                 // residual of a patch, by far smaller than that of an open one

// A patch in the plane whose rim is held.
class PatchAreas final : public AreaFunctional {
 public:
  PatchAreas(const Faces& faces, std::vector<char> freedom) : AreaFunctional(faces, std::move(freedom)) {}

  [[nodiscard]] Eigen::VectorXd areas(const Coordinates& image) const override {
    return signedFaceAreas(Points2(image), faces());
  }
  [[nodiscard]] Frames frames(const Coordinates& image) const override {
    Frames result = Frames::Zero(image.rows(), 4);
    for (int v = 0; v < vertexCount(); ++v) {
      if (freedom(v) == 2) result.row(v) << 1, 0, 0, 1;
    }
    return result;
  }
  [[nodiscard]] Gradients gradients(const Coordinates& image, const Frames& frames) const override {
    return planarGradients(faces(), image, frames);
  }
  [[nodiscard]] Coordinates moved(const Coordinates& image, const Coordinates& displacement,
                                  double t) const override {
    return image + t * displacement;
  }
  [[nodiscard]] double firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const override {
    return planarFirstFlip(faces(), image, displacement, face);
  }
};

// Rings of 4, 8 and 16 around the faces that are narrow, the rest held.
template <class Image, class Areas, class AreasOf>
void openInPatches(const Faces& faces, const std::vector<char>& held, const TargetMeasure& target,
                   const Points3& surface, SolverBackend backend, const Narrowness& narrowness, const Areas& areas,
                   const AreasOf& areasOf, Image& image) {
  for (const int rings : {4, 8, 16}) {
    const auto narrow = narrowFaces(areas(image), target, narrowness);
    if (!narrow.any()) break;
    const Parts parts = partsBetween(heldAround(faces, held, narrow, rings), faces);
    for (const Patch& patch : patchesOf(parts, faces)) {
      Coordinates points = image(patch.vertices, Eigen::all);
      openPatch(areasOf(patch), target.faces()(patch.faces), surface(patch.vertices, Eigen::all), backend, points,
                narrowness);
      image(patch.vertices, Eigen::all) = points;
    }
  }
}

}  // namespace

void openPatch(const AreaFunctional& areas, Eigen::VectorXd shares, const Points3& surface, SolverBackend backend,
               Coordinates& points, const Narrowness& narrowness) {
  shares /= shares.sum();
  AnalysedSystems systems;
  FaceMatch match(areas, shares, cotangentWeights(surface, areas.faces()), backend, Shapes::Free, systems);
  match.restart(kGoal);
  const auto narrowest = [&] {
    const Eigen::VectorXd a = areas.areas(points);
    return (a.array() / (a.sum() * shares.array())).minCoeff();
  };
  for (int k = 0; k < kMostSteps && !match.stalled() && narrowest() < narrowness.open; ++k) match.advance(points);
}

Eigen::Array<bool, Eigen::Dynamic, 1> narrowFaces(const Eigen::VectorXd& areas, const TargetMeasure& target,
                                                  const Narrowness& narrowness) {
  return areas.array() < narrowness.narrow * areas.sum() * target.faces().array();
}

UnfoldResult openNarrowFaces(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                             SolverBackend backend, const Execution& execution) {
  const Faces& faces = disk.mesh().faces();
  UnfoldResult result =
      unfold(disk.topology(), reviveCollapsedFaces(disk, image, target, backend, kCollapsed), execution);
  if (result.flippedFaces > 0) return result;
  result.image = reviveCollapsedFaces(disk, result.image, target, backend, kCollapsed);
  openInPatches(faces, disk.topology().onBoundary(), target, disk.mesh().points(), backend, {},
                [&faces](const Points2& points) { return signedFaceAreas(points, faces); },
                [](const Patch& patch) { return PatchAreas(patch.corners, patch.freedom); }, result.image);
  return result;
}

void openNarrowFacesOnSphere(const SphereMesh& sphere, const TargetMeasure& target, SolverBackend backend,
                             Points3& image) {
  const Faces& faces = sphere.mesh().faces();
  openInPatches(faces, std::vector<char>(static_cast<std::size_t>(image.rows()), 0), target, sphere.mesh().points(),
                backend, kOnSphere, [&faces](const Points3& points) { return signedSolidAngles(points, faces); },
                [](const Patch& patch) { return SolidAngles(patch.corners, patch.freedom); }, image);
}

}  // namespace authalic
