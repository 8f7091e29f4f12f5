#include "vtkPolyAnnulusTransportMap.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "AuthalicReport.h"
#include "BoundaryLoops.h"
#include "Conversion.h"
#include "Core/authalic/CircleDomainFinish.h"
#include "Core/transport/OptimalTransportMap.h"
#include "Core/transport/PolyAnnulusTransportMap.h"
#include "HoledDomains.h"
#include "MapArrays.h"
#include "TransportReport.h"

vtkStandardNewMacro(vtkPolyAnnulusTransportMap);

namespace {

// As a map to a circle domain reports it, before its holes are round.
authalic::CircleDomainImage imageOf(const authalic::PolyAnnulusTransportResult& result) {
  authalic::CircleDomainImage image;
  image.image = result.image;
  image.circles = result.circles;
  image.outerLoop = result.outerLoop;
  image.holeAreas = result.holeAreas;
  image.pockets = static_cast<int>(result.pockets.size());
  for (Eigen::Index i = result.image.rows(); i < result.masses.size(); ++i) {
    image.holeResidual = std::max(image.holeResidual, std::abs(std::log(result.cellAreas[i] / result.masses[i])));
  }
  return image;
}

double displacement(const authalic::PolyAnnulusTransportResult& result, const authalic::Points2& image) {
  const Eigen::Index n = image.rows();
  return authalic::displacementCost(result.masses.head(n), result.sites.topRows(n), image);
}

}  // namespace

vtkPolyAnnulusTransportMap::vtkPolyAnnulusTransportMap() {
  this->SetNumberOfOutputPorts(2);
  const authalic::PolyAnnulusTransportOptions defaults;
  this->HoleShare = defaults.holeShare;
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
  this->Start = static_cast<int>(defaults.start);
}

void vtkPolyAnnulusTransportMap::AddHoleArea(double area) {
  this->HoleAreas.push_back(area);
  this->Modified();
}

void vtkPolyAnnulusTransportMap::ClearHoleAreas() {
  this->HoleAreas.clear();
  this->Modified();
}

authalic::Json vtkPolyAnnulusTransportMap::DescribeOptions() const {
  authalic::Json options = authalic::Json::object();
  authalic::addHoledOptions(options, authalic::HoledDomain::CircleDomain, this->MeasureArrayName, this->OuterVertex,
                            this->HoleAreas);
  options.set("hole_share", this->HoleShare);
  options.set("tolerance", this->Tolerance);
  options.set("max_iterations", this->MaximumIterations);
  options.set("start", authalic::nameOf(static_cast<authalic::TransportStart>(this->Start)));
  options.set("finish", this->Finish == AUTHALIC ? "authalic" : "none");
  return options;
}

void vtkPolyAnnulusTransportMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                         const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::PolyAnnulusMesh surface(authalic::toTriangleMesh(input));
  authalic::PolyAnnulusTransportOptions options;
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  options.start = static_cast<authalic::TransportStart>(this->Start);
  options.outerLoop = authalic::loopOf(surface.loops(), this->OuterVertex);
  options.holeAreas = this->HoleAreas;
  options.holeShare = this->HoleShare;
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, surface.mesh(), this->MeasureArrayName);
  const double share = this->Finish == AUTHALIC ? 0.5 : 1.0;  // of the progress
  const auto result =
      authalic::polyAnnulusTransportMap(surface, target.vertices(), options, execution.part(0, share));
  std::optional<authalic::CircleDomainAuthalicMapResult> finished;
  if (this->Finish == AUTHALIC && result.status != authalic::Status::Cancelled) {
    finished = authalic::finishCircleDomain(
        surface, target, result.image, {result.outerLoop, result.holeCentres, result.holeAreas, result.pockets}, {},
        execution.part(share, 1));
  }
  const authalic::CircleDomainImage image = finished ? *finished : imageOf(result);
  authalic::MapReport report = authalic::reportCircles(input, output, surface, image, target, [&] {
    const double moved = displacement(result, result.image);
    authalic::MapReport described =
        authalic::describeTransport(result, {result.transportCost, moved, result.emptyCells}, output);
    described.seconds = {{"start", result.startSeconds}, {"transport", result.transportSeconds}};
    if (finished) {
      authalic::describeFinish(*finished, {displacement(result, image.image), result.flippedFaces}, described, output);
    }
    return described;
  });
  report.options = this->DescribeOptions();
  const authalic::PlanarTransport transport{result.sites, result.heights, result.cellAreas, result.potential,
                                            result.cells};
  authalic::addPlanarArrays(transport, output);
  authalic::setPlanarCells(transport, vtkPolyData::GetData(outputs, 1));
  this->Publish(output, report);
}

void vtkPolyAnnulusTransportMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OuterVertex: " << this->OuterVertex << "\n";
  os << indent << "HoleAreas: " << this->HoleAreas.size() << "\n";
  os << indent << "HoleShare: " << this->HoleShare << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Start: " << this->Start << "\n";
  os << indent << "Finish: " << this->Finish << "\n";
}
