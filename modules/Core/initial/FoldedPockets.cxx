#include "Core/initial/FoldedPockets.h"

#include <algorithm>
#include <utility>

#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

constexpr double kFlattest = 0.05, kHighest = 0.5;  // of a pocket, in chords

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Pockets {
 public:
  Pockets(const TriangleMesh& surface, const SurfaceTopology& topology, Points2 image)
      : surface_(surface), topology_(topology), areas_(faceAreas(surface)), loop_(at(surface.vertexCount()), -1) {
    result_.image = std::move(image);
    for (std::size_t k = 0; k < topology.boundaryLoops().size(); ++k) {
      for (const int v : topology.boundaryLoops()[k]) loop_[at(v)] = static_cast<int>(k);
    }
  }

  FoldedPocketsResult run();

 private:
  [[nodiscard]] bool isChord(int h) const {
    return topology_.opposite(h) >= 0 && loop_[at(topology_.tail(h))] >= 0 &&
           loop_[at(topology_.tail(h))] == loop_[at(topology_.head(h))];
  }
  [[nodiscard]] std::vector<int> collect(int firstFace, int entry, std::vector<char>& seen) const;
  [[nodiscard]] std::vector<int> mainPart() const;
  [[nodiscard]] bool folded(const std::vector<int>& pocket) const;
  void bulge(int chord, const std::vector<int>& pocket);
  void placeEar(int chord, int face);
  void placeLarge(int chord, const std::vector<int>& pocket);

  const TriangleMesh& surface_;
  const SurfaceTopology& topology_;
  Eigen::VectorXd areas_;
  std::vector<int> loop_;  // per vertex, −1 inside
  FoldedPocketsResult result_;
};

// Faces reached from one without crossing `entry`; chords are crossed unless entry is −1.
std::vector<int> Pockets::collect(int firstFace, int entry, std::vector<char>& seen) const {
  std::vector<int> faces{firstFace};
  seen[at(firstFace)] = 1;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    for (int h = 3 * faces[k]; h < 3 * faces[k] + 3; ++h) {
      const int across = topology_.opposite(h);
      if (across < 0 || h == entry || seen[at(across / 3)] || (entry < 0 && isChord(h))) continue;
      seen[at(across / 3)] = 1;
      faces.push_back(across / 3);
    }
  }
  return faces;
}

// The largest part of the surface between chords.
std::vector<int> Pockets::mainPart() const {
  std::vector<char> seen(at(surface_.faceCount()), 0);
  std::vector<int> largest;
  double most = -1;
  for (int f = 0; f < surface_.faceCount(); ++f) {
    if (seen[at(f)]) continue;
    std::vector<int> part = collect(f, -1, seen);
    double area = 0;
    for (const int g : part) area += areas_[g];
    if (area > most) {
      most = area;
      largest = std::move(part);
    }
  }
  return largest;
}

bool Pockets::folded(const std::vector<int>& pocket) const {
  Faces faces(static_cast<Eigen::Index>(pocket.size()), 3);
  for (std::size_t k = 0; k < pocket.size(); ++k) faces.row(static_cast<Eigen::Index>(k)) = surface_.faces().row(pocket[k]);
  return countFlippedFaces(result_.image, faces) > 0;
}

// The ear's own shape over the image of its chord. The chord runs so that the pocket lies to its left.
void Pockets::placeEar(int chord, int face) {
  const int i = topology_.tail(chord), j = topology_.head(chord), tip = topology_.head(SurfaceTopology::next(chord));
  const Eigen::Vector3d base = surface_.point(j) - surface_.point(i), arm = surface_.point(tip) - surface_.point(i);
  const double along = std::clamp(base.dot(arm) / base.squaredNorm(), 0.0, 1.0),
               height = std::clamp(2 * areas_[face] / base.squaredNorm(), kFlattest, kHighest);
  const Eigen::RowVector2d side = result_.image.row(j) - result_.image.row(i), normal(-side[1], side[0]);
  result_.image.row(tip) = result_.image.row(i) + along * side + height * normal;
  result_.movedVertices.push_back(tip);
}

// Boundary on a parabola over the chord, the rest at the mean of its neighbours.
void Pockets::placeLarge(int chord, const std::vector<int>& pocket) {
  std::vector<int> local(at(surface_.vertexCount()), -1), vertices;
  Faces faces(static_cast<Eigen::Index>(pocket.size()), 3);
  double area = 0;
  for (std::size_t k = 0; k < pocket.size(); ++k) {
    area += areas_[pocket[k]];
    for (int c = 0; c < 3; ++c) {
      const int v = surface_.faces()(pocket[k], c);
      if (local[at(v)] < 0) {
        local[at(v)] = static_cast<int>(vertices.size());
        vertices.push_back(v);
      }
      faces(static_cast<Eigen::Index>(k), c) = local[at(v)];
    }
  }
  const SurfaceTopology topology(faces, static_cast<int>(vertices.size()));
  std::vector<int> loop = topology.boundaryLoops().front();
  const int i = topology_.tail(chord), j = topology_.head(chord);
  std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), local[at(j)]), loop.end());  // j … i, then the chord
  std::vector<double> reached{0};
  for (std::size_t k = 1; k < loop.size(); ++k) {
    reached.push_back(reached.back() + (surface_.point(vertices[at(loop[k])]) - surface_.point(vertices[at(loop[k - 1])])).norm());
  }
  const double chordSquared = (surface_.point(j) - surface_.point(i)).squaredNorm(),
               sagitta = std::clamp(1.5 * area / std::max(chordSquared, 1e-300), kFlattest, kHighest);
  const Eigen::RowVector2d start = result_.image.row(j), side = result_.image.row(i) - start, normal(side[1], -side[0]);
  Points2 image = Points2::Zero(static_cast<Eigen::Index>(vertices.size()), 2);
  std::vector<char> held(vertices.size(), 0);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const double t = reached[k] / reached.back();
    held[at(loop[k])] = 1;
    image.row(loop[k]) = start + t * side + 4 * sagitta * t * (1 - t) * normal;
  }
  solveBarycentric(faces, HalfEdgeWeights::Constant(faces.rows(), 3, 1.0), held, SolverBackend::Automatic, image);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (vertices[v] == i || vertices[v] == j) continue;
    result_.image.row(vertices[v]) = image.row(static_cast<Eigen::Index>(v));
    result_.movedVertices.push_back(vertices[v]);
  }
}

void Pockets::bulge(int chord, const std::vector<int>& pocket) {
  ++result_.pockets;
  if (pocket.size() == 1) {
    placeEar(chord, pocket.front());
  } else {
    placeLarge(chord, pocket);
  }
}

FoldedPocketsResult Pockets::run() {
  std::vector<char> seen(at(surface_.faceCount()), 0);
  const std::vector<int> main = mainPart();
  for (const int f : main) seen[at(f)] = 1;
  for (const int f : main) {
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int chord = topology_.opposite(h);
      if (chord < 0 || seen[at(chord / 3)]) continue;
      const std::vector<int> pocket = collect(chord / 3, chord, seen);
      if (folded(pocket)) bulge(chord, pocket);
    }
  }
  std::sort(result_.movedVertices.begin(), result_.movedVertices.end());
  return std::move(result_);
}

}  // namespace

FoldedPocketsResult bulgeFoldedPockets(const TriangleMesh& surface, const SurfaceTopology& topology, Points2 image) {
  return Pockets(surface, topology, std::move(image)).run();
}

}  // namespace authalic
