#include "Core/authalic/FlatConeAuthalicMap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "Core/authalic/AreaSolve.h"
#include "Core/authalic/BalancedStart.h"
#include "Core/authalic/SeamedBarycentricSystem.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kWithinSight = 0.3;  // mean |ln r| of the stars, from where face steps converge

Points2 makeStart(const HighGenusMesh& surface, const FlatConeSurface& flat, const SeamedAreas& areas,
                  const TargetMeasure& target, SolverBackend backend, const Execution& execution) {
  SeamedBarycentricSystem system(areas, backend);
  const BarycentricImage map{
      [&system](const HalfEdgeWeights& weights, Points2& image) { system.solve(weights, image); },
      [&areas](const Points2& image) { return areas.areas(image); }};
  return balancedStart(surface.topology(), map, flat.places, target, kWithinSight, execution);
}

void describe(const HighGenusMesh& surface, FlatConeAuthalicMapResult& result) {
  const Faces& faces = surface.mesh().faces();
  result.image = openImage(result.flat, faces, result.flat.places);
  result.seams = coneSeams(surface.topology(), result.flat, result.image);
  for (const ConeSeam& seam : result.seams) result.seamError = std::max(result.seamError, seam.error);
  Eigen::VectorXd wrong = angleSums(faces, result.flat.cut, result.image).array() - 2 * M_PI;
  for (const int v : result.flat.cones) wrong[v] += result.flat.curvature;
  result.angleError = wrong.cwiseAbs().maxCoeff();
  result.flippedFaces = countFlippedFaces(result.image, result.flat.cut.faces);
}

}  // namespace

FlatConeAuthalicMapResult flatConeAuthalicMap(const HighGenusMesh& surface, const TargetMeasure& target,
                                              const AuthalicMapOptions& options, const Execution& execution) {
  options.validate();
  requireTargetOf(surface.mesh(), target);
  const auto begun = std::chrono::steady_clock::now();
  FlatConeAuthalicMapResult result;
  result.flat = flatConeSurface(surface, options.solver, execution.part(0, 0.2));
  const SeamedAreas areas(surface.mesh().faces(), result.flat);
  const Points2 start = makeStart(surface, result.flat, areas, target, options.solver, execution.part(0.2, 0.4));
  const double startSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  AreaSolveResult solved = solveAreas(areas, target, start, options, execution.part(0.4, 1));
  result.flat.places = solved.image;
  static_cast<AuthalicSolution&>(result) = std::move(solved);
  result.startSeconds = startSeconds;
  describe(surface, result);
  execution.report(1, "Authalic map");
  return result;
}

}  // namespace authalic
