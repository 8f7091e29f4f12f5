#include "Reports/MapReport.h"

#include <algorithm>

#include "Core/base/Error.h"
#include "Reports/Version.h"

namespace authalic {

namespace {

Json placeJson(const Eigen::Vector3d& place) {
  return Json::array().add(place[0]).add(place[1]).add(place[2]);
}

Json defectsJson(const std::vector<MeshDefect>& defects, std::size_t most) {
  Json list = Json::array();
  for (std::size_t k = 0; k < std::min(most, defects.size()); ++k) {
    list.add(Json::object()
                 .set("ids", Json::arrayOf(defects[k].ids))
                 .set("place_mm", placeJson(defects[k].place)));
  }
  return Json::object().set("count", defects.size()).set("first", list);
}

Json loopsJson(const std::vector<BoundaryLoopReport>& loops) {
  Json list = Json::array();
  for (const BoundaryLoopReport& loop : loops) {
    list.add(Json::object()
                 .set("vertices", loop.vertexCount)
                 .set("length_mm", loop.length)
                 .set("place_mm", placeJson(loop.place)));
  }
  return list;
}

Json componentsJson(const std::vector<ComponentReport>& components) {
  Json list = Json::array();
  for (const ComponentReport& component : components) {
    list.add(Json::object()
                 .set("vertices", component.vertexCount)
                 .set("faces", component.faceCount)
                 .set("area_mm2", component.area)
                 .set("place_mm", placeJson(component.place)));
  }
  return list;
}

Json histogramJson(const Histogram& histogram) {
  return Json::object()
      .set("edges", Json::arrayOf(histogram.edges))
      .set("counts", Json::arrayOf(histogram.counts))
      .set("below", histogram.below)
      .set("above", histogram.above)
      .set("undefined", histogram.undefined);
}

/// name_sd, name_p5 … name_p99, name_max.
void setSpread(Json& report, const std::string& name, const std::string& unit, const Spread& spread) {
  report.set(name + "_sd" + unit, spread.standardDeviation);
  for (std::size_t k = 0; k < kPercentiles.size(); ++k) {
    const std::string which = kPercentiles[k] == 100 ? "max" : "p" + std::to_string(kPercentiles[k]);
    report.set(name + "_" + which + unit, spread.percentiles[k]);
  }
}

Json secondsJson(const std::vector<std::pair<std::string, double>>& seconds) {
  Json stages = Json::object();
  double total = 0.0;
  for (const auto& [stage, value] : seconds) {
    stages.set(stage, value);
    total += value;
  }
  return stages.set("total", total);
}

}  // namespace

Json distortionReport(const DistortionSummary& summary) {
  Json report = Json::object();
  report
      .set("area_distortion", summary.areaDistortion)
      .set("angle_distortion", summary.angleDistortion)
      .set("symmetric_dirichlet", summary.symmetricDirichlet)
      .set("as_rigid_as_possible", summary.asRigidAsPossible)
      .set("area_error_l2", summary.areaErrorL2)
      .set("face_log_area_ratio_mean_abs", summary.faceMeanAbsLog)
      .set("face_log_area_ratio_max_abs", summary.faceMaxAbsLog)
      .set("face_area_ratio_sd", summary.faceStandardDeviation)
      .set("vertex_log_area_ratio_mean_abs", summary.vertexMeanAbsLog)
      .set("vertex_log_area_ratio_max_abs", summary.vertexMaxAbsLog)
      .set("angle_error_mean_degrees", summary.meanAngleError)
      .set("quasi_conformal_mean", summary.meanQuasiConformal)
      .set("beltrami_mean", summary.meanBeltrami);
  setSpread(report, "angle_error", "_degrees", summary.angleError);
  setSpread(report, "quasi_conformal", "", summary.quasiConformal);
  setSpread(report, "beltrami", "", summary.beltrami);
  return report.set("flipped_faces", summary.flippedFaces)
      .set("degenerate_faces", summary.degenerateFaces)
      .set("finite", summary.finite);
}

Json sphericalDistortionReport(const SphericalDistortion& distortion) {
  return Json::object()
      .set("area_distortion_flat", distortion.flatSummary.areaDistortion)
      .set("face_area_ratio_sd_flat", distortion.flatSummary.faceStandardDeviation)
      .set("vertex_log_area_ratio_mean_abs_flat", distortion.flatSummary.vertexMeanAbsLog)
      .set("vertex_log_area_ratio_max_abs_flat", distortion.flatSummary.vertexMaxAbsLog)
      .set("angle_error_mean_degrees_spherical", distortion.sphericalAngleError)
      .set("coverage", distortion.coverage)
      .set("flipped_faces_by_solid_angle", distortion.flippedBySolidAngle)
      .set("flipped_faces_by_volume", distortion.flippedByVolume);
}

Json histogramReport(const DistortionHistograms& histograms) {
  return Json::object()
      .set("vertex_log_area_ratio", histogramJson(histograms.vertexLogAreaRatio))
      .set("face_log_area_ratio", histogramJson(histograms.faceLogAreaRatio))
      .set("corner_log_angle_ratio", histogramJson(histograms.cornerLogAngleRatio))
      .set("angle_error_degrees", histogramJson(histograms.angleError))
      .set("beltrami", histogramJson(histograms.beltrami));
}

Json meshReport(const MeshReport& report, std::size_t mostDefects) {
  return Json::object()
      .set("summary", report.summary())
      .set("vertices", report.vertexCount)
      .set("edges", report.edgeCount)
      .set("faces", report.faceCount)
      .set("euler_characteristic", report.eulerCharacteristic)
      .set("genus", report.genus >= 0 ? Json(report.genus) : Json())
      .set("oriented_manifold", report.orientedManifold())
      .set("area_mm2", report.area)
      .set("volume_mm3", report.volume)
      .set("bounds_mm", Json::array().add(placeJson(report.lower)).add(placeJson(report.upper)))
      .set("components", componentsJson(report.components))
      .set("boundary_loops", loopsJson(report.loops))
      .set("non_manifold_edges", defectsJson(report.nonManifoldEdges, mostDefects))
      .set("inconsistent_edges", defectsJson(report.inconsistentEdges, mostDefects))
      .set("non_manifold_vertices", defectsJson(report.nonManifoldVertices, mostDefects))
      .set("isolated_vertices", defectsJson(report.isolatedVertices, mostDefects))
      .set("degenerate_faces", defectsJson(report.degenerateFaces, mostDefects))
      .set("duplicate_faces", defectsJson(report.duplicateFaces, mostDefects));
}

Json mapReport(const MapReport& report) {
  Json result = Json::object();
  result.set("version", version())
      .set("method", report.method)
      .set("status", statusName(report.status))
      .set("iterations", report.iterations)
      .set("residual_history", Json::arrayOf(report.residuals))
      .set("seconds", secondsJson(report.seconds))
      .set("metrics", distortionReport(report.metrics))
      .set("flips", report.metrics.flippedFaces);
  if (report.histograms) result.set("histograms", histogramReport(*report.histograms));
  result.set("topology", meshReport(report.topology))
      .set("options", report.options);
  const Json::Object* more = std::get_if<Json::Object>(&report.more.value());
  if (more == nullptr) throw InvalidArgument("The further members of a map's report must be a JSON object.");
  const Json::Object fixed = std::get<Json::Object>(result.value());
  for (const auto& [key, value] : *more) {
    const std::string& name = key;
    if (std::any_of(fixed.begin(), fixed.end(),
                    [&](const Json::Member& member) { return member.first == name; })) {
      throw InvalidArgument("A map's report has its own member '" + name + "'; give yours another name.");
    }
    result.set(name, value);
  }
  return result;
}

}  // namespace authalic
