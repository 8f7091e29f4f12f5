#include "Core/mesh/MeshReport.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

namespace authalic {

namespace {

/// Faces whose area is below this fraction of their longest edge squared have no usable normal.
constexpr double kDegenerate = 1e-12;

struct FaceShape {
  double area;
  double longestSquared;
  Eigen::Vector3d centroid;
};

FaceShape faceShape(const TriangleMesh& mesh, int face) {
  const Eigen::Vector3d a = mesh.corner(face, 0), b = mesh.corner(face, 1), c = mesh.corner(face, 2);
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return {0.5 * (b - a).cross(c - a).norm(), longest, (a + b + c) / 3.0};
}

std::vector<MeshDefect> edgeDefects(const TriangleMesh& mesh, const std::vector<std::array<int, 2>>& edges) {
  std::vector<MeshDefect> defects;
  defects.reserve(edges.size());
  for (const auto& edge : edges) {
    defects.push_back({{edge[0], edge[1]}, 0.5 * (mesh.point(edge[0]) + mesh.point(edge[1]))});
  }
  return defects;
}

std::vector<MeshDefect> vertexDefects(const TriangleMesh& mesh, const std::vector<int>& vertices) {
  std::vector<MeshDefect> defects;
  defects.reserve(vertices.size());
  for (const int vertex : vertices) defects.push_back({{vertex}, mesh.point(vertex)});
  return defects;
}

void measureFaces(const TriangleMesh& mesh, const SurfaceTopology& topology, MeshReport& report) {
  report.components.resize(static_cast<std::size_t>(topology.componentCount()));
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const FaceShape shape = faceShape(mesh, f);
    ComponentReport& component =
        report.components[static_cast<std::size_t>(topology.faceComponents()[static_cast<std::size_t>(f)])];
    ++component.faceCount;
    component.area += shape.area;
    component.place += shape.area * shape.centroid;
    report.area += shape.area;
    report.volume += mesh.corner(f, 0).dot(mesh.corner(f, 1).cross(mesh.corner(f, 2))) / 6.0;
    if (shape.area <= kDegenerate * shape.longestSquared) report.degenerateFaces.push_back({{f}, shape.centroid});
  }
  for (ComponentReport& component : report.components) {
    if (component.area > 0) component.place /= component.area;
  }
}

void countVertices(const TriangleMesh& mesh, const SurfaceTopology& topology, MeshReport& report) {
  std::vector<int> componentOf(static_cast<std::size_t>(mesh.vertexCount()), -1);
  for (int h = 0; h < 3 * mesh.faceCount(); ++h) {
    componentOf[static_cast<std::size_t>(topology.tail(h))] =
        topology.faceComponents()[static_cast<std::size_t>(h / 3)];
  }
  for (const int component : componentOf) {
    if (component >= 0) ++report.components[static_cast<std::size_t>(component)].vertexCount;
  }
  std::stable_sort(report.components.begin(), report.components.end(),
                   [](const auto& a, const auto& b) { return a.area > b.area; });
}

void findDuplicates(const TriangleMesh& mesh, MeshReport& report) {
  std::vector<std::pair<std::array<int, 3>, int>> keyed;
  keyed.reserve(static_cast<std::size_t>(mesh.faceCount()));
  for (int f = 0; f < mesh.faceCount(); ++f) {
    std::array<int, 3> key{mesh.faces()(f, 0), mesh.faces()(f, 1), mesh.faces()(f, 2)};
    std::sort(key.begin(), key.end());
    keyed.emplace_back(key, f);
  }
  std::sort(keyed.begin(), keyed.end());
  for (std::size_t i = 1; i < keyed.size(); ++i) {
    if (keyed[i].first == keyed[i - 1].first) {
      report.duplicateFaces.push_back({{keyed[i].second}, faceShape(mesh, keyed[i].second).centroid});
    }
  }
}

void measureLoops(const TriangleMesh& mesh, const SurfaceTopology& topology, MeshReport& report) {
  for (const std::vector<int>& loop : topology.boundaryLoops()) {
    BoundaryLoopReport entry;
    entry.vertexCount = static_cast<int>(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      entry.length += (mesh.point(loop[(i + 1) % loop.size()]) - mesh.point(loop[i])).norm();
      entry.place += mesh.point(loop[i]) / static_cast<double>(loop.size());
    }
    report.loops.push_back(entry);
  }
  std::stable_sort(report.loops.begin(), report.loops.end(),
                   [](const auto& a, const auto& b) { return a.length > b.length; });
}

std::string counted(std::size_t count, const std::string& noun, const std::string& plural) {
  return std::to_string(count) + " " + (count == 1 ? noun : plural);
}

}  // namespace

std::string MeshReport::summary() const {
  std::string text = counted(components.size(), "component", "components") +
                     ", Euler characteristic " + std::to_string(eulerCharacteristic);
  if (genus >= 0) text += ", genus " + std::to_string(genus);
  text += ", " + counted(loops.size(), "boundary loop", "boundary loops");
  const auto add = [&text](const std::vector<MeshDefect>& defects, const char* noun, const char* plural) {
    if (!defects.empty()) text += ", " + counted(defects.size(), noun, plural);
  };
  add(nonManifoldEdges, "non-manifold edge", "non-manifold edges");
  add(inconsistentEdges, "inconsistently oriented edge", "inconsistently oriented edges");
  add(nonManifoldVertices, "non-manifold vertex", "non-manifold vertices");
  add(isolatedVertices, "isolated vertex", "isolated vertices");
  add(degenerateFaces, "degenerate face", "degenerate faces");
  add(duplicateFaces, "duplicate face", "duplicate faces");
  return text;
}

MeshReport inspect(const TriangleMesh& mesh) {
  return inspect(mesh, SurfaceTopology(mesh.faces(), mesh.vertexCount()));
}

MeshReport inspect(const TriangleMesh& mesh, const SurfaceTopology& topology) {
  MeshReport report;
  report.vertexCount = mesh.vertexCount();
  report.edgeCount = topology.edgeCount();
  report.faceCount = mesh.faceCount();
  report.eulerCharacteristic = topology.eulerCharacteristic();
  report.lower = mesh.points().colwise().minCoeff().transpose();
  report.upper = mesh.points().colwise().maxCoeff().transpose();
  measureFaces(mesh, topology, report);
  countVertices(mesh, topology, report);
  measureLoops(mesh, topology, report);
  findDuplicates(mesh, report);
  report.nonManifoldEdges = edgeDefects(mesh, topology.nonManifoldEdges());
  report.inconsistentEdges = edgeDefects(mesh, topology.inconsistentEdges());
  report.nonManifoldVertices = vertexDefects(mesh, topology.nonManifoldVertices());
  report.isolatedVertices = vertexDefects(mesh, topology.isolatedVertices());
  if (report.orientedManifold()) {
    report.genus = (2 * topology.componentCount() - report.eulerCharacteristic -
                    static_cast<int>(topology.boundaryLoops().size())) / 2;
  }
  return report;
}

}  // namespace authalic
