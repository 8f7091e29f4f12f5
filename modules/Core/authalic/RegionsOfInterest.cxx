#include "Core/authalic/RegionsOfInterest.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "Core/authalic/TargetMeasure.h"
#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SurfaceDistance.h"

namespace authalic {
namespace {

constexpr double kShareTolerance = 1e-12;
constexpr double kLargestExponent = 40;
constexpr int kMostSweeps = 300;

std::string shown(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string placeOf(const Eigen::Vector3d& p) { return shown(p[0]) + ", " + shown(p[1]) + ", " + shown(p[2]); }

void requireRegion(const RegionOfInterest& region, int vertexCount) {
  const std::string name = "Region '" + region.name + "'";
  if (region.inside.size() != static_cast<std::size_t>(vertexCount)) {
    throw GeometryError(name + " must say of each of the " + std::to_string(vertexCount) +
                        " vertices whether it is inside, but has " + std::to_string(region.inside.size()) + " flags.");
  }
  if (!(region.factor > 0) || !std::isfinite(region.factor)) {
    throw InvalidArgument(name + " needs a positive, finite factor, but it is " + shown(region.factor) +
                          "; 4 enlarges it four times, 0.25 shrinks it to a quarter.");
  }
  if (!(region.blend >= 0) || !std::isfinite(region.blend)) {
    throw InvalidArgument(name + " needs a blend of 0 mm or more, but it is " + shown(region.blend) + ".");
  }
}

/// 0 far outside, 1 deep inside, ½ on the border.
Eigen::VectorXd weightsOf(const TriangleMesh& surface, const RegionOfInterest& region) {
  const int n = surface.vertexCount();
  Eigen::VectorXd weights(n);
  for (int v = 0; v < n; ++v) weights[v] = region.inside[static_cast<std::size_t>(v)] != 0;
  if (region.blend == 0) return weights;
  std::vector<int> in, out;
  for (int v = 0; v < n; ++v) (weights[v] > 0 ? in : out).push_back(v);
  // The border lies between the vertices on either side of it: as far from the ones as from the others.
  const Eigen::VectorXd depth = surfaceDistance(surface, out) - surfaceDistance(surface, in);
  for (int v = 0; v < n; ++v) {
    const double x = std::clamp(0.5 + depth[v] / region.blend, 0.0, 1.0);
    weights[v] = x * x * (3 - 2 * x);
  }
  return weights;
}

double logit(double share) { return std::log(share / (1 - share)); }

/// Solves for the exponents g that give the regions their shares.
class ShareSolve {
 public:
  ShareSolve(const TriangleMesh& surface, const Eigen::VectorXd& base, const std::vector<RegionOfInterest>& regions)
      : surface_(surface), regions_(regions),
        measure_(base.size() > 0 ? faceAreas(surface).cwiseProduct(base).eval() : faceAreas(surface)),
        exponents_(regions.size()), logDensity_(Eigen::VectorXd::Zero(surface.vertexCount())) {
    for (std::size_t r = 0; r < regions.size(); ++r) {
      weights_.push_back(weightsOf(surface, regions[r]));
      exponents_[static_cast<Eigen::Index>(r)] = std::log(regions[r].factor);
      logDensity_ += exponents_[static_cast<Eigen::Index>(r)] * weights_.back();
    }
    findTargets();
  }

  void run() {
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      double worst = 0;
      for (std::size_t r = 0; r < regions_.size(); ++r) worst = std::max(worst, improve(r));
      if (worst < kShareTolerance) return;
    }
    refuse(regions_.front());
  }

  [[nodiscard]] RegionsOfInterestDensity result(const Eigen::VectorXd& base) const {
    const Eigen::VectorXd areas = faceAreas(surface_);
    RegionsOfInterestDensity density;
    density.faces = meanOfCorners(surface_, logDensity_.array().exp().matrix());
    if (base.size() > 0) density.faces = density.faces.cwiseProduct(base);
    density.factors = exponents_.array().exp();
    density.targetShares = targets_;
    density.sourceShares.resize(targets_.size());
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      density.sourceShares[static_cast<Eigen::Index>(r)] =
          regionMeasure(areas, surface_.faces(), regions_[r].inside) / areas.sum();
    }
    return density;
  }

 private:
  void findTargets() {
    Eigen::VectorXd wanted = vertexStars(measure_, surface_.faces(), surface_.vertexCount());
    for (const RegionOfInterest& region : regions_) {
      for (int v = 0; v < wanted.size(); ++v) {
        if (region.inside[static_cast<std::size_t>(v)]) wanted[v] *= region.factor;
      }
    }
    targets_.resize(static_cast<Eigen::Index>(regions_.size()));
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      double inside = 0, outside = 0;
      for (int v = 0; v < wanted.size(); ++v)
        (regions_[r].inside[static_cast<std::size_t>(v)] ? inside : outside) += wanted[v];
      const std::string name = "Region '" + regions_[r].name + "'";
      if (!(inside > 0)) throw InvalidArgument(name + " must have vertices with some area, but it is empty.");
      if (!(outside > 0)) {
        throw InvalidArgument(name + " must leave some of the surface outside, but it is everything: its factor has "
                                     "nothing to be relative to.");
      }
      targets_[static_cast<Eigen::Index>(r)] = inside / (inside + outside);
    }
  }

  /// One Newton step on the odds of one region. @returns how far its share was off
  double improve(std::size_t r) {
    const auto index = static_cast<Eigen::Index>(r);
    const Eigen::VectorXd density = logDensity_.array().exp();
    const Eigen::VectorXd masses = measure_.cwiseProduct(meanOfCorners(surface_, density));
    const Eigen::VectorXd changes = measure_.cwiseProduct(meanOfCorners(surface_, density.cwiseProduct(weights_[r])));
    const double in = inside(masses, r), out = masses.sum() - in;
    const double inChange = inside(changes, r), outChange = changes.sum() - inChange;
    const double share = in / (in + out), slope = inChange / in - outChange / out;
    if (!(slope > 1e-9)) refuse(regions_[r]);
    const double step = std::clamp((logit(targets_[index]) - logit(share)) / slope, -2.0, 2.0);
    exponents_[index] += step;
    if (!(std::abs(exponents_[index]) < kLargestExponent)) refuse(regions_[r]);
    logDensity_ += step * weights_[r];
    return std::abs(share - targets_[index]);
  }

  [[noreturn]] static void refuse(const RegionOfInterest& region) {
    throw InvalidArgument("Region '" + region.name + "' cannot have " + shown(region.factor) +
                          " times its area by any density with a blend of " + shown(region.blend) +
                          " mm; take a smaller factor or a blend that is narrower than the region.");
  }

  [[nodiscard]] double inside(const Eigen::VectorXd& masses, std::size_t r) const {
    return regionMeasure(masses, surface_.faces(), regions_[r].inside);
  }

  const TriangleMesh& surface_;
  const std::vector<RegionOfInterest>& regions_;
  Eigen::VectorXd measure_;
  std::vector<Eigen::VectorXd> weights_;
  Eigen::VectorXd exponents_, logDensity_, targets_;
};

int nearestVertex(const TriangleMesh& surface, const Eigen::Vector3d& centre, double radius) {
  if (!(radius > 0) || !std::isfinite(radius) || !centre.allFinite()) {
    throw InvalidArgument("A brush needs a centre and a radius above 0 mm, but its radius is " + shown(radius) + ".");
  }
  Eigen::Index nearest = 0;
  const double away =
      std::sqrt((surface.points().rowwise() - centre.transpose()).rowwise().squaredNorm().minCoeff(&nearest));
  if (away > radius) {
    throw InvalidArgument("A brush must reach the surface, but the nearest vertex to its centre (" + placeOf(centre) +
                          ") is " + shown(away) + " mm away, at (" +
                          placeOf(surface.point(static_cast<int>(nearest))) + "), and its radius is " +
                          shown(radius) + " mm.");
  }
  return static_cast<int>(nearest);
}

}  // namespace

RegionsOfInterestDensity densityOfRegions(const TriangleMesh& surface, const Eigen::VectorXd& base,
                                          const std::vector<RegionOfInterest>& regions) {
  for (const RegionOfInterest& region : regions) requireRegion(region, surface.vertexCount());
  if (base.size() > 0) static_cast<void>(TargetMeasure::fromFaceDensity(surface, base));
  ShareSolve solve(surface, base, regions);
  solve.run();
  return solve.result(base);
}

std::vector<char> ballOnSurface(const TriangleMesh& surface, const Eigen::Vector3d& centre, double radius) {
  const int nearest = nearestVertex(surface, centre, radius);
  const FacesAroundVertices around(surface.faces(), surface.vertexCount());
  std::vector<char> inside(static_cast<std::size_t>(surface.vertexCount()), 0);
  std::vector<int> open{nearest};
  inside[static_cast<std::size_t>(nearest)] = 1;
  while (!open.empty()) {
    const auto v = static_cast<std::size_t>(open.back());
    open.pop_back();
    for (int k = around.first[v]; k < around.first[v + 1]; ++k) {
      for (const int other : surface.faces().row(around.faces[static_cast<std::size_t>(k)])) {
        char& flag = inside[static_cast<std::size_t>(other)];
        if (flag || (surface.point(other) - centre).norm() > radius) continue;
        flag = 1;
        open.push_back(other);
      }
    }
  }
  return inside;
}

std::vector<char> geodesicBallOnSurface(const TriangleMesh& surface, const Eigen::Vector3d& centre, double radius) {
  const Eigen::VectorXd distance = surfaceDistance(surface, {nearestVertex(surface, centre, radius)});
  std::vector<char> inside(static_cast<std::size_t>(surface.vertexCount()));
  for (int v = 0; v < surface.vertexCount(); ++v) inside[static_cast<std::size_t>(v)] = distance[v] <= radius;
  return inside;
}

double regionMeasure(const Eigen::VectorXd& faceMeasures, const Faces& faces, const std::vector<char>& inside) {
  double sum = 0;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    int corners = 0;
    for (int k = 0; k < 3; ++k) corners += inside[static_cast<std::size_t>(faces(f, k))] != 0;
    if (corners > 0) sum += faceMeasures[f] * corners / 3;
  }
  return sum;
}

}  // namespace authalic
