#include <gtest/gtest.h>

#include "Core/initial/BarycentricMap.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

TEST(SolverBackends, GiveTheSameMaps) {
  const DiskMesh disk(bumpyDisk(20, 1.0));
  for (const auto weights :
       {BarycentricWeights::Uniform, BarycentricWeights::Harmonic, BarycentricWeights::MeanValue}) {
    BarycentricMapOptions options;
    options.weights = weights;
    options.solver = SolverBackend::EigenLDLT;
    const Points2 reference = barycentricMap(disk, options).image;
    for (const auto backend : {SolverBackend::EigenLLT, SolverBackend::Cholmod}) {
      if (!SparseSolver::available(backend)) continue;
      options.solver = backend;
      EXPECT_LT((barycentricMap(disk, options).image - reference).cwiseAbs().maxCoeff(), 1e-11);
    }
  }
}
