#include "Core/authalic/FlowingMesh.h"

#include <Eigen/Geometry>

#include "Core/geometry/SphericalAreas.h"
#include "Core/mesh/SurfaceTopology.h"

namespace authalic {
namespace {

// Blocks of rows, one block for each face.
template <class Rows>
Rows withoutFrozen(const Rows& rows, Eigen::Index perFace, const std::vector<char>& frozen) {
  if (frozen.empty() || rows.size() == 0) return rows;
  Rows kept(rows.rows(), rows.cols());
  Eigen::Index count = 0;
  for (Eigen::Index f = 0; perFace * f < rows.rows(); ++f) {
    if (frozen[static_cast<std::size_t>(f)]) continue;
    kept.middleRows(count, perFace) = rows.middleRows(perFace * f, perFace);
    count += perFace;
  }
  return kept.topRows(count);
}

// Cross and dot product of the edge vectors a − c and b − c.
struct Corner {
  double cross, dot;
  Corner(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c) {
    const Eigen::RowVector2d u = a - c, v = b - c;
    cross = u[0] * v[1] - u[1] * v[0];
    dot = u.dot(v);
  }
};

// Whether the quad a d b c, all unit vectors, is convex, and its diagonal a b not that of the convex hull.
bool shouldFlipOnSphere(const Coordinates& p, int a, int b, int c, int d) {
  const auto row = [&p](int v) { return Eigen::Vector3d(p.row(v).transpose()); };
  const Eigen::Vector3d u = row(b) - row(a), v = row(c) - row(a), w = row(d) - row(a);
  const Eigen::Vector3d normal = u.cross(v);
  if (!(normal.dot(w) > 1e-12 * normal.norm() * w.norm())) return false;
  return signedDeterminant(row(c), row(a), row(d)) > 0 && signedDeterminant(row(d), row(b), row(c)) > 0;
}

}  // namespace

FlowingMesh::FlowingMesh(const Faces& faces, int vertexCount, const std::vector<char>& frozen, const Points2& shifts)
    : faces_(withoutFrozen(faces, 1, frozen)), shifts_(withoutFrozen(shifts, 3, frozen)) {
  const SurfaceTopology topology(faces_, vertexCount);
  opposite_.resize(static_cast<std::size_t>(3 * faces_.rows()));
  for (std::size_t h = 0; h < opposite_.size(); ++h) opposite_[h] = topology.opposite(static_cast<int>(h));
}

// Of the corner that a half-edge leaves.
Eigen::RowVector2d FlowingMesh::shift(int h) const {
  return shifts_.size() == 0 ? Eigen::RowVector2d(0, 0) : Eigen::RowVector2d(shifts_.row(h));
}

bool FlowingMesh::shouldFlip(const Coordinates& points, int h) const {
  const int g = opposite_[static_cast<std::size_t>(h)];
  if (g < 0) return false;
  const int a = faces_(h / 3, h % 3), b = faces_(h / 3, (h + 1) % 3), c = faces_(h / 3, (h + 2) % 3),
            d = faces_(g / 3, (g + 2) % 3);
  if (points.cols() == 3) return shouldFlipOnSphere(points, a, b, c, d);
  const int f = h / 3;
  const Eigen::RowVector2d across = shift(h) - shift(3 * (g / 3) + (g + 1) % 3),  // from the chart of the other face
      pa = points.row(a) + shift(h), pb = points.row(b) + shift(3 * f + (h + 1) % 3),
      pc = points.row(c) + shift(3 * f + (h + 2) % 3), pd = points.row(d) + shift(3 * (g / 3) + (g + 2) % 3) + across;
  const Corner atC(pa, pb, pc), atD(pb, pa, pd);
  if (!(atC.cross > 0 && atD.cross > 0)) return false;
  if (atC.dot * atD.cross + atD.dot * atC.cross >= -1e-12 * atC.cross * atD.cross) return false;  // cot + cot ≥ 0
  const double first = Corner(pa, pd, pc).cross, second = Corner(pd, pb, pc).cross;
  return first > 0 && second > 0;
}

void FlowingMesh::join(int h, int g) {
  opposite_[static_cast<std::size_t>(h)] = g;
  if (g >= 0) opposite_[static_cast<std::size_t>(g)] = h;
}

// Faces (a b c) and (b a d) become (c a d) and (d b c).
void FlowingMesh::flip(int h) {
  const int g = opposite_[static_cast<std::size_t>(h)], f = h / 3, e = g / 3;
  const int a = faces_(f, h % 3), b = faces_(f, (h + 1) % 3), c = faces_(f, (h + 2) % 3), d = faces_(e, (g + 2) % 3);
  const auto outside = [this](int face, int k) { return opposite_[static_cast<std::size_t>(3 * face + k % 3)]; };
  const int bc = outside(f, h % 3 + 1), ca = outside(f, h % 3 + 2), ad = outside(e, g % 3 + 1),
            db = outside(e, g % 3 + 2);
  if (shifts_.size() > 0) {
    const auto corner = [this](int face, int k) { return Eigen::RowVector2d(shifts_.row(3 * face + k % 3)); };
    const Eigen::RowVector2d sa = corner(f, h), sb = corner(f, h % 3 + 1), sc = corner(f, h % 3 + 2),
                             sd = corner(e, g % 3 + 2) + sa - corner(e, g % 3 + 1);
    shifts_.middleRows<3>(3 * f) << sc, sa, sd;
    shifts_.middleRows<3>(3 * e) << sd, sb, sc;
  }
  faces_.row(f) << c, a, d;
  faces_.row(e) << d, b, c;
  join(3 * f, ca);
  join(3 * f + 1, ad);
  join(3 * e, db);
  join(3 * e + 1, bc);
  join(3 * f + 2, 3 * e + 2);
  for (const int k : {3 * f, 3 * f + 1, 3 * e, 3 * e + 1}) stack_.push_back(k);
}

int FlowingMesh::makeDelaunay(const Coordinates& points) {
  const int halfEdges = static_cast<int>(3 * faces_.rows());
  stack_.clear();
  for (int h = halfEdges - 1; h >= 0; --h) {
    if (opposite_[static_cast<std::size_t>(h)] > h && shouldFlip(points, h)) stack_.push_back(h);
  }
  int flips = 0;
  while (!stack_.empty() && flips < 50 * halfEdges) {
    const int h = stack_.back();
    stack_.pop_back();
    if (!shouldFlip(points, h)) continue;
    flip(h);
    ++flips;
  }
  return flips;
}

}  // namespace authalic
