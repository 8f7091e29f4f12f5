#include "Core/authalic/PeriodicAreas.h"

#include <utility>

#include "Core/authalic/Patches.h"
#include "Core/authalic/SeamedAreas.h"
#include "Core/geometry/Areas.h"
#include "Core/numerics/FlipFreeStep.h"

namespace authalic {
namespace {

double cross(const Eigen::Vector2d& u, const Eigen::Vector2d& v) { return u[0] * v[1] - u[1] * v[0]; }

}  // namespace

PeriodicAreas::PeriodicAreas(const Faces& faces, const Points2& shifts, std::vector<char> freedom)
    : AreaFunctional(faces, std::move(freedom)), shifts_(shifts) {}

Eigen::VectorXd PeriodicAreas::areas(const Coordinates& image) const {
  return periodicFaceAreas(Points2(image), shifts_, faces());
}

AreaFunctional::Frames PeriodicAreas::frames(const Coordinates& image) const {
  Frames result = Frames::Zero(image.rows(), 4);
  for (int v = 0; v < vertexCount(); ++v) {
    if (freedom(v) > 0) result(v, 0) = 1;
    if (freedom(v) == 2) result(v, 3) = 1;
  }
  return result;
}

AreaFunctional::Gradients PeriodicAreas::gradients(const Coordinates& image, const Frames& frames) const {
  Gradients result(faces().rows(), 6);
  for (int f = 0; f < static_cast<int>(faces().rows()); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d across = corner(image, f, (k + 2) % 3) - corner(image, f, (k + 1) % 3);
      const auto frame = frames.row(faces()(f, k));
      result(f, 2 * k) = 0.5 * (across[0] * frame[1] - across[1] * frame[0]);
      result(f, 2 * k + 1) = 0.5 * (across[0] * frame[3] - across[1] * frame[2]);
    }
  }
  return result;
}

AreaFunctional::Corners PeriodicAreas::corners(const Coordinates& image, int face) const {
  return AreaFunctional::corners(image, face) + shifts_.middleRows<3>(3 * face);
}

Coordinates PeriodicAreas::moved(const Coordinates& image, const Coordinates& displacement, double t) const {
  return image + t * displacement;
}

double PeriodicAreas::firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const {
  const Eigen::Vector2d e = corner(image, face, 1) - corner(image, face, 0);
  const Eigen::Vector2d g = corner(image, face, 2) - corner(image, face, 0);
  const auto moves = [&](int k) { return Eigen::Vector2d(displacement.row(faces()(face, k)).transpose()); };
  const Eigen::Vector2d d = moves(1) - moves(0), h = moves(2) - moves(0);
  return smallestPositiveRoot(cross(d, h), cross(e, h) + cross(d, g), cross(e, g));
}

std::unique_ptr<AreaFunctional> PeriodicAreas::inPatch(const Patch& patch, const Coordinates&) const {
  std::vector<RigidMotion> motions;
  for (const int f : patch.faces) {
    for (int k = 0; k < 3; ++k) motions.push_back({1, {shifts_(3 * f + k, 0), shifts_(3 * f + k, 1)}});
  }
  return std::make_unique<SeamedAreas>(patch.corners, patch.freedom, std::move(motions));
}

}  // namespace authalic
