#include "Core/mesh/DiskMesh.h"

#include <utility>

#include "Core/mesh/RequiredTopology.h"

namespace authalic {

DiskMesh::DiskMesh(TriangleMesh mesh) : mesh_(std::move(mesh)), topology_(mesh_.faces(), mesh_.vertexCount()) {
  requireTopology(mesh_, topology_, {"A topological disk is required (1 component, genus 0, 1 boundary loop)", 1, 1});
}

}  // namespace authalic
