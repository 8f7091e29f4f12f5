#include "Core/authalic/FlatConeAuthalicMap.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "Core/authalic/AreaSolve.h"
#include "Core/authalic/FoldRemoval.h"
#include "Core/authalic/HolonomyFit.h"
#include "Core/authalic/NarrowFaces.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr int kMostFits = 12;
constexpr double kLeastWeight = 1e-2, kMostWeight = 1e2;

// ½(cot α + cot β), but positive: near the conformal layout, so that edges beside cones do not bend around them, as
// they would with equal weights.
HalfEdgeWeights positiveWeights(const HighGenusMesh& surface) {
  HalfEdgeWeights weights = cotangentWeights(surface.mesh());
  for (int h = 0; h < 3 * surface.mesh().faceCount(); ++h) {
    const int g = surface.topology().opposite(h);
    if (g < h) continue;
    double &one = weights.data()[h], &other = weights.data()[g];
    one = other = std::clamp(0.5 * (one + other), kLeastWeight, kMostWeight);
  }
  return weights;
}

Points2 makeStart(const HighGenusMesh& surface, const SeamedAreas& areas, const TargetMeasure& target,
                  SolverBackend backend, const FlatConeSurface& flat, HolonomyFit& fit, const Execution& execution) {
  const Points3& points = surface.mesh().points();
  Coordinates image = flat.places;
  if (removeFolds(areas, target, points, backend, image, execution.part(0, 0.2)) > 0) return image;
  openNarrowFaces(areas, target, points, backend, image, {}, execution.part(0.2, 0.4));
  for (int step = 0; step < kMostFits && !execution.cancelled() && fit.relax(image); ++step) {
    execution.report(0.4 + 0.3 * step / kMostFits, "Fitting the flat surface");
  }
  openNarrowFaces(areas, target, points, backend, image, {}, execution.part(0.7, 1));
  return image;
}

// Parameters of the holonomy in the last rows, see SeamedAreas.
Coordinates withParameters(const Points2& places, const FlatConeSurface& flat) {
  Coordinates image(places.rows() + flat.translations.size(), 2);
  image.topRows(places.rows()) = places;
  image.bottomRows(flat.translations.size()) << flat.translations.real(), flat.translations.imag();
  return image;
}

void takeImage(const SurfaceTopology& topology, const Coordinates& image, FlatConeSurface& flat) {
  const auto rows = image.bottomRows(flat.translations.size());
  flat.translations.real() = rows.col(0);
  flat.translations.imag() = rows.col(1);
  flat.places = image.topRows(flat.places.rows());
  setMotions(flat, flat.holonomy.motions(topology, flat.cut, flat.translations));
}

// Half of the iterations keep shapes; where they do not suffice, areas alone have the rest.
AreaSolveResult solve(const SeamedAreas& areas, const HighGenusMesh& surface, const TargetMeasure& target,
                      const Coordinates& start, AuthalicMapOptions options, const Execution& execution) {
  AnalysedSystems systems(execution.threads());
  const int all = options.maxIterations;
  options.maxIterations = (all + 1) / 2;
  AreaSolveResult solved = solveAreas(areas, surface.mesh(), target, start, options, execution.part(0, 0.6),
                                      Shapes::Kept, &systems);
  options.maxIterations = all - solved.iterations;
  if (solved.status == Status::Converged || solved.status == Status::Cancelled || options.maxIterations == 0 ||
      !(areas.areas(start).minCoeff() > 0)) {
    return solved;
  }
  AreaSolveResult second = solveAreas(areas, surface.mesh(), target, solved.image, options, execution.part(0.6, 1),
                                      Shapes::Free, &systems);
  const bool cancelled = second.status == Status::Cancelled;
  AreaSolveResult& better = giveBetterTheEffortOfBoth(solved, second) ? second : solved;
  if (cancelled) better.status = Status::Cancelled;
  return std::move(better);
}

// To an image of area 1.
void normalise(const SurfaceTopology& topology, const SeamedAreas& areas, FlatConeSurface& flat) {
  const double scale = 1 / std::sqrt(areas.areas(flat.places).sum());
  flat.places *= scale;
  flat.translations *= scale;
  setMotions(flat, flat.holonomy.motions(topology, flat.cut, flat.translations));
}

void describe(const HighGenusMesh& surface, FlatConeAuthalicMapResult& result) {
  const Faces& faces = surface.mesh().faces();
  result.image = openImage(result.flat, faces, result.flat.places);
  result.seams = coneSeams(surface.topology(), result.flat, result.image);
  for (const ConeSeam& seam : result.seams) result.seamError = std::max(result.seamError, seam.error);
  Eigen::VectorXd wrong = angleSums(faces, result.flat.cut, result.image).array() - 2 * M_PI;
  for (std::size_t i = 0; i < result.flat.cones.size(); ++i) wrong[result.flat.cones[i]] += result.flat.curvature[i];
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
  HolonomyFit fit(surface.topology(), areas, target, result.flat, positiveWeights(surface), options.solver);
  const Points2 start = makeStart(surface, areas, target, options.solver, result.flat, fit, execution.part(0.2, 0.4));
  const double startSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  const SeamedAreas free(surface.mesh().faces(), result.flat, cornerMoves(surface.topology(), result.flat));
  AreaSolveResult solved =
      solve(free, surface, target, withParameters(start, result.flat), options, execution.part(0.4, 1));
  takeImage(surface.topology(), solved.image, result.flat);
  static_cast<AuthalicSolution&>(result) = std::move(solved);
  result.startSeconds = startSeconds;
  normalise(surface.topology(), areas, result.flat);
  describe(surface, result);
  execution.report(1, "Authalic map");
  return result;
}

}  // namespace authalic
