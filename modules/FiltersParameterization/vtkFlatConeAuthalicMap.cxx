#include "vtkFlatConeAuthalicMap.h"

#include <cmath>
#include <vector>

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "AuthalicReport.h"
#include "Conversion.h"
#include "Core/authalic/FlatConeAuthalicMap.h"
#include "FieldArrays.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkFlatConeAuthalicMap);

namespace {

Eigen::MatrixXd seamPairs(const std::vector<authalic::ConeSeam>& seams) {
  std::vector<Eigen::RowVector3d> rows;
  for (std::size_t s = 0; s < seams.size(); ++s) {
    for (std::size_t i = 0; i < seams[s].side.size(); ++i) {
      rows.emplace_back(double(s), seams[s].side[i], seams[s].otherSide[i]);
    }
  }
  Eigen::MatrixXd pairs(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) pairs.row(static_cast<Eigen::Index>(i)) = rows[i];
  return pairs;
}

Eigen::MatrixXd seamMotions(const std::vector<authalic::ConeSeam>& seams) {
  Eigen::MatrixXd motions(static_cast<Eigen::Index>(seams.size()), 3);
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const authalic::RigidMotion& motion = seams[s].motion;
    motions.row(static_cast<Eigen::Index>(s)) << std::arg(motion.turn), motion.shift.real(), motion.shift.imag();
  }
  return motions;
}

std::vector<double> coneAngles(const authalic::FlatConeSurface& flat) {
  std::vector<double> angles(static_cast<std::size_t>(flat.places.rows()), 2 * M_PI);
  for (std::size_t i = 0; i < flat.cones.size(); ++i) {
    angles[static_cast<std::size_t>(flat.cones[i])] -= flat.curvature[i];
  }
  std::vector<double> opened;
  for (const int v : flat.cut.originalPointIds) opened.push_back(angles[static_cast<std::size_t>(v)]);
  return opened;
}

authalic::Json conesOf(const authalic::FlatConeSurface& flat) {
  authalic::Json cones = authalic::Json::array();
  for (std::size_t i = 0; i < flat.cones.size(); ++i) {
    authalic::Json cone = authalic::Json::object();
    cone.set("vertex", flat.cones[i]);
    cone.set("angle", 2 * M_PI - flat.curvature[i]);
    cones.add(std::move(cone));
  }
  return cones;
}

authalic::Json seamsOf(const std::vector<authalic::ConeSeam>& seams) {
  authalic::Json list = authalic::Json::array();
  for (const authalic::ConeSeam& seam : seams) {
    authalic::Json entry = authalic::Json::object();
    entry.set("edges", static_cast<int>(seam.side.size()) - 1);
    entry.set("angle", std::arg(seam.motion.turn));
    const std::vector<double> translation{seam.motion.shift.real(), seam.motion.shift.imag()};
    entry.set("translation", authalic::Json::arrayOf(translation));
    entry.set("error", seam.error);
    list.add(std::move(entry));
  }
  return list;
}

}  // namespace

void vtkFlatConeAuthalicMap::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                     const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::AuthalicMapOptions options = this->Options();
  const authalic::HighGenusMesh surface(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, surface.mesh(), this->MeasureArrayName);
  const authalic::FlatConeAuthalicMapResult result =
      authalic::flatConeAuthalicMap(surface, target, options, execution);
  const authalic::CutGraph& cut = result.flat.cut;
  const authalic::Distortion distortion =
      authalic::fillOpenedMap(input, output, {cut.faces, cut.originalPointIds}, result.image, target.shares());
  authalic::MapReport report = authalic::describeAuthalicMap(result, output);
  authalic::addArray(output->GetPointData(), "ConeAngle", coneAngles(result.flat));
  authalic::addField(output, "SeamPairs", seamPairs(result.seams));
  authalic::addField(output, "SeamMotions", seamMotions(result.seams));
  authalic::addField(output, "SeamError", result.seamError);
  authalic::addField(output, "AngleError", result.angleError);
  report.more.set("seam_error", result.seamError);
  report.more.set("angle_error", result.angleError);
  report.more.set("cones", conesOf(result.flat));
  report.more.set("seams", seamsOf(result.seams));
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(surface.mesh(), surface.topology());
  report.options.set("domain", "flat-cones");
  report.options.set("measure", this->MeasureArrayName);
  authalic::addAuthalicOptions(report.options, options);
  this->Publish(output, report);
}
