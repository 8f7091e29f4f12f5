#include "Core/authalic/TargetMeasure.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"

namespace authalic {
namespace {

constexpr double kSmallestTarget = 1e-6;  // of the mean of the faces: smaller ones have no area
constexpr double kWithoutArea = 1e-2;     // of that mean, for those: thin faces stop all steps
constexpr double kOfStar = 0.05;          // of the smallest star around them, if that is less

void requireDensity(const Eigen::VectorXd& density, int count, const std::string& element) {
  if (density.size() != count) {
    throw GeometryError("A density of one value per " + element + " (" + std::to_string(count) +
                        ") is required, but it has " + std::to_string(density.size()) +
                        " values; take it from the same surface.");
  }
  for (Eigen::Index i = 0; i < density.size(); ++i) {
    if (density[i] > 0 && std::isfinite(density[i])) continue;
    throw InvalidArgument("A positive, finite density is required, but " + element + " " + std::to_string(i) +
                          " has " + std::to_string(density[i]) + "; give small regions a small density, not zero.");
  }
}

void requireBalance(const Eigen::VectorXd& t, int count) {
  if (t.size() != count) {
    throw GeometryError("A balance of one weight per vertex (" + std::to_string(count) + ") is required, but it has " +
                        std::to_string(t.size()) + "; take it from the same surface.");
  }
  for (Eigen::Index v = 0; v < t.size(); ++v) {
    if (t[v] >= 0 && t[v] <= 1) continue;
    throw InvalidArgument("A balance from 0 (the image's areas) to 1 (the target) is required, but vertex " +
                          std::to_string(v) + " has " + std::to_string(t[v]) + ".");
  }
}

}  // namespace

TargetMeasure::TargetMeasure(const TriangleMesh& surface)
    : TargetMeasure(surface, Eigen::VectorXd::Ones(surface.faceCount())) {}

TargetMeasure::TargetMeasure(const TriangleMesh& surface, const Eigen::VectorXd& faceDensity)
    : shares_(faceAreas(surface).cwiseProduct(faceDensity)) {
  const double total = shares_.sum();
  if (!(total > 0) || !std::isfinite(total)) {
    throw GeometryError("A surface with a positive, finite area is required, but its " +
                        std::to_string(surface.faceCount()) + " faces have none.");
  }
  shares_ /= total;
  raiseSmallTargets(surface, kSmallestTarget);
}

void TargetMeasure::raiseSmallTargets(const TriangleMesh& surface, double ofMean) {
  const double smallest = ofMean / surface.faceCount();
  vertices_ = vertexStars(shares_, surface.faces(), surface.vertexCount());
  faces_ = shares_;
  clampedFaces_ = 0;
  for (int f = 0; f < surface.faceCount(); ++f) {
    if (shares_[f] >= smallest) continue;
    double raised = kWithoutArea / surface.faceCount();
    for (const int v : surface.faces().row(f)) raised = std::min(raised, kOfStar * vertices_[v]);
    faces_[f] = std::max(raised, smallest);
    ++clampedFaces_;
  }
  faces_ /= faces_.sum();
  const Eigen::VectorXd raisedStars = vertexStars(faces_, surface.faces(), surface.vertexCount());
  vertices_ = (vertices_.array() < smallest / 3).select(raisedStars, vertices_);
  vertices_ /= vertices_.sum();
}

TargetMeasure TargetMeasure::fromVertexDensity(const TriangleMesh& surface, const Eigen::VectorXd& density) {
  requireDensity(density, surface.vertexCount(), "vertex");
  return TargetMeasure(surface, meanOfCorners(surface, density));
}

TargetMeasure TargetMeasure::fromFaceDensity(const TriangleMesh& surface, const Eigen::VectorXd& density) {
  requireDensity(density, surface.faceCount(), "face");
  return TargetMeasure(surface, density);
}

TargetMeasure TargetMeasure::blended(const TriangleMesh& surface, const Eigen::VectorXd& imageAreas, double t) const {
  return blended(surface, imageAreas, Eigen::VectorXd::Constant(surface.vertexCount(), t).eval());
}

TargetMeasure TargetMeasure::blended(const TriangleMesh& surface, const Eigen::VectorXd& imageAreas,
                                     const Eigen::VectorXd& t) const {
  requireBalance(t, surface.vertexCount());
  if (imageAreas.size() != faces_.size() || !(imageAreas.minCoeff() > 0)) {
    throw GeometryError("An image of " + std::to_string(faces_.size()) +
                        " faces without a fold is required to balance areas against it.");
  }
  const Eigen::VectorXd ofFace = meanOfCorners(surface, t);
  TargetMeasure result = *this;
  result.shares_ = (1 - ofFace.array()) * imageAreas.array() / imageAreas.sum() + ofFace.array() * shares_.array();
  result.shares_ /= result.shares_.sum();
  result.raiseSmallTargets(surface, ofFace.maxCoeff() > 0 ? kSmallestTarget : 0);  // at 0 the image has them all
  return result;
}

void requireTargetOf(const TriangleMesh& surface, const TargetMeasure& target) {
  if (target.faces().size() == surface.faceCount() && target.vertices().size() == surface.vertexCount()) return;
  throw GeometryError("A target measure for the " + std::to_string(surface.faceCount()) +
                      " faces of this surface is required, but it has " + std::to_string(target.faces().size()) +
                      "; build it from the same surface.");
}

Eigen::VectorXd meanOfCorners(const TriangleMesh& surface, const Eigen::VectorXd& ofVertices) {
  Eigen::VectorXd ofFace(surface.faceCount());
  for (int f = 0; f < surface.faceCount(); ++f) {
    const auto corners = surface.faces().row(f);
    ofFace[f] = (ofVertices[corners[0]] + ofVertices[corners[1]] + ofVertices[corners[2]]) / 3;
  }
  return ofFace;
}

Eigen::VectorXd curvatureDensity(const TriangleMesh& surface, const Eigen::VectorXd& curvature, double weight) {
  if (!(weight >= 0 && weight < 1)) {
    throw InvalidArgument("A weight of the curvature from 0 to below 1 is required, but it is " +
                          std::to_string(weight) + "; at 1, flat places would have no share.");
  }
  if (curvature.size() != surface.vertexCount()) {
    throw GeometryError("A curvature for each of the " + std::to_string(surface.vertexCount()) +
                        " vertices is required, but there are " + std::to_string(curvature.size()) + ".");
  }
  for (Eigen::Index v = 0; v < curvature.size(); ++v) {
    if (std::isfinite(curvature[v])) continue;
    throw InvalidArgument("A finite curvature is required, but vertex " + std::to_string(v) + " has " +
                          std::to_string(curvature[v]) + ".");
  }
  const Eigen::VectorXd stars = vertexStars(faceAreas(surface), surface.faces(), surface.vertexCount());
  const double mean = stars.dot(curvature.cwiseAbs()) / stars.sum();
  if (!(mean > 0)) throw InvalidArgument("A curvature that is not 0 everywhere is required, but it is.");
  return ((1 - weight) + weight * curvature.array().abs() / mean).matrix();
}

Eigen::VectorXd regionDensity(int count, const std::vector<int>& region, double factor) {
  if (!(factor > 0) || !std::isfinite(factor)) {
    throw InvalidArgument("A positive, finite factor is required, but it is " + std::to_string(factor) + ".");
  }
  Eigen::VectorXd density = Eigen::VectorXd::Ones(count);
  for (const int index : region) {
    if (index < 0 || index >= count) {
      throw InvalidArgument("Indices from 0 to " + std::to_string(count - 1) +
                            " are required in a region, but it has " + std::to_string(index) + ".");
    }
    density[index] = factor;
  }
  return density;
}

}  // namespace authalic
