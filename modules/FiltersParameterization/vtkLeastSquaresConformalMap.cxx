#include "vtkLeastSquaresConformalMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/initial/LeastSquaresConformalMap.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkLeastSquaresConformalMap);

static_assert(static_cast<int>(authalic::ConformalPins::Spectral) == vtkLeastSquaresConformalMap::SPECTRAL);

vtkLeastSquaresConformalMap::vtkLeastSquaresConformalMap() {
  const authalic::LeastSquaresConformalMapOptions defaults;
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
}

void vtkLeastSquaresConformalMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                          const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  authalic::LeastSquaresConformalMapOptions options;
  options.pins = static_cast<authalic::ConformalPins>(this->Pins);
  options.firstPin = this->FirstPin;
  options.secondPin = this->SecondPin;
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  const authalic::LeastSquaresConformalMapResult result =
      authalic::leastSquaresConformalMap(disk, options, execution);
  authalic::MapReport report;
  report.metrics = authalic::fillMap(input, output, disk.mesh(), result.image, target.shares()).summary;
  authalic::addField(output, "ConformalEnergy", result.conformalEnergy);
  report.method = "lscm";
  report.status = result.status;
  report.iterations = result.iterations;
  report.residuals = result.history;
  report.seconds = {{"map", result.seconds}};
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options.set("domain", "free")
      .set("measure", this->MeasureArrayName)
      .set("pins", authalic::conformalPinsName(options.pins))
      .set("first_pin", result.firstPin)
      .set("second_pin", result.secondPin);
  if (this->Pins == SPECTRAL) {
    report.options.set("tolerance", options.tolerance).set("max_iterations", options.maxIterations);
  }
  report.more.set("conformal_energy", result.conformalEnergy);
  this->Publish(output, report);
}

void vtkLeastSquaresConformalMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pins: " << this->Pins << "\n";
  os << indent << "FirstPin: " << this->FirstPin << "\n";
  os << indent << "SecondPin: " << this->SecondPin << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
}
