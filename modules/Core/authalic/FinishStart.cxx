#include "Core/authalic/FinishStart.h"

#include <cmath>

#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"

namespace authalic {
namespace {

constexpr double kExact = 1e-10;

bool exact(const Eigen::VectorXd& faceAreas, const Faces& faces, const Eigen::VectorXd& targets) {
  if (!(faceAreas.minCoeff() > 0)) return false;
  const Eigen::VectorXd stars = vertexStars(faceAreas / faceAreas.sum(), faces, static_cast<int>(targets.size()));
  for (Eigen::Index v = 0; v < stars.size(); ++v) {
    if (targets[v] > 0 && !(std::abs(std::log(stars[v] / targets[v])) <= kExact)) return false;
  }
  return true;
}

}  // namespace

const Points2& finishStart(const DiskMesh& disk, const TargetMeasure& target, const Points2& moved,
                           const Points2& sites) {
  const Faces& faces = disk.mesh().faces();
  return sites.size() > 0 && exact(signedFaceAreas(sites, faces), faces, target.vertices()) ? sites : moved;
}

const Points3& finishStart(const SphereMesh& sphere, const TargetMeasure& target, const Points3& moved,
                           const Points3& sites) {
  const Faces& faces = sphere.mesh().faces();
  return sites.size() > 0 && exact(signedSolidAngles(sites, faces), faces, target.vertices()) ? sites : moved;
}

}  // namespace authalic
