#include "Core/authalic/SeamedAreas.h"

#include <utility>

#include "Core/numerics/FlipFreeStep.h"

namespace authalic {
namespace {

using Complex = std::complex<double>;

std::vector<char> freeButCones(const FlatConeSurface& flat) {
  std::vector<char> freedom(static_cast<std::size_t>(flat.places.rows()), 2);
  for (const int v : flat.cones) freedom[static_cast<std::size_t>(v)] = 0;
  return freedom;
}

double cross(Complex u, Complex v) { return (std::conj(u) * v).imag(); }

}  // namespace

SeamedAreas::SeamedAreas(const Faces& faces, const FlatConeSurface& flat)
    : SeamedAreas(faces, freeButCones(flat), flat.motions.corners) {}

SeamedAreas::SeamedAreas(const Faces& faces, std::vector<char> freedom, const std::vector<RigidMotion>& motions)
    : AreaFunctional(faces, std::move(freedom)), motions_(motions) {}

Eigen::VectorXd SeamedAreas::areas(const Coordinates& image) const {
  Eigen::VectorXd result(faces().rows());
  for (int f = 0; f < static_cast<int>(faces().rows()); ++f) {
    const Complex a = corner(image, f, 0);
    result[f] = 0.5 * cross(corner(image, f, 1) - a, corner(image, f, 2) - a);
  }
  return result;
}

AreaFunctional::Frames SeamedAreas::frames(const Coordinates& image) const {
  Frames result = Frames::Zero(image.rows(), 4);
  for (int v = 0; v < vertexCount(); ++v) {
    if (freedom(v) > 0) result.row(v) << 1, 0, 0, 1;
  }
  return result;
}

AreaFunctional::Gradients SeamedAreas::gradients(const Coordinates& image, const Frames&) const {
  Gradients result = Gradients::Zero(faces().rows(), 6);
  for (int f = 0; f < static_cast<int>(faces().rows()); ++f) {
    for (int k = 0; k < 3; ++k) {
      if (freedom(faces()(f, k)) == 0) continue;
      const Complex side = corner(image, f, (k + 2) % 3) - corner(image, f, (k + 1) % 3);
      const Complex gradient = std::conj(motion(f, k).turn) * Complex(-0.5 * side.imag(), 0.5 * side.real());
      result(f, 2 * k) = gradient.real();
      result(f, 2 * k + 1) = gradient.imag();
    }
  }
  return result;
}

AreaFunctional::Corners SeamedAreas::corners(const Coordinates& image, int face) const {
  Corners result(3, 2);
  for (int k = 0; k < 3; ++k) {
    const Complex place = corner(image, face, k);
    result.row(k) << place.real(), place.imag();
  }
  return result;
}

AreaFunctional::Directions SeamedAreas::directions(const Frames&, int face) const {
  Directions result = Directions::Zero(6, 2);
  for (int k = 0; k < 3; ++k) {
    if (freedom(faces()(face, k)) == 0) continue;
    const Complex turn = motion(face, k).turn;
    result.block<2, 2>(2 * k, 0) << turn.real(), turn.imag(), -turn.imag(), turn.real();
  }
  return result;
}

Coordinates SeamedAreas::moved(const Coordinates& image, const Coordinates& displacement, double t) const {
  return image + t * displacement;
}

double SeamedAreas::firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const {
  const auto move = [&](int k) {
    const int v = faces()(face, k);
    return motion(face, k).turn * Complex(displacement(v, 0), displacement(v, 1));
  };
  const Complex a = corner(image, face, 0), e = corner(image, face, 1) - a, g = corner(image, face, 2) - a;
  const Complex d = move(1) - move(0), h = move(2) - move(0);
  return smallestPositiveRoot(cross(d, h), cross(e, h) + cross(d, g), cross(e, g));
}

}  // namespace authalic
