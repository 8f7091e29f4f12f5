#include "Core/imaging/SimplePoint.h"

#include <bitset>
#include <memory>

namespace authalic {

namespace {

constexpr unsigned kAll = (1u << 14) - 1;

int neighbourWithOffset(const std::array<int, 3>& offset) {
  for (int k = 0; k < 14; ++k) {
    if (kLatticeNeighbours[static_cast<std::size_t>(k)] == offset) return k;
  }
  return -1;
}

std::array<std::uint16_t, 14> makeLinkAdjacency() {
  std::array<std::uint16_t, 14> adjacency{};
  for (std::size_t a = 0; a < 14; ++a) {
    for (std::size_t b = 0; b < 14; ++b) {
      const auto &p = kLatticeNeighbours[a], &q = kLatticeNeighbours[b];
      if (neighbourWithOffset({q[0] - p[0], q[1] - p[1], q[2] - p[2]}) >= 0) {
        adjacency[a] = static_cast<std::uint16_t>(adjacency[a] | (1u << b));
      }
    }
  }
  return adjacency;
}

// Not empty, and one flood along the link reaches all of it.
bool connectedOnLink(unsigned set) {
  if (set == 0) return false;
  unsigned reached = set & (~set + 1), front = reached;
  while (front != 0) {
    unsigned grown = 0;
    for (std::size_t k = 0; k < 14; ++k) {
      if (front >> k & 1u) grown |= latticeLinkAdjacency()[k];
    }
    front = grown & set & ~reached;
    reached |= front;
  }
  return reached == set;
}

std::bitset<kAll + 1> makeSimpleTable() {
  std::bitset<kAll + 1> table;
  for (unsigned set = 0; set <= kAll; ++set)
    table[set] = connectedOnLink(set) && connectedOnLink(~set & kAll);
  return table;
}

}  // namespace

const std::array<std::uint16_t, 14>& latticeLinkAdjacency() {
  static const std::array<std::uint16_t, 14> adjacency = makeLinkAdjacency();
  return adjacency;
}

bool isSimplePoint(std::uint16_t objectNeighbours) {
  static const std::bitset<kAll + 1> table = makeSimpleTable();
  return table[objectNeighbours & kAll];
}

}  // namespace authalic
