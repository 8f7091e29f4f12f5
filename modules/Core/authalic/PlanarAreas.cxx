#include "Core/authalic/PlanarAreas.h"

#include <utility>

#include "Core/authalic/Patches.h"
#include "Core/geometry/Areas.h"
#include "Core/numerics/FlipFreeStep.h"

namespace authalic {
namespace {

std::vector<char> freedoms(const SlidingBoundary& sliding, int vertexCount) {
  std::vector<char> freedom(static_cast<std::size_t>(vertexCount));
  for (int v = 0; v < vertexCount; ++v) freedom[static_cast<std::size_t>(v)] = static_cast<char>(sliding.freedom(v));
  return freedom;
}

std::vector<char> freedomsWithoutTips(const EarsOnCircle& ears, const SlidingBoundary& sliding, int vertexCount) {
  std::vector<char> freedom = freedoms(sliding, vertexCount);
  for (const EarOnCircle& ear : ears.all()) freedom[static_cast<std::size_t>(ear.tip)] = 0;
  return freedom;
}

EarsOnCircle earsOf(const Faces& faces, const SlidingBoundary& sliding, int vertexCount) {
  std::vector<char> onCircle(static_cast<std::size_t>(vertexCount), 0);
  for (int v = 0; v < vertexCount; ++v) {
    onCircle[static_cast<std::size_t>(v)] = sliding.onCircle() && sliding.freedom(v) == 1;
  }
  return {faces, onCircle};
}

}  // namespace

PlanarAreas::PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, EarsOnCircle ears,
                         std::vector<char> freedoms, const Eigen::VectorXd* vertexShares)
    : AreaFunctional(faces, std::move(freedoms)), sliding_(sliding), ears_(std::move(ears)),
      vertexShares_(vertexShares) {}

PlanarAreas::PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, int vertexCount)
    : PlanarAreas(faces, sliding, earsOf(faces, sliding, vertexCount),
                  freedomsWithoutTips(earsOf(faces, sliding, vertexCount), sliding, vertexCount), nullptr) {}

PlanarAreas::PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, const Eigen::VectorXd& vertexShares)
    : PlanarAreas(faces, sliding, earsOf(faces, sliding, static_cast<int>(vertexShares.size())),
                  freedoms(sliding, static_cast<int>(vertexShares.size())), &vertexShares) {}

Eigen::VectorXd PlanarAreas::areas(const Coordinates& image) const { return signedFaceAreas(Points2(image), faces()); }

AreaFunctional::Frames PlanarAreas::frames(const Coordinates& image) const {
  const Points2 points = image;
  Frames result = Frames::Zero(image.rows(), 4);
  for (int v = 0; v < vertexCount(); ++v) {
    if (freedom(v) == 2) result.row(v) << 1, 0, 0, 1;
    if (freedom(v) == 1) result.row(v).head<2>() = sliding_.tangent(points, v);
  }
  return result;
}

AreaFunctional::Gradients planarGradients(const Faces& faces, const Coordinates& image,
                                          const AreaFunctional::Frames& frames) {
  AreaFunctional::Gradients result(faces.rows(), 6);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int i = faces(f, k), j = faces(f, (k + 1) % 3), l = faces(f, (k + 2) % 3);
      const double gx = 0.5 * (image(j, 1) - image(l, 1)), gy = 0.5 * (image(l, 0) - image(j, 0));
      result(f, 2 * k) = gx * frames(i, 0) + gy * frames(i, 1);
      result(f, 2 * k + 1) = gx * frames(i, 2) + gy * frames(i, 3);
    }
  }
  return result;
}

AreaFunctional::Gradients PlanarAreas::gradients(const Coordinates& image, const Frames& frames) const {
  return planarGradients(faces(), image, frames);
}

Coordinates PlanarAreas::moved(const Coordinates& image, const Coordinates& displacement, double t) const {
  Points2 result = image + t * displacement;
  sliding_.retract(result);
  if (vertexShares_ == nullptr) ears_.centreTips(result);
  return result;
}

Coordinates PlanarAreas::displacement(const Frames& frames, const Eigen::VectorXd& step) const {
  Coordinates result = AreaFunctional::displacement(frames, step);
  if (vertexShares_ != nullptr) return result;
  for (const EarOnCircle& ear : ears_.all()) {
    result.row(ear.tip) = 0.5 * (result.row(ear.from) + result.row(ear.to));
  }
  return result;
}

Coordinates PlanarAreas::eased(Coordinates image) const {
  if (vertexShares_ == nullptr || ears_.all().empty()) return image;
  Points2 points = image;
  ears_.easeTips(points, faces(), *vertexShares_);
  return points;
}

const std::vector<EarOnCircle>& PlanarAreas::slidingEars() const {
  return vertexShares_ == nullptr ? AreaFunctional::slidingEars() : ears_.all();
}

double planarFirstFlip(const Faces& faces, const Coordinates& image, const Coordinates& displacement, int face) {
  const int a = faces(face, 0), b = faces(face, 1), c = faces(face, 2);
  const auto edge = [](const Coordinates& x, int from, int to) { return Eigen::Vector2d(x.row(to) - x.row(from)); };
  const auto cross = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) { return u[0] * v[1] - u[1] * v[0]; };
  const Eigen::Vector2d e = edge(image, a, b), g = edge(image, a, c), d = edge(displacement, a, b),
                        h = edge(displacement, a, c);
  return smallestPositiveRoot(cross(d, h), cross(e, h) + cross(d, g), cross(e, g));
}

double PlanarAreas::firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const {
  return planarFirstFlip(faces(), image, displacement, face);
}

std::unique_ptr<AreaFunctional> PlanarAreas::inPatch(const Patch& patch, const Coordinates&) const {
  return std::make_unique<PlanarPatchAreas>(patch.corners, patch.freedom);
}

PlanarPatchAreas::PlanarPatchAreas(const Faces& faces, std::vector<char> freedom)
    : AreaFunctional(faces, std::move(freedom)) {}

Eigen::VectorXd PlanarPatchAreas::areas(const Coordinates& image) const {
  return signedFaceAreas(Points2(image), faces());
}

AreaFunctional::Frames PlanarPatchAreas::frames(const Coordinates& image) const {
  Frames result = Frames::Zero(image.rows(), 4);
  for (int v = 0; v < vertexCount(); ++v) {
    if (freedom(v) == 2) result.row(v) << 1, 0, 0, 1;
  }
  return result;
}

AreaFunctional::Gradients PlanarPatchAreas::gradients(const Coordinates& image, const Frames& frames) const {
  return planarGradients(faces(), image, frames);
}

Coordinates PlanarPatchAreas::moved(const Coordinates& image, const Coordinates& displacement, double t) const {
  return image + t * displacement;
}

std::unique_ptr<AreaFunctional> PlanarPatchAreas::inPatch(const Patch& patch, const Coordinates&) const {
  return std::make_unique<PlanarPatchAreas>(patch.corners, patch.freedom);
}

double PlanarPatchAreas::firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const {
  return planarFirstFlip(faces(), image, displacement, face);
}

}  // namespace authalic
