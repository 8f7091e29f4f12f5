#include "Core/mesh/SphereMesh.h"

#include <utility>

#include "Core/mesh/RequiredTopology.h"

namespace authalic {

SphereMesh::SphereMesh(TriangleMesh mesh) : mesh_(std::move(mesh)), topology_(mesh_.faces(), mesh_.vertexCount()) {
  requireTopology(mesh_, topology_, {"A topological sphere is required (1 component, genus 0, no boundary)", 0, 0});
}

}  // namespace authalic
