#include "Core/mesh/DiskMesh.h"

#include <sstream>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/mesh/MeshReport.h"

namespace authalic {

namespace {

std::string at(const Eigen::Vector3d& place) {
  std::ostringstream text;
  text.precision(1);
  text << std::fixed << "(" << place.x() << ", " << place.y() << ", " << place.z() << ") mm";
  return text.str();
}

/// Where the first reason not to be a disk lies and what would help; empty for a disk.
std::string obstacle(const MeshReport& report) {
  const auto first = [](const std::vector<MeshDefect>& defects, const std::string& what, const std::string& advice) {
    return what + " at " + at(defects.front().place) + "; " + advice;
  };
  if (!report.nonManifoldEdges.empty()) {
    return first(report.nonManifoldEdges, "an edge with more than two faces", "repair the surface first");
  }
  if (!report.inconsistentEdges.empty()) {
    return first(report.inconsistentEdges, "two neighbouring faces with opposite orientation",
                 "orient the surface consistently (a Möbius band cannot be)");
  }
  if (!report.nonManifoldVertices.empty()) {
    return first(report.nonManifoldVertices, "a vertex where the surface touches itself", "repair the surface first");
  }
  if (report.components.size() != 1) {
    return "a second component centred at " + at(report.components[1].place) + "; keep the largest one ('authalic cut')";
  }
  if (!report.isolatedVertices.empty()) {
    return first(report.isolatedVertices, "a vertex that no face uses", "drop such vertices ('authalic cut')");
  }
  if (report.loops.empty()) return "no boundary; open the surface first ('authalic cut')";
  if (report.loops.size() > 1) {
    return "a second boundary loop near " + at(report.loops[1].place) + "; close all loops but one";
  }
  if (report.genus != 0) return "handles (genus " + std::to_string(report.genus) + "); cut or repair them first";
  return {};
}

}  // namespace

DiskMesh::DiskMesh(TriangleMesh mesh) : mesh_(std::move(mesh)), topology_(mesh_.faces(), mesh_.vertexCount()) {
  const bool disk = topology_.manifold() && topology_.componentCount() == 1 && topology_.isolatedVertices().empty() &&
                    topology_.boundaryLoops().size() == 1 && topology_.eulerCharacteristic() == 1;
  if (disk) return;
  const MeshReport report = inspect(mesh_, topology_);
  throw TopologyError("A topological disk is required (1 component, genus 0, 1 boundary loop), but the surface has " +
                      report.summary() + ": found " + obstacle(report) + ".");
}

}  // namespace authalic
