#include "Core/geometry/IntrinsicTriangulation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <utility>

#include "Core/base/Error.h"

namespace authalic {
namespace {

// ln(e^a + e^b) without overflow.
double logOfSum(double a, double b) {
  const double most = std::max(a, b);
  return most + std::log1p(std::exp(std::min(a, b) - most));
}

// cos γ = (a² + b² − c²)/(2ab) and the size of its terms, from logarithms.
struct Cosine {
  double value, size;
};

Cosine cosineOpposite(double logC, double logA, double logB) {
  const double ratio = std::exp(logA - logB), square = std::exp(2 * logC - logA - logB);
  const double symmetric = 0.5 * (ratio + 1 / ratio);
  return {symmetric - 0.5 * square, symmetric + 0.5 * square};
}

// Sine law and half-angle formulas are exact enough only with the sides in order (W. Kahan): 16 × area².
double sixteenSquaredAreas(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  return (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
}

std::string edgeName(int i, int j) {
  return std::to_string(i) + "-" + std::to_string(j);
}

}  // namespace

IntrinsicTriangulation::IntrinsicTriangulation(const TriangleMesh& surface, const SurfaceTopology& topology) {
  connect(topology);
  for (int h = 0; h < halfEdgeCount(); ++h) {
    const double length = (surface.point(topology.head(h)) - surface.point(topology.tail(h))).norm();
    if (!(length > 0)) {
      throw GeometryError("Edges with a length are required, but the edge " + edgeName(tail(h), head(h)) +
                          " joins two vertices at the same place; merge them first.");
    }
    logLength_[static_cast<std::size_t>(h)] = std::log(length);
  }
}

IntrinsicTriangulation::IntrinsicTriangulation(const SurfaceTopology& topology, const FaceLengths& lengths) {
  connect(topology);
  if (lengths.rows() != faceCount()) {
    throw GeometryError("Three lengths per face are required: there are " + std::to_string(faceCount()) +
                        " faces, but " + std::to_string(lengths.rows()) + " rows of lengths.");
  }
  for (int h = 0; h < halfEdgeCount(); ++h) {
    const double length = lengths(h / 3, h % 3);
    const int across = opposite(h);
    if (!(length > 0) || !std::isfinite(length)) {
      throw GeometryError("Positive finite edge lengths are required, but the edge " +
                          edgeName(tail(h), head(h)) + " has " + std::to_string(length) + ".");
    }
    if (across >= 0 && lengths(across / 3, across % 3) != length) {
      throw GeometryError("One length per edge is required, but the two faces of the edge " +
                          edgeName(tail(h), head(h)) + " give it different ones.");
    }
    logLength_[static_cast<std::size_t>(h)] = std::log(length);
  }
}

void IntrinsicTriangulation::connect(const SurfaceTopology& topology) {
  const int count = static_cast<int>(3 * topology.faces().rows());
  vertexCount_ = topology.vertexCount();
  onBoundary_ = topology.onBoundary();
  tail_.resize(static_cast<std::size_t>(count));
  next_.resize(tail_.size());
  opposite_.resize(tail_.size());
  face_.resize(tail_.size());
  logLength_.resize(tail_.size());
  first_.resize(tail_.size() / 3);
  for (int h = 0; h < count; ++h) {
    const auto i = static_cast<std::size_t>(h);
    tail_[i] = topology.tail(h);
    next_[i] = SurfaceTopology::next(h);
    opposite_[i] = topology.opposite(h);
    face_[i] = h / 3;
    if (h % 3 == 0) first_[i / 3] = h;
  }
}

Faces IntrinsicTriangulation::faces() const {
  Faces faces(faceCount(), 3);
  for (int f = 0; f < faceCount(); ++f) {
    const int h = first(f);
    faces.row(f) << tail(h), tail(next(h)), tail(previous(h));
  }
  return faces;
}

void IntrinsicTriangulation::setLogLength(int h, double logLength) {
  logLength_[static_cast<std::size_t>(h)] = logLength;
  if (opposite(h) >= 0) logLength_[static_cast<std::size_t>(opposite(h))] = logLength;
}

FaceShape IntrinsicTriangulation::shape(int f, const Eigen::VectorXd& u) const {
  const int h0 = first(f), h1 = next(h0), h2 = next(h1);
  const double u0 = u[tail(h0)], u1 = u[tail(h1)], u2 = u[tail(h2)];
  const double log0 = logLength(h0) + 0.5 * (u0 + u1), log1 = logLength(h1) + 0.5 * (u1 + u2),
               log2 = logLength(h2) + 0.5 * (u2 + u0);
  const double most = std::max({log0, log1, log2});
  const double side[3] = {std::exp(log0 - most), std::exp(log1 - most), std::exp(log2 - most)};
  const double square = sixteenSquaredAreas(side[0], side[1], side[2]);
  FaceShape shape{};
  shape.triangle = square > 0 && std::min({side[0], side[1], side[2]}) > 0;
  if (!shape.triangle) {
    // The convex continuation: the longest side takes the straight angle @cite bobenko2015.
    for (int k = 0; k < 3; ++k) shape.angle[k] = 0;
    shape.angle[side[0] == 1 ? 0 : side[1] == 1 ? 1 : 2] = M_PI;
    return shape;
  }
  const double area = std::sqrt(square);
  for (int k = 0; k < 3; ++k) {
    const double c = side[k], a = side[(k + 1) % 3], b = side[(k + 2) % 3];
    const double numerator = a > b ? (a - c) * (a + c) + b * b : (b - c) * (b + c) + a * a;
    shape.angle[k] = std::atan2(area, numerator);
    shape.cotangent[k] = numerator / area;
  }
  return shape;
}

double IntrinsicTriangulation::oppositeCosine(int h, const Eigen::VectorXd& u) const {
  return cosineOpposite(logLength(h, u), logLength(next(h), u), logLength(previous(h), u)).value;
}

namespace {

// cot γ opposite to the side c, NaN where no triangle has such sides.
double cotangentOpposite(double logC, double logA, double logB) {
  const double most = std::max({logA, logB, logC});
  double a = std::exp(logA - most), b = std::exp(logB - most);
  const double c = std::exp(logC - most), square = sixteenSquaredAreas(a, b, c);
  if (!(square > 0)) return NAN;
  if (a < b) std::swap(a, b);
  return ((a - c) * (a + c) + b * b) / std::sqrt(square);
}

}  // namespace

bool IntrinsicTriangulation::isDelaunay(int h, const Eigen::VectorXd& u) const {
  const int g = opposite(h);
  if (g < 0 || face(g) == face(h)) return true;
  const double side = logLength(h, u), a = logLength(next(h), u), b = logLength(previous(h), u),
               c = logLength(next(g), u), d = logLength(previous(g), u);
  const double left = cotangentOpposite(side, a, b), right = cotangentOpposite(side, c, d);
  if (std::isnan(left + right)) {
    const Cosine one = cosineOpposite(side, a, b), other = cosineOpposite(side, c, d);
    return one.value + other.value >= -1e-12 * (one.size + other.size);
  }
  // The rounding of lengths, that of their logarithms, becomes 1 + cot² times as large in a cotangent.
  const double largest = std::max({1.0, std::abs(side), std::abs(a), std::abs(b), std::abs(c), std::abs(d)});
  return left + right >= -1e-12 - 1e-14 * largest * (2 + left * left + right * right);
}

bool IntrinsicTriangulation::flippable(int h) const {
  const int g = opposite(h);
  return g >= 0 && face(g) != face(h);
}

double IntrinsicTriangulation::flippedLogLength(int h, const Eigen::VectorXd& u, FlipRule rule) const {
  const int g = opposite(h);
  const int jk = next(h), ki = next(jk), il = next(g), lj = next(il);
  if (rule == FlipRule::Ptolemy) {
    return logOfSum(logLength(ki) + logLength(lj), logLength(il) + logLength(jk)) - logLength(h);
  }
  // l_kl² = b² + d² − 2 b d cos(α + β) with the sides b, d and angles α, β of both triangles at i.
  const FaceShape left = shape(face(h), u), right = shape(face(g), u);
  const auto angleAt = [this](const FaceShape& s, int half) {  // opposite to `half`
    const int h0 = first(face(half));
    return s.angle[half == h0 ? 0 : half == next(h0) ? 1 : 2];
  };
  const double angle = angleAt(left, jk) + angleAt(right, lj);
  const double logB = logLength(ki, u), logD = logLength(il, u), most = std::max(logB, logD);
  const double b = std::exp(logB - most), d = std::exp(logD - most), half = std::sin(0.5 * angle);
  // Two vertices that fall together (faces folded flat) keep a distance that has a logarithm.
  const double squared = std::max((b - d) * (b - d) + 4 * b * d * half * half, 1e-20);
  return most + 0.5 * std::log(squared) - 0.5 * (u[tail(ki)] + u[tail(lj)]);
}

void IntrinsicTriangulation::flip(int h, const Eigen::VectorXd& u, FlipRule rule) {
  const int g = opposite(h);
  const int jk = next(h), ki = next(jk), il = next(g), lj = next(il);
  const double length = flippedLogLength(h, u, rule);
  if (recording_) flips_.push_back(h);
  const auto at = [](auto& array, int i) -> auto& {
    return array[static_cast<std::size_t>(i)];
  };
  if (!winding_.empty()) {
    at(winding_, h) = -(winding(ki) + winding(il));  // around face (l → k → i)
    at(winding_, g) = -at(winding_, h);
  }
  if (!crossings_.empty()) at(crossings_, h) = at(crossings_, g) = flippedCrossings(h);
  at(tail_, h) = tail(lj);
  at(tail_, g) = tail(ki);
  at(logLength_, h) = at(logLength_, g) = length;
  at(next_, il) = h;  // face i, l, k
  at(next_, h) = ki;
  at(next_, ki) = il;
  at(next_, jk) = g;  // face j, k, l
  at(next_, g) = lj;
  at(next_, lj) = jk;
  at(face_, il) = at(face_, ki) = face(h);
  at(face_, jk) = at(face_, lj) = face(g);
  at(first_, face(h)) = h;
  at(first_, face(g)) = g;
}

void IntrinsicTriangulation::trackCrossings() {
  crossings_.assign(next_.size(), -1);
}

FaceCrossings IntrinsicTriangulation::faceCrossings(int h) const {
  const int ij = std::max(crossings(h), 0), jk = std::max(crossings(next(h)), 0),
            ki = std::max(crossings(previous(h)), 0);
  const auto from = [](int across, int one, int other) { return std::max(0, across - one - other); };
  const int fromI = from(jk, ij, ki), fromJ = from(ki, ij, jk);
  FaceCrossings c;
  c.fromApex = from(ij, jk, ki);
  c.aroundTail = (std::max(0, ij + ki - jk) - fromJ - c.fromApex) / 2;
  c.aroundHead = (std::max(0, ij + jk - ki) - fromI - c.fromApex) / 2;
  return c;
}

// A tracked edge crosses the new diagonal kl when it cuts off k or l, runs from i or j over the far side,
// changes sides on its way through ij, or is ij.
int IntrinsicTriangulation::flippedCrossings(int h) const {
  const int g = opposite(h);
  const FaceCrossings above = faceCrossings(h), below = faceCrossings(g);
  int count = crossings(h) < 0 ? 1 : 0;
  for (const int half :
       {next(h), next(g)}) {  // jk and il: around their heads lie k and l; their apices are i and j
    const FaceCrossings side = faceCrossings(half);
    count += side.aroundHead + side.fromApex;
  }
  for (const int half : {previous(h), previous(g)}) count += faceCrossings(half).fromApex;
  count += std::max(0, above.aroundTail - below.aroundHead - below.fromApex) +
           std::max(0, below.aroundHead - above.aroundTail - above.fromApex);
  // One that runs from k to l through ij is the new diagonal.
  const int both = std::min(above.aroundTail + above.fromApex, below.aroundHead + below.fromApex) -
                   std::max(above.aroundTail, below.aroundHead);
  return both > 0 ? -1 : count;
}

int IntrinsicTriangulation::makeDelaunay(const Eigen::VectorXd& u, FlipRule rule,
                                         const Execution& execution) {
  std::vector<char> waiting(static_cast<std::size_t>(halfEdgeCount()), 0);
  parallelFor(waiting.size(), execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h) {
      const int half = static_cast<int>(h);
      if (opposite(half) > half) waiting[h] = !isDelaunay(half, u);
    }
  });
  std::deque<int> queue;
  for (int h = 0; h < halfEdgeCount(); ++h) {
    if (waiting[static_cast<std::size_t>(h)]) queue.push_back(h);
  }
  int flips = 0;
  const int most = 1000 * (halfEdgeCount() + 100);
  while (!queue.empty()) {
    if (flips > most)
      throw SolverError("Edge lengths within the range of double are required, but flips do not end.");
    const int h = queue.front(), g = opposite(h);
    queue.pop_front();
    waiting[static_cast<std::size_t>(h)] = 0;
    if (isDelaunay(h, u)) continue;
    flip(h, u, rule);
    ++flips;
    for (const int side : {next(h), previous(h), next(g), previous(g)}) {
      const int edge =
          std::min(side, opposite(side));  // the half-edge that stands for its edge; −1: boundary
      if (edge < 0 || waiting[static_cast<std::size_t>(edge)]) continue;
      waiting[static_cast<std::size_t>(edge)] = 1;
      queue.push_back(edge);
    }
  }
  return flips;
}

int IntrinsicTriangulation::splitBoundaryEdge(int h, const Eigen::VectorXd& u) {
  const int jk = next(h), ki = previous(h), i = tail(h), j = head(h), middle = vertexCount_++;
  const FaceShape form = shape(face(h), u);
  const auto angleOpposite = [&](int half) {
    return form.angle[half == first(face(h)) ? 0 : half == next(first(face(h))) ? 1 : 2];
  };
  const double alpha = angleOpposite(jk), beta = angleOpposite(ki), uMiddle = 0.5 * (u[i] + u[j]);
  const auto stored = [&](double logLength, int end) { return logLength - 0.5 * (u[end] + uMiddle); };
  const double logIm = stored(logLength(ki, u) + std::log(std::cos(alpha)), i),
               logMj = stored(logLength(jk, u) + std::log(std::cos(beta)), j),
               logMk = stored(logLength(ki, u) + std::log(std::sin(alpha)), tail(ki));
  const int mj = halfEdgeCount(), km = mj + 1, mk = mj + 2, newFace = faceCount();
  // Face i, m, k keeps the number: h, mk, ki. The new one is m, j, k: mj, jk, km.
  tail_.insert(tail_.end(), {middle, tail(ki), middle});
  next_.insert(next_.end(), {jk, mj, ki});
  opposite_.insert(opposite_.end(), {-1, mk, km});
  face_.insert(face_.end(), {newFace, newFace, face(h)});
  logLength_.insert(logLength_.end(), {logMj, logMk, logMk});
  if (!winding_.empty()) winding_.insert(winding_.end(), {winding(h), winding(ki), -winding(ki)});
  if (!winding_.empty()) winding_[static_cast<std::size_t>(h)] = 0;
  logLength_[static_cast<std::size_t>(h)] = logIm;
  next_[static_cast<std::size_t>(h)] = mk;
  next_[static_cast<std::size_t>(jk)] = km;
  face_[static_cast<std::size_t>(jk)] = newFace;
  first_[static_cast<std::size_t>(face(h))] = h;
  first_.push_back(mj);
  onBoundary_.push_back(1);
  crossings_.clear();
  return middle;
}

void IntrinsicTriangulation::attachWinding(std::vector<int> winding) {
  bool closed = static_cast<int>(winding.size()) == halfEdgeCount();
  for (int h = 0; closed && h < halfEdgeCount(); ++h) {
    const auto w = [&winding](int half) { return winding[static_cast<std::size_t>(half)]; };
    closed = w(h) + w(next(h)) + w(previous(h)) == 0 && (opposite(h) < 0 || w(opposite(h)) == -w(h));
  }
  if (!closed) {
    throw InvalidArgument(
        "A closed integer 1-form is required as winding numbers: one per half-edge, opposite on "
        "opposite half-edges, summing to 0 around every face.");
  }
  winding_ = std::move(winding);
}

}  // namespace authalic
