#include "Core/authalic/RoundHoles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "Core/authalic/PlanarAreas.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"
#include "Core/initial/FoldedPockets.h"
#include "Core/initial/Untangle.h"

namespace authalic {
namespace {

constexpr int kSteps = 40, kFewest = 5;
constexpr double kMarginToFlip = 0.7;
constexpr double kTooShort = 1e-3;         // a step that leads nowhere
constexpr double kSmallest = 1e-4;         // of the mean area, in the weights
constexpr double kNarrowest = 0.05;        // angle between neighbours of a loop, by the mean one
constexpr double kGap = 0.15;              // between circles, by the smaller radius
constexpr int kPushes = 500;
constexpr double kThere = 1e-10;           // of a vertex to its place on the circle

struct Circle {
  Eigen::RowVector2d centre{0, 0};
  double radius = 1;
};

Circle circleOf(const Points2& image, const std::vector<int>& loop, double share) {
  double twice = 0;
  Circle circle;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::RowVector2d p = image.row(loop[i]), q = image.row(loop[(i + 1) % loop.size()]);
    const double cross = p[0] * q[1] - p[1] * q[0];
    twice += cross;
    circle.centre += cross * (p + q);
  }
  circle.centre /= 3 * twice;
  circle.radius = std::sqrt(share);
  return circle;
}

// Circles that overlap push each other away, the heavier less; the unit circle pushes back.
void pushApart(std::vector<Circle>& circles) {
  for (int pass = 0; pass < kPushes; ++pass) {
    bool moved = false;
    for (std::size_t i = 0; i < circles.size(); ++i) {
      Circle& a = circles[i];
      for (std::size_t j = i + 1; j < circles.size(); ++j) {
        Circle& b = circles[j];
        const Eigen::RowVector2d apart = b.centre - a.centre;
        const double distance = std::max(apart.norm(), 1e-12),
                     over = a.radius + b.radius + kGap * std::min(a.radius, b.radius) - distance;
        if (!(over > 1e-12)) continue;
        const double weight = a.radius * a.radius / (a.radius * a.radius + b.radius * b.radius);
        a.centre -= (1 - weight) * over / distance * apart;
        b.centre += weight * over / distance * apart;
        moved = true;
      }
      const double out = a.centre.norm() + (1 + kGap) * a.radius - 1;
      if (!(out > 1e-12) || a.centre.norm() == 0) continue;
      a.centre *= std::max(a.centre.norm() - out, 0.0) / a.centre.norm();
      moved = true;
    }
    if (!moved) return;
  }
}

// Angles of the vertices of a hole (clockwise) about a centre, made monotone by arc lengths where they are not.
std::vector<double> anglesOf(const Points2& image, const std::vector<int>& loop, const Eigen::RowVector2d& centre) {
  const std::size_t n = loop.size();
  std::vector<double> turn(n), length(n), result(n);
  double turned = 0, around = 0, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::RowVector2d a = image.row(loop[i]), b = image.row(loop[(i + 1) % n]), p = a - centre, q = b - centre;
    turn[i] = std::atan2(p[1] * q[0] - p[0] * q[1], p.dot(q));
    length[i] = (b - a).norm();
    turned += turn[i];
    around += length[i];
    least = std::min(least, turn[i]);
  }
  const double mean = 2 * M_PI / static_cast<double>(n);
  const bool once = std::abs(turned - 2 * M_PI) < 1;
  const double smooth = least >= kNarrowest * mean && once ? 0 : least > 0 && once ? 0.5 : 1;
  const Eigen::RowVector2d first = image.row(loop[0]) - centre;
  double byTurn = 0, byLength = 0, off = 0;
  std::vector<double> lengths(n);
  for (std::size_t i = 0; i < n; ++i) {
    result[i] = byTurn;
    lengths[i] = byLength;
    off += (byTurn - byLength) / static_cast<double>(n);
    byTurn += turn[i];
    byLength += 2 * M_PI * length[i] / around;
  }
  const double start = std::atan2(first[1], first[0]);
  for (std::size_t i = 0; i < n; ++i) {
    result[i] = start - ((1 - smooth) * result[i] + smooth * (lengths[i] + off));
  }
  return result;
}

// Weights of the edges of every face: small faces and needles are stiff.
HalfEdgeWeights stiffnessOf(const Points2& image, const Faces& faces) {
  const Eigen::VectorXd areas = signedFaceAreas(image, faces);
  const double mean = areas.cwiseAbs().mean();
  HalfEdgeWeights weights(areas.size(), 3);
  for (Eigen::Index f = 0; f < areas.size(); ++f) {
    const double area = std::max(areas[f], kSmallest * mean);
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      longest = std::max(longest, (image.row(faces(f, (k + 1) % 3)) - image.row(faces(f, k))).squaredNorm());
    }
    weights.row(f).setConstant(std::min(longest / area * mean / area, 1e8));
  }
  return weights;
}

// With which the polygon at these angles has the area.
double radiusFor(const std::vector<double>& angles, double area) {
  double sines = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) sines += std::sin(angles[i] - angles[(i + 1) % angles.size()]);
  return std::sqrt(2 * area / sines);
}

class Rounding {
 public:
  Rounding(const PolyAnnulusMesh& surface, Points2 image, SolverBackend backend)
      : surface_(surface), faces_(surface.mesh().faces()), image_(std::move(image)), goal_(image_),
        driven_(surface.topology().onBoundary()), inPocket_(driven_.size(), 0), backend_(backend) {}

  void aim(const std::vector<int>& loop, const std::vector<double>& angles, const Circle& circle) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      goal_.row(loop[i]) =
          circle.centre + circle.radius * Eigen::RowVector2d(std::cos(angles[i]), std::sin(angles[i]));
    }
  }

  int findPockets() {
    FoldedPocketsResult bulged = bulgeFoldedPockets(surface_.mesh(), surface_.topology(), goal_);
    goal_ = std::move(bulged.image);
    for (const int v : bulged.movedVertices) inPocket_[at(v)] = driven_[at(v)] = 1;
    return bulged.pockets;
  }

  // Returns whether the goal was reached.
  bool move(const Execution& execution) {
    BarycentricSolver solver(faces_, driven_, backend_);
    for (int step = 0; step < kSteps && !execution.cancelled(); ++step) {
      Points2 way = Points2::Zero(image_.rows(), 2);
      for (std::size_t v = 0; v < driven_.size(); ++v) {
        const auto i = static_cast<Eigen::Index>(v);
        if (driven_[v]) way.row(i) = goal_.row(i) - image_.row(i);
      }
      solver.solve(stiffnessOf(image_, faces_), way);
      Coordinates now = way / std::max(1, kFewest - step);
      slow(now);
      const double part = std::min(1.0, kMarginToFlip * firstFlip(now));
      if (part < kTooShort) return false;
      image_ += part * now;
      if (distance() < kThere) return true;
    }
    return false;
  }

  // What lies on the way is folded and unfolded again.
  void jump() {
    for (std::size_t v = 0; v < driven_.size(); ++v) {
      if (driven_[v]) image_.row(static_cast<Eigen::Index>(v)) = goal_.row(static_cast<Eigen::Index>(v));
    }
    UnfoldResult unfolded = unfoldOrUntangle(surface_.topology(), image_);
    image_ = std::move(unfolded.image);
  }

  [[nodiscard]] bool inPocket(int v) const { return inPocket_[at(v)] != 0; }
  [[nodiscard]] const Points2& image() const noexcept { return image_; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  [[nodiscard]] bool inPocket(const Faces& faces, int f) const {
    return inPocket(faces(f, 0)) || inPocket(faces(f, 1)) || inPocket(faces(f, 2));
  }

  // Corners of faces that would collapse early go a part of the way; the others need not wait.
  void slow(Coordinates& way) const {
    const Coordinates image = image_;
    for (int pass = 0; pass < 20; ++pass) {
      Eigen::VectorXd part = Eigen::VectorXd::Ones(way.rows());
      for (int f = 0; f < static_cast<int>(faces_.rows()); ++f) {
        const double flip = inPocket(faces_, f) ? 1 : planarFirstFlip(faces_, image, way, f);
        for (int k = 0; k < 3 && flip < 1; ++k) {
          part[faces_(f, k)] = std::min(part[faces_(f, k)], std::max(0.5 * flip, 0.02));
        }
      }
      if (part.minCoeff() == 1) return;
      way = part.asDiagonal() * way;
    }
  }

  // Of the farthest driven vertex to its goal.
  [[nodiscard]] double distance() const {
    double farthest = 0;
    for (std::size_t v = 0; v < driven_.size(); ++v) {
      const auto i = static_cast<Eigen::Index>(v);
      if (driven_[v] && !inPocket_[v]) farthest = std::max(farthest, (goal_.row(i) - image_.row(i)).norm());
    }
    return farthest;
  }

  [[nodiscard]] double firstFlip(const Coordinates& way) const {
    const Coordinates image = image_;
    double first = std::numeric_limits<double>::infinity();
    for (int f = 0; f < static_cast<int>(faces_.rows()); ++f) {
      if (inPocket(faces_, f)) continue;
      first = std::min(first, planarFirstFlip(faces_, image, way, f));
    }
    return first;
  }

  const PolyAnnulusMesh& surface_;
  const Faces& faces_;
  Points2 image_, goal_;
  std::vector<char> driven_, inPocket_;
  SolverBackend backend_;
};

}  // namespace

RoundedHoles roundHoles(const PolyAnnulusMesh& surface, const Points2& image, const std::vector<double>& shares,
                        int outer, SolverBackend backend, const Execution& execution) {
  std::vector<Circle> circles;
  std::vector<std::vector<double>> angles;
  for (std::size_t k = 0; k < surface.loops().size(); ++k) {
    if (static_cast<int>(k) == outer) continue;
    circles.push_back(circleOf(image, surface.loops()[k], shares[circles.size()]));
    angles.push_back(anglesOf(image, surface.loops()[k], circles.back().centre));
  }
  pushApart(circles);
  const double disk = polygonArea(image, surface.loops()[static_cast<std::size_t>(outer)]);
  Rounding rounding(surface, image, backend);
  for (std::size_t k = 0, hole = 0; k < surface.loops().size(); ++k) {
    if (static_cast<int>(k) == outer) continue;
    circles[hole].radius = radiusFor(angles[hole], shares[hole] * disk);
    rounding.aim(surface.loops()[k], angles[hole], circles[hole]);
    ++hole;
  }
  RoundedHoles result;
  result.pockets = rounding.findPockets();
  if (!rounding.move(execution) && !execution.cancelled()) rounding.jump();
  result.image = rounding.image();
  result.folded = countFlippedFaces(result.image, surface.mesh().faces());
  result.loops.resize(1);
  for (std::size_t k = 0, hole = 0; k < surface.loops().size(); ++k) {
    LoopOnCircle loop;
    for (const int v : surface.loops()[k]) {
      if (!rounding.inPocket(v)) loop.vertices.push_back(v);
    }
    if (static_cast<int>(k) == outer) {
      result.loops.front() = std::move(loop);
      continue;
    }
    loop.centre = circles[hole].centre;
    loop.share = shares[hole++];
    result.loops.push_back(std::move(loop));
  }
  return result;
}

}  // namespace authalic
