#include "Core/imaging/LatticeSurfaceTable.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace authalic {

namespace {

using Crossing = std::pair<int, int>;  // positive and negative corner that a surface vertex lies between
using Piece = std::vector<std::array<Crossing, 3>>;  // triangles
using Loop = std::vector<int>;  // cube edges, in the direction of the boundary of a piece

Eigen::Vector3d corner(int c) {
  return Eigen::Vector3d(c & 1, c >> 1 & 1, c >> 2 & 1);
}
Eigen::Vector3d middle(const Crossing& x) {
  return 0.5 * (corner(x.first) + corner(x.second));
}
Eigen::Vector3d edgeMiddle(int e) {
  return 0.5 * (corner(kCubeEdges[static_cast<std::size_t>(e)][0]) +
                corner(kCubeEdges[static_cast<std::size_t>(e)][1]));
}

// -1 when the crossing lies on a diagonal.
int cubeEdge(const Crossing& x) {
  const std::array<int, 2> wanted{std::min(x.first, x.second), std::max(x.first, x.second)};
  const auto found = std::find(kCubeEdges.begin(), kCubeEdges.end(), wanted);
  return found == kCubeEdges.end() ? -1 : static_cast<int>(found - kCubeEdges.begin());
}

void addOriented(Piece& piece, const Crossing& a, const Crossing& b, const Crossing& c) {
  const Eigen::Vector3d normal = (middle(b) - middle(a)).cross(middle(c) - middle(a));
  const bool outward = normal.dot(corner(a.second) - corner(a.first)) > 0;
  piece.push_back(outward ? std::array<Crossing, 3>{a, b, c} : std::array<Crossing, 3>{a, c, b});
}

// Marching tetrahedra in one cube.
Piece allTriangles(int signs) {
  Piece triangles;
  std::array<int, 3> axes{1, 2, 4};
  do {
    const std::array<int, 4> tetrahedron{0, axes[0], axes[0] | axes[1], 7};
    std::vector<int> in, out;
    for (const int c : tetrahedron) (signs >> c & 1 ? in : out).push_back(c);
    if (in.size() == 1 || out.size() == 1) {
      std::vector<Crossing> x;
      for (const int a : in) {
        for (const int b : out) x.emplace_back(a, b);
      }
      addOriented(triangles, x[0], x[1], x[2]);
    } else if (in.size() == 2) {
      const Crossing p(in[0], out[0]), q(in[0], out[1]), r(in[1], out[1]), s(in[1], out[0]);
      addOriented(triangles, p, q, r);
      addOriented(triangles, p, r, s);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return triangles;
}

// Triangles that share a crossing belong to one piece.
std::vector<Piece> connectedPieces(const Piece& triangles) {
  std::map<Crossing, int> root;
  std::vector<int> parent(triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&parent](int t) {
    while (parent[static_cast<std::size_t>(t)] != t) t = parent[static_cast<std::size_t>(t)];
    return t;
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const Crossing& x : triangles[t]) {
      const auto [known, fresh] = root.emplace(x, static_cast<int>(t));
      const int a = find(known->second), b = find(static_cast<int>(t));
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  std::map<int, Piece> byRoot;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    byRoot[find(static_cast<int>(t))].push_back(triangles[t]);
  std::vector<Piece> pieces;
  pieces.reserve(byRoot.size());
  for (auto& entry : byRoot) pieces.push_back(std::move(entry.second));
  return pieces;
}

// Boundary loops of a piece, reduced to the crossings on the cube's own edges.
std::vector<Loop> boundaryLoops(const Piece& piece) {
  std::map<Crossing, Crossing> following;
  std::map<std::pair<Crossing, Crossing>, int> uses;
  for (const auto& t : piece) {
    for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : uses) {
    if (uses.find({edge.second, edge.first}) == uses.end()) following[edge.first] = edge.second;
  }
  std::vector<Loop> loops;
  while (!following.empty()) {
    Loop loop;
    for (auto at = following.begin(); at != following.end();) {
      if (const int e = cubeEdge(at->first); e >= 0) loop.push_back(e);
      const Crossing next = at->second;
      following.erase(at);
      at = following.find(next);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

// Two cube edges lie in one face of the cube when their middles share a coordinate 0 or 1.
bool inOneFace(int e, int f) {
  const Eigen::Vector3d p = edgeMiddle(e), q = edgeMiddle(f);
  for (int a = 0; a < 3; ++a) {
    if (p[a] == q[a] && p[a] != 0.5) return true;
  }
  return false;
}

// Shortest triangulation of the polygon loop[first…last] by chords that lie in no face; infinite when there
// is none.
double triangulate(const Loop& loop, std::size_t first, std::size_t last,
                   std::vector<std::array<int, 3>>& best) {
  best.clear();
  if (last - first < 2) return 0;
  double bestLength = std::numeric_limits<double>::infinity();
  const auto chord = [&loop](std::size_t a, std::size_t b) {
    if (b - a == 1 || (a == 0 && b + 1 == loop.size())) return 0.0;
    return inOneFace(loop[a], loop[b]) ? std::numeric_limits<double>::infinity()
                                       : (edgeMiddle(loop[a]) - edgeMiddle(loop[b])).norm();
  };
  for (std::size_t m = first + 1; m < last; ++m) {
    std::vector<std::array<int, 3>> left, right;
    const double length = chord(first, m) + chord(m, last) + triangulate(loop, first, m, left) +
                          triangulate(loop, m, last, right);
    if (!(length < bestLength)) continue;
    bestLength = length;
    best = std::move(left);
    best.insert(best.end(), right.begin(), right.end());
    best.push_back({loop[first], loop[m], loop[last]});
  }
  return bestLength;
}

void addDisk(const Loop& loop, LatticeSurfaceCell& cell) {
  std::vector<std::array<int, 3>> triangles;
  if (triangulate(loop, 0, loop.size() - 1, triangles) < std::numeric_limits<double>::infinity()) {
    cell.triangles.insert(cell.triangles.end(), triangles.begin(), triangles.end());
    return;
  }
  const int centre = 12 + static_cast<int>(cell.centres.size());
  for (std::size_t k = 0; k < loop.size(); ++k) {
    cell.triangles.push_back({loop[k], loop[(k + 1) % loop.size()], centre});
  }
  cell.centres.push_back(loop);
}

// A band between two loops: always the shorter of the two possible next rungs.
void addTube(const Loop& a, const Loop& b, LatticeSurfaceCell& cell) {
  const auto distance = [](int e, int f) { return (edgeMiddle(e) - edgeMiddle(f)).squaredNorm(); };
  const std::size_t n = a.size(), m = b.size();
  std::size_t start = 0;
  for (std::size_t j = 1; j < m; ++j) {
    if (distance(a[0], b[j]) < distance(a[0], b[start])) start = j;
  }
  for (std::size_t i = 0, j = 0; i < n || j < m;) {
    const int p = a[i % n], nextP = a[(i + 1) % n];
    const int q = b[(start + m - j % m) % m], nextQ = b[(start + 2 * m - j % m - 1) % m];
    if (j == m || (i < n && distance(nextP, q) <= distance(p, nextQ))) {
      cell.triangles.push_back({p, nextP, q});
      ++i;
    } else {
      cell.triangles.push_back({nextQ, q, p});
      ++j;
    }
  }
}

std::array<LatticeSurfaceCell, 256> makeTable() {
  std::array<LatticeSurfaceCell, 256> table;
  for (int signs = 0; signs < 256; ++signs) {
    LatticeSurfaceCell& cell = table[static_cast<std::size_t>(signs)];
    for (const Piece& piece : connectedPieces(allTriangles(signs))) {
      const std::vector<Loop> loops = boundaryLoops(piece);
      if (loops.size() == 1) {
        addDisk(loops[0], cell);
      } else {
        addTube(loops[0], loops[1], cell);
      }
    }
  }
  return table;
}

}  // namespace

const LatticeSurfaceCell& latticeSurfaceCell(int signs) {
  static const std::array<LatticeSurfaceCell, 256> table = makeTable();
  return table[static_cast<std::size_t>(signs & 255)];
}

}  // namespace authalic
