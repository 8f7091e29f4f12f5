#include "Core/authalic/NarrowFaces.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/FaceMatch.h"
#include "Core/authalic/Patches.h"
#include "Core/authalic/PlanarAreas.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kCollapsed = 1e-4;           // share of its target from where a face does not open by itself
constexpr double kNarrow = 0.1, kOpen = 0.3;  // share of a face by its target, in the image and in its patch
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

// The faces of one part of the disk, numbered by themselves.
struct Patch {
  std::vector<int> faces, vertices;  // of the disk
  Faces corners;
  std::vector<char> freedom;
};

std::vector<Patch> patchesOf(const Parts& parts, const Faces& faces) {
  std::vector<Patch> patches(static_cast<std::size_t>(parts.count));
  for (std::size_t f = 0; f < parts.ofFace.size(); ++f) {
    if (parts.ofFace[f] >= 0) patches[static_cast<std::size_t>(parts.ofFace[f])].faces.push_back(static_cast<int>(f));
  }
  std::vector<int> number(parts.ofVertex.size(), -1);
  for (Patch& patch : patches) {
    patch.corners = faces(patch.faces, Eigen::all);
    for (int& v : patch.corners.reshaped<Eigen::RowMajor>()) {
      int& local = number[static_cast<std::size_t>(v)];
      if (local < 0) {
        local = static_cast<int>(patch.vertices.size());
        patch.vertices.push_back(v);
        patch.freedom.push_back(parts.ofVertex[static_cast<std::size_t>(v)] >= 0 ? 2 : 0);
      }
      v = local;
    }
    for (const int v : patch.vertices) number[static_cast<std::size_t>(v)] = -1;
  }
  return patches;
}

void openPatch(const DiskMesh& disk, const Patch& patch, const TargetMeasure& target, SolverBackend backend,
               Points2& image) {
  const PatchAreas areas(patch.corners, patch.freedom);
  Eigen::VectorXd shares = target.faces()(patch.faces);
  shares /= shares.sum();
  const Points3 surface = disk.mesh().points()(patch.vertices, Eigen::all);
  AnalysedSystems systems;
  FaceMatch match(areas, shares, cotangentWeights(surface, patch.corners), backend, Shapes::Free, systems);
  match.restart(kGoal);
  Coordinates points = image(patch.vertices, Eigen::all);
  const auto narrowest = [&] {
    const Eigen::VectorXd a = areas.areas(points);
    return (a.array() / (a.sum() * shares.array())).minCoeff();
  };
  for (int k = 0; k < kMostSteps && !match.stalled() && narrowest() < kOpen; ++k) match.advance(points);
  image(patch.vertices, Eigen::all) = points;
}

}  // namespace

UnfoldResult openNarrowFaces(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                             SolverBackend backend, const Execution& execution) {
  const Faces& faces = disk.mesh().faces();
  UnfoldResult result =
      unfold(disk.topology(), reviveCollapsedFaces(disk, image, target, backend, kCollapsed), execution);
  if (result.flippedFaces > 0) return result;
  result.image = reviveCollapsedFaces(disk, result.image, target, backend, kCollapsed);
  for (const int rings : {4, 8, 16}) {
    const Eigen::VectorXd areas = signedFaceAreas(result.image, faces);
    const auto narrow = areas.array() < kNarrow * areas.sum() * target.faces().array();
    if (!narrow.any()) break;
    const Parts parts = partsBetween(heldAround(disk, narrow, rings), faces);
    for (const Patch& patch : patchesOf(parts, faces)) openPatch(disk, patch, target, backend, result.image);
  }
  return result;
}

}  // namespace authalic
