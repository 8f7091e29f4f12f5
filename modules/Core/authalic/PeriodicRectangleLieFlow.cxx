#include "Core/authalic/PeriodicRectangleLieFlow.h"

#include "Core/authalic/LieFlowStages.h"
#include "Core/authalic/PeriodicAreas.h"
#include "Core/authalic/RectangleStart.h"
#include "Core/authalic/Stopwatch.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

// The vertices of both loops slide along their lines.
class RectangleFlowDomain final : public LieFlowDomain {
 public:
  RectangleFlowDomain(const AnnulusMesh& annulus, const RectangleStart& start, const TargetMeasure& target)
      : LieFlowDomain(annulus.mesh().faces(), target), annulus_(annulus), start_(start) {}

  [[nodiscard]] const Points2& shifts() const override { return start_.shifts; }

  [[nodiscard]] std::unique_ptr<AreaFunctional> areasOn(const Faces& faces, const Points2& shifts) const override {
    return std::make_unique<PeriodicAreas>(faces, shifts, start_.freedom);
  }

  [[nodiscard]] std::unique_ptr<AreaFunctional> heldAreas() const override {
    return std::make_unique<PeriodicAreas>(faces(), start_.shifts, start_.heldFreedom());
  }

  [[nodiscard]] Coordinates unfolded(const Coordinates& image, UnfoldReach reach) const override {
    return unfold(annulus_.topology(), Points2(image), {}, reach, start_.shifts).image;
  }

 private:
  const AnnulusMesh& annulus_;
  const RectangleStart& start_;
};

}  // namespace

void PeriodicRectangleLieFlowOptions::validate() const { flow.validate(); }

PeriodicRectangleLieFlowResult periodicRectangleLieFlow(const AnnulusMesh& annulus, const TargetMeasure& target,
                                                        const PeriodicRectangleLieFlowOptions& options,
                                                        const Execution& execution) {
  options.validate();
  requireTargetOf(annulus.mesh(), target);
  PeriodicRectangleLieFlowResult result;
  Stopwatch watch;
  const RectangleStart start =
      rectangleStart(annulus, target, options.outerLoop, options.flow.solver, execution.part(0, 0.3));
  result.status = Status::Cancelled;
  if (start.image.rows() == 0) return result;
  result.startSeconds = watch.lap();
  Coordinates image = start.image;
  runLieFlow(RectangleFlowDomain(annulus, start, target), options.flow, execution.part(0.3, 1), image, result);
  static_cast<PeriodicRectangleImage&>(result) = openRectangle(annulus, start, image);
  execution.report(1, "Discrete Lie flow");
  return result;
}

}  // namespace authalic
