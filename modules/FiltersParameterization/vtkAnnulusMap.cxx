#include "vtkAnnulusMap.h"

#include <cmath>

#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "ConformalArrays.h"
#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "FieldArrays.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkAnnulusMap);

namespace {

void addModulus(const authalic::AnnulusMapResult& result, const authalic::TriangleMesh& surface, vtkPolyData* map,
                authalic::MapReport& report) {
  const double circumference = std::sqrt(authalic::faceAreas(surface).sum() / result.modulus);
  const auto both = [&](const char* array, const char* member, double value) {
    authalic::addField(map, array, value);
    report.more.set(member, value);
  };
  both("ConformalModulus", "conformal_modulus", result.modulus);
  both("Height", "height", result.modulus * circumference);
  both("Circumference", "circumference", circumference);
  both("InnerRadius", "inner_radius", result.innerRadius);
  both("Straightness", "straightness", result.straightness);
  vtkNew<vtkIdTypeArray> cut;
  cut->SetName("Cut");
  for (const int vertex : result.cut) cut->InsertNextValue(vertex);
  map->GetFieldData()->AddArray(cut);
  report.more.set("cut", authalic::Json::arrayOf(result.cut));
}

// What differs between ring and rectangle goes into the places of the ring.
authalic::Distortion fillRectangle(vtkPolyData* input, vtkPolyData* output, const Eigen::VectorXd& target,
                                   authalic::AnnulusMapResult& result) {
  result.logScale = result.rectangle.logScale;
  result.pockets = result.rectanglePockets;
  return authalic::fillOpenedMap(input, output, {result.rectangle.faces, result.rectangle.originalPointIds},
                                 result.rectangle.points, target);
}

}  // namespace

authalic::AnnulusMapOptions vtkAnnulusMap::Options(const std::vector<std::vector<int>>& loops) const {
  authalic::AnnulusMapOptions options;
  options.outerLoop = authalic::loopThrough(this->OuterVertex, loops);
  options.startVertex = this->StartVertex;
  options.refine = this->Refine;
  options.unfold = this->Unfold;
  options.flow = this->FlowOptions();
  if (this->Refine && this->Domain == RECTANGLE) {
    throw authalic::InvalidArgument(
        "The domain 'annulus' is required for a common refinement, but it is 'rectangle'.");
  }
  return options;
}

void vtkAnnulusMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                            const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::AnnulusMesh annulus(authalic::toTriangleMesh(input));
  const authalic::AnnulusMapOptions options = this->Options(annulus.loops());
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, annulus.mesh(), this->MeasureArrayName);
  authalic::AnnulusMapResult map = authalic::annulusMap(annulus, options, execution);
  if (map.image.rows() == 0) throw authalic::CancelledError();
  const authalic::Distortion distortion =
      this->Domain == RECTANGLE ? fillRectangle(input, output, target.faces(), map)
                                : authalic::fillMap(input, output, annulus.mesh(), map.image, target.faces());
  authalic::MapReport report = authalic::describeFlowMap(map, output);
  authalic::fillRefinement(map.refinement, output, vtkPolyData::GetData(outputs, 1), report);
  addModulus(map, annulus.mesh(), output, report);
  report.method = "annulus";
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(annulus.mesh(), annulus.topology());
  report.options = this->DescribeOptions();
  report.options.set("domain", this->Domain == RECTANGLE ? "rectangle" : "annulus");
  report.options.set("outer_vertex", this->OuterVertex);
  this->Publish(output, report);
}

void vtkAnnulusMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Domain: " << this->Domain << "\n";
  os << indent << "OuterVertex: " << this->OuterVertex << "\n";
}
