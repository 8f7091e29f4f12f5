#include "Core/authalic/CircleDomainAreas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "Core/authalic/Patches.h"
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

// ½ Σ sin Δθ of a loop's vertices about a centre: the area of its polygon at radius 1.
double unitPolygon(const Coordinates& image, const std::vector<int>& vertices, const Eigen::RowVector2d& centre) {
  double sines = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Eigen::RowVector2d p = (image.row(vertices[i]) - centre).normalized(),
                             q = (image.row(vertices[(i + 1) % vertices.size()]) - centre).normalized();
    sines += p[0] * q[1] - p[1] * q[0];
  }
  return 0.5 * sines;
}

// Of the surface, where radii are free: the outer circle follows.
constexpr double kGround = 1;

}  // namespace

double polygonArea(const Points2& image, const std::vector<int>& vertices) {
  double sum = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto p = image.row(vertices[i]), q = image.row(vertices[(i + 1) % vertices.size()]);
    sum += p[0] * q[1] - p[1] * q[0];
  }
  return 0.5 * sum;
}

CircleDomainAreas::CircleDomainAreas(const Faces& faces, std::vector<LoopOnCircle> loops, int vertexCount,
                                     CircleFreedom freedom)
    : AreaFunctional(faces, freedoms(loops, vertexCount)), loops_(std::move(loops)), circles_(freedom) {}

Eigen::RowVector2d CircleDomainAreas::centre(const Coordinates& image, std::size_t loop) const {
  return loop > 0 && circles_.centres ? Eigen::RowVector2d(image.row(row(loop))) : loops_[loop].centre;
}

Eigen::VectorXd CircleDomainAreas::areas(const Coordinates& image) const {
  return signedFaceAreas(Points2(image), faces());
}

AreaFunctional::Frames CircleDomainAreas::frames(const Coordinates& image) const {
  Frames result = Frames::Zero(image.rows(), 4);
  for (int v = 0; v < vertexCount(); ++v) {
    if (freedom(v) == 2) result.row(v) << 1, 0, 0, 1;
  }
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    for (const int v : loops_[k].vertices) {
      const Eigen::RowVector2d arm = (image.row(v) - centre(image, k)).normalized();
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
  const double polygon = -unitPolygon(image, hole.vertices, hole.centre);  // holes run clockwise
  return std::sqrt(hole.share * polygonArea(image, loops_.front().vertices) / polygon);
}

// Of the outer circle, so that the surface has its area beside holes of these radii.
double CircleDomainAreas::outerRadius(const Coordinates& image, const Eigen::VectorXd& radii) const {
  if (!circles_.radii) return 1;
  double whole = kGround;
  for (std::size_t k = 1; k < loops_.size(); ++k) {
    const double r = radii[static_cast<Eigen::Index>(k)];
    whole -= r * r * unitPolygon(image, loops_[k].vertices, centre(image, k));
  }
  return std::sqrt(whole / unitPolygon(image, loops_.front().vertices, loops_.front().centre));
}

Coordinates CircleDomainAreas::moved(const Coordinates& image, const Coordinates& displacement, double t) const {
  Coordinates result = image + t * displacement;
  const double unit = unitPolygon(result, loops_.front().vertices, loops_.front().centre);
  Eigen::VectorXd radii(static_cast<Eigen::Index>(loops_.size()));
  for (std::size_t k = 1; k < loops_.size(); ++k) {
    const double polygon = -unitPolygon(result, loops_[k].vertices, centre(result, k));
    radii[static_cast<Eigen::Index>(k)] =
        circles_.radii ? std::exp(result(row(k) + 1, 0)) : std::sqrt(loops_[k].share * unit / polygon);
  }
  radii[0] = outerRadius(result, radii);
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    const Eigen::RowVector2d middle = centre(result, k);
    for (const int v : loops_[k].vertices) {
      const Eigen::RowVector2d arm = result.row(v) - middle;
      result.row(v) = middle + arm * (radii[static_cast<Eigen::Index>(k)] / arm.norm());
    }
  }
  return result;
}

std::unique_ptr<AreaFunctional> CircleDomainAreas::inPatch(const Patch& patch, const Coordinates&) const {
  return std::make_unique<PlanarPatchAreas>(patch.corners, patch.freedom);
}

std::vector<Coordinates> CircleDomainAreas::jointMoves(const Coordinates& image) const {
  std::vector<Coordinates> moves;
  const std::vector<int>& outer = loops_.front().vertices;
  for (std::size_t k = 1; k < loops_.size() && circles_.any(); ++k) {
    for (int axis = 0; axis < 2 && circles_.centres; ++axis) {
      Coordinates& along = moves.emplace_back(Coordinates::Zero(image.rows(), 2));
      for (const int v : loops_[k].vertices) along(v, axis) = 1;
      along(row(k), axis) = 1;
    }
    if (!circles_.radii) continue;
    Coordinates& grows = moves.emplace_back(Coordinates::Zero(image.rows(), 2));
    for (const int v : loops_[k].vertices) grows.row(v) = image.row(v) - centre(image, k);
    const double part = -polygonArea(image.leftCols<2>(), loops_[k].vertices) / polygonArea(image.leftCols<2>(), outer);
    for (const int v : outer) grows.row(v) = part * (image.row(v) - loops_.front().centre);
    grows(row(k) + 1, 0) = 1;
  }
  return moves;
}

Coordinates CircleDomainAreas::slowed(const Coordinates& image, const Coordinates& displacement,
                                      const Eigen::VectorXd& part) const {
  Coordinates result = part.asDiagonal() * displacement;
  for (std::size_t k = 1; k < loops_.size() && circles_.any(); ++k) {
    double least = 1;
    for (const int v : loops_[k].vertices) least = std::min(least, part[v]);
    for (const Eigen::Index i : {row(k), row(k) + 1}) result.row(i) = least * displacement.row(i);
    for (const int v : loops_[k].vertices) {
      const Eigen::RowVector2d joint =
          displacement.row(row(k)) + displacement(row(k) + 1, 0) * (image.row(v) - centre(image, k));
      result.row(v) += (least - part[v]) * joint;
    }
  }
  return result;
}

Coordinates CircleDomainAreas::begun(const Points2& image) const {
  if (!circles_.any()) return image;
  Coordinates result = Coordinates::Zero(vertexCount() + 2 * static_cast<Eigen::Index>(loops_.size() - 1), 2);
  double ground = polygonArea(image, loops_.front().vertices);
  for (std::size_t k = 1; k < loops_.size(); ++k) ground += polygonArea(image, loops_[k].vertices);
  const double scale = circles_.radii ? std::sqrt(kGround / ground) : 1;
  result.topRows(vertexCount()) = scale * image;
  for (std::size_t k = 1; k < loops_.size(); ++k) {
    result.row(row(k)) = scale * loops_[k].centre;
    result(row(k) + 1, 0) = std::log(scale * (image.row(loops_[k].vertices.front()) - loops_[k].centre).norm());
  }
  return result;
}

Points2 CircleDomainAreas::ended(const Coordinates& image, std::vector<LoopOnCircle>& loops) const {
  if (!circles_.any()) return image;
  const double scale = 1 / image.row(loops_.front().vertices.front()).norm();
  for (std::size_t k = 1; k < loops.size(); ++k) loops[k].centre = scale * centre(image, k);
  return scale * image.topRows(vertexCount());
}

double CircleDomainAreas::firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const {
  return planarFirstFlip(faces(), image, displacement, face);
}

}  // namespace authalic
