#include "Core/initial/Untangle.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <utility>

#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"

namespace authalic {
namespace {

constexpr int kPasses = 16, kRings = 8;
constexpr std::size_t kMostFaces = 16;
constexpr double kLowestHeight = 0.05;  // of a star above the plane through the centre of the sphere

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

// What is folded, and how a star is seen, in the plane.
class Plane {
 public:
  using Image = Points2;

  explicit Plane(const Eigen::VectorXd& least) : least_(least) {}

  [[nodiscard]] Eigen::VectorXd areas(const Points2& image, const Faces& faces) const {
    const Eigen::VectorXd areas = signedFaceAreas(image, faces);
    return least_.size() > 0 ? Eigen::VectorXd(areas - least_) : areas;
  }
  // Prepares for a star; false where it cannot be seen.
  [[nodiscard]] bool lookAt(const Points2&, int, const std::vector<int>&) { return true; }
  [[nodiscard]] static Eigen::RowVector2d seen(const Eigen::RowVector2d& p) { return p; }
  [[nodiscard]] static Eigen::RowVector2d back(const Eigen::RowVector2d& p) { return p; }

 private:
  const Eigen::VectorXd& least_;
};

// The same on the unit sphere.
class Sphere {
 public:
  using Image = Points3;

  [[nodiscard]] static Eigen::VectorXd areas(const Points3& image, const Faces& faces) {
    Eigen::VectorXd result(faces.rows());
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      result[f] = signedDeterminant(image.row(faces(f, 0)), image.row(faces(f, 1)), image.row(faces(f, 2)));
    }
    return result;
  }
  [[nodiscard]] bool lookAt(const Points3& image, int v, const std::vector<int>& around) {
    Eigen::Vector3d middle = image.row(v).transpose();
    for (const int w : around) middle += image.row(w).transpose();
    const Eigen::Vector3d z = middle.normalized(), x = z.unitOrthogonal();
    frame_ << x.transpose(), z.cross(x).transpose(), z.transpose();
    const auto inSight = [&](int w) { return image.row(w).dot(frame_.row(2)) > kLowestHeight; };
    return inSight(v) && std::all_of(around.begin(), around.end(), inSight);
  }
  [[nodiscard]] Eigen::RowVector2d seen(const Eigen::RowVector3d& p) const {
    const Eigen::Vector3d q = frame_ * p.transpose();
    return {q[0] / q[2], q[1] / q[2]};
  }
  [[nodiscard]] Eigen::RowVector3d back(const Eigen::RowVector2d& p) const {
    return (Eigen::RowVector3d(p[0], p[1], 1) * frame_).normalized();
  }

 private:
  Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
};

template <class Domain>
class Untangling {
 public:
  using Image = typename Domain::Image;

  Untangling(const SurfaceTopology& topology, Domain domain, Image image)
      : topology_(topology), faces_(topology.faces()), domain_(std::move(domain)), image_(std::move(image)),
        facesOf_(at(topology.vertexCount())) {
    for (int f = 0; f < static_cast<int>(faces_.rows()); ++f) {
      for (int k = 0; k < 3; ++k) facesOf_[at(faces_(f, k))].push_back(f);
    }
  }

  void run() {
    for (int rings = 0; rings <= kRings; ++rings) {
      for (int pass = 0; pass < kPasses; ++pass) {
        const Eigen::Array<bool, Eigen::Dynamic, 1> small = !(domain_.areas(image_, faces_).array() > 0);
        if (!small.any()) break;
        const std::vector<char> marked = near(small, rings);
        for (int v = 0; v < topology_.vertexCount(); ++v) {
          if (marked[at(v)] && !topology_.onBoundary()[at(v)]) move(v);
        }
        ++rounds_;
      }
    }
  }

  [[nodiscard]] Image& image() noexcept { return image_; }
  [[nodiscard]] int rounds() const noexcept { return rounds_; }
  [[nodiscard]] int movedVertices() const noexcept { return movedVertices_; }

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
    std::vector<int> around;
    for (const int f : facesOf_[at(v)]) {
      const int k = faces_(f, 0) == v ? 0 : faces_(f, 1) == v ? 1 : 2;
      around.push_back(faces_(f, (k + 1) % 3));
      around.push_back(faces_(f, (k + 2) % 3));
    }
    if (!domain_.lookAt(image_, v, around)) return;
    Star star;
    for (std::size_t i = 0; i < around.size(); i += 2) {
      const Eigen::RowVector2d p = domain_.seen(image_.row(around[i])), q = domain_.seen(image_.row(around[i + 1]));
      star.emplace_back(p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]);
    }
    Star heights = star;
    for (auto& height : heights) height /= std::max(height.template head<2>().norm(), 1e-300);
    const Eigen::RowVector2d start = domain_.seen(image_.row(v));
    Eigen::RowVector2d place = largestSmallest(heights, start);
    if (!(smallest(star, place) > 0)) place = largestSmallest(star, start);
    if (place == start) return;
    ++movedVertices_;
    image_.row(v) = domain_.back(place);
  }

  const SurfaceTopology& topology_;
  const Faces& faces_;
  Domain domain_;
  Image image_;
  std::vector<std::vector<int>> facesOf_;
  int rounds_ = 0, movedVertices_ = 0;
};

}  // namespace

UnfoldResult untangle(const SurfaceTopology& topology, Points2 image, const Eigen::VectorXd& least) {
  Untangling<Plane> untangling(topology, Plane(least), std::move(image));
  untangling.run();
  UnfoldResult result{std::move(untangling.image()), untangling.rounds(), untangling.movedVertices(), 0};
  result.flippedFaces = countFlippedFaces(result.image, topology.faces());
  return result;
}

Points3 untangleOnSphere(const SurfaceTopology& topology, Points3 image) {
  Untangling<Sphere> untangling(topology, Sphere(), std::move(image));
  untangling.run();
  return std::move(untangling.image());
}

UnfoldResult unfoldOrUntangle(const SurfaceTopology& topology, const Points2& image) {
  UnfoldResult unfolded = unfold(topology, image, {}, UnfoldReach::Patches);
  return unfolded.flippedFaces == 0 ? unfolded : untangle(topology, image);
}

}  // namespace authalic
