#include "vtkStretchMinimisation.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/initial/StretchMinimisation.h"
#include "Core/mesh/DiskMesh.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkStretchMinimisation);

static_assert(static_cast<int>(authalic::BarycentricWeights::Uniform) == vtkStretchMinimisation::TUTTE);
static_assert(static_cast<int>(authalic::BarycentricWeights::Harmonic) == vtkStretchMinimisation::HARMONIC);
static_assert(static_cast<int>(authalic::BarycentricWeights::MeanValue) == vtkStretchMinimisation::MEAN_VALUE);

namespace {

authalic::MapReport describe(const authalic::StretchMinimisationResult& result, vtkPolyData* map) {
  const int pockets = static_cast<int>(result.boundary.pockets.size());
  authalic::MapReport report;
  report.method = "stretch";
  report.status = result.status;
  report.iterations = result.iterations;
  report.residuals = result.history;
  report.residuals.push_back(result.stretch);
  report.seconds = {{"map", result.seconds}};
  report.more.set("stretch", result.stretch);
  report.more.set("pockets", pockets);
  authalic::addField(map, "Stretch", result.stretch);
  authalic::addField(map, "Pockets", pockets);
  return report;
}

}  // namespace

vtkStretchMinimisation::vtkStretchMinimisation() {
  const authalic::StretchMinimisationOptions defaults;
  this->Weights = static_cast<int>(defaults.weights);
  this->StartVertex = defaults.startVertex;
  this->MaximumIterations = defaults.maxIterations;
}

void vtkStretchMinimisation::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                     const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  authalic::StretchMinimisationOptions options;
  options.weights = static_cast<authalic::BarycentricWeights>(this->Weights);
  options.domain = this->MakeDomain();
  options.startVertex = this->StartVertex;
  options.maxIterations = this->MaximumIterations;
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  const authalic::StretchMinimisationResult result = authalic::stretchMinimisation(disk, options, execution);
  const authalic::Distortion distortion = authalic::fillMap(input, output, disk.mesh(), result.image, target.shares());
  authalic::MapReport report = describe(result, output);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeOptions();
  report.options.set("weights", authalic::barycentricWeightsName(options.weights));
  report.options.set("start_vertex", options.startVertex);
  report.options.set("max_iterations", options.maxIterations);
  this->Publish(output, report);
}

void vtkStretchMinimisation::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Weights: " << this->Weights << "\n";
  os << indent << "StartVertex: " << this->StartVertex << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
}
