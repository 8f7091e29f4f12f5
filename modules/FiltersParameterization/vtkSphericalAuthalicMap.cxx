#include "vtkSphericalAuthalicMap.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "AuthalicReport.h"
#include "Conversion.h"
#include "Core/authalic/SphericalAuthalicMap.h"
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
  const authalic::Points3 initial = given ? authalic::toPoints(given) : authalic::Points3();
  const authalic::SphericalAuthalicMapResult result =
      authalic::sphericalAuthalicMap(sphere, target, options, initial, execution);
  const authalic::SphericalDistortion distortion =
      authalic::fillMap(input, output, sphere.mesh(), result.image, target.faces());
  authalic::MapReport report = authalic::describeAuthalicMap(result, output);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(sphere.mesh(), sphere.topology());
  report.options.set("domain", "sphere");
  report.options.set("measure", this->MeasureArrayName);
  report.options.set("initial", given ? "given" : "two-caps");
  authalic::addAuthalicOptions(report.options, options);
  this->Publish(output, report);
}
