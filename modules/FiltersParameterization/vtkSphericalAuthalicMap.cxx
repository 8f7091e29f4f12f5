#include "vtkSphericalAuthalicMap.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "AuthalicReport.h"
#include "ConformalImages.h"
#include "Conversion.h"
#include "Core/authalic/SphericalAuthalicMap.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/mesh/SphereMesh.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkSphericalAuthalicMap);

vtkSphericalAuthalicMap::vtkSphericalAuthalicMap() { this->SetNumberOfInputPorts(2); }

int vtkSphericalAuthalicMap::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkSphericalAuthalicMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                             const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::AuthalicMapOptions options = this->Options();
  const authalic::SphereMesh sphere(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, sphere.mesh(), this->MeasureArrayName);
  authalic::Points3 initial = given ? authalic::toPoints(given) : authalic::Points3();
  authalic::TargetMeasure wanted = target;
  const authalic::Balance balance{this->Balance, this->BalanceArrayName};
  if (!balance.whole()) {
    const authalic::Points3 conformal = authalic::conformalImage(sphere, "a balance below 1", execution.part(0, 0.3));
    const Eigen::VectorXd areas = authalic::signedSolidAngles(conformal, sphere.mesh().faces());
    wanted = authalic::balancedTarget(input, sphere.mesh(), target, areas, balance);
    if (!given) initial = conformal;
  }
  const authalic::SphericalAuthalicMapResult result = authalic::sphericalAuthalicMap(
      sphere, wanted, options, initial, execution.part(balance.whole() ? 0 : 0.3, 1));
  const authalic::SphericalDistortion distortion =
      authalic::fillMap(input, output, sphere.mesh(), result.image, target.shares());
  authalic::MapReport report = authalic::describeAuthalicMap(result, output);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(sphere.mesh(), sphere.topology());
  report.options.set("domain", "sphere");
  report.options.set("measure", this->MeasureArrayName);
  report.options.set("initial", given ? "given" : balance.whole() ? "two-caps" : "conformal");
  authalic::describeBalance(balance, report.options, output);
  authalic::addAuthalicOptions(report.options, options);
  this->Publish(output, report);
}

void vtkSphericalAuthalicMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Balance: " << this->Balance << "\n";
  os << indent << "BalanceArrayName: " << this->BalanceArrayName << "\n";
}
