#include "vtkMapDistortion.h"

#include <utility>

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/distortion/SphericalDistortion.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkMapDistortion);

namespace {

using namespace authalic;

/// Of a planar map, or of one to a sphere around 0.
Distortion measure(vtkPolyData* map, vtkPolyData* output, const TriangleMesh& surface, const Eigen::VectorXd& target) {
  const Points3 image = toPoints(map);
  if (image.col(2).isZero(0)) return fillMap(map, output, surface, Points2(image.leftCols<2>()), target);
  SphericalDistortion distortion = fillMap(map, output, surface, ontoUnitSphere(image), target);
  setPoints(output, image);
  return {std::move(distortion.arrays), distortion.summary};
}

}  // namespace

vtkMapDistortion::vtkMapDistortion() { this->SetNumberOfInputPorts(2); }

int vtkMapDistortion::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkMapDistortion::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                               const authalic::Execution&) {
  vtkPolyData* map = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->Report.clear();
  const TriangleMesh image = toTriangleMesh(map, "map");
  const TriangleMesh surface = given ? toTriangleMesh(given) : surfaceOfMap(map);
  if (surface.faces() != image.faces()) {
    throw GeometryError("The map and the surface must have the same triangles in the same order; they have " +
                        std::to_string(image.faceCount()) + " and " + std::to_string(surface.faceCount()) +
                        " triangles, or other corners.");
  }
  Eigen::VectorXd target;
  if (!this->MeasureArrayName.empty()) {
    target = toVector(requireArray(map->GetCellData(), this->MeasureArrayName, 1, "measure"));
  }
  const Distortion distortion = measure(map, output, surface, target);
  if (this->Details) {
    addArray(output->GetCellData(), "SigmaMax", distortion.arrays.sigmaMax);
    addArray(output->GetCellData(), "SigmaMin", distortion.arrays.sigmaMin);
  }
  this->Report = distortionReport(distortion.summary).text();
}

void vtkMapDistortion::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeasureArrayName: " << this->MeasureArrayName << "\n";
  os << indent << "Details: " << (this->Details ? "On" : "Off") << "\n";
}
