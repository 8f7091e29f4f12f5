#include "Core/conformal/StereographicSphereMap.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "Core/base/Error.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "Core/initial/BarycentricSystem.h"
#include "Core/initial/ConformalEnergy.h"
#include "Core/numerics/SphereMobius.h"

namespace authalic {
namespace {

constexpr std::size_t kFewestHeld = 12;  // vertices around the far pole

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The value below which half of the mass lies.
double weightedMedian(const Eigen::VectorXd& values, const Eigen::VectorXd& mass) {
  std::vector<int> order(at(static_cast<int>(values.size())));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&values](int a, int b) { return values[a] < values[b]; });
  const double half = 0.5 * mass.sum();
  double sum = 0;
  for (const int i : order) {
    sum += mass[i];
    if (sum >= half) return values[i];
  }
  return values[order.back()];
}

// The dipole of the punctured face, integrated against the hat functions of its corners: n×2, columns sum to 0.
Eigen::MatrixXd dipole(const TriangleMesh& surface, int face) {
  const Eigen::Vector3d a = surface.corner(face, 0), b = surface.corner(face, 1), c = surface.corner(face, 2);
  const double base = std::max((b - a).norm(), 1e-300), along = (c - a).dot(b - a) / (base * base);
  const double height = std::max((c - a - along * (b - a)).norm(), 1e-8 * base);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(surface.vertexCount(), 2);
  right.row(surface.faces()(face, 0)) << -1 / base, (1 - along) / height;
  right.row(surface.faces()(face, 1)) << 1 / base, along / height;
  right.row(surface.faces()(face, 2)) << 0, -1 / height;
  return right;
}

// Half of the mass on each side of both axes and of the unit circle, so that lifting loses no digits.
void centreInPlane(const Eigen::VectorXd& mass, Points2& plane) {
  for (int c = 0; c < 2; ++c) plane.col(c).array() -= weightedMedian(plane.col(c), mass);
  const double radius = weightedMedian(plane.rowwise().norm(), mass);
  if (radius > 0) plane /= radius;
}

Eigen::VectorXd vertexMass(const TriangleMesh& surface) {
  return vertexStars(faceAreas(surface), surface.faces(), surface.vertexCount());
}

// All but the vertices nearest to the pole (0, 0, 1) that hold the given share of the area; at least some are held.
std::vector<char> outsideOfPolarPart(const Points3& image, const Eigen::VectorXd& mass, double share) {
  std::vector<int> order(at(static_cast<int>(mass.size())));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&image](int a, int b) { return image(a, 2) > image(b, 2); });
  std::vector<char> held(order.size(), 1);
  double sum = 0;
  for (std::size_t k = 0; k + kFewestHeld < order.size(); ++k) {
    sum += mass[order[k]];
    if (sum > share * mass.sum()) break;
    held[at(order[k])] = 0;
  }
  return held;
}

// Places the polar part anew as a planar harmonic map in the chart of the opposite pole.
void correctPolarPart(const SphereMesh& sphere, const Eigen::VectorXd& mass, double share, SolverBackend backend,
                      const Eigen::Vector3d& pole, Points3& image) {
  const Eigen::Matrix3d up = Eigen::Quaterniond::FromTwoVectors(pole, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Points3 turned = image * up.transpose();
  const std::vector<char> held = outsideOfPolarPart(turned, mass, share);
  const Eigen::RowVector3d flip(1, -1, -1);  // a rotation about x: the pole goes to the origin of the chart
  Points2 plane = projectToPlane(turned.array().rowwise() * flip.array());
  solveBarycentric(sphere.mesh().faces(), shapeWeights(sphere.mesh()), held, backend, plane);
  const Points3 lifted = liftToSphere(plane).array().rowwise() * flip.array();
  image = lifted * up;
}

double squaredIrregularity(const TriangleMesh& surface, int f) {
  std::array<double, 3> l{};
  for (int k = 0; k < 3; ++k) l[at(k)] = (surface.corner(f, (k + 1) % 3) - surface.corner(f, k)).squaredNorm();
  const Eigen::Vector3d a = surface.corner(f, 0);
  const double area = (surface.corner(f, 1) - a).cross(surface.corner(f, 2) - a).norm();
  return area > 0 ? (l[0] + l[1] + l[2]) / area : std::numeric_limits<double>::infinity();
}

}  // namespace

Points3 liftToSphere(const Points2& plane) {
  Points3 sphere(plane.rows(), 3);
  for (Eigen::Index i = 0; i < plane.rows(); ++i) {
    const double x = plane(i, 0), y = plane(i, 1), square = x * x + y * y;
    sphere.row(i) << 2 * x / (1 + square), 2 * y / (1 + square), (square - 1) / (1 + square);
  }
  return sphere;
}

Points2 projectToPlane(const Points3& sphere) {
  Points2 plane(sphere.rows(), 2);
  for (Eigen::Index i = 0; i < sphere.rows(); ++i) {
    // Above the equator 1 − z cancels; x² + y² = (1 − z)(1 + z) does not.
    const double x = sphere(i, 0), y = sphere(i, 1), z = sphere(i, 2);
    plane.row(i) = sphere.row(i).leftCols<2>() * (z > 0 ? (1 + z) / (x * x + y * y) : 1 / (1 - z));
  }
  return plane;
}

int mostRegularFace(const TriangleMesh& surface) {
  int best = 0;
  double least = squaredIrregularity(surface, 0);
  for (int f = 1; f < surface.faceCount(); ++f) {
    const double irregularity = squaredIrregularity(surface, f);
    if (irregularity < least) least = irregularity, best = f;
  }
  return best;
}

void StereographicSphereMapOptions::validate() const {
  if (puncturedFace < -1 || !(correctedShare >= 0) || !(correctedShare < 1)) {
    throw InvalidArgument(
        "A punctured face of at least -1 and a corrected share in [0, 1) are required, but they are " +
        std::to_string(puncturedFace) + " and " + std::to_string(correctedShare) + ".");
  }
  if (!SparseSolver::available(solver)) {
    throw InvalidArgument("A solver that is part of this build is required, but " +
                          std::string(solverBackendName(solver)) + " was not built in.");
  }
}

Points3 liftCentred(const TriangleMesh& surface, Points2 plane) {
  const Eigen::VectorXd mass = vertexMass(surface);
  centreInPlane(mass, plane);
  const Points3 lifted = liftToSphere(plane);
  return centreOfSphericalMassToOrigin(lifted, mass).map(lifted);
}

Points3 dipoleSphereMap(const SphereMesh& sphere, const SphereLaplacian& laplacian, int puncturedFace) {
  const TriangleMesh& mesh = sphere.mesh();
  if (puncturedFace >= mesh.faceCount()) {
    throw InvalidArgument("A punctured face below " + std::to_string(mesh.faceCount()) + " is required, but it is " +
                          std::to_string(puncturedFace) + ".");
  }
  Points2 plane = laplacian.solve(dipole(mesh, puncturedFace));
  // Seen from outside the sphere the punctured face is the outer one.
  if ((signedFaceAreas(plane, mesh.faces()).array() > 0).count() * 2 > mesh.faceCount()) plane.col(1) *= -1;
  return liftCentred(mesh, std::move(plane));
}

SphericalMapResult stereographicSphereMap(const SphereMesh& sphere, const StereographicSphereMapOptions& options,
                                          const Execution& execution) {
  options.validate();
  const auto start = std::chrono::steady_clock::now();
  execution.report(0, "Stereographic map");
  const TriangleMesh& mesh = sphere.mesh();
  const int face = options.puncturedFace < 0 ? mostRegularFace(mesh) : options.puncturedFace;
  SphericalMapResult result;
  result.image = dipoleSphereMap(sphere, SphereLaplacian(sphere, options.solver), face);
  execution.throwIfCancelled();
  execution.report(0.5, "Stereographic map");
  if (options.correctedShare > 0) {
    const Eigen::VectorXd mass = vertexMass(mesh);
    Eigen::Vector3d pole = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) pole += result.image.row(mesh.faces()(face, k)).transpose();
    correctPolarPart(sphere, mass, options.correctedShare, options.solver, pole.normalized(), result.image);
    result.image = centreOfSphericalMassToOrigin(result.image, mass).map(result.image);
  }
  result.status = Status::Converged;
  result.flippedFaces = countFlippedOnSphere(result.image, mesh.faces());
  result.degenerateFaces = static_cast<int>((faceAreas(mesh).array() <= 0).count());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  execution.report(1, "Stereographic map");
  return result;
}

}  // namespace authalic
