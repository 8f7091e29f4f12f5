#include "Core/conformal/ConePlacement.h"

#include <cmath>

#include "Core/conformal/YamabeFlow.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"

namespace authalic {
namespace {

constexpr int kFewestFaces = 5;        // around a cone, so that its angle of 5π/2 makes no obtuse corners
constexpr double kRegularisation = 1e-10;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Vertices where no (further) cone may stand.
class Room {
 public:
  explicit Room(const Faces& faces, int vertexCount) : faces_(faces), taken_(at(vertexCount), 0) {
    std::vector<int> valence(taken_.size(), 0);
    for (Eigen::Index c = 0; c < faces.size(); ++c) ++valence[at(faces.data()[c])];
    for (std::size_t v = 0; v < taken_.size(); ++v) taken_[v] = valence[v] < kFewestFaces;
  }

  // The vertex with the largest value that is not taken; of all when all are.
  [[nodiscard]] int largest(const Eigen::VectorXd& values) const {
    int best = -1;
    for (int v = 0; v < static_cast<int>(taken_.size()); ++v) {
      if (!taken_[at(v)] && (best < 0 || values[v] > values[best])) best = v;
    }
    if (best < 0) values.maxCoeff(&best);
    return best;
  }

  void take(int vertex) {
    std::vector<char> ring(taken_.size(), 0);
    ring[at(vertex)] = 1;
    for (int step = 0; step < 2; ++step) {
      const std::vector<char> before = ring;
      for (Eigen::Index f = 0; f < faces_.rows(); ++f) {
        if (!before[at(faces_(f, 0))] && !before[at(faces_(f, 1))] && !before[at(faces_(f, 2))]) continue;
        for (int k = 0; k < 3; ++k) ring[at(faces_(f, k))] = 1;
      }
    }
    for (std::size_t v = 0; v < ring.size(); ++v) taken_[v] = taken_[v] || ring[v];
  }

 private:
  const Faces& faces_;
  std::vector<char> taken_;
};

}  // namespace

std::vector<int> placeCones(const HighGenusMesh& surface, int count, SolverBackend backend) {
  const TriangleMesh& mesh = surface.mesh();
  const int n = mesh.vertexCount();
  const Eigen::VectorXd areas = faceAreas(mesh), spread = vertexStars(areas, mesh.faces(), n) / areas.sum();
  SparseMatrix stiffness = cotangentStiffness(mesh);
  for (int v = 0; v < n; ++v) stiffness.coeffRef(v, v) *= 1 + kRegularisation;
  SparseSolver solver(backend);
  solver.compute(stiffness);
  const double total = 2 * M_PI * surface.topology().eulerCharacteristic();
  Eigen::VectorXd wanted =
      total * spread - vertexCurvature(IntrinsicTriangulation(mesh, surface.topology()), Eigen::VectorXd::Zero(n));
  Room room(mesh.faces(), n);
  std::vector<int> cones;
  for (int k = 0; k < count; ++k) {
    const int v = room.largest(solver.solve(wanted));
    room.take(v);
    cones.push_back(v);
    wanted -= total / count * spread;
    wanted[v] += total / count;
  }
  return cones;
}

}  // namespace authalic
