#include "Core/conformal/UnfoldOnSphere.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/initial/BarycentricSystem.h"
#include "Core/initial/Untangle.h"

namespace authalic {
namespace {

constexpr int kMostRings = 32;
constexpr double kFewFolds = 0.1;      // of the faces: an image turned inside out is not untangled
constexpr double kLowestHeight = 0.1;  // of the patch above the plane through the centre of the sphere

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool folded(const Points3& image, const Faces& faces, Eigen::Index f) {
  return !(signedDeterminant(image.row(faces(f, 0)), image.row(faces(f, 1)), image.row(faces(f, 2))) > 0);
}

std::vector<char> verticesNearFolds(const Points3& image, const Faces& faces, int rings) {
  std::vector<char> marked(at(static_cast<int>(image.rows())), 0);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    if (!folded(image, faces, f)) continue;
    for (int k = 0; k < 3; ++k) marked[at(faces(f, k))] = 1;
  }
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<char> next = marked;
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      if (!marked[at(faces(f, 0))] && !marked[at(faces(f, 1))] && !marked[at(faces(f, 2))]) continue;
      for (int k = 0; k < 3; ++k) next[at(faces(f, k))] = 1;
    }
    marked.swap(next);
  }
  return marked;
}

// The faces that have a marked corner, in groups that share no marked vertex.
std::vector<std::vector<int>> patchesOf(const SphereMesh& sphere, const std::vector<char>& marked) {
  const SurfaceTopology& topology = sphere.topology();
  const Faces& faces = topology.faces();
  std::vector<char> seen(at(static_cast<int>(faces.rows())), 0);
  std::vector<std::vector<int>> patches;
  for (int first = 0; first < static_cast<int>(faces.rows()); ++first) {
    const auto touches = [&](int f) {
      return marked[at(faces(f, 0))] || marked[at(faces(f, 1))] || marked[at(faces(f, 2))];
    };
    if (seen[at(first)] || !touches(first)) continue;
    std::vector<int> patch{first};
    seen[at(first)] = 1;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      for (int k = 0; k < 3; ++k) {
        const int h = 3 * patch[next] + k, other = topology.opposite(h) / 3;
        // Across an edge with a marked end the same patch goes on.
        if (seen[at(other)] || !(marked[at(topology.tail(h))] || marked[at(topology.head(h))])) continue;
        seen[at(other)] = 1;
        patch.push_back(other);
      }
    }
    std::sort(patch.begin(), patch.end());
    patches.push_back(std::move(patch));
  }
  return patches;
}

// One patch, flattened.
class Patch {
 public:
  Patch(const SphereMesh& sphere, const Points3& image, const std::vector<int>& patchFaces,
        const std::vector<char>& marked)
      : faces_(static_cast<Eigen::Index>(patchFaces.size()), 3) {
    const Faces& all = sphere.mesh().faces();
    for (const int f : patchFaces) {
      for (int k = 0; k < 3; ++k) vertices_.push_back(all(f, k));
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    Points3 surface(static_cast<Eigen::Index>(vertices_.size()), 3);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      surface.row(static_cast<Eigen::Index>(i)) = sphere.mesh().points().row(vertices_[i]);
      held_.push_back(!marked[at(vertices_[i])]);
    }
    for (std::size_t f = 0; f < patchFaces.size(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const auto place = std::lower_bound(vertices_.begin(), vertices_.end(), all(patchFaces[f], k));
        faces_(static_cast<Eigen::Index>(f), k) = static_cast<int>(place - vertices_.begin());
      }
    }
    weights_ = meanValueWeights(TriangleMesh(std::move(surface), faces_));
    flatten(image);
  }

  [[nodiscard]] bool fits() const { return fits_; }
  [[nodiscard]] int folds() const { return countFlippedFaces(plane_, faces_); }

  // Moves the vertices that are not held; keeps their places where nothing is gained. @return whether they moved
  bool embed() {
    const int before = folds();
    const Points2 old = plane_;
    const HalfEdgeWeights ones = HalfEdgeWeights::Constant(faces_.rows(), 3, 1);
    const MeanValueWeights equal{ones, ones};
    Points2 best = old;
    int fewest = before;
    for (const MeanValueWeights& weights : {weights_, meanValueWeights(old, faces_), equal}) {
      plane_ = old;
      try {
        solveBarycentric(faces_, weights, held_, SolverBackend::Automatic, plane_);
      } catch (const SolverError&) {
        continue;
      }
      if (folds() >= fewest) continue;
      fewest = folds();
      best = plane_;
      if (fewest == 0) break;
    }
    plane_ = best;
    return fewest < before;
  }

  void store(Points3& image) const {
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (held_[i]) continue;
      const Eigen::RowVector2d p = plane_.row(static_cast<Eigen::Index>(i));
      image.row(vertices_[i]) = (Eigen::RowVector3d(p[0], p[1], 1) * frame_).normalized();
    }
  }

 private:
  // Gnomonic projection from the middle of the patch; the rows of frame_ are its axes, the third one outwards.
  void flatten(const Points3& image) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int v : vertices_) middle += image.row(v).transpose();
    const Eigen::Vector3d z = middle.normalized(), x = z.unitOrthogonal();
    frame_ << x.transpose(), z.cross(x).transpose(), z.transpose();
    plane_.resize(static_cast<Eigen::Index>(vertices_.size()), 2);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Eigen::Vector3d p = frame_ * image.row(vertices_[i]).transpose();
      fits_ = fits_ && p[2] > kLowestHeight;
      plane_.row(static_cast<Eigen::Index>(i)) << p[0] / p[2], p[1] / p[2];
    }
  }

  std::vector<int> vertices_;
  Faces faces_;
  std::vector<char> held_;
  MeanValueWeights weights_;
  Eigen::Matrix3d frame_;
  Points2 plane_;
  bool fits_ = true;
};

}  // namespace

SphereUnfolding unfoldOnSphere(const SphereMesh& sphere, Points3 image) {
  if (image.rows() != sphere.mesh().vertexCount()) {
    throw GeometryError("One image point per vertex is required: the surface has " +
                        std::to_string(sphere.mesh().vertexCount()) + " vertices, the image " +
                        std::to_string(image.rows()) + " points.");
  }
  requireOnUnitSphere(image);
  const Faces& faces = sphere.mesh().faces();
  const Points3 before = image;
  SphereUnfolding result{std::move(image), 0, 0, 0};
  result.flippedFaces = countFlippedOnSphere(result.image, faces);
  for (int rings = 1; rings <= kMostRings && result.flippedFaces > 0; rings += (rings + 1) / 2) {
    ++result.rounds;
    const std::vector<char> marked = verticesNearFolds(result.image, faces, rings);
    for (const std::vector<int>& patchFaces : patchesOf(sphere, marked)) {
      Patch patch(sphere, result.image, patchFaces, marked);
      if (patch.fits() && patch.folds() > 0 && patch.embed()) patch.store(result.image);
    }
    result.flippedFaces = countFlippedOnSphere(result.image, faces);
  }
  if (result.flippedFaces > 0 && result.flippedFaces <= kFewFolds * sphere.mesh().faceCount()) {
    Points3 untangled = untangleOnSphere(sphere.topology(), result.image);
    const int left = countFlippedOnSphere(untangled, faces);
    if (left < result.flippedFaces) {
      result.image = std::move(untangled);
      result.flippedFaces = left;
    }
  }
  for (Eigen::Index v = 0; v < before.rows(); ++v) result.movedVertices += result.image.row(v) != before.row(v);
  return result;
}

}  // namespace authalic
