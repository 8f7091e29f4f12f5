#include "Reports/RepairReport.h"

#include <locale>
#include <sstream>

#include "Reports/MapReport.h"
#include "Reports/Version.h"

namespace authalic {
namespace {

const char* sizeName(RepairKind kind) {
  switch (kind) {
    case RepairKind::Hole:
    case RepairKind::Handle: return "length_mm";
    case RepairKind::StrayComponent:
    case RepairKind::InsideOutComponent: return "area_mm2";
    default: return nullptr;
  }
}

Json changeJson(const RepairChange& change) {
  Json json = Json::object()
                  .set("ids", Json::arrayOf(change.ids))
                  .set("place_mm", Json::array().add(change.place[0]).add(change.place[1]).add(change.place[2]));
  if (const char* name = sizeName(change.kind)) json.set(name, change.size);
  return json;
}

Json kindJson(const SurfaceRepair& repair, RepairKind kind, std::size_t most) {
  Json list = Json::array();
  std::size_t shown = 0;
  for (const RepairChange& change : repair.changes) {
    if (change.kind != kind || (shown >= most && kind != RepairKind::Handle)) continue;
    list.add(changeJson(change));
    ++shown;
  }
  return Json::object().set("count", repair.count(kind)).set("first", list);
}

Json optionsJson(const SurfaceRepairOptions& options) {
  return Json::object()
      .set("sew_seams", options.sewSeams)
      .set("junction_tolerance", options.junctionTolerance)
      .set("stray_share", options.strayShare)
      .set("largest_hole", options.largestHole)
      .set("largest_handle", options.largestHandle);
}

std::string placeText(const RepairChange& change) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  const char* name = sizeName(change.kind);
  if (name) text << change.size << (std::string(name) == "length_mm" ? " mm " : " mm^2 ");
  return text.str() + "at " + placeWords(change.place);
}

}  // namespace

Json repairReport(const SurfaceRepair& repair, const SurfaceRepairOptions& options, std::size_t mostChanges) {
  Json changes = Json::object();
  for (int k = 0; k < kRepairKinds; ++k) {
    const auto kind = static_cast<RepairKind>(k);
    if (repair.count(kind) > 0) changes.set(repairKindName(kind), kindJson(repair, kind, mostChanges));
  }
  return Json::object()
      .set("version", version())
      .set("status", statusName(repair.status))
      .set("rounds", repair.passes)
      .set("changed", repair.changes.size())
      .set("changes", changes)
      .set("remaining", repair.remaining())
      .set("topology", meshReport(repair.after))
      .set("options", optionsJson(options));
}

std::vector<std::string> repairLines(const SurfaceRepair& repair, std::size_t mostPlaces) {
  std::vector<std::string> lines;
  for (int k = 0; k < kRepairKinds; ++k) {
    const auto kind = static_cast<RepairKind>(k);
    const int count = repair.count(kind);
    if (count == 0) continue;
    std::string line = repairKindWords(kind, count);
    std::size_t shown = 0;
    for (const RepairChange& change : repair.changes) {
      if (change.kind != kind || shown > mostPlaces) continue;
      line += shown == mostPlaces ? ", ..." : (shown == 0 ? ": " : ", ") + placeText(change);
      ++shown;
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace authalic
