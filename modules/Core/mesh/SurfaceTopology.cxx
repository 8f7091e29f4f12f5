#include "Core/mesh/SurfaceTopology.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace authalic {

SurfaceTopology::SurfaceTopology(const Faces& faces, int vertexCount)
    : faces_(faces), vertexCount_(vertexCount), onBoundary_(static_cast<std::size_t>(vertexCount), 0) {
  pairHalfEdges();
  findComponents();
  classifyVertices();
  traceLoops();
}

// Half-edges sorted by their undirected edge: every edge is one run of equal keys.
void SurfaceTopology::pairHalfEdges() {
  const int count = static_cast<int>(3 * faces_.rows());
  opposite_.assign(static_cast<std::size_t>(count), -1);
  std::vector<std::pair<std::uint64_t, int>> keyed(static_cast<std::size_t>(count));
  for (int h = 0; h < count; ++h) {
    const auto a = static_cast<std::uint64_t>(std::min(tail(h), head(h)));
    const auto b = static_cast<std::uint64_t>(std::max(tail(h), head(h)));
    keyed[static_cast<std::size_t>(h)] = {(a << 32) | b, h};
  }
  std::sort(keyed.begin(), keyed.end());
  for (std::size_t begin = 0, end; begin < keyed.size(); begin = end) {
    for (end = begin + 1; end < keyed.size() && keyed[end].first == keyed[begin].first;) ++end;
    ++edgeCount_;
    const int h = keyed[begin].second;
    if (end - begin == 1) {
      onBoundary_[static_cast<std::size_t>(tail(h))] = onBoundary_[static_cast<std::size_t>(head(h))] = 1;
    } else if (end - begin > 2) {
      nonManifoldEdges_.push_back({tail(h), head(h)});
    } else if (const int g = keyed[begin + 1].second; tail(h) == tail(g)) {
      inconsistentEdges_.push_back({tail(h), head(h)});
    } else {
      opposite_[static_cast<std::size_t>(h)] = g;
      opposite_[static_cast<std::size_t>(g)] = h;
    }
  }
}

// Components over shared vertices, so that pieces which touch in a point count as one.
void SurfaceTopology::findComponents() {
  std::vector<int> parent(static_cast<std::size_t>(vertexCount_));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int v) {
    while (parent[static_cast<std::size_t>(v)] != v) {
      auto& p = parent[static_cast<std::size_t>(v)];
      p = parent[static_cast<std::size_t>(p)];
      v = p;
    }
    return v;
  };
  for (Eigen::Index f = 0; f < faces_.rows(); ++f) {
    const int a = root(faces_(f, 0));
    parent[static_cast<std::size_t>(root(faces_(f, 1)))] = a;
    parent[static_cast<std::size_t>(root(faces_(f, 2)))] = a;
  }
  std::vector<int> number(static_cast<std::size_t>(vertexCount_), -1);
  faceComponents_.resize(static_cast<std::size_t>(faces_.rows()));
  for (Eigen::Index f = 0; f < faces_.rows(); ++f) {
    int& id = number[static_cast<std::size_t>(root(faces_(f, 0)))];
    if (id < 0) id = componentCount_++;
    faceComponents_[static_cast<std::size_t>(f)] = id;
  }
}

// A vertex is manifold when walking from face to face around it reaches every one of its faces.
void SurfaceTopology::classifyVertices() {
  std::vector<int> facesAt(static_cast<std::size_t>(vertexCount_), 0), start(facesAt.size(), -1);
  const int count = static_cast<int>(3 * faces_.rows());
  for (int h = 0; h < count; ++h) {
    const auto v = static_cast<std::size_t>(tail(h));
    ++facesAt[v];
    // Prefer the half-edge on the boundary: turning from it sweeps the whole fan.
    if (start[v] < 0 || opposite(h) < 0) start[v] = h;
  }
  for (int v = 0; v < vertexCount_; ++v) {
    const auto i = static_cast<std::size_t>(v);
    if (facesAt[i] == 0) {
      isolatedVertices_.push_back(v);
      continue;
    }
    int reached = 0;
    for (int h = start[i]; h >= 0;) {
      ++reached;
      h = opposite(previous(h));
      if (h == start[i] || reached > facesAt[i]) break;
    }
    if (reached != facesAt[i]) nonManifoldVertices_.push_back(v);
  }
}

void SurfaceTopology::traceLoops() {
  const int count = static_cast<int>(3 * faces_.rows());
  std::vector<int> following(static_cast<std::size_t>(vertexCount_), -1);
  if (!manifold()) return;
  for (int h = 0; h < count; ++h) {
    if (opposite(h) < 0) following[static_cast<std::size_t>(tail(h))] = head(h);
  }
  for (int v = 0; v < vertexCount_; ++v) {
    if (following[static_cast<std::size_t>(v)] < 0) continue;
    std::vector<int> loop;
    for (int at = v; following[static_cast<std::size_t>(at)] >= 0;) {
      loop.push_back(at);
      at = std::exchange(following[static_cast<std::size_t>(at)], -1);
    }
    loops_.push_back(std::move(loop));
  }
}

int SurfaceTopology::eulerCharacteristic() const noexcept {
  return vertexCount_ - static_cast<int>(isolatedVertices_.size()) - edgeCount_ + static_cast<int>(faces_.rows());
}

}  // namespace authalic
