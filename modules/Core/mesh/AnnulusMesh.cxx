#include "Core/mesh/AnnulusMesh.h"

#include <utility>

#include "Core/mesh/RequiredTopology.h"

namespace authalic {

AnnulusMesh::AnnulusMesh(TriangleMesh mesh) : mesh_(std::move(mesh)), topology_(mesh_.faces(), mesh_.vertexCount()) {
  requireTopology(mesh_, topology_,
                  {"A topological annulus is required (1 component, genus 0, 2 boundary loops)", 2, 2});
}

}  // namespace authalic
