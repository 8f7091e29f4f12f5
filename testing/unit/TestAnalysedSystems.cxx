#include <gtest/gtest.h>

#include "Core/numerics/AnalysedSystems.h"

using namespace authalic;

namespace {

// A chain of springs, element e between unknowns e and e + 1; the last one fixed to the ground.
ElementAssembly::Unknowns chain(int count) {
  ElementAssembly::Unknowns elements(count, 2);
  for (int e = 0; e < count; ++e) elements.row(e) << e, (e + 1 < count ? e + 1 : -1);
  return elements;
}

std::vector<double> springs(int count, double stiffness) {
  std::vector<double> values;
  for (int e = 0; e < count; ++e) values.insert(values.end(), {stiffness, -stiffness, stiffness});
  return values;
}

}  // namespace

TEST(AnalysedSystems, GiveOneSystemForOnePatternAndAnotherForAnother) {
  AnalysedSystems systems;
  const auto first = systems.of(5, chain(5), SolverBackend::EigenLDLT, PatternUse::Once);
  EXPECT_EQ(systems.of(5, chain(5), SolverBackend::EigenLDLT, PatternUse::Once), first);
  EXPECT_NE(systems.of(6, chain(6), SolverBackend::EigenLDLT, PatternUse::Once), first);
  EXPECT_NE(systems.of(5, chain(5), SolverBackend::EigenLLT, PatternUse::Once), first);
  EXPECT_NE(systems.of(5, chain(5), SolverBackend::EigenLDLT, PatternUse::Reused), first);
  EXPECT_EQ(systems.of(5, chain(5), SolverBackend::EigenLDLT, PatternUse::Once), first);
}

TEST(AnalysedSystems, ForgetThePatternThatWasNotUsedForTheLongestTime) {
  AnalysedSystems systems;
  const auto first = systems.of(2, chain(2), SolverBackend::EigenLDLT, PatternUse::Once);
  for (int count = 3; count < 9; ++count)
    (void)systems.of(count, chain(count), SolverBackend::EigenLDLT, PatternUse::Once);
  EXPECT_NE(systems.of(2, chain(2), SolverBackend::EigenLDLT, PatternUse::Once), first);
}

TEST(AnalysedSystems, SolveWhatWasLastFactorised) {
  AnalysedSystems systems;
  const auto system = systems.of(4, chain(4), SolverBackend::EigenLDLT, PatternUse::Once);
  const Eigen::VectorXd load = Eigen::VectorXd::Unit(4, 0);
  for (const double stiffness : {1.0, 4.0}) {
    system->factorize(system->assemble(springs(4, stiffness)));
    EXPECT_NEAR(system->solver().solve(load)(0, 0), 4 / stiffness, 1e-14);  // four springs in a row
  }
}
