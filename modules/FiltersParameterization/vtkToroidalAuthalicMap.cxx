#include "vtkToroidalAuthalicMap.h"

#include <vector>

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "AuthalicReport.h"
#include "Conversion.h"
#include "Core/authalic/ToroidalAuthalicMap.h"
#include "Core/mesh/TorusMesh.h"
#include "FieldArrays.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkToroidalAuthalicMap);

void vtkToroidalAuthalicMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                     const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::AuthalicMapOptions options = this->Options();
  const authalic::TorusMesh torus(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, torus.mesh(), this->MeasureArrayName);
  const authalic::ToroidalAuthalicMapResult result =
      authalic::toroidalAuthalicMap(torus, target, options, execution);
  const authalic::Distortion distortion = authalic::fillOpenedMap(
      input, output, {result.cut.faces, result.cut.originalPointIds}, result.image, target.shares());
  authalic::MapReport report = authalic::describeAuthalicMap(result, output);
  const std::vector<double> periods(result.lattice.data(), result.lattice.data() + 4);  // column by column
  authalic::addField(output, "Periods", periods);
  authalic::addField(output, "SeamError", result.seamError);
  report.more.set("periods", authalic::Json::arrayOf(periods));
  report.more.set("seam_error", result.seamError);
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(torus.mesh(), torus.topology());
  report.options.set("domain", "torus");
  report.options.set("measure", this->MeasureArrayName);
  authalic::addAuthalicOptions(report.options, options);
  this->Publish(output, report);
}
