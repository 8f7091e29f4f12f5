#include "Core/conformal/ConePlacement.h"

#include <cmath>
#include <string>

#include "Core/base/Error.h"
#include "Core/conformal/YamabeFlow.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/Laplacian.h"

namespace authalic {
namespace {

constexpr double kRegularisation = 1e-10;
constexpr double kPerFace = 0.03;      // of u, for a vertex whose faces would not have angles near π/3

constexpr double kQuarter = 0.5 * M_PI;
constexpr double kBlur = 1e-3;         // of the area: a cone is a logarithmic peak of u, which must not call for others
constexpr double kEven = 0.25;          // standard deviation of u that needs no more cones
constexpr double kWorthAPair = 0.98;   // factor of it
constexpr int kAhead = 16;             // pairs
constexpr int kMostPairs = 32;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Where further cones may stand: not within two edges of each other, while there are other places.
class Room {
 public:
  Room(const Faces& faces, int vertexCount)
      : faces_(faces), valence_(at(vertexCount), 0), taken_(at(vertexCount), 0), cones_(at(vertexCount), 0) {
    for (Eigen::Index c = 0; c < faces.size(); ++c) ++valence_[at(faces.data()[c])];
  }

  // The free vertex with the largest value, less a little for every face that it has too few or too many.
  [[nodiscard]] int best(const Eigen::VectorXd& values, int faces) const {
    int best = bestOutside(taken_, values, faces);
    if (best < 0) best = bestOutside(cones_, values, faces);
    if (best >= 0) return best;
    throw GeometryError("A surface with room for the cones of its genus is required, but all " +
                        std::to_string(cones_.size()) + " vertices are taken; refine the surface.");
  }

  void take(int vertex) {
    cones_[at(vertex)] = 1;
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
  [[nodiscard]] int bestOutside(const std::vector<char>& taken, const Eigen::VectorXd& values, int faces) const {
    int best = -1;
    double most = 0;
    for (int v = 0; v < static_cast<int>(taken.size()); ++v) {
      const double value = values[v] - kPerFace * std::abs(valence_[at(v)] - faces);
      if (taken[at(v)] || valence_[at(v)] < 3 || (best >= 0 && value <= most)) continue;
      best = v;
      most = value;
    }
    return best;
  }

  const Faces& faces_;
  std::vector<int> valence_;
  std::vector<char> taken_, cones_;
};

class Placement {
 public:
  Placement(const HighGenusMesh& surface, SolverBackend backend)
      : room_(surface.mesh().faces(), surface.mesh().vertexCount()), solver_(backend), blur_(backend) {
    const TriangleMesh& mesh = surface.mesh();
    const int n = mesh.vertexCount();
    const Eigen::VectorXd areas = faceAreas(mesh);
    spread_ = vertexStars(areas, mesh.faces(), n) / areas.sum();
    SparseMatrix stiffness = cotangentStiffness(mesh);
    for (int v = 0; v < n; ++v) stiffness.coeffRef(v, v) *= 1 + kRegularisation;
    solver_.compute(stiffness);
    stiffness *= kBlur;
    for (int v = 0; v < n; ++v) stiffness.coeffRef(v, v) += spread_[v];
    blur_.compute(stiffness);
    wanted_ = 2 * M_PI * surface.topology().eulerCharacteristic() * spread_ -
              vertexCurvature(IntrinsicTriangulation(mesh, surface.topology()), Eigen::VectorXd::Zero(n));
    u_ = solver_.solve(wanted_);
  }

  void add(double sign) {
    const int v = room_.best(-sign * blur_.solve(spread_.cwiseProduct(u_)), sign < 0 ? 7 : 5);
    room_.take(v);
    cones.push_back({v, sign * kQuarter});
    wanted_ -= sign * kQuarter * spread_;
    wanted_[v] += sign * kQuarter;
    u_ = solver_.solve(wanted_);
  }

  // Standard deviation of u over the area.
  [[nodiscard]] double unevenness() const {
    const double mean = spread_.dot(u_);
    return std::sqrt(spread_.dot((u_.array() - mean).square().matrix()));
  }

  std::vector<Cone> cones;

 private:
  Room room_;
  SparseSolver solver_, blur_;
  Eigen::VectorXd spread_, wanted_, u_;
};

}  // namespace

std::vector<Cone> placeCones(const HighGenusMesh& surface, SolverBackend backend) {
  Placement placement(surface, backend);
  for (int k = 0; k < -4 * surface.topology().eulerCharacteristic(); ++k) placement.add(-1);
  // A finger asks for several pairs before it is even: some ahead are tried before the last worthwhile one is it.
  double wanted = placement.unevenness();
  std::size_t worthwhile = placement.cones.size();
  int ahead = 0;
  for (int pair = 0; pair < kMostPairs && ahead < kAhead && placement.unevenness() > kEven; ++pair, ++ahead) {
    placement.add(1);
    placement.add(-1);
    wanted *= kWorthAPair;
    if (placement.unevenness() > wanted) continue;
    wanted = placement.unevenness();
    worthwhile = placement.cones.size();
    ahead = -1;
  }
  placement.cones.resize(worthwhile);
  return placement.cones;
}

}  // namespace authalic
