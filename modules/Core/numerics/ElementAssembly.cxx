#include "Core/numerics/ElementAssembly.h"

#include <algorithm>

namespace authalic {
namespace {

// Stable counting sort of `order` by key(item) in [0, keyCount).
template <class Key>
std::vector<int> countingSort(const std::vector<int>& order, int keyCount, const Key& key) {
  std::vector<int> start(static_cast<std::size_t>(keyCount) + 1, 0), sorted(order.size());
  for (const int item : order) ++start[static_cast<std::size_t>(key(item)) + 1];
  for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
  for (const int item : order) sorted[static_cast<std::size_t>(start[static_cast<std::size_t>(key(item))]++)] = item;
  return sorted;
}

// {column, row} of the lower triangle for the upper triangle of one element.
void appendPairs(const int* unknowns, Eigen::Index count, std::vector<std::array<int, 2>>& pairs) {
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = a; b < count; ++b) {
      const int i = unknowns[a], j = unknowns[b];
      pairs.push_back(i < 0 || j < 0 ? std::array<int, 2>{-1, -1} : std::array<int, 2>{std::min(i, j), std::max(i, j)});
    }
  }
}

}  // namespace

ElementAssembly::ElementAssembly(int unknownCount, const Unknowns& elements) {
  std::vector<std::array<int, 2>> pairs;
  pairs.reserve(static_cast<std::size_t>(elements.rows() * elements.cols() * (elements.cols() + 1) / 2));
  for (Eigen::Index e = 0; e < elements.rows(); ++e) appendPairs(elements.row(e).data(), elements.cols(), pairs);
  sortPairs(unknownCount, pairs);
}

ElementAssembly::ElementAssembly(int unknownCount, const std::vector<int>& starts, const std::vector<int>& unknowns) {
  std::vector<std::array<int, 2>> pairs;
  for (std::size_t e = 0; e + 1 < starts.size(); ++e) {
    appendPairs(unknowns.data() + starts[e], starts[e + 1] - starts[e], pairs);
  }
  sortPairs(unknownCount, pairs);
}

void ElementAssembly::sortPairs(int unknownCount, const std::vector<std::array<int, 2>>& pairs) {
  std::vector<int> order;
  order.reserve(pairs.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (pairs[p][0] >= 0) order.push_back(static_cast<int>(p));
  }
  const auto pair = [&pairs](int p) -> const std::array<int, 2>& { return pairs[static_cast<std::size_t>(p)]; };
  order = countingSort(order, unknownCount, [&](int p) { return pair(p)[1]; });
  order = countingSort(order, unknownCount, [&](int p) { return pair(p)[0]; });

  slots_.assign(pairs.size(), -1);
  std::vector<int> rows, columnEnd(static_cast<std::size_t>(unknownCount) + 1, 0);
  rows.reserve(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& now = pair(order[k]);
    if (k == 0 || now != pair(order[k - 1])) {
      rows.push_back(now[1]);
      ++columnEnd[static_cast<std::size_t>(now[0]) + 1];
    }
    slots_[static_cast<std::size_t>(order[k])] = static_cast<int>(rows.size()) - 1;
  }
  for (std::size_t c = 1; c < columnEnd.size(); ++c) columnEnd[c] += columnEnd[c - 1];
  matrix_.resize(unknownCount, unknownCount);
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(columnEnd.begin(), columnEnd.end(), matrix_.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), matrix_.innerIndexPtr());
}

const SparseMatrix& ElementAssembly::assemble(const std::vector<double>& values) {
  double* sum = matrix_.valuePtr();
  std::fill(sum, sum + matrix_.nonZeros(), 0.0);
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    if (slots_[k] >= 0) sum[slots_[k]] += values[k];
  }
  return matrix_;
}

}  // namespace authalic
