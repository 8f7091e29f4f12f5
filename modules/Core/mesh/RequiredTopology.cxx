#include "Core/mesh/RequiredTopology.h"

#include <sstream>
#include <string>
#include <vector>

#include "Core/base/Error.h"
#include "Core/mesh/HandleLoop.h"
#include "Core/mesh/MeshReport.h"

namespace authalic {
namespace {

std::string at(const Eigen::Vector3d& place) {
  std::ostringstream text;
  text.precision(1);
  text << std::fixed << "(" << place.x() << ", " << place.y() << ", " << place.z() << ") mm";
  return text.str();
}

/// A loop of edges around or through a handle, in words.
std::string loopOf(const TriangleMesh& mesh, const SurfaceTopology& topology) {
  const std::vector<int> loop = handleLoop(mesh, topology);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int vertex : loop) middle += mesh.point(vertex) / static_cast<double>(loop.size());
  return "a loop of " + std::to_string(loop.size()) + " edges around " + at(middle);
}

std::string placesOf(const std::vector<BoundaryLoopReport>& loops) {
  std::string places;
  for (const BoundaryLoopReport& loop : loops) places += (places.empty() ? "" : ", ") + at(loop.place);
  return places;
}

/// Where the first reason not to be such a surface lies and what would help.
std::string obstacle(const TriangleMesh& mesh, const SurfaceTopology& topology, const MeshReport& report,
                     const RequiredTopology& required) {
  const auto first = [](const std::vector<MeshDefect>& defects, const std::string& what, const std::string& advice) {
    return what + " at " + at(defects.front().place) + "; " + advice;
  };
  if (!report.nonManifoldEdges.empty()) {
    return first(report.nonManifoldEdges, "an edge with more than two faces",
                 "repair the surface first ('authalic repair')");
  }
  if (!report.inconsistentEdges.empty()) {
    return first(report.inconsistentEdges, "two neighbouring faces with opposite orientation",
                 "orient the surface consistently ('authalic repair'; a Möbius band cannot be)");
  }
  if (!report.nonManifoldVertices.empty()) {
    return first(report.nonManifoldVertices, "a vertex where the surface touches itself",
                 "repair the surface first ('authalic repair')");
  }
  if (report.components.size() != 1) {
    return "a second component centred at " + at(report.components[1].place) +
           "; keep the largest one ('authalic repair --stray-share 1')";
  }
  if (!report.isolatedVertices.empty()) {
    return first(report.isolatedVertices, "a vertex that no face uses", "drop such vertices ('authalic repair')");
  }
  if (report.loops.size() < required.fewestLoops) {
    return report.loops.empty() ? "no boundary; open the surface first ('authalic cut')"
                                : "too few boundary loops, only those near " + placesOf(report.loops) +
                                      "; cut another opening ('authalic cut'), or take a method for fewer loops";
  }
  if (report.loops.size() > required.mostLoops) {
    return "a boundary loop too many near " + at(report.loops[required.mostLoops].place) +
           "; close it, or take a method for more loops ('authalic info' lists the loops)";
  }
  if (report.genus < required.genus) {
    return "too few handles (genus " + std::to_string(report.genus) + "); take a method for this genus" +
           (required.mostGenus == kAnyGenus ? ", for a " + std::string(report.genus == 0 ? "sphere" : "torus") : "");
  }
  if (report.genus > required.mostGenus)
    return "handles (genus " + std::to_string(report.genus) + "), one of them along " + loopOf(mesh, topology) +
           "; cut or repair them first ('authalic repair')";
  return {};
}

}  // namespace

void requireTopology(const TriangleMesh& mesh, const SurfaceTopology& topology, const RequiredTopology& required) {
  const std::size_t loops = topology.boundaryLoops().size();
  const int handles = (2 - static_cast<int>(loops) - topology.eulerCharacteristic()) / 2;
  const bool fits = topology.manifold() && topology.componentCount() == 1 && topology.isolatedVertices().empty() &&
                    loops >= required.fewestLoops && loops <= required.mostLoops &&
                    handles >= required.genus && handles <= required.mostGenus;
  if (fits) return;
  const MeshReport report = inspect(mesh, topology);
  throw TopologyError(std::string(required.words) + ", but the surface has " + report.summary() + ": found " +
                      obstacle(mesh, topology, report, required) + ".");
}

}  // namespace authalic
