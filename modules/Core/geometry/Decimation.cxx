#include "Core/geometry/Decimation.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <string>
#include <utility>
#include <vector>

#include "Core/base/Error.h"
#include "Core/mesh/SurfaceTopology.h"

namespace authalic {

namespace {

namespace sms = CGAL::Surface_mesh_simplification;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

Mesh toSurfaceMesh(const TriangleMesh& mesh) {
  Mesh out;
  std::vector<Mesh::Vertex_index> id(static_cast<std::size_t>(mesh.vertexCount()));
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      Mesh::Vertex_index& v = id[static_cast<std::size_t>(mesh.faces()(f, k))];
      if (!v.is_valid()) {
        const Eigen::Vector3d p = mesh.corner(f, k);
        v = out.add_vertex({p[0], p[1], p[2]});
      }
    }
    const auto corner = [&](int k) { return id[static_cast<std::size_t>(mesh.faces()(f, k))]; };
    out.add_face(corner(0), corner(1), corner(2));
  }
  return out;
}

TriangleMesh fromSurfaceMesh(Mesh& mesh) {
  mesh.collect_garbage();
  Points3 points(static_cast<Eigen::Index>(mesh.number_of_vertices()), 3);
  Eigen::Index row = 0;
  for (const auto v : mesh.vertices())
    points.row(row++) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
  Faces faces(static_cast<Eigen::Index>(mesh.number_of_faces()), 3);
  row = 0;
  for (const auto f : mesh.faces()) {
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      faces(row, k++) = static_cast<int>(v.idx());
    ++row;
  }
  return TriangleMesh(std::move(points), std::move(faces));
}

// Tells the caller how far the collapses are, and stops them by exception on request.
struct ProgressVisitor : sms::Edge_collapse_visitor_base<Mesh> {
  ProgressVisitor(const Execution& where, std::size_t from, std::size_t to)
      : execution(&where), initial(from), target(to) {}
  void OnSelected(const Profile&, boost::optional<double>, std::size_t, std::size_t current) const {
    if (current % 8192 != 0) return;
    execution->throwIfCancelled();
    execution->report(static_cast<double>(initial - current) / static_cast<double>(initial - target),
                      "decimation");
  }
  const Execution* execution;
  std::size_t initial, target;
};

void requireManifold(const TriangleMesh& mesh) {
  const SurfaceTopology topology(mesh.faces(), mesh.vertexCount());
  if (topology.manifold()) return;
  throw TopologyError(
      "A consistently oriented manifold surface is required for decimation, but there are " +
      std::to_string(topology.nonManifoldEdges().size() + topology.inconsistentEdges().size()) +
      " bad edges and " + std::to_string(topology.nonManifoldVertices().size()) +
      " bad vertices; repair the surface first.");
}

}  // namespace

TriangleMesh decimate(const TriangleMesh& mesh, int targetFaces, const Execution& execution) {
  if (targetFaces < 4) {
    throw InvalidArgument("At least 4 faces must be asked of decimation, but the target is " +
                          std::to_string(targetFaces) + ".");
  }
  if (mesh.faceCount() <= targetFaces) return mesh;
  requireManifold(mesh);
  Mesh surface = toSurfaceMesh(mesh);
  // On a closed surface faces = 2/3 edges; a boundary only lowers the number of faces for the same number of
  // edges.
  const std::size_t edges = static_cast<std::size_t>(targetFaces) * 3 / 2 + 1;
  const ProgressVisitor visitor(execution, surface.number_of_edges(), edges);
  sms::edge_collapse(surface, sms::Count_stop_predicate<Mesh>(edges),
                     CGAL::parameters::get_cost(sms::LindstromTurk_cost<Mesh>())
                         .get_placement(sms::LindstromTurk_placement<Mesh>())
                         .filter(sms::Bounded_normal_change_filter<>())
                         .visitor(visitor));
  return fromSurfaceMesh(surface);
}

}  // namespace authalic
