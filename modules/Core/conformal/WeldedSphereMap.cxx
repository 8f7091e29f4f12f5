#include "Core/conformal/WeldedSphereMap.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/conformal/SphereNormalisation.h"
#include "Core/conformal/UnfoldOnSphere.h"
#include "Core/conformal/WeldedHalves.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/LaplacianEigenfunctions.h"
#include "Core/geometry/SphericalAreas.h"

namespace authalic {
namespace {

/// Vertices at the ends of edges without length, a thousandth of the way towards the mean of their neighbours, until
/// every edge has length; returns how many were moved.
int separateCoincidentVertices(const Faces& faces, Points3& points) {
  std::vector<char> moved(static_cast<std::size_t>(points.rows()), 0);
  for (int pass = 0; pass < 20; ++pass) {
    std::vector<char> coincident(moved.size(), 0);
    Points3 sum = Points3::Zero(points.rows(), 3);
    Eigen::VectorXd count = Eigen::VectorXd::Zero(points.rows());
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int a = faces(f, k), b = faces(f, (k + 1) % 3);
        sum.row(a) += points.row(b);
        count[a] += 1;
        if (points.row(a) != points.row(b)) continue;
        coincident[static_cast<std::size_t>(a)] = coincident[static_cast<std::size_t>(b)] = 1;
      }
    }
    if (std::find(coincident.begin(), coincident.end(), 1) == coincident.end()) break;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      if (!coincident[static_cast<std::size_t>(i)]) continue;
      points.row(i) += 1e-3 * (sum.row(i) / count[i] - points.row(i));
      moved[static_cast<std::size_t>(i)] = 1;
    }
  }
  return static_cast<int>(std::count(moved.begin(), moved.end(), 1));
}

LevelSetCutResult cutAtFirstEigenfunction(const SphereMesh& sphere, const WeldedSphereMapOptions& options,
                                          const Execution& execution, WeldedSphereMapResult& result) {
  LaplacianEigenfunctionsOptions eigen;
  eigen.tolerance = options.eigenTolerance;
  eigen.solver = options.riemann.flow.solver;
  const LaplacianEigenfunctionsResult first = laplacianEigenfunctions(sphere.mesh(), eigen, execution.part(0, 0.8));
  LevelSetCutResult cut = levelSetCut(sphere, first.functions.col(0), options.cut, execution.part(0.8, 1));
  result.eigenvalue = first.values[0];
  result.seamPoints = static_cast<int>(cut.seam.size());
  result.seamLength = cut.seamLength;
  result.mergedPieces = cut.mergedPieces;
  return cut;
}

Points2 mapHalf(const CutHalf& half, const RiemannMapOptions& options, const Execution& execution,
                WeldedSphereMapResult& result, WeldedHalfReport& report) {
  RiemannMapResult map = riemannMap(half.disk, options, execution);
  execution.throwIfCancelled();
  report = {half.area, half.disk.mesh().vertexCount(), map.status, map.iterations, map.residual, map.flippedFaces};
  for (const YamabeIteration& iteration : map.history) result.history.push_back(iteration.residual);
  result.iterations += map.iterations;
  result.residual = std::max(result.residual, map.residual);
  if (result.status == Status::NotRun || map.status != Status::Converged) result.status = map.status;
  return std::move(map.image);
}

}  // namespace

void WeldedSphereMapOptions::validate() const {
  cut.validate();
  riemann.flow.validate();
  if (!(eigenTolerance > 0)) {
    throw InvalidArgument("A positive tolerance for the eigenfunction is required, but it is " +
                          std::to_string(eigenTolerance) + ".");
  }
}

WeldedSphereMapResult weldedSphereMap(const SphereMesh& sphere, const WeldedSphereMapOptions& options,
                                      const Execution& execution) {
  options.validate();
  const auto start = std::chrono::steady_clock::now();
  WeldedSphereMapResult result;
  const Faces& faces = sphere.mesh().faces();
  result.degenerateFaces = static_cast<int>((faceAreas(sphere.mesh()).array() <= 0).count());
  Points3 points = sphere.mesh().points();
  result.separatedVertices = separateCoincidentVertices(faces, points);
  const SphereMesh separated = result.separatedVertices > 0 ? SphereMesh(TriangleMesh(points, faces)) : sphere;
  const LevelSetCutResult cut = cutAtFirstEigenfunction(separated, options, execution.part(0, 0.2), result);
  const Points2 above = mapHalf(cut.above, options.riemann, execution.part(0.2, 0.5), result, result.halves[0]);
  const Points2 below = mapHalf(cut.below, options.riemann, execution.part(0.5, 0.8), result, result.halves[1]);
  const WeldedHalves welded = weldHalves(cut, above, below, execution.part(0.8, 0.95));
  execution.throwIfCancelled();
  result.accuracy = welded.welding.accuracy(execution);
  SphereNormalisationOptions centring;
  centring.rotation = SphereRotation::None;
  SphereNormalisation centred = normaliseSphere(sphere.mesh(), welded.image, centring);
  result.image = std::move(centred.image);
  result.centreOfMass = centred.residual;
  result.flippedBeforeUnfolding = result.flippedFaces = countFlippedOnSphere(result.image, faces);
  if (options.unfold && result.flippedFaces > 0) {
    SphereUnfolding unfolded = unfoldOnSphere(separated, std::move(result.image));
    result.image = std::move(unfolded.image);
    result.unfoldedVertices = unfolded.movedVertices;
    result.flippedFaces = unfolded.flippedFaces;
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.report(1, "welding");
  return result;
}

}  // namespace authalic
