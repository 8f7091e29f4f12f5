#include "Core/authalic/BoundaryStars.h"

#include <algorithm>
#include <cstddef>

namespace authalic {
namespace {

constexpr double kFacesPerWeight = 2500, kSmallestWeight = 10, kLargestWeight = 30;
constexpr double kSmallestRatio = 1e-3;  // of areas, in the weights

double sumOver(const std::vector<int>& faces, const Eigen::VectorXd& values) {
  double sum = 0;
  for (const int f : faces) sum += values[f];
  return sum;
}

}  // namespace

BoundaryStars::BoundaryStars(const AreaFunctional& areas, const Eigen::VectorXd& targets,
                             const Eigen::VectorXd& importance)
    : weight_(std::clamp(static_cast<double>(targets.size()) / kFacesPerWeight, kSmallestWeight, kLargestWeight)) {
  if (!areas.looksAtBoundaryStars()) return;
  const Faces& faces = areas.faces();
  std::vector<int> number(static_cast<std::size_t>(areas.vertexCount()), -1);
  for (Eigen::Index k = 0; k < faces.size(); ++k) {
    const int v = faces.data()[k];
    if (areas.freedom(v) != 1) continue;
    int& star = number[static_cast<std::size_t>(v)];
    if (star < 0) {
      star = static_cast<int>(stars_.size());
      stars_.emplace_back();
    }
    stars_[static_cast<std::size_t>(star)].faces.push_back(static_cast<int>(k / 3));
  }
  const Eigen::VectorXd important = importance.cwiseProduct(targets);
  for (Star& star : stars_) {
    star.target = sumOver(star.faces, targets);
    star.importance = sumOver(star.faces, important) / star.target;
    for (const int f : star.faces) {
      for (int k = 0; k < 6; ++k) star.places.push_back(areas.unknown(faces(f, k / 2), k % 2));
    }
    star.unknowns = star.places;
    std::sort(star.unknowns.begin(), star.unknowns.end());
    star.unknowns.erase(std::unique(star.unknowns.begin(), star.unknowns.end()), star.unknowns.end());
    if (star.unknowns.front() < 0) star.unknowns.erase(star.unknowns.begin());
    for (int& place : star.places) {
      if (place < 0) continue;
      const auto found = std::lower_bound(star.unknowns.begin(), star.unknowns.end(), place);
      place = static_cast<int>(found - star.unknowns.begin());
    }
  }
}

double BoundaryStars::value(const Eigen::VectorXd& faceAreas) const {
  const double total = faceAreas.sum();
  double sum = 0;
  for (const Star& star : stars_) {
    const double share = sumOver(star.faces, faceAreas) / total, off = share - star.target;
    sum += star.importance * off * off / share;
  }
  return weight_ * sum;
}

void BoundaryStars::linearise(const Eigen::VectorXd& faceAreas) {
  const double total = faceAreas.sum();
  for (Star& star : stars_) {
    const double wanted = total * star.target, area = sumOver(star.faces, faceAreas);
    const double ratio = std::max(area / wanted, kSmallestRatio);
    star.weight = weight_ * star.importance * (1 + ratio) / (2 * ratio * ratio * wanted);
    star.lacks = wanted - area;
  }
}

void BoundaryStars::addPulls(Eigen::VectorXd& pulls) const {
  for (const Star& star : stars_) {
    for (const int f : star.faces) pulls[f] += star.weight * star.lacks;
  }
}

void BoundaryStars::appendElements(std::vector<int>& starts, std::vector<int>& unknowns) const {
  for (const Star& star : stars_) {
    unknowns.insert(unknowns.end(), star.unknowns.begin(), star.unknowns.end());
    starts.push_back(static_cast<int>(unknowns.size()));
  }
}

std::size_t BoundaryStars::valueCount() const {
  std::size_t count = 0;
  for (const Star& star : stars_) count += star.unknowns.size() * (star.unknowns.size() + 1) / 2;
  return count;
}

void BoundaryStars::appendValues(const AreaFunctional::Gradients& gradients, double* values) const {
  for (const Star& star : stars_) {
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(star.unknowns.size()));
    for (std::size_t k = 0; k < star.places.size(); ++k) {
      if (star.places[k] >= 0) slope[star.places[k]] += gradients(star.faces[k / 6], static_cast<int>(k % 6));
    }
    for (Eigen::Index a = 0; a < slope.size(); ++a) {
      for (Eigen::Index b = a; b < slope.size(); ++b) *values++ = star.weight * slope[a] * slope[b];
    }
  }
}

}  // namespace authalic
