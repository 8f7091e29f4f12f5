#include "Core/authalic/ToroidalAuthalicMap.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "Core/authalic/AreaSolve.h"
#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/PeriodicAreas.h"
#include "Core/authalic/PeriodicStretch.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kWithinSight = 0.3;  // mean |ln r| of the stars, from where face steps converge

// An image of the vertices and the periods (columns) that its corners are displaced by.
struct PeriodicImage {
  Points2 points;
  Eigen::Matrix2d lattice;

  [[nodiscard]] Points2 shifts(const CutGraph& cut) const {
    return cut.windings.cast<double>() * lattice.transpose();
  }
  void transform(const Eigen::Matrix2d& linear) {
    points *= linear.transpose();
    lattice = linear * lattice;
  }
};

// The periods that make the Dirichlet energy least at area 1, the first one along +x.
void relaxLattice(const TriangleMesh& surface, const CutGraph& cut, PeriodicImage& image) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(periodicStretch(surface, image.points, image.shifts(cut)));
  const Eigen::Matrix2d relax = eigen.operatorInverseSqrt();
  image.transform(relax / std::sqrt(std::abs((relax * image.lattice).determinant())));
  const Eigen::Vector2d first = image.lattice.col(0).normalized();
  image.transform((Eigen::Matrix2d() << first[0], first[1], -first[1], first[0]).finished());
}

PeriodicImage makeStart(const TorusMesh& torus, CutGraph& cut, const TargetMeasure& target,
                        SolverBackend backend, const Execution& execution) {
  PeriodicImage image{Points2::Zero(torus.mesh().vertexCount(), 2), Eigen::Matrix2d::Identity()};
  const auto areas = [&] { return periodicFaceAreas(image.points, image.shifts(cut), torus.mesh().faces()); };
  // Whatever the points, the areas sum to ±1: the generators may be numbered so that the image is mirrored.
  if (areas().sum() < 0) cut.windings.col(1) *= -1;
  std::vector<char> held(static_cast<std::size_t>(torus.mesh().vertexCount()), 0);
  held[0] = 1;
  image.points = balancedPeriodicStart(torus.topology(), image.points, image.shifts(cut), held, target, backend,
                                       kWithinSight, execution);
  relaxLattice(torus.mesh(), cut, image);
  return image;
}

// The image of the cut's vertices.
Points2 openImage(const CutGraph& cut, const Faces& faces, const PeriodicImage& image) {
  const Points2 shifts = image.shifts(cut);
  Points2 open(static_cast<Eigen::Index>(cut.originalPointIds.size()), 2);
  for (Eigen::Index c = 0; c < cut.faces.size(); ++c) {
    open.row(cut.faces.data()[c]) = image.points.row(faces.data()[c]) + shifts.row(c);
  }
  return open;
}

// Largest difference of an edge of the cut as seen from its two sides.
double seamError(const SurfaceTopology& topology, const CutGraph& cut, const Points2& open) {
  double worst = 0;
  const auto vector = [&](int h) {
    const int next = SurfaceTopology::next(h);
    return Eigen::RowVector2d(open.row(cut.faces.data()[next]) - open.row(cut.faces.data()[h]));
  };
  for (int h = 0; h < static_cast<int>(cut.onCut.size()); ++h) {
    if (cut.onCut[static_cast<std::size_t>(h)]) {
      worst = std::max(worst, (vector(h) + vector(topology.opposite(h))).norm());
    }
  }
  return worst;
}

}  // namespace

ToroidalAuthalicMapResult toroidalAuthalicMap(const TorusMesh& torus, const TargetMeasure& target,
                                              const AuthalicMapOptions& options, const Execution& execution) {
  options.validate();
  requireTargetOf(torus.mesh(), target);
  const auto begun = std::chrono::steady_clock::now();
  const Faces& faces = torus.mesh().faces();
  ToroidalAuthalicMapResult result;
  result.cut = cutToFundamentalDomain(torus.mesh(), torus.topology());
  PeriodicImage image = makeStart(torus, result.cut, target, options.solver, execution.part(0, 0.3));
  const Points2 shifts = image.shifts(result.cut);
  std::vector<char> freedom(static_cast<std::size_t>(torus.mesh().vertexCount()), 2);
  freedom[0] = 0;
  const PeriodicAreas areas(faces, shifts, std::move(freedom));
  const double startSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  AreaSolveResult solved = solveAreas(areas, torus.mesh(), target, image.points, options, execution.part(0.3, 1));
  image.points = solved.image;
  relaxLattice(torus.mesh(), result.cut, image);
  result.image = openImage(result.cut, faces, image);
  result.seamError = seamError(torus.topology(), result.cut, result.image);
  result.points = std::move(image.points);
  result.lattice = image.lattice;
  static_cast<AuthalicSolution&>(result) = std::move(solved);
  result.startSeconds = startSeconds;
  result.flippedFaces = countFlippedFaces(result.image, result.cut.faces);
  execution.report(1, "Authalic map");
  return result;
}

}  // namespace authalic
