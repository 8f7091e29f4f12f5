#include "Core/authalic/VertexMatch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "Core/authalic/StarConstraint.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kRegularisation = 1e-12;
constexpr double kMarginToFlip = 0.9;
constexpr double kCollapsesEarly = 2;  // of a step: faces that collapse before it get stiffer corners
constexpr double kStiffer = 0.1;
constexpr int kAttempts = 12, kAttemptsInVain = 3;  // in vain: none of which gets farther by this factor
constexpr double kFarther = 1.05;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The frames with a second direction for vertices that slide along a curve in the plane. The only face of a boundary
// vertex may have no derivative along it; such a vertex must not count as infinitely mobile.
AreaFunctional::Frames fullFrames(const AreaFunctional& areas, const Coordinates& image) {
  AreaFunctional::Frames frames = areas.frames(image);
  for (int v = 0; v < areas.vertexCount() && image.cols() == 2; ++v) {
    if (areas.freedom(v) == 1) frames.row(v).tail<2>() << -frames(v, 1), frames(v, 0);
  }
  return frames;
}

}  // namespace

VertexMatch::VertexMatch(const AreaFunctional& areas, const Eigen::VectorXd& targets, SolverBackend backend,
                         AnalysedSystems& systems)
    : areas_(areas), targets_(targets) {
  findStars();
  system_ = systems.of(areas.vertexCount(), starts_, stars_, backend, PatternUse::Once);
  std::size_t entries = 0;
  for (std::size_t w = 0; w + 1 < starts_.size(); ++w) {
    const auto size = static_cast<std::size_t>(starts_[w + 1] - starts_[w]);
    entries += size * (size + 1) / 2;
  }
  values_.resize(entries);
  jacobian_.resize(2 * stars_.size());
}

void VertexMatch::restart(const Coordinates& image) {
  const AreaFunctional::Gradients gradients = areas_.gradients(image, fullFrames(areas_, image));
  const Eigen::VectorXd a = areas_.areas(image);
  mobility_ = Eigen::VectorXd::Zero(areas_.vertexCount());
  for (Eigen::Index f = 0; f < gradients.rows(); ++f) {
    for (int k = 0; k < 3; ++k)
      mobility_[areas_.faces()(f, k)] += gradients.row(f).segment<2>(2 * k).squaredNorm() / a[f];
  }
  mobility_ = (mobility_.array() > 0).select(mobility_.array().max(1e-300).inverse(), 0.0);
}

// The star of w holds the corners of the faces around it, w included, in increasing order.
void VertexMatch::findStars() {
  const Faces& faces = areas_.faces();
  std::vector<std::vector<int>> star(at(areas_.vertexCount()));
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) star[at(faces(f, k))].push_back(faces(f, l));
    }
  }
  starts_.assign(1, 0);
  for (std::vector<int>& s : star) {
    std::sort(s.begin(), s.end());
    s.erase(std::unique(s.begin(), s.end()), s.end());
    stars_.insert(stars_.end(), s.begin(), s.end());
    starts_.push_back(static_cast<int>(stars_.size()));
  }
  place_.resize(9 * at(static_cast<int>(faces.rows())));
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int w = faces(f, k);
      const auto begin = stars_.begin() + starts_[at(w)], end = stars_.begin() + starts_[at(w) + 1];
      for (int l = 0; l < 3; ++l) {
        place_[static_cast<std::size_t>(9 * f + 3 * k + l)] =
            static_cast<int>(std::lower_bound(begin, end, faces(f, l)) - stars_.begin());
      }
    }
  }
}

Eigen::VectorXd VertexMatch::error(const Coordinates& image) const {
  const Eigen::VectorXd a = areas_.areas(image);
  return vertexStars(a, areas_.faces(), areas_.vertexCount()) - a.sum() * targets_;
}

double VertexMatch::residual(const Coordinates& image) const { return starResidual(areas_, targets_, image); }

// A tip that does not run by itself stays in the middle between the ends of its base.
void VertexMatch::letTipsRide() {
  for (const EarOnCircle& ear : areas_.slidingEars()) {
    for (int i = starts_[at(ear.tip)]; i < starts_[at(ear.tip) + 1]; ++i) {
      for (const int end : {ear.from, ear.to}) {
        const auto begin = stars_.begin() + starts_[at(end)], last = stars_.begin() + starts_[at(end) + 1];
        const auto place = std::lower_bound(begin, last, stars_[at(i)]) - stars_.begin();
        jacobian_[2 * static_cast<std::size_t>(place)] += 0.5 * jacobian_[2 * at(i)];
      }
    }
  }
}

void VertexMatch::fillJacobian(const Coordinates& image) {
  frames_ = areas_.frames(image);
  const AreaFunctional::Gradients gradients = areas_.gradients(image, frames_);
  std::fill(jacobian_.begin(), jacobian_.end(), 0.0);
  for (Eigen::Index f = 0; f < gradients.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) {
        double* entry = &jacobian_[2 * at(place_[static_cast<std::size_t>(9 * f + 3 * k + l)])];
        entry[0] += gradients(f, 2 * k) / 3;
        entry[1] += gradients(f, 2 * k + 1) / 3;
      }
    }
  }
  letTipsRide();
}

// The shortest displacement, in the metric of the weights, that solves the linearised equations.
Coordinates VertexMatch::step(const Eigen::VectorXd& error) {
  double* value = values_.data();
  for (int w = 0; w < areas_.vertexCount(); ++w) {
    for (int i = starts_[at(w)]; i < starts_[at(w) + 1]; ++i) {
      for (int j = i; j < starts_[at(w) + 1]; ++j, ++value) {
        *value = mobility_[w] *
                 (jacobian_[2 * at(i)] * jacobian_[2 * at(j)] + jacobian_[2 * at(i) + 1] * jacobian_[2 * at(j) + 1]);
      }
    }
  }
  SparseMatrix matrix = system_->assemble(values_);
  for (int v = 0; v < matrix.cols(); ++v) {
    double& diagonal = matrix.valuePtr()[matrix.outerIndexPtr()[v]];
    diagonal = diagonal > 0 ? diagonal * (1 + kRegularisation) : 1;
  }
  system_->factorize(matrix);
  const Eigen::VectorXd multipliers = system_->solver().solve(error);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(areas_.unknownCount());
  for (int w = 0; w < areas_.vertexCount(); ++w) {
    for (int j = 0; j < areas_.freedom(w); ++j) {
      double sum = 0;
      for (int i = starts_[at(w)]; i < starts_[at(w) + 1]; ++i)
        sum += jacobian_[2 * at(i) + at(j)] * multipliers[stars_[at(i)]];
      step[areas_.unknown(w, j)] = -mobility_[w] * sum;
    }
  }
  for (const EarOnCircle& ear : areas_.slidingEars()) {
    step[areas_.unknown(ear.tip, 0)] += 0.5 * (step[areas_.unknown(ear.from, 0)] + step[areas_.unknown(ear.to, 0)]);
  }
  return areas_.displacement(frames_, step);
}

// The first flip; corners of the faces that collapse early are made stiffer.
double VertexMatch::flipFree(const Coordinates& image, const Coordinates& displacement) {
  double first = std::numeric_limits<double>::infinity();
  Eigen::VectorXd factor = Eigen::VectorXd::Ones(mobility_.size());
  for (int f = 0; f < static_cast<int>(areas_.faces().rows()); ++f) {
    const double flip = areas_.firstFlip(image, displacement, f);
    first = std::min(first, flip);
    for (int k = 0; k < 3 && flip < kCollapsesEarly; ++k) factor[areas_.faces()(f, k)] = kStiffer;
  }
  if (kMarginToFlip * first < 1) mobility_.array() *= factor.array();
  return first;
}

double VertexMatch::advance(Coordinates& image) {
  fillJacobian(image);
  const Eigen::VectorXd wrong = error(image);
  Coordinates best;
  double part = 0;
  for (int attempt = 0, inVain = 0; attempt < kAttempts && inVain < kAttemptsInVain && part < 1; ++attempt) {
    const double before = part;
    const Coordinates displacement = step(wrong);
    double now = std::min(1.0, kMarginToFlip * flipFree(image, displacement));
    for (; now > part; now *= 0.5) {
      Coordinates next = areas_.moved(image, displacement, now);
      if (!(areas_.areas(next).minCoeff() > 0)) continue;  // folded by the way back to the domain
      best = std::move(next);
      part = now;
    }
    inVain = part > kFarther * before ? 0 : inVain + 1;
  }
  if (part > 0) image = std::move(best);
  return part;
}

}  // namespace authalic
