#include "Core/mesh/HighGenusMesh.h"

#include <utility>

#include "Core/mesh/RequiredTopology.h"

namespace authalic {

HighGenusMesh::HighGenusMesh(TriangleMesh mesh)
    : mesh_(std::move(mesh)), topology_(mesh_.faces(), mesh_.vertexCount()) {
  requireTopology(mesh_, topology_,
                  {"A closed surface with handles is required (1 component, genus 2 or more, no boundary)", 0, 0, 2,
                   kAnyGenus});
}

}  // namespace authalic
