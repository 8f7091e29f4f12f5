#include "vtkBarycentricMap.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/mesh/DiskMesh.h"
#include "FieldArrays.h"
#include "FilterGuard.h"
#include "MapArrays.h"

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
  const authalic::BarycentricMapResult map = authalic::barycentricMap(disk, options, execution);
  authalic::fillMap(input, output, disk.mesh(), map.image);
  this->ErrorKind = authalic::reportStatus(this, output, map.status, 1);
  authalic::addField(output, "Method", std::string(authalic::barycentricWeightsName(options.weights)));
  authalic::addField(output, "Residuals", map.residual);
  authalic::addField(output, "Seconds", map.seconds);
  authalic::addField(output, "Pockets", map.boundary.pocketCount);
}

void vtkBarycentricMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "StartVertex: " << this->StartVertex << "\n";
}
