#include "Core/authalic/SphericalFlowDomain.h"

#include <cmath>
#include <string>

#include "Core/authalic/SolidAngles.h"
#include "Core/authalic/TwoCapsStart.h"
#include "Core/base/Error.h"
#include "Core/conformal/StereographicSphereMap.h"
#include "Core/conformal/UnfoldOnSphere.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"

namespace authalic {
namespace {

constexpr double kFar = 8;             // |ln r| of a star: beyond it the smallest triangles would pin the flow
constexpr double kWithinSight = 0.3;   // mean |ln r| of the stars of the caps

double farthestStar(const SphereMesh& sphere, const TargetMeasure& target, const Points3& image) {
  const Faces& faces = sphere.mesh().faces();
  const Eigen::ArrayXd stars =
      vertexStars(signedSolidAngles(image, faces) / (4 * M_PI), faces, sphere.mesh().vertexCount());
  return (stars.max(1e-300) / target.vertices().array()).log().abs().maxCoeff();
}

}  // namespace

std::unique_ptr<AreaFunctional> SphericalFlowDomain::areasOn(const Faces& faces, const Points2&) const {
  return std::make_unique<SolidAngles>(faces, sphere_.mesh().vertexCount());
}

Coordinates SphericalFlowDomain::unfolded(const Coordinates& image, UnfoldReach) const {
  return unfoldOnSphere(sphere_, Points3(image)).image;
}

SphericalFlowStart sphericalFlowStart(const SphereMesh& sphere, const Points3& initial, const TargetMeasure& target,
                                      SolverBackend backend, const Execution& execution) {
  SphericalFlowStart start;
  if (initial.size() == 0) {
    StereographicSphereMapOptions stereographic;
    stereographic.solver = backend;
    stereographic.correctedShare = 0;
    start.image = stereographicSphereMap(sphere, stereographic, execution.part(0, 0.3)).image;
  } else {
    start.image = initial;
  }
  start.image = unfoldOnSphere(sphere, start.image).image;
  start.balanced = countFlippedOnSphere(start.image, sphere.mesh().faces()) > 0 ||
                   farthestStar(sphere, target, start.image) > kFar;
  if (start.balanced) {
    start.image = twoCapsStart(sphere, start.image, target, backend, kWithinSight, execution.part(0.3, 1));
  }
  const int folded = countFlippedOnSphere(start.image, sphere.mesh().faces());
  if (folded > 0 && !execution.cancelled()) {
    throw GeometryError("A start without folded faces is required, but " + std::to_string(folded) +
                        " faces stay folded on the sphere; give an initial map without folds.");
  }
  return start;
}

}  // namespace authalic
