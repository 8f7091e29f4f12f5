#include "Core/authalic/CircleDomainAreas.h"

#include <cmath>
#include <utility>

#include "Core/authalic/PlanarAreas.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

std::vector<char> freedoms(const std::vector<LoopOnCircle>& loops, int vertexCount) {
  std::vector<char> freedom(static_cast<std::size_t>(vertexCount), 2);
  for (const LoopOnCircle& loop : loops) {
    for (const int v : loop.vertices) freedom[static_cast<std::size_t>(v)] = 1;
  }
  return freedom;
}

}  // namespace

double polygonArea(const Points2& image, const std::vector<int>& vertices) {
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto p = image.row(vertices[i]), q = image.row(vertices[(i + 1) % vertices.size()]);
    sum += p[0] * q[1] - p[1] * q[0];
  }
  return 0.5 * sum;
}

CircleDomainAreas::CircleDomainAreas(const Faces& faces, std::vector<LoopOnCircle> loops, int vertexCount)
    : AreaFunctional(faces, freedoms(loops, vertexCount)), loops_(std::move(loops)) {}

Eigen::VectorXd CircleDomainAreas::areas(const Coordinates& image) const {
  return signedFaceAreas(Points2(image), faces());
}

AreaFunctional::Frames CircleDomainAreas::frames(const Coordinates& image) const {
  Frames result = Frames::Zero(image.rows(), 4);
  for (int v = 0; v < vertexCount(); ++v) {
    if (freedom(v) == 2) result.row(v) << 1, 0, 0, 1;
  }
  for (const LoopOnCircle& loop : loops_) {
    for (const int v : loop.vertices) {
      const Eigen::RowVector2d arm = (image.row(v) - loop.centre).normalized();
      result.row(v) << -arm[1], arm[0], 0, 0;
    }
  }
  return result;
}

AreaFunctional::Gradients CircleDomainAreas::gradients(const Coordinates& image, const Frames& frames) const {
  return planarGradients(faces(), image, frames);
}

double CircleDomainAreas::radius(const Points2& image, std::size_t loop) const {
  if (loop == 0) return 1;
  const LoopOnCircle& hole = loops_[loop];
  double sines = 0;
  for (std::size_t i = 0; i < hole.vertices.size(); ++i) {
    const Eigen::RowVector2d p = (image.row(hole.vertices[i]) - hole.centre).normalized(),
                             q = (image.row(hole.vertices[(i + 1) % hole.vertices.size()]) - hole.centre).normalized();
    sines -= p[0] * q[1] - p[1] * q[0];  // the surface is to the left: holes run clockwise
  }
  return std::sqrt(2 * hole.share * polygonArea(image, loops_.front().vertices) / sines);
}

Coordinates CircleDomainAreas::moved(const Coordinates& image, const Coordinates& displacement, double t) const {
  Points2 result = image + t * displacement;
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    const Eigen::RowVector2d centre = loops_[k].centre;
    const double onto = radius(result, k);
    for (const int v : loops_[k].vertices) {
      const Eigen::RowVector2d arm = result.row(v) - centre;
      result.row(v) = centre + arm * (onto / arm.norm());
    }
  }
  return result;
}

double CircleDomainAreas::firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const {
  return planarFirstFlip(faces(), image, displacement, face);
}

}  // namespace authalic
