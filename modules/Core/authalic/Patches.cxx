#include "Core/authalic/Patches.h"

#include <numeric>

namespace authalic {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<Patch> patchesOf(const Parts& parts, const Faces& faces) {
  std::vector<Patch> patches(static_cast<std::size_t>(parts.count));
  for (std::size_t f = 0; f < parts.ofFace.size(); ++f) {
    if (parts.ofFace[f] >= 0) patches[static_cast<std::size_t>(parts.ofFace[f])].faces.push_back(static_cast<int>(f));
  }
  std::vector<int> number(parts.ofVertex.size(), -1);
  for (Patch& patch : patches) {
    patch.corners = faces(patch.faces, Eigen::all);
    for (int& v : patch.corners.reshaped<Eigen::RowMajor>()) {
      int& local = number[static_cast<std::size_t>(v)];
      if (local < 0) {
        local = static_cast<int>(patch.vertices.size());
        patch.vertices.push_back(v);
        patch.freedom.push_back(parts.ofVertex[static_cast<std::size_t>(v)] >= 0 ? 2 : 0);
      }
      v = local;
    }
    for (const int v : patch.vertices) number[static_cast<std::size_t>(v)] = -1;
  }
  return patches;
}

}  // namespace

std::vector<char> heldAround(const Faces& corners, const std::vector<char>& heldAnyway,
                             const FaceFlags& chosen, int rings) {
  std::vector<char> marked(heldAnyway.size(), 0);
  for (Eigen::Index f = 0; f < corners.rows(); ++f) {
    for (int k = 0; k < 3 && chosen[f]; ++k) marked[at(corners(f, k))] = 1;
  }
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<char> before = marked;
    for (Eigen::Index f = 0; f < corners.rows(); ++f) {
      if (!before[at(corners(f, 0))] && !before[at(corners(f, 1))] && !before[at(corners(f, 2))]) continue;
      for (int k = 0; k < 3; ++k) marked[at(corners(f, k))] = 1;
    }
  }
  for (std::size_t v = 0; v < marked.size(); ++v) marked[v] = !marked[v] || heldAnyway[v];
  return marked;
}

Parts partsBetween(const std::vector<char>& held, const Faces& faces) {
  std::vector<int> root(held.size());
  std::iota(root.begin(), root.end(), 0);
  const auto rootOf = [&](int v) {
    while (root[at(v)] != v) v = root[at(v)] = root[at(root[at(v)])];
    return v;
  };
  std::vector<int> freeCorner(static_cast<std::size_t>(faces.rows()), -1);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    int& first = freeCorner[static_cast<std::size_t>(f)];
    for (int k = 0; k < 3; ++k) {
      const int v = faces(f, k);
      if (held[at(v)]) continue;
      if (first < 0) first = v;
      root[at(rootOf(v))] = rootOf(first);
    }
  }
  Parts parts{std::vector<int>(held.size(), -1), std::vector<int>(freeCorner.size(), -1)};
  for (std::size_t v = 0; v < held.size(); ++v) {
    if (!held[v] && root[v] == static_cast<int>(v)) parts.ofVertex[v] = parts.count++;
  }
  for (std::size_t v = 0; v < held.size(); ++v) {
    if (!held[v]) parts.ofVertex[v] = parts.ofVertex[at(rootOf(static_cast<int>(v)))];
  }
  for (std::size_t f = 0; f < freeCorner.size(); ++f) {
    if (freeCorner[f] >= 0) parts.ofFace[f] = parts.ofVertex[at(freeCorner[f])];
  }
  return parts;
}

std::vector<Patch> patchesAround(const FaceFlags& chosen, int rings, const AreaFunctional& areas) {
  std::vector<char> held(static_cast<std::size_t>(areas.vertexCount()));
  for (int v = 0; v < areas.vertexCount(); ++v) held[at(v)] = areas.freedom(v) < 2;
  return patchesOf(partsBetween(heldAround(areas.faces(), held, chosen, rings), areas.faces()), areas.faces());
}

}  // namespace authalic
