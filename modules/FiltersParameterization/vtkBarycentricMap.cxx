#include "vtkBarycentricMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/mesh/DiskMesh.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkBarycentricMap);

static_assert(static_cast<int>(authalic::BarycentricWeights::Uniform) == vtkBarycentricMap::TUTTE);
static_assert(static_cast<int>(authalic::BarycentricWeights::Harmonic) == vtkBarycentricMap::HARMONIC);
static_assert(static_cast<int>(authalic::BarycentricWeights::MeanValue) == vtkBarycentricMap::MEAN_VALUE);

vtkBarycentricMap::vtkBarycentricMap() {
  const authalic::BarycentricMapOptions defaults;
  this->Method = static_cast<int>(defaults.weights);
  this->StartVertex = defaults.startVertex;
}

void vtkBarycentricMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  authalic::BarycentricMapOptions options;
  options.weights = static_cast<authalic::BarycentricWeights>(this->Method);
  options.domain = this->MakeDomain();
  options.startVertex = this->StartVertex;
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  const authalic::BarycentricMapResult map = authalic::barycentricMap(disk, options, execution);
  const int pockets = static_cast<int>(map.boundary.pockets.size());
  authalic::MapReport report;
  report.method = authalic::barycentricWeightsName(options.weights);
  report.status = map.status;
  report.residuals = {map.residual};
  report.seconds = {{"solve", map.seconds}};
  report.metrics = authalic::fillMap(input, output, disk.mesh(), map.image, target.shares()).summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeOptions();
  report.options.set("start_vertex", this->StartVertex);
  report.more.set("pockets", pockets);
  authalic::addField(output, "Pockets", pockets);
  this->Publish(output, report);
}

void vtkBarycentricMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "StartVertex: " << this->StartVertex << "\n";
}
