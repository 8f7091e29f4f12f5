#include "ConformalImages.h"

#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/conformal/SphericalConformalMap.h"

namespace authalic {
namespace {

void requireNoFolds(int flippedFaces, const char* use) {
  if (flippedFaces == 0) return;
  throw GeometryError(std::string("A conformal map without folds is required for ") + use + ", but " +
                      std::to_string(flippedFaces) + " faces of it are folded.");
}

}  // namespace

Points2 conformalImage(const DiskMesh& disk, bool isDisk, const char* use, bool foldsAllowed,
                       const Execution& execution) {
  if (!isDisk) {
    throw InvalidArgument(std::string("The domain disk is required for ") + use + "; angles are kept there.");
  }
  RiemannMapResult riemann = riemannMap(disk, {}, execution);
  if (riemann.status == Status::Cancelled) throw CancelledError();
  if (!foldsAllowed) requireNoFolds(riemann.flippedFaces, use);
  return std::move(riemann.image);
}

Points3 conformalImage(const SphereMesh& sphere, const char* use, const Execution& execution) {
  SphericalMapResult conformal = sphericalConformalMap(sphere, {}, execution);
  if (conformal.status == Status::Cancelled) throw CancelledError();
  requireNoFolds(conformal.flippedFaces, use);
  return std::move(conformal.image);
}

}  // namespace authalic
