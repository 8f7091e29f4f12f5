#include "Core/topology/LoopLength.h"

namespace authalic {

double loopLength(const TriangleMesh& mesh, const std::vector<int>& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += (mesh.point(loop[(i + 1) % loop.size()]) - mesh.point(loop[i])).norm();
  }
  return length;
}

std::size_t longestLoop(const TriangleMesh& mesh, const std::vector<std::vector<int>>& loops) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const double length = loopLength(mesh, loops[k]);
    if (length > most) {
      most = length;
      longest = k;
    }
  }
  return longest;
}

}  // namespace authalic
