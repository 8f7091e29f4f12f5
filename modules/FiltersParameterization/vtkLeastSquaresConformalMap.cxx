#include "vtkLeastSquaresConformalMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/initial/LeastSquaresConformalMap.h"
#include "Core/mesh/DiskMesh.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkLeastSquaresConformalMap);

static_assert(static_cast<int>(authalic::ConformalPins::Spectral) == vtkLeastSquaresConformalMap::SPECTRAL);

vtkLeastSquaresConformalMap::vtkLeastSquaresConformalMap() {
  const authalic::LeastSquaresConformalMapOptions defaults;
  this->Pins = static_cast<int>(defaults.pins);
  this->FirstPin = defaults.firstPin;
  this->SecondPin = defaults.secondPin;
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
}

authalic::LeastSquaresConformalMapOptions vtkLeastSquaresConformalMap::Options() const {
  authalic::LeastSquaresConformalMapOptions options;
  options.pins = static_cast<authalic::ConformalPins>(this->Pins);
  options.firstPin = this->FirstPin;
  options.secondPin = this->SecondPin;
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  options.validate();
  return options;
}

void vtkLeastSquaresConformalMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                          const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::LeastSquaresConformalMapOptions options = this->Options();
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  const authalic::LeastSquaresConformalMapResult map = authalic::leastSquaresConformalMap(disk, options, execution);
  authalic::MapReport report;
  report.method = "lscm";
  report.status = map.status;
  report.iterations = map.iterations;
  report.residuals = map.history;
  report.seconds = {{"solve", map.seconds}};
  report.metrics = authalic::fillMap(input, output, disk.mesh(), map.image, target.faces()).summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options.set("pins", authalic::conformalPinsName(options.pins));
  report.options.set("first_pin", this->FirstPin);
  report.options.set("second_pin", this->SecondPin);
  report.options.set("tolerance", this->Tolerance);
  report.options.set("max_iterations", this->MaximumIterations);
  report.options.set("measure", this->MeasureArrayName);
  report.more.set("conformal_energy", map.conformalEnergy);
  report.more.set("pins", authalic::Json::arrayOf(std::vector<int>{map.firstPin, map.secondPin}));
  authalic::addField(output, "ConformalEnergy", map.conformalEnergy);
  authalic::addField(output, "FirstPin", map.firstPin);
  authalic::addField(output, "SecondPin", map.secondPin);
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
