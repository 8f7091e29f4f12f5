#include "Core/authalic/SphericalAuthalicMap.h"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "Core/authalic/AreaSolve.h"
#include "Core/authalic/SolidAngles.h"
#include "Core/authalic/TwoCapsStart.h"
#include "Core/base/Error.h"
#include "Core/conformal/SphereNormalisation.h"
#include "Core/conformal/StereographicSphereMap.h"
#include "Core/conformal/UnfoldOnSphere.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"

namespace authalic {
namespace {

constexpr double kWithinSight = 0.3;  // mean |ln r| of the stars, from where face steps converge
constexpr double kUsable = 2;         // |ln r| of the stars of an initial map that is taken as it is

double farthestStar(const SphereMesh& sphere, const TargetMeasure& target, const Points3& image) {
  const Faces& faces = sphere.mesh().faces();
  const Eigen::VectorXd stars =
      vertexStars(signedSolidAngles(image, faces) / (4 * M_PI), faces, sphere.mesh().vertexCount());
  double farthest = 0;
  for (Eigen::Index v = 0; v < stars.size(); ++v) {
    farthest = std::max(farthest, std::abs(std::log(std::max(stars[v], 1e-300) / target.vertices()[v])));
  }
  return farthest;
}

Points3 makeStart(const SphereMesh& sphere, const TargetMeasure& target, const AuthalicMapOptions& options,
                  const Points3& initial, const Execution& execution) {
  Points3 guide = initial;
  if (initial.size() == 0) {
    StereographicSphereMapOptions stereographic;
    stereographic.solver = options.solver;
    stereographic.correctedShare = 0;
    guide = stereographicSphereMap(sphere, stereographic, execution.part(0, 0.3)).image;
  } else {
    guide = unfoldOnSphere(sphere, initial).image;
  }
  const int foldedGuide = countFlippedOnSphere(guide, sphere.mesh().faces());
  if (initial.size() > 0 && foldedGuide == 0 && farthestStar(sphere, target, guide) <= kUsable) return guide;
  Points3 start = twoCapsStart(sphere, guide, target, options.solver, kWithinSight, execution.part(0.3, 1));
  const int folded = countFlippedOnSphere(start, sphere.mesh().faces());
  if (folded == 0 || execution.cancelled()) return start;
  if (foldedGuide == 0) return guide;  // far from its targets, but a start
  throw GeometryError("A start without folded faces is required, but " + std::to_string(folded) +
                      " faces stay folded on the sphere; give an initial map without folds.");
}

}  // namespace

SphericalAuthalicMapResult sphericalAuthalicMap(const SphereMesh& sphere, const TargetMeasure& target,
                                                const AuthalicMapOptions& options, const Points3& initial,
                                                const Execution& execution, AnalysedSystems* systems) {
  options.validate();
  requireTargetOf(sphere.mesh(), target);
  const auto begun = std::chrono::steady_clock::now();
  Points3 start = makeStart(sphere, target, options, initial, execution.part(0, 0.3));
  const SolidAngles areas(sphere.mesh().faces(), sphere.mesh().vertexCount());
  SphericalAuthalicMapResult result;
  const double startSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  AreaSolveResult solved = solveAreas(areas, sphere.mesh(), target, start, options, execution.part(0.3, 1),
                                      Shapes::First, systems);
  result.image = rotateSphere(sphere.mesh(), Points3(solved.image));
  static_cast<AuthalicSolution&>(result) = std::move(solved);
  result.startSeconds = startSeconds;
  result.flippedFaces = countFlippedOnSphere(result.image, sphere.mesh().faces());
  execution.report(1, "Authalic map");
  return result;
}

}  // namespace authalic
