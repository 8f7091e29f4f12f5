#include "Core/authalic/PlanarAreas.h"

#include <utility>

#include "Core/geometry/Areas.h"
#include "Core/numerics/FlipFreeStep.h"

namespace authalic {

std::vector<PlanarAreas::Ear> PlanarAreas::ears(const Faces& faces, const SlidingBoundary& sliding, int vertexCount) {
  std::vector<Ear> result;
  if (!sliding.onCircle()) return result;
  std::vector<int> valence(static_cast<std::size_t>(vertexCount), 0);
  for (Eigen::Index c = 0; c < faces.size(); ++c) ++valence[static_cast<std::size_t>(faces.data()[c])];
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Ear ear{faces(f, k), faces(f, (k + 2) % 3), faces(f, (k + 1) % 3)};
      const bool slides =
          sliding.freedom(ear.tip) == 1 && sliding.freedom(ear.from) == 1 && sliding.freedom(ear.to) == 1;
      if (slides && valence[static_cast<std::size_t>(ear.tip)] == 1) result.push_back(ear);
    }
  }
  return result;
}

std::vector<char> PlanarAreas::freedoms(const std::vector<Ear>& ears, const SlidingBoundary& sliding, int vertexCount) {
  std::vector<char> freedom(static_cast<std::size_t>(vertexCount));
  for (int v = 0; v < vertexCount; ++v) freedom[static_cast<std::size_t>(v)] = static_cast<char>(sliding.freedom(v));
  for (const Ear& ear : ears) freedom[static_cast<std::size_t>(ear.tip)] = 0;
  return freedom;
}

PlanarAreas::PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, int vertexCount)
    : PlanarAreas(faces, sliding, vertexCount, ears(faces, sliding, vertexCount)) {}

PlanarAreas::PlanarAreas(const Faces& faces, const SlidingBoundary& sliding, int vertexCount, std::vector<Ear> ears)
    : AreaFunctional(faces, freedoms(ears, sliding, vertexCount)), sliding_(sliding), ears_(std::move(ears)) {}

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
  for (const Ear& ear : ears_) {
    const Eigen::RowVector2d middle = result.row(ear.from) + result.row(ear.to);
    if (middle.norm() > 0) result.row(ear.tip) = middle.normalized() * (middle.dot(image.row(ear.tip)) < 0 ? -1 : 1);
  }
  return result;
}

Coordinates PlanarAreas::displacement(const Frames& frames, const Eigen::VectorXd& step) const {
  Coordinates result = AreaFunctional::displacement(frames, step);
  for (const Ear& ear : ears_) result.row(ear.tip) = 0.5 * (result.row(ear.from) + result.row(ear.to));
  return result;
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

}  // namespace authalic
