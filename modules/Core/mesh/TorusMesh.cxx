#include "Core/mesh/TorusMesh.h"

#include <utility>

#include "Core/mesh/RequiredTopology.h"

namespace authalic {

TorusMesh::TorusMesh(TriangleMesh mesh) : mesh_(std::move(mesh)), topology_(mesh_.faces(), mesh_.vertexCount()) {
  requireTopology(mesh_, topology_,
                  {"A topological torus is required (1 component, genus 1, no boundary)", 0, 0, 1});
}

}  // namespace authalic
