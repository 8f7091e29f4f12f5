#include "Core/authalic/SphericalLieFlow.h"

#include <utility>

#include "Core/authalic/SphericalFlowDomain.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/conformal/SphereNormalisation.h"

namespace authalic {

SphericalLieFlowResult sphericalLieFlow(const SphereMesh& sphere, const TargetMeasure& target,
                                        const DiscreteLieFlowOptions& options, const Points3& initial,
                                        const Execution& execution) {
  options.validate();
  requireTargetOf(sphere.mesh(), target);
  SphericalLieFlowResult result;
  Stopwatch watch;
  const SphericalFlowStart start =
      sphericalFlowStart(sphere, initial, target, options.solver, execution.part(0, 0.3));
  result.startSeconds = watch.lap();
  Coordinates image = start.image;
  runLieFlow(SphericalFlowDomain(sphere, target), options, execution.part(0.3, 1), image, result);
  result.balancedStart = start.balanced;
  result.image = rotateSphere(sphere.mesh(), Points3(image));
  execution.report(1, "Discrete Lie flow");
  return result;
}

SphericalLieAdvectionResult sphericalLieAdvection(const SphereMesh& sphere, const TargetMeasure& target,
                                                  const LieAdvectionOptions& options, const Points3& initial,
                                                  const Execution& execution) {
  options.validate();
  requireTargetOf(sphere.mesh(), target);
  SphericalLieAdvectionResult result;
  Stopwatch watch;
  SphericalFlowStart start =
      sphericalFlowStart(sphere, initial, target, options.solver, execution.part(0, 0.3));
  result.startSeconds = watch.lap();
  Coordinates image = start.image;
  runLieAdvection(SphericalFlowDomain(sphere, target), options, execution.part(0.3, 1), image, result);
  result.balancedStart = start.balanced;
  result.image = rotateSphere(sphere.mesh(), Points3(image));
  return result;
}

}  // namespace authalic
