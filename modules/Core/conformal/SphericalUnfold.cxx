#include "Core/conformal/SphericalUnfold.h"

#include <Eigen/Geometry>

#include <numeric>
#include <utility>
#include <vector>

#include "Core/base/Error.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/initial/BarycentricSystem.h"

namespace authalic {
namespace {

constexpr int kMostRings = 32;

std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

std::vector<char> cornersOfFolds(const Faces& faces, const Points3& image) {
  std::vector<char> marked(at(image.rows()), 0);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    if (signedDeterminant(image.row(faces(f, 0)), image.row(faces(f, 1)), image.row(faces(f, 2))) > 0) continue;
    for (int k = 0; k < 3; ++k) marked[at(faces(f, k))] = 1;
  }
  return marked;
}

void grow(const Faces& faces, int rings, std::vector<char>& marked) {
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<char> next = marked;
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
      if (!marked[at(faces(f, 0))] && !marked[at(faces(f, 1))] && !marked[at(faces(f, 2))]) continue;
      for (int k = 0; k < 3; ++k) next[at(faces(f, k))] = 1;
    }
    marked.swap(next);
  }
}

/// Faces that touch a marked vertex, in groups that share marked vertices.
std::vector<std::vector<int>> patchesAround(const Faces& faces, const std::vector<char>& marked) {
  std::vector<int> leader(marked.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](int v) {
    while (leader[at(v)] != v) v = leader[at(v)] = leader[at(leader[at(v)])];
    return v;
  };
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = faces(f, k), b = faces(f, (k + 1) % 3);
      if (marked[at(a)] && marked[at(b)]) leader[at(std::max(find(a), find(b)))] = std::min(find(a), find(b));
    }
  }
  std::vector<std::vector<int>> patches;
  std::vector<int> number(marked.size(), -1);
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      if (!marked[at(faces(f, k))]) continue;
      int& patch = number[at(find(faces(f, k)))];
      if (patch < 0) {
        patch = static_cast<int>(patches.size());
        patches.emplace_back();
      }
      if (patches[at(patch)].empty() || patches[at(patch)].back() != f) patches[at(patch)].push_back(static_cast<int>(f));
    }
  }
  return patches;
}

/// The patch as a planar mesh in the gnomonic chart about its mean.
struct Chart {
  std::vector<int> vertices;
  Faces faces;
  Points2 points;
  std::vector<char> held;
  Eigen::Matrix3d frame;
  bool fits = true;

  Chart(const Faces& all, const std::vector<int>& patch, const std::vector<char>& marked, const Points3& image,
        std::vector<int>& number)
      : faces(static_cast<Eigen::Index>(patch.size()), 3) {
    for (std::size_t f = 0; f < patch.size(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int v = all(patch[f], k);
        if (number[at(v)] < 0) {
          number[at(v)] = static_cast<int>(vertices.size());
          vertices.push_back(v);
          held.push_back(!marked[at(v)]);
        }
        faces(static_cast<Eigen::Index>(f), k) = number[at(v)];
      }
    }
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const int v : vertices) {
      number[at(v)] = -1;
      centre += image.row(v).transpose();
    }
    frame = Eigen::Quaterniond::FromTwoVectors(centre, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    points.resize(static_cast<Eigen::Index>(vertices.size()), 2);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Eigen::Vector3d p = frame * image.row(vertices[i]).transpose();
      fits = fits && p.z() > 0.1;
      points.row(static_cast<Eigen::Index>(i)) = p.head<2>().transpose() / std::max(p.z(), 0.1);
    }
  }

  /// Re-embeds the free vertices and writes them back.
  void embed(Points3& image) {
    try {
      solveBarycentric(faces, meanValueWeights(points, faces), held, SolverBackend::Automatic, points);
    } catch (const SolverError&) {
      solveBarycentric(faces, HalfEdgeWeights::Constant(faces.rows(), 3, 1.0), held, SolverBackend::Automatic, points);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (held[i]) continue;
      const Eigen::Vector3d p(points(static_cast<Eigen::Index>(i), 0), points(static_cast<Eigen::Index>(i), 1), 1);
      image.row(vertices[i]) = (frame.transpose() * p).normalized().transpose();
    }
  }
};

}  // namespace

SphericalUnfoldResult unfoldOnSphere(const Faces& faces, Points3 image, const Execution& execution) {
  SphericalUnfoldResult result;
  const Points3 before = image;
  std::vector<int> number(at(image.rows()), -1);
  for (int rings = 1; rings <= kMostRings && countFlippedOnSphere(image, faces) > 0; rings *= 2) {
    if (execution.cancelled()) break;
    std::vector<char> marked = cornersOfFolds(faces, image);
    grow(faces, rings, marked);
    for (const std::vector<int>& patch : patchesAround(faces, marked)) {
      Chart chart(faces, patch, marked, image, number);
      if (chart.fits) chart.embed(image);
    }
    ++result.rounds;
  }
  result.movedVertices = static_cast<int>(((image - before).rowwise().squaredNorm().array() > 0).count());
  result.flippedFaces = countFlippedOnSphere(image, faces);
  result.image = std::move(image);
  return result;
}

}  // namespace authalic
