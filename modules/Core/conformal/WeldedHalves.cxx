#include "Core/conformal/WeldedHalves.h"

#include <string>
#include <utility>

#include "Core/base/Error.h"

namespace authalic {
namespace {

void requireOneImagePerVertex(const CutHalf& half, const Points2& image, const char* name) {
  if (image.rows() == half.disk.mesh().vertexCount()) return;
  throw InvalidArgument("One image per vertex of the half " + std::string(name) + " the level is required: it has " +
                        std::to_string(half.disk.mesh().vertexCount()) + " vertices, but there are " +
                        std::to_string(image.rows()) + " images.");
}

}  // namespace

WeldedHalves weldHalves(const LevelSetCutResult& cut, const Points2& above, const Points2& below,
                        const Execution& execution) {
  requireOneImagePerVertex(cut.above, above, "above");
  requireOneImagePerVertex(cut.below, below, "below");
  const auto seam = static_cast<Eigen::Index>(cut.seam.size());
  ConformalWelding welding(WeldingSignature::fromPoints(above.bottomRows(seam), below.bottomRows(seam)),
                           execution.part(0, 0.3));
  const Points3 inner = welding.mapFirstToSphere(above.topRows(cut.above.seamStart), execution);
  const Points3 outer = welding.mapSecondToSphere(below.topRows(cut.below.seamStart), execution);
  Points3 image(inner.rows() + outer.rows(), 3);
  for (Eigen::Index i = 0; i < inner.rows(); ++i) {
    image.row(cut.above.originalPointIds[static_cast<std::size_t>(i)]) = inner.row(i);
  }
  for (Eigen::Index i = 0; i < outer.rows(); ++i) {
    image.row(cut.below.originalPointIds[static_cast<std::size_t>(i)]) = outer.row(i);
  }
  execution.report(1, "welding");
  return {std::move(image), std::move(welding)};
}

}  // namespace authalic
