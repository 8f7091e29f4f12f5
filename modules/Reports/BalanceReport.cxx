#include "Reports/BalanceReport.h"

#include <cstdint>
#include <string>
#include <vector>

#include "Reports/Version.h"

namespace authalic {
namespace {

template <class T, class Get>
Table::Values values(const BalanceCurve& curve, const Get& get) {
  std::vector<T> result;
  result.reserve(curve.points.size());
  for (const BalancePoint& point : curve.points) result.push_back(get(point));
  return result;
}

void addMetrics(Table& table, const BalanceCurve& curve, const std::string& prefix, const std::string& which,
                DistortionSummary BalancePoint::*map) {
  const auto add = [&](const char* name, const char* what, const char* units, double DistortionSummary::*metric) {
    table.add(prefix + name, values<double>(curve, [=](const BalancePoint& point) { return (point.*map).*metric; }),
              {"", what + which, units, {}});
  };
  add("angle_distortion", "Mean of s1/s2 + s2/s1 over the area, ideal 2, ", "1", &DistortionSummary::angleDistortion);
  add("area_distortion", "Mean of r + 1/r over the measure, r image share / target share of a face, ideal 2, ", "1",
      &DistortionSummary::areaDistortion);
  add("angle_error_mean_degrees", "Mean difference of a corner's angle in image and surface, ", "degree",
      &DistortionSummary::meanAngleError);
  table.add(prefix + "flipped_faces",
            values<std::int64_t>(curve, [=](const BalancePoint& point) { return (point.*map).flippedFaces; }),
            {"", "Faces folded in the image, " + which, "", {}});
}

}  // namespace

Table balanceTable(const BalanceCurve& curve) {
  Table table;
  table.add("balance", values<double>(curve, [](const BalancePoint& point) { return point.balance; }),
            {"Balance", "Weight of the areas: 0 = conformal, 1 = area-preserving", "1", {}});
  addMetrics(table, curve, "", "of the map", &BalancePoint::metrics);
  addMetrics(table, curve, "transport_", "of the map by transport alone", &BalancePoint::transport);
  table.add("status",
            values<std::string>(curve, [](const BalancePoint& point) { return statusName(point.status); }),
            {"", "Whether transport and finish reached their tolerances", "", {}});
  return table;
}

Json balanceReport(const BalanceCurve& curve, const Json& options) {
  Json maps = Json::array(), seconds = Json::object(), about = Json::object();
  double total = curve.startSeconds;
  for (const BalancePoint& point : curve.points) {
    maps.add(point.seconds);
    total += point.seconds;
  }
  seconds.set("conformal", curve.startSeconds).set("maps", maps).set("total", total);
  about.set("Curve", Json::object()
                         .set("version", version())
                         .set("status", statusName(curve.status))
                         .set("seconds", seconds)
                         .set("options", options));
  return balanceTable(curve).sidecar(about);
}

}  // namespace authalic
