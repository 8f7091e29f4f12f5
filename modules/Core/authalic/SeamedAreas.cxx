#include "Core/authalic/SeamedAreas.h"

#include <cmath>
#include <utility>

#include "Core/authalic/Patches.h"
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
    : SeamedAreas(faces, flat, CornerMoves()) {}

SeamedAreas::SeamedAreas(const Faces& faces, std::vector<char> freedom, std::vector<RigidMotion> motions)
    : AreaFunctional(faces, std::move(freedom)), own_(std::move(motions)), motions_(own_) {}

SeamedAreas::SeamedAreas(const Faces& faces, const FlatConeSurface& flat, CornerMoves parameters)
    : AreaFunctional(faces, freeButCones(flat)), motions_(flat.motions.corners), moves_(std::move(parameters)) {}

// What the rows of the parameters, either values or displacements, do to a corner.
Complex SeamedAreas::shift(const Coordinates& rows, int face, int k) const {
  Complex result = 0;
  const int row = moves_.row.empty() ? -1 : moves_.row[static_cast<std::size_t>(3 * face + k)];
  for (Eigen::Index j = 0; row >= 0 && j < moves_.moves.cols(); ++j) {
    result += moves_.moves(row, j) * Complex(rows(vertexCount() + j, 0), rows(vertexCount() + j, 1));
  }
  return result;
}

// The same with the row of its vertex.
Complex SeamedAreas::change(const Coordinates& rows, int face, int k) const {
  const int v = faces()(face, k);
  Complex result = shift(rows, face, k);
  if (freedom(v) > 0) result += motion(face, k).turn * Complex(rows(v, 0), rows(v, 1));
  return result;
}

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
  const Coordinates result = image + t * displacement;
  if (displacement.bottomRows(displacement.rows() - vertexCount()).isZero(0)) return result;
  return result * std::sqrt(areas(image).sum() / areas(result).sum());
}

double SeamedAreas::firstFlip(const Coordinates& image, const Coordinates& displacement, int face) const {
  const Complex a = corner(image, face, 0), e = corner(image, face, 1) - a, g = corner(image, face, 2) - a;
  const Complex still = change(displacement, face, 0), d = change(displacement, face, 1) - still,
                h = change(displacement, face, 2) - still;
  return smallestPositiveRoot(cross(d, h), cross(e, h) + cross(d, g), cross(e, g));
}

// With parameters, the motions that these make; each corner at a cone, whose row then says nothing, stays where it is.
std::unique_ptr<AreaFunctional> SeamedAreas::inPatch(const Patch& patch, const Coordinates& image) const {
  const auto motionIn = [&](int f, int k) {
    if (moves_.row.empty()) return motion(f, k);
    return RigidMotion{freedom(faces()(f, k)) > 0 ? motion(f, k).turn : 0, shift(image, f, k)};
  };
  std::vector<RigidMotion> motions;
  for (const int f : patch.faces) {
    for (int k = 0; k < 3; ++k) motions.push_back(motionIn(f, k));
  }
  return std::make_unique<SeamedAreas>(patch.corners, patch.freedom, std::move(motions));
}

CornerMoves cornerMoves(const SurfaceTopology& topology, const FlatConeSurface& flat) {
  const Eigen::Index count = flat.translations.size();
  const std::size_t corners = flat.motions.corners.size();
  std::vector<int> coneOf(static_cast<std::size_t>(flat.places.rows()), -1);
  for (std::size_t i = 0; i < flat.cones.size(); ++i) {
    coneOf[static_cast<std::size_t>(flat.cones[i])] = static_cast<int>(i);
  }
  std::vector<ConeMotions> units;
  for (Eigen::Index j = 0; j < count; ++j) {
    units.push_back(flat.holonomy.motions(topology, flat.cut, Eigen::VectorXcd::Unit(count, j)));
  }
  CornerMoves result{std::vector<int>(corners, -1), {}};
  Eigen::VectorXcd moves(count);
  std::vector<Complex> table;
  for (std::size_t c = 0; c < corners; ++c) {
    const int cone = coneOf[static_cast<std::size_t>(topology.tail(static_cast<int>(c)))];
    for (Eigen::Index j = 0; j < count; ++j) {
      const ConeMotions& unit = units[static_cast<std::size_t>(j)];
      moves[j] = cone < 0 ? unit.corners[c].shift : unit.corners[c](unit.places[static_cast<std::size_t>(cone)]);
    }
    if (moves.isZero(0)) continue;
    result.row[c] = static_cast<int>(table.size()) / static_cast<int>(count);
    table.insert(table.end(), moves.begin(), moves.end());
  }
  result.moves = Eigen::Map<CornerMoves::Table>(table.data(), static_cast<Eigen::Index>(table.size()) / count, count);
  return result;
}

}  // namespace authalic
