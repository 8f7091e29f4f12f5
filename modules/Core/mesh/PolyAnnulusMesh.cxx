#include "Core/mesh/PolyAnnulusMesh.h"

#include <utility>

#include "Core/mesh/RequiredTopology.h"

namespace authalic {

PolyAnnulusMesh::PolyAnnulusMesh(TriangleMesh mesh)
    : mesh_(std::move(mesh)), topology_(mesh_.faces(), mesh_.vertexCount()) {
  requireTopology(
      mesh_, topology_,
      {"A poly-annulus is required (1 component, genus 0, at least 1 boundary loop)", 1, kAnyNumberOfLoops});
}

}  // namespace authalic
