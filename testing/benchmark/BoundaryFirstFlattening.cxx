/// bff SURFACE MAP.obj: geometry-central's boundary first flattening, to be timed beside `authalic map riemann`.
#include <fstream>
#include <iostream>

#include <geometrycentral/surface/boundary_first_flattening.h>
#include <geometrycentral/surface/manifold_surface_mesh.h>
#include <geometrycentral/surface/meshio.h>
#include <geometrycentral/surface/vertex_position_geometry.h>

int main(int count, char** words) {
  if (count != 3) {
    std::cerr << "bff: SURFACE and MAP.obj are required.\n";
    return 2;
  }
  using namespace geometrycentral::surface;
  const auto [mesh, geometry] = readManifoldSurfaceMesh(words[1]);
  const auto image = parameterizeBFF(*mesh, *geometry);
  std::ofstream out(words[2]);
  out.precision(17);
  for (const Vertex v : mesh->vertices()) out << "v " << image[v].x << ' ' << image[v].y << " 0\n";
  for (const Face f : mesh->faces()) {
    out << 'f';
    for (const Vertex v : f.adjacentVertices()) out << ' ' << v.getIndex() + 1;
    out << '\n';
  }
  return 0;
}
