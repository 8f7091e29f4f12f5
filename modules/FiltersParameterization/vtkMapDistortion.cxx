#include "vtkMapDistortion.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "Reports/MapReport.h"

vtkStandardNewMacro(vtkMapDistortion);

namespace {

void addDetails(vtkPolyData* map, const authalic::DistortionArrays& arrays) {
  vtkNew<vtkDoubleArray> beltrami;
  beltrami->SetName("Beltrami");
  beltrami->SetNumberOfComponents(2);
  beltrami->SetNumberOfTuples(arrays.beltrami.size());
  for (Eigen::Index f = 0; f < arrays.beltrami.size(); ++f) {
    beltrami->SetTuple2(f, arrays.beltrami[f].real(), arrays.beltrami[f].imag());
  }
  map->GetCellData()->AddArray(beltrami);
  authalic::addArray(map->GetCellData(), "SigmaMax", arrays.sigmaMax);
  authalic::addArray(map->GetCellData(), "SigmaMin", arrays.sigmaMin);
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
  using namespace authalic;
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
  const Distortion distortion = fillMap(map, output, surface, toPlanarPoints(map), target);
  if (this->Details) addDetails(output, distortion.arrays);
  this->Report = distortionReport(distortion.summary).text();
}

void vtkMapDistortion::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeasureArrayName: " << this->MeasureArrayName << "\n";
  os << indent << "Details: " << (this->Details ? "On" : "Off") << "\n";
}
