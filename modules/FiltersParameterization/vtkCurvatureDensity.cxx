#include "vtkCurvatureDensity.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/geometry/GaussianCurvature.h"
#include "FieldArrays.h"

vtkStandardNewMacro(vtkCurvatureDensity);

void vtkCurvatureDensity::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                  const authalic::Execution&) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::TriangleMesh mesh = authalic::toTriangleMesh(input);
  const Eigen::VectorXd curvature =
      this->CurvatureArrayName.empty()
          ? authalic::gaussianCurvature(mesh, authalic::SurfaceTopology(mesh.faces(), mesh.vertexCount()))
          : authalic::toVector(
                authalic::requireArray(input->GetPointData(), this->CurvatureArrayName, 1, "curvature"));
  const Eigen::VectorXd density = authalic::curvatureDensity(mesh, curvature, this->Weight);
  output->ShallowCopy(input);
  authalic::addArray(output->GetPointData(), "CurvatureDensity", density);
}

void vtkCurvatureDensity::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CurvatureArrayName: " << this->CurvatureArrayName << "\n";
  os << indent << "Weight: " << this->Weight << "\n";
}
