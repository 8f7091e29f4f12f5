#include "vtkOptimalTransportMap.h"

#include <optional>

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "AuthalicReport.h"
#include "ConformalImages.h"
#include "Conversion.h"
#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/FinishStart.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/transport/OptimalTransportMap.h"
#include "MapArrays.h"
#include "SourceDensity.h"
#include "TransportReport.h"

vtkStandardNewMacro(vtkOptimalTransportMap);

vtkOptimalTransportMap::vtkOptimalTransportMap() {
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
  const authalic::OptimalTransportMapOptions defaults;
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
  this->Start = static_cast<int>(defaults.start);
}

int vtkOptimalTransportMap::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port > 0) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

authalic::Json vtkOptimalTransportMap::DescribeAllOptions(bool initialMapGiven) const {
  const bool riemann = this->InitialMethod == RIEMANN || this->Balance < 1 || !this->BalanceArrayName.empty();
  authalic::Json options = this->DescribeOptions();
  options.set("initial", initialMapGiven ? "given" : riemann ? "riemann" : "harmonic");
  options.set("tolerance", this->Tolerance);
  options.set("max_iterations", this->MaximumIterations);
  options.set("start", authalic::nameOf(static_cast<authalic::TransportStart>(this->Start)));
  options.set("finish", this->Finish == AUTHALIC ? "authalic" : "none");
  options.set("source_density", this->SourceDensityArrayName);
  return options;
}

void vtkOptimalTransportMap::CheckSource(bool meshGiven) const {
  if (!meshGiven && this->SourceDensityArrayName.empty()) return;
  if (!meshGiven || this->SourceDensityArrayName.empty()) {
    throw authalic::InvalidArgument("A source density is a mesh and the name of its point array, but only the " +
                                    std::string(meshGiven ? "mesh" : "name") + " was given; give both, or neither.");
  }
  if (this->Finish == AUTHALIC) {
    throw authalic::InvalidArgument("A uniform source is required for the finish authalic, which makes areas exact, "
                                    "but there is a source density; leave one of them out.");
  }
  if (this->Balance < 1 || !this->BalanceArrayName.empty()) {
    throw authalic::InvalidArgument("A uniform source is required for a balance, which is one with the areas of the "
                                    "conformal map, but there is a source density; leave one of them out.");
  }
}

void vtkOptimalTransportMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                     const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::OptimalTransportMapOptions options;
  options.domain = this->MakeDomain();
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  options.start = static_cast<authalic::TransportStart>(this->Start);
  options.validate();
  vtkPolyData* source = vtkPolyData::GetData(inputs[2]);
  this->CheckSource(source != nullptr);
  if (source) options.source = authalic::sourceDensityOf(source, this->SourceDensityArrayName, options.domain);
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  authalic::Points2 initial;  // empty: Core starts from the harmonic map
  authalic::TargetMeasure wanted = target;
  const authalic::Balance balance{this->Balance, this->BalanceArrayName};
  if (!balance.whole() || (!given && this->InitialMethod == RIEMANN)) {
    initial = authalic::conformalImage(disk, this->Domain == DISK,
                                       balance.whole() ? "sites from the Riemann map" : "a balance below 1",
                                       balance.whole(), execution.part(0, 0.1));
  }
  if (!balance.whole()) {
    const Eigen::VectorXd areas = authalic::signedFaceAreas(initial, disk.mesh().faces());
    wanted = authalic::balancedTarget(input, disk.mesh(), target, areas, balance);
  }
  if (given) initial = authalic::toPlanarPoints(given);
  const double share = this->Finish == AUTHALIC ? 0.4 : 1.0;  // of the progress
  const authalic::OptimalTransportMapResult result = authalic::optimalTransportMap(
      disk, wanted.vertices(), options, initial, execution.part(0.1, share));
  std::optional<authalic::AuthalicMapResult> finished;
  if (this->Finish == AUTHALIC && result.status != authalic::Status::Cancelled) {
    authalic::AuthalicMapOptions exact;
    exact.domain = options.domain;
    const authalic::Points2& begun = authalic::finishStart(disk, wanted, result.image, initial);
    finished = authalic::authalicMap(disk, wanted, exact, begun, execution.part(share, 1));
  }
  const authalic::Points2& image = finished ? finished->image : result.image;
  const authalic::Distortion distortion = authalic::fillMap(input, output, disk.mesh(), image, target.shares());
  const double displacement = authalic::displacementCost(result.masses, result.sites, result.image);
  authalic::MapReport report =
      authalic::describeTransport(result, {result.transportCost, displacement, result.emptyCells}, output);
  report.seconds = {{"start", result.startSeconds}, {"transport", result.transportSeconds}};
  if (finished) {
    const double cost = authalic::displacementCost(result.masses, result.sites, image);
    authalic::describeFinish(*finished, {cost, result.flippedFaces}, report, output);
  }
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeAllOptions(given != nullptr);
  authalic::describeBalance(balance, report.options, output);
  if (!balance.whole()) report.method = "balanced";
  if (source) authalic::describeSource(*options.source, report, output);
  const authalic::PlanarTransport transport{result.sites,     result.heights, result.cellAreas,
                                            result.potential, result.cells,   source ? &result.cellMasses : nullptr};
  authalic::addPlanarArrays(transport, output);
  authalic::setPlanarCells(transport, vtkPolyData::GetData(outputs, 1));
  this->Publish(output, report);
}

void vtkOptimalTransportMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InitialMethod: " << this->InitialMethod << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Start: " << this->Start << "\n";
  os << indent << "Finish: " << this->Finish << "\n";
  os << indent << "Balance: " << this->Balance << "\n";
  os << indent << "BalanceArrayName: " << this->BalanceArrayName << "\n";
  os << indent << "SourceDensityArrayName: " << this->SourceDensityArrayName << "\n";
}
