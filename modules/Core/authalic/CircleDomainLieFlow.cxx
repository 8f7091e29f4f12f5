#include "Core/authalic/CircleDomainLieFlow.h"

#include "Core/authalic/CircleDomainStart.h"
#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/initial/Untangle.h"

namespace authalic {
namespace {

// The vertices of loops slide on their circles.
class CircleFlowDomain final : public LieFlowDomain {
 public:
  CircleFlowDomain(const PolyAnnulusMesh& surface, const std::vector<LoopOnCircle>& loops, const TargetMeasure& target)
      : LieFlowDomain(surface.mesh().faces(), target), surface_(surface), loops_(loops) {}

  [[nodiscard]] std::unique_ptr<AreaFunctional> areasOn(const Faces& faces, const Points2&) const override {
    return std::make_unique<CircleDomainAreas>(faces, loops_, surface_.mesh().vertexCount());
  }

  [[nodiscard]] Coordinates unfolded(const Coordinates& image, UnfoldReach reach) const override {
    if (reach == UnfoldReach::Patches) return unfold(surface_.topology(), Points2(image), {}, reach).image;
    return unfoldOrUntangle(surface_.topology(), Points2(image)).image;
  }

 private:
  const PolyAnnulusMesh& surface_;
  const std::vector<LoopOnCircle>& loops_;
};

}  // namespace

void CircleDomainLieFlowOptions::validate(const PolyAnnulusMesh& surface) const {
  flow.validate();
  CircleDomainHoles::validate(surface);
}

CircleDomainLieFlowResult circleDomainLieFlow(const PolyAnnulusMesh& surface, const TargetMeasure& target,
                                              const CircleDomainLieFlowOptions& options, const Execution& execution) {
  options.validate(surface);
  requireTargetOf(surface.mesh(), target);
  CircleDomainLieFlowResult result;
  Stopwatch watch;
  const CircleDomainStart start = circleDomainStart(surface, target, options, HolesRoad::Either,
                                                    SolverBackend::Automatic, execution.part(0, 0.3));
  result.status = Status::Cancelled;
  if (start.image.rows() == 0) return result;
  result.startSeconds = watch.lap();
  Coordinates image = start.image;
  runLieFlow(CircleFlowDomain(surface, start.loops, target), options.flow, execution.part(0.3, 1), image, result);
  static_cast<CircleDomainImage&>(result) = imageOf(start, image);
  execution.report(1, "Discrete Lie flow");
  return result;
}

}  // namespace authalic
