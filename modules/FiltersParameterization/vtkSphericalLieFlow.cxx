#include "vtkSphericalLieFlow.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/authalic/SphericalLieFlow.h"
#include "Core/mesh/SphereMesh.h"
#include "LieFlowReport.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkSphericalLieFlow);

vtkSphericalLieFlow::vtkSphericalLieFlow() { this->SetNumberOfInputPorts(2); }

int vtkSphericalLieFlow::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkSphericalLieFlow::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                  const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::DiscreteLieFlowOptions options = this->Options();
  const authalic::SphereMesh sphere(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, sphere.mesh(), this->MeasureArrayName);
  const authalic::Points3 initial = given ? authalic::toPoints(given) : authalic::Points3();
  const auto result = authalic::sphericalLieFlow(sphere, target, options, initial, execution);
  const authalic::SphericalDistortion distortion =
      authalic::fillMap(input, output, sphere.mesh(), result.image, target.shares());
  authalic::MapReport report = authalic::describeLieFlow(result, output);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(sphere.mesh(), sphere.topology());
  report.options.set("domain", "sphere");
  report.options.set("measure", this->MeasureArrayName);
  report.options.set("initial", result.balancedStart ? "two-caps" : given ? "given" : "stereographic");
  authalic::addLieFlowOptions(report.options, options);
  this->Publish(output, report);
}
