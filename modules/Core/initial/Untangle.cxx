#include "Core/initial/Untangle.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <utility>

#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr int kPasses = 16, kRings = 8;
constexpr std::size_t kMostFaces = 16;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Twice the area of a face, or its height, as a function of one corner x: (x, y, 1)·row.
using Star = std::vector<Eigen::RowVector3d>;

double smallest(const Star& star, const Eigen::RowVector2d& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& face : star) least = std::min(least, face[0] * x[0] + face[1] * x[1] + face[2]);
  return least;
}

// The vertex of the linear program: three of the numbers are equal there, and the others larger.
Eigen::RowVector2d largestSmallest(const Star& star, const Eigen::RowVector2d& start) {
  Eigen::RowVector2d best = start;
  double most = smallest(star, start);
  for (std::size_t i = 0; i < star.size(); ++i) {
    for (std::size_t j = i + 1; j < star.size(); ++j) {
      for (std::size_t k = j + 1; k < star.size(); ++k) {
        Eigen::Matrix2d system;
        system << (star[i] - star[j]).head<2>(), (star[i] - star[k]).head<2>();
        const Eigen::Vector2d right(star[j][2] - star[i][2], star[k][2] - star[i][2]);
        if (std::abs(system.determinant()) < 1e-14 * system.squaredNorm()) continue;
        const Eigen::RowVector2d x = (system.inverse() * right).transpose();
        const double least = smallest(star, x);
        if (least > most) best = x, most = least;
      }
    }
  }
  return best;
}

class Untangling {
 public:
  Untangling(const SurfaceTopology& topology, Points2 image, const Eigen::VectorXd& least)
      : topology_(topology), faces_(topology.faces()),
        least_(least.size() > 0 ? least : Eigen::VectorXd::Zero(faces_.rows())), facesOf_(at(topology.vertexCount())) {
    result_.image = std::move(image);
    for (int f = 0; f < static_cast<int>(faces_.rows()); ++f) {
      for (int k = 0; k < 3; ++k) facesOf_[at(faces_(f, k))].push_back(f);
    }
  }

  UnfoldResult run() {
    for (int rings = 0; rings <= kRings; ++rings) {
      for (int pass = 0; pass < kPasses; ++pass) {
        const Eigen::Array<bool, Eigen::Dynamic, 1> small =
            !(signedFaceAreas(result_.image, faces_).array() > least_.array());
        if (!small.any()) break;
        const std::vector<char> marked = near(small, rings);
        for (int v = 0; v < topology_.vertexCount(); ++v) {
          if (marked[at(v)] && !topology_.onBoundary()[at(v)]) move(v);
        }
        ++result_.rounds;
      }
    }
    result_.flippedFaces = countFlippedFaces(result_.image, faces_);
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::vector<char> near(const Eigen::Array<bool, Eigen::Dynamic, 1>& small, int rings) const {
    std::vector<char> marked(at(topology_.vertexCount()), 0);
    for (Eigen::Index f = 0; f < faces_.rows(); ++f) {
      for (int k = 0; k < 3 && small[f]; ++k) marked[at(faces_(f, k))] = 1;
    }
    for (int ring = 0; ring < rings; ++ring) {
      const std::vector<char> before = marked;
      for (int v = 0; v < topology_.vertexCount(); ++v) {
        if (!before[at(v)]) continue;
        for (const int f : facesOf_[at(v)]) {
          for (int k = 0; k < 3; ++k) marked[at(faces_(f, k))] = 1;
        }
      }
    }
    return marked;
  }

  void move(int v) {
    if (facesOf_[at(v)].size() > kMostFaces) return;
    Star star;
    for (const int f : facesOf_[at(v)]) {
      const int k = faces_(f, 0) == v ? 0 : faces_(f, 1) == v ? 1 : 2;
      const Eigen::RowVector2d p = result_.image.row(faces_(f, (k + 1) % 3)),
                               q = result_.image.row(faces_(f, (k + 2) % 3));
      star.emplace_back(p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]);
    }
    Star heights = star;
    for (auto& height : heights) height /= std::max(height.head<2>().norm(), 1e-300);
    Eigen::RowVector2d place = largestSmallest(heights, result_.image.row(v));
    if (!(smallest(star, place) > 0)) place = largestSmallest(star, result_.image.row(v));
    result_.movedVertices += place != result_.image.row(v);
    result_.image.row(v) = place;
  }

  const SurfaceTopology& topology_;
  const Faces& faces_;
  Eigen::VectorXd least_;
  std::vector<std::vector<int>> facesOf_;
  UnfoldResult result_;
};

}  // namespace

UnfoldResult untangle(const SurfaceTopology& topology, Points2 image, const Eigen::VectorXd& least) {
  return Untangling(topology, std::move(image), least).run();
}

UnfoldResult unfoldOrUntangle(const SurfaceTopology& topology, const Points2& image) {
  UnfoldResult unfolded = unfold(topology, image, {}, UnfoldReach::Patches);
  return unfolded.flippedFaces == 0 ? unfolded : untangle(topology, image);
}

}  // namespace authalic
