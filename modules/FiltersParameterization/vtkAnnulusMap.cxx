#include "vtkAnnulusMap.h"

#include <cmath>

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "BoundaryLoops.h"
#include "ConformalReport.h"
#include "Conversion.h"
#include "Core/base/Error.h"
#include "Core/conformal/AnnulusMap.h"
#include "Core/geometry/Areas.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkAnnulusMap);

void vtkAnnulusMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                            const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::AnnulusMesh annulus(authalic::toTriangleMesh(input));
  authalic::AnnulusMapOptions options;
  options.outerLoop = authalic::loopOf(annulus.loops(), this->OuterVertex);
  options.startVertex = this->StartVertex;
  options.unfold = this->Unfold;
  options.flow = this->FlowOptions();
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, annulus.mesh(), this->MeasureArrayName);
  const authalic::AnnulusMapResult result = authalic::annulusMap(annulus, options, execution);
  if (result.status == authalic::Status::Cancelled) throw authalic::CancelledError();
  const bool ring = this->Domain == RING;
  const authalic::PeriodicRectangle& rectangle = result.rectangle;
  const authalic::Distortion distortion =
      ring ? authalic::fillMap(input, output, annulus.mesh(), result.image, target.shares())
           : authalic::fillOpenedMap(input, output, {rectangle.faces, rectangle.originalPointIds}, rectangle.points,
                                     target.shares());
  authalic::MapReport report = authalic::describeConformalMap("annulus", result, output);
  const int pockets = ring ? result.pockets : result.rectanglePockets;
  const double circumference = std::sqrt(authalic::faceAreas(annulus.mesh()).sum() / result.modulus);
  authalic::addArray(output->GetPointData(), "LogScaleFactor", ring ? result.logScale : rectangle.logScale);
  authalic::addField(output, "ConformalModulus", result.modulus);
  authalic::addField(output, "Height", result.modulus * circumference);
  authalic::addField(output, "Circumference", circumference);
  authalic::addField(output, "InnerRadius", result.innerRadius);
  authalic::addField(output, "Straightness", result.straightness);
  authalic::addField(output, "Pockets", pockets);
  authalic::addField(output, "Cut", std::vector<double>(result.cut.begin(), result.cut.end()));
  report.more.set("conformal_modulus", result.modulus)
      .set("height", result.modulus * circumference)
      .set("circumference", circumference)
      .set("inner_radius", result.innerRadius)
      .set("straightness", result.straightness)
      .set("pockets", pockets)
      .set("cut", authalic::Json::arrayOf(result.cut));
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(annulus.mesh(), annulus.topology());
  report.options = this->DescribeFlow(ring ? "annulus" : "rectangle");
  report.options.set("outer_vertex", this->OuterVertex).set("start_vertex", this->StartVertex);
  this->Publish(output, report);
}

void vtkAnnulusMap::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Domain: " << this->Domain << "\n";
  os << indent << "OuterVertex: " << this->OuterVertex << "\n";
  os << indent << "StartVertex: " << this->StartVertex << "\n";
}
