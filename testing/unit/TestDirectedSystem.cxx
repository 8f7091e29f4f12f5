#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "Core/initial/DirectedSystem.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// A rough disk whose vertex 0 is held, with the mean-value matrix summed face by face.
struct Example {
  explicit Example(unsigned seed) : surface(roughDisk(8, seed)), weights(meanValueWeights(surface)) {
    unknowns = surface.faces().array() - 1;
    count = static_cast<int>(surface.vertexCount()) - 1;
    directed = Eigen::MatrixXd::Zero(count + 1, count + 1);
    for (Eigen::Index f = 0; f < unknowns.rows(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int i = surface.faces()(f, k), j = surface.faces()(f, (k + 1) % 3);
        directed(i, j) += weights.forward(f, k);
        directed(j, i) += weights.backward(f, k);
      }
    }
  }

  // (A x)_i = Σ_j w_ij (x_i − x_j) for the free vertices
  Eigen::MatrixXd matrix() const {
    const Eigen::VectorXd rowSums = directed.rowwise().sum();
    return (Eigen::MatrixXd(rowSums.asDiagonal()) - directed).bottomRightCorner(count, count);
  }

  TriangleMesh surface;
  MeanValueWeights weights;
  ElementAssembly::Unknowns unknowns;
  int count = 0;
  Eigen::MatrixXd directed;
};

double asymmetry(const Eigen::MatrixXd& matrix) { return (matrix - matrix.transpose()).norm() / matrix.norm(); }

}  // namespace

TEST(DirectedSystem, IsTheRowScaledMatrixOfTheWeights) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Example example(seed);
    const DirectedSystem system(example.weights, example.unknowns, example.count);
    const Eigen::MatrixXd expected = system.scale().asDiagonal() * example.matrix();
    EXPECT_LT((Eigen::MatrixXd(system.matrix()) - expected).norm(), 1e-13 * expected.norm());
    const Eigen::MatrixXd x = Eigen::MatrixXd::Random(example.count, 2);
    EXPECT_LT((system.multiply(x) - expected * x).norm(), 1e-13 * expected.norm() * x.norm());
  }
}

TEST(DirectedSystem, ScalingBringsItCloserToSymmetry) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Example example(seed);
    const DirectedSystem system(example.weights, example.unknowns, example.count);
    EXPECT_LT(asymmetry(Eigen::MatrixXd(system.matrix())), 0.7 * asymmetry(example.matrix()));
  }
}

TEST(DirectedSystem, SymmetricPartIsPositiveDefiniteAndKeepsConstantsAwayFromHeldVertices) {
  const Example example(1);
  const DirectedSystem system(example.weights, example.unknowns, example.count);
  const Eigen::MatrixXd lower = system.symmetricPart();
  const Eigen::MatrixXd part = lower.selfadjointView<Eigen::Lower>();
  EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(part).info(), Eigen::Success);
  const Eigen::VectorXd rowSums = part.rowwise().sum();
  for (int i = 0; i < example.count; ++i) {
    const double held = system.scale()[i] * example.directed(i + 1, 0);
    EXPECT_NEAR(rowSums[i], held, 1e-12 * part.norm()) << "unknown " << i;
  }
}

TEST(DirectedSystem, WeightsThatScalingMakesSymmetricAreMadeSo) {
  const Example example(2);  // symmetric weights, each row times its own factor
  MeanValueWeights weights{HalfEdgeWeights::Ones(example.weights.forward.rows(), 3),
                           HalfEdgeWeights::Ones(example.weights.forward.rows(), 3)};
  const Eigen::VectorXd factors = (0.1 * Eigen::VectorXd::Random(example.count + 1)).array().exp();
  for (Eigen::Index f = 0; f < example.unknowns.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      weights.forward(f, k) = factors[example.surface.faces()(f, k)];
      weights.backward(f, k) = factors[example.surface.faces()(f, (k + 1) % 3)];
    }
  }
  const DirectedSystem system(weights, example.unknowns, example.count);
  EXPECT_LT(asymmetry(Eigen::MatrixXd(system.matrix())), 0.02);
}
