#include "vtkSphericalTransportMap.h"

#include <array>
#include <optional>

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "AuthalicReport.h"
#include "ConformalImages.h"
#include "Conversion.h"
#include "Core/authalic/FinishStart.h"
#include "Core/authalic/SphericalAuthalicMap.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/transport/SphericalTransportMap.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "TransportReport.h"

vtkStandardNewMacro(vtkSphericalTransportMap);

namespace {

void describePole(const Eigen::Vector3d& pole, authalic::MapReport& report, vtkPolyData* map) {
  vtkNew<vtkDoubleArray> field;
  field->SetName("Pole");
  field->SetNumberOfComponents(3);
  field->InsertNextTuple(pole.data());
  map->GetFieldData()->AddArray(field);
  report.more.set("pole", authalic::Json::arrayOf(std::array{pole.x(), pole.y(), pole.z()}));
}

}  // namespace

vtkSphericalTransportMap::vtkSphericalTransportMap() {
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  const authalic::SphericalTransportMapOptions defaults;
  this->Formulation = static_cast<int>(defaults.formulation);
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
}

int vtkSphericalTransportMap::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkSphericalTransportMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                       const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::SphericalTransportMapOptions options;
  options.formulation = static_cast<authalic::SphereFormulation>(this->Formulation);
  options.pole = Eigen::Vector3d(this->Pole);
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  options.validate();
  const authalic::SphereMesh sphere(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, sphere.mesh(), this->MeasureArrayName);
  authalic::Points3 initial = given ? authalic::toPoints(given) : authalic::Points3();
  authalic::TargetMeasure wanted = target;
  const authalic::Balance balance{this->Balance, this->BalanceArrayName};
  if (!balance.whole()) {
    const authalic::Points3 conformal =
        authalic::conformalImage(sphere, "a balance below 1", execution.part(0, 0.2));
    const Eigen::VectorXd areas = authalic::signedSolidAngles(conformal, sphere.mesh().faces());
    wanted = authalic::balancedTarget(input, sphere.mesh(), target, areas, balance);
    if (!given) initial = conformal;
  }
  const double share = this->Finish == AUTHALIC ? 0.5 : 1.0;  // of the progress
  const authalic::SphericalTransportMapResult result = authalic::sphericalTransportMap(
      sphere, wanted.vertices(), options, initial, execution.part(balance.whole() ? 0 : 0.2, share));
  std::optional<authalic::SphericalAuthalicMapResult> finished;
  if (this->Finish == AUTHALIC && result.status != authalic::Status::Cancelled) {
    const authalic::Points3& begun = authalic::finishStart(sphere, wanted, result.image, initial);
    finished = authalic::sphericalAuthalicMap(sphere, wanted, {}, begun, execution.part(share, 1));
  }
  const authalic::Points3& image = finished ? finished->image : result.image;
  const authalic::SphericalDistortion distortion =
      authalic::fillMap(input, output, sphere.mesh(), image, target.shares());
  const double displacement = authalic::displacementCost(result.masses, result.sites, result.image);
  authalic::TransportCosts costs{result.transportCost, displacement, result.emptyCells};
  if (this->Formulation == STEREOGRAPHIC) costs.transport.reset();
  authalic::MapReport report = authalic::describeTransport(result, costs, output);
  report.seconds = {{"start", result.startSeconds}, {"transport", result.transportSeconds}};
  if (finished) {
    const double cost = authalic::displacementCost(result.masses, result.sites, image);
    authalic::describeFinish(*finished, {cost, result.flippedFaces}, report, output);
  }
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(sphere.mesh(), sphere.topology());
  report.options.set("domain", "sphere");
  report.options.set("measure", this->MeasureArrayName);
  report.options.set("initial", given ? "given" : "conformal");
  report.options.set("formulation", this->Formulation == STEREOGRAPHIC ? "stereographic" : "spherical");
  if (this->Formulation == STEREOGRAPHIC) describePole(result.pole, report, output);
  report.options.set("tolerance", this->Tolerance);
  report.options.set("max_iterations", this->MaximumIterations);
  report.options.set("finish", this->Finish == AUTHALIC ? "authalic" : "none");
  authalic::describeBalance(balance, report.options, output);
  if (!balance.whole()) report.method = "balanced";
  authalic::addArray(output->GetPointData(), "Site", result.sites);
  authalic::addArray(output->GetPointData(), "CellArea", result.cellAreas);
  authalic::addArray(output->GetPointData(), "Potential", result.potential);
  authalic::setCells(vtkPolyData::GetData(outputs, 1), result.cells.corners, result.cells.starts, result.cellAreas);
  this->Publish(output, report);
}

void vtkSphericalTransportMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Finish: " << this->Finish << "\n";
  os << indent << "Formulation: " << this->Formulation << "\n";
  os << indent << "Pole: " << this->Pole[0] << " " << this->Pole[1] << " " << this->Pole[2] << "\n";
  os << indent << "Balance: " << this->Balance << "\n";
  os << indent << "BalanceArrayName: " << this->BalanceArrayName << "\n";
}
