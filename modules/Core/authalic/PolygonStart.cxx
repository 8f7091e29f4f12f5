#include "Core/authalic/PolygonStart.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/PolygonMesh.h"
#include "Core/initial/BarycentricSystem.h"
#include "Core/initial/Untangle.h"

namespace authalic {
namespace {

constexpr double kWithinSight = 0.1;  // mean |ln r| of the stars of both balanced maps
constexpr double kSmallest = 0.05;    // of the target of a face: smaller ones are opened
constexpr int kFewestFaces = 4000, kMostFaces = 60000;  // of the polygon

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Length of the polygon's boundary up to each entry of the placement that is not in a pocket; the last one:
// all of it.
std::vector<double> lengthsAlong(const Points2& boundary) {
  std::vector<double> length{0};
  for (Eigen::Index i = 0; i < boundary.rows(); ++i) {
    length.push_back(length.back() + (boundary.row((i + 1) % boundary.rows()) - boundary.row(i)).norm());
  }
  return length;
}

Eigen::RowVector2d onCircle(double turns) { return {std::cos(2 * M_PI * turns), std::sin(2 * M_PI * turns)}; }

// The boundary of the placement without its pockets, and for every entry of the placement its place on the circle.
struct Outline {
  Points2 points;
  std::vector<int> corners;
  Points2 circle;        // of `points`
  Points2 circleOfAll;   // of the placement's entries; pockets between the ends of their chords

  explicit Outline(const BoundaryPlacement& placement) {
    std::vector<int> kept;
    for (int i = 0; i < static_cast<int>(placement.vertices.size()); ++i) {
      if (placement.role[at(i)] == BoundaryRole::Pocket) continue;
      if (placement.role[at(i)] == BoundaryRole::Corner) corners.push_back(static_cast<int>(kept.size()));
      kept.push_back(i);
    }
    points = placement.points(kept, Eigen::all);
    const std::vector<double> length = lengthsAlong(points);
    circle.resize(points.rows(), 2);
    circleOfAll.resize(static_cast<Eigen::Index>(placement.vertices.size()), 2);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const int past = k + 1 < kept.size() ? kept[k + 1] : static_cast<int>(placement.vertices.size());
      for (int i = kept[k]; i < past; ++i) {
        const double t = double(i - kept[k]) / (past - kept[k]);
        circleOfAll.row(i) = onCircle(((1 - t) * length[k] + t * length[k + 1]) / length.back());
      }
      circle.row(static_cast<Eigen::Index>(k)) = circleOfAll.row(kept[k]);
    }
  }
};

DiskMesh inSpace(const PolygonMesh& mesh) {
  Points3 points = Points3::Zero(mesh.points.rows(), 3);
  points.leftCols<2>() = mesh.points;
  return DiskMesh(TriangleMesh(std::move(points), mesh.faces));
}

// Finds points in a planar triangulation by walking towards them.
class Locator {
 public:
  Locator(const SurfaceTopology& topology, const Points2& points) : topology_(topology), points_(points) {}

  /// Face (and barycentric coordinates) with the point in it, or the nearest one that the walk has met.
  int find(const Eigen::RowVector2d& p, Eigen::RowVector3d& where) {
    const int faceCount = static_cast<int>(topology_.faces().rows());
    for (int step = 0; step < 4 * faceCount; ++step) {
      where = coordinates(face_, p);
      Eigen::Index worst = 0;
      if (where.minCoeff(&worst) >= -1e-12) break;
      int across = topology_.opposite(3 * face_ + static_cast<int>((worst + 1) % 3));
      for (Eigen::Index k = 1; k < 3 && across < 0; ++k) {  // at the boundary: another way that leads nearer
        if (where[(worst + k) % 3] < 0) across = topology_.opposite(3 * face_ + static_cast<int>((worst + k + 1) % 3));
      }
      if (across < 0) break;
      face_ = across / 3;
    }
    where = where.cwiseMax(0);
    where /= where.sum();
    return face_;
  }

 private:
  [[nodiscard]] Eigen::RowVector3d coordinates(int face, const Eigen::RowVector2d& p) const {
    const auto corner = [&](int k) { return Eigen::RowVector2d(points_.row(topology_.faces()(face, k))); };
    const auto cross = [](const Eigen::RowVector2d& u, const Eigen::RowVector2d& v) {
      return u[0] * v[1] - u[1] * v[0];
    };
    const Eigen::RowVector2d a = corner(0), b = corner(1), c = corner(2);
    const Eigen::RowVector3d parts(cross(b - p, c - p), cross(c - p, a - p), cross(a - p, b - p));
    return parts / std::max(cross(b - a, c - a), 1e-300);
  }

  const SurfaceTopology& topology_;
  const Points2& points_;
  int face_ = 0;
};

// Vertices of pockets inside them: means of their neighbours.
void fillPockets(const DiskMesh& disk, const BoundaryPlacement& placement, SolverBackend backend, Points2& image) {
  std::vector<char> held(at(disk.mesh().vertexCount()), 1);
  bool any = false;
  for (std::size_t v = 0; v < held.size(); ++v) {
    if (placement.pocketOf[v] < 0 || disk.topology().onBoundary()[v]) continue;
    held[v] = 0;
    any = true;
  }
  if (!any) return;
  solveBarycentric(disk.mesh().faces(), HalfEdgeWeights::Constant(disk.mesh().faceCount(), 3, 1), held, backend, image);
}

}  // namespace

Points2 polygonStart(const DiskMesh& disk, const PlanarDomain& domain, const BoundaryPlacement& placement,
                     const TargetMeasure& target, SolverBackend backend, const Execution& execution) {
  const Outline outline(placement);
  const int faceCount = std::clamp(disk.mesh().faceCount(), kFewestFaces, kMostFaces);
  const PolygonMesh polygon = polygonMesh(outline.points, outline.corners, 1.5 * domain.area() / faceCount);
  const DiskMesh flat = inSpace(polygon);
  Points2 flatOnDisk = Points2::Zero(polygon.points.rows(), 2);
  flatOnDisk.topRows(polygon.boundarySize) = outline.circle;
  flatOnDisk = balancedStart(flat, flatOnDisk, TargetMeasure(flat.mesh()), backend, kWithinSight,
                             execution.part(0, 0.4));
  Points2 onDisk = Points2::Zero(disk.mesh().vertexCount(), 2);
  onDisk(placement.vertices, Eigen::all) = outline.circleOfAll;
  onDisk = balancedStart(disk, onDisk, target, backend, kWithinSight, execution.part(0.4, 0.9));
  Points2 image = onDisk;
  Locator locator(flat.topology(), flatOnDisk);
  Eigen::RowVector3d where;
  for (int v = 0; v < disk.mesh().vertexCount(); ++v) {
    const auto corners = flat.mesh().faces().row(locator.find(onDisk.row(v), where));
    image.row(v).setZero();
    for (int k = 0; k < 3; ++k) image.row(v) += where[k] * polygon.points.row(corners[k]);
  }
  image(placement.vertices, Eigen::all) = placement.points;
  fillPockets(disk, placement, backend, image);
  return untangle(disk.topology(), std::move(image), kSmallest * domain.area() * target.faces()).image;
}

}  // namespace authalic
