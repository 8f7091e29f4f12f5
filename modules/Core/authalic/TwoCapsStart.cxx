#include "Core/authalic/TwoCapsStart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "Core/authalic/NarrowFaces.h"
#include "Core/authalic/StretchStart.h"
#include "Core/conformal/UnfoldOnSphere.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/initial/BarycentricMap.h"

namespace authalic {
namespace {

constexpr std::array<double, 7> kHeights{0, 0.1, -0.1, 0.2, -0.2, 0.35, -0.35};  // where the sphere is divided
constexpr int kRoundsWithEars = 20;
constexpr double kWellInSight = 0.5;  // of what is good enough, for a start that gets better with every round

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Labels the edge-connected parts of the faces with the given side; others −1. Returns the sizes.
std::vector<int> componentsOf(const SurfaceTopology& topology, const std::vector<char>& side, char which,
                              std::vector<int>& label) {
  std::vector<int> sizes, stack;
  label.assign(side.size(), -1);
  for (int seed = 0; seed < static_cast<int>(side.size()); ++seed) {
    if (side[at(seed)] != which || label[at(seed)] >= 0) continue;
    label[at(seed)] = static_cast<int>(sizes.size());
    sizes.push_back(0);
    stack.assign(1, seed);
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      ++sizes.back();
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const int g = topology.opposite(h) / 3;
        if (side[at(g)] != which || label[at(g)] >= 0) continue;
        label[at(g)] = label[at(f)];
        stack.push_back(g);
      }
    }
  }
  return sizes;
}

// All parts of one side but the largest go to the other side; whether there were any.
bool keepLargest(const SurfaceTopology& topology, std::vector<char>& side, char which) {
  std::vector<int> label;
  const std::vector<int> sizes = componentsOf(topology, side, which, label);
  if (sizes.size() <= 1) return false;
  const int largest = static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (std::size_t f = 0; f < side.size(); ++f) {
    if (label[f] >= 0 && label[f] != largest) side[f] = static_cast<char>(!which);
  }
  return true;
}

// Where the two sides meet more than once around a vertex, all its faces go north; whether there was such a vertex.
bool joinPinches(const SurfaceTopology& topology, std::vector<char>& side) {
  std::vector<int> borders(at(topology.vertexCount()), 0);
  for (int h = 0; h < 3 * static_cast<int>(side.size()); ++h) {
    if (side[at(h / 3)] && !side[at(topology.opposite(h) / 3)]) ++borders[at(topology.tail(h))];
  }
  bool any = false;
  for (int f = 0; f < static_cast<int>(side.size()); ++f) {
    for (int k = 0; k < 3; ++k) {
      if (borders[at(topology.faces()(f, k))] < 2 || side[at(f)]) continue;
      side[at(f)] = 1;
      any = true;
    }
  }
  return any;
}

// Faces with two neighbours on the other side join them: three corners on the rim of a cap span no area on its side of
// a great circle. Every such face shortens the rim.
bool giveAwayEars(const SurfaceTopology& topology, std::vector<char>& side) {
  bool any = false;
  for (int f = 0; f < static_cast<int>(side.size()); ++f) {
    int across = 0;
    for (int h = 3 * f; h < 3 * f + 3; ++h) across += side[at(topology.opposite(h) / 3)] != side[at(f)];
    if (across != 2) continue;
    side[at(f)] = static_cast<char>(!side[at(f)]);
    any = true;
  }
  return any;
}

// 1 for the faces of the northern disk, above the height, 0 for those of the southern one.
std::vector<char> northernDisk(const SphereMesh& sphere, const Points3& image, double height) {
  const Faces& faces = sphere.mesh().faces();
  Eigen::VectorXd middle(faces.rows());
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    middle[f] = (image(faces(f, 0), 2) + image(faces(f, 1), 2) + image(faces(f, 2), 2)) / 3;
  }
  Eigen::Index highest = 0, lowest = 0;
  middle.maxCoeff(&highest);
  middle.minCoeff(&lowest);
  std::vector<char> side(static_cast<std::size_t>(faces.rows()));
  for (Eigen::Index f = 0; f < faces.rows(); ++f) side[static_cast<std::size_t>(f)] = middle[f] > height;
  side[static_cast<std::size_t>(highest)] = 1;  // neither side is empty
  side[static_cast<std::size_t>(lowest)] = 0;
  int roundsWithEars = kRoundsWithEars;
  for (bool changed = true; changed;) {
    changed = roundsWithEars-- > 0 && giveAwayEars(sphere.topology(), side);
    changed = keepLargest(sphere.topology(), side, 1) || changed;
    changed = keepLargest(sphere.topology(), side, 0) || changed;
    changed = joinPinches(sphere.topology(), side) || changed;
  }
  return side;
}

// One of the two disks, with its image in the unit disk.
struct Half {
  std::vector<int> faces, vertices;  // of the sphere
  Points2 image;
  double share = 0;                  // of the target measure
};

struct LocalMesh {
  TriangleMesh mesh;
  std::vector<int> number;  // in the half, of the vertices of the sphere
};

LocalMesh extract(const TriangleMesh& whole, Half& half) {
  std::vector<int> number(at(whole.vertexCount()), -1);
  Faces faces = whole.faces()(half.faces, Eigen::all);
  for (Eigen::Index k = 0; k < faces.size(); ++k) {
    int& local = number[at(faces.data()[k])];
    if (local < 0) {
      local = static_cast<int>(half.vertices.size());
      half.vertices.push_back(faces.data()[k]);
    }
    faces.data()[k] = local;
  }
  return {TriangleMesh(whole.points()(half.vertices, Eigen::all), faces), std::move(number)};
}

Half makeHalf(const SphereMesh& sphere, const std::vector<char>& side, char which, int startVertex,
              StretchRounds rounds, const TargetMeasure& target, SolverBackend backend, double goodEnough,
              const Execution& execution) {
  Half half;
  for (int f = 0; f < static_cast<int>(side.size()); ++f) {
    if (side[at(f)] == which) half.faces.push_back(f);
  }
  LocalMesh local = extract(sphere.mesh(), half);
  const DiskMesh disk(std::move(local.mesh));
  const Eigen::VectorXd measure = target.faces()(half.faces);
  half.share = measure.sum();
  const TargetMeasure own =
      TargetMeasure::fromFaceDensity(disk.mesh(), measure.cwiseQuotient(faceAreas(disk.mesh()).cwiseMax(1e-300)));
  BarycentricMapOptions tutte;
  tutte.weights = BarycentricWeights::Uniform;
  tutte.startVertex = local.number[at(startVertex)];
  tutte.solver = backend;
  const Points2 plain = barycentricMap(disk, tutte).image;
  half.image = stretchStart(disk, plain, own, backend, goodEnough, kWellInSight * goodEnough, rounds, execution)
                   .opened.image;
  return half;
}

// Lambert's projection of the unit disk to the cap about the north (sign 1) or south pole that holds `share` of the
// sphere.
void projectToCap(const Half& half, double sign, Points3& image) {
  for (std::size_t i = 0; i < half.vertices.size(); ++i) {
    const Eigen::RowVector2d p = half.image.row(static_cast<Eigen::Index>(i));
    const double radius = p.norm(), height = 1 - 2 * half.share * std::min(1.0, radius * radius);
    const double scale = radius > 0 ? std::sqrt(1 - height * height) / radius : 0;
    image.row(half.vertices[i]) << scale * p[0], sign * scale * p[1], sign * height;
  }
}

Points3 startDividedAt(double height, StretchRounds rounds, const SphereMesh& sphere, const Points3& image,
                       const TargetMeasure& target, SolverBackend backend, double goodEnough,
                       const Execution& execution) {
  const std::vector<char> side = northernDisk(sphere, image, height);
  int startVertex = 0;
  for (int h = 0; h < 3 * static_cast<int>(side.size()); ++h) {
    if (side[at(h / 3)] == side[at(sphere.topology().opposite(h) / 3)]) continue;
    startVertex = sphere.topology().tail(h);
    break;
  }
  std::array<Half, 2> halves;  // south, north
  const auto make = [&](std::size_t begin, std::size_t end) {
    for (std::size_t h = begin; h < end; ++h) {
      halves[h] = makeHalf(sphere, side, h == 1, startVertex, rounds, target, backend, goodEnough,
                           h == 0 ? execution : execution.silent());
    }
  };
  parallelFor(2, execution, make, 1);
  Points3 start(sphere.mesh().vertexCount(), 3);
  projectToCap(halves[0], -1, start);
  projectToCap(halves[1], 1, start);
  start.rowwise().normalize();
  SphereUnfolding unfolded = unfoldOnSphere(sphere, std::move(start));
  if (unfolded.flippedFaces == 0) openNarrowFacesOnSphere(sphere, target, backend, unfolded.image);
  return std::move(unfolded.image);
}

// A third of a turn about (1, 1, 1): another axis points north.
Points3 turned(const Points3& image) {
  Points3 result(image.rows(), 3);
  result << image.col(1), image.col(2), image.col(0);
  return result;
}

}  // namespace

Points3 twoCapsStart(const SphereMesh& sphere, const Points3& image, const TargetMeasure& target, SolverBackend backend,
                     double goodEnough, const Execution& execution) {
  Points3 best, guide = image;
  int fewest = std::numeric_limits<int>::max();
  for (int axis = 0; axis < 3; ++axis, guide = turned(guide)) {
    for (const double height : kHeights) {
      for (const StretchRounds rounds : kStretchRoundsInTurn) {
        Points3 start = startDividedAt(height, rounds, sphere, guide, target, backend, goodEnough, execution);
        const int folded = countFlippedOnSphere(start, sphere.mesh().faces());
        if (folded >= fewest) continue;
        fewest = folded;
        best = std::move(start);
        if (folded == 0 || execution.cancelled()) return best;
      }
    }
  }
  return best;
}

}  // namespace authalic
