#include "Core/transport/SiteClusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace authalic {
namespace {

using Iterator = std::vector<int>::iterator;

class Halving {
 public:
  Halving(const Points2& sites, const Eigen::VectorXd& masses, int depth)
      : sites_(sites), masses_(masses), depth_(depth) {
    clusterOf.assign(static_cast<std::size_t>(sites.rows()), 0);
    std::vector<int> order(clusterOf.size());
    std::iota(order.begin(), order.end(), 0);
    halve(order.begin(), order.end(), 0);
  }

  std::vector<int> clusterOf;
  int count = 0;

 private:
  void halve(Iterator begin, Iterator end, int level) {
    if (level == depth_ || end - begin < 2) return close(begin, end);
    Eigen::RowVector2d low = sites_.row(*begin), high = low;
    for (Iterator i = begin; i != end; ++i) {
      low = low.cwiseMin(sites_.row(*i)), high = high.cwiseMax(sites_.row(*i));
    }
    const int axis = high[1] - low[1] > high[0] - low[0] ? 1 : 0;
    const Iterator middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](int i, int j) {
      return sites_(i, axis) != sites_(j, axis) ? sites_(i, axis) < sites_(j, axis) : i < j;
    });
    halve(begin, middle, level + 1);
    halve(middle, end, level + 1);
  }

  void close(Iterator begin, Iterator end) {
    double sum = 0;
    for (Iterator i = begin; i != end; ++i) sum += masses_[*i];
    int alone = -1;
    for (Iterator i = begin; i != end; ++i) {
      if (end - begin > 1 && masses_[*i] > sum / 2) alone = *i;
    }
    for (Iterator i = begin; i != end; ++i) clusterOf[static_cast<std::size_t>(*i)] = *i == alone ? count + 1 : count;
    count += alone < 0 ? 1 : 2;
  }

  const Points2& sites_;
  const Eigen::VectorXd& masses_;
  int depth_;
};

}  // namespace

SiteClusters clusterSites(const Points2& sites, const Eigen::VectorXd& masses, double size) {
  const double halvings = std::log2(std::max(1.0, static_cast<double>(sites.rows()) / size));
  Halving halving(sites, masses, static_cast<int>(std::lround(halvings)));
  SiteClusters clusters{std::move(halving.clusterOf), Points2::Zero(halving.count, 2),
                        Eigen::VectorXd::Zero(halving.count)};
  for (Eigen::Index i = 0; i < sites.rows(); ++i) {
    const int cluster = clusters.clusterOf[static_cast<std::size_t>(i)];
    clusters.places.row(cluster) += masses[i] * sites.row(i);
    clusters.masses[cluster] += masses[i];
  }
  clusters.places = clusters.masses.cwiseInverse().asDiagonal() * clusters.places;
  return clusters;
}

}  // namespace authalic
