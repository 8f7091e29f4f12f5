#include <benchmark/benchmark.h>

#include <string>

#include "Core/conformal/AnnulusMap.h"
#include "Core/conformal/CircleDomainMap.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/distortion/Distortion.h"
#include "support/LegacyVtkFile.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

const char* const kDisks[] = {"camelhead", "human_face", "chinese_lion", "human_brain"};
const char* const kPolyAnnuli[] = {"sophie", "alex_3"};
const char* const kColon[] = {"DSJ-SF-", "HF-HF+", "SF-SF+"};

void countMap(benchmark::State& state, const TriangleMesh& mesh, const Points2& image) {
  const DistortionSummary summary = measureDistortion(mesh, image).summary;
  state.counters["angle_error"] = summary.meanAngleError;
  state.counters["beltrami"] = summary.meanBeltrami;
  state.counters["flips"] = summary.flippedFaces;
}

template <class Result>
void countFlow(benchmark::State& state, const Result& result) {
  state.counters["converged"] = result.status == Status::Converged;
  state.counters["newton"] = result.iterations;
  state.counters["edge_flips"] = result.edgeFlips;
  state.counters["residual"] = result.residual;
  state.counters["holonomy"] = result.holonomy;
  state.counters["folds_before"] = result.flippedBeforeUnfolding;
}

// Second argument: 0 boundary, 1 puncture, 2 boundary by circle packing, 3 the same with circumradii.
void riemann(benchmark::State& state) {
  const DiskMesh disk(readOff(sharedData(std::string("meshes/open_disk/") + kDisks[state.range(0)] + ".off")));
  RiemannMapOptions options;
  options.road = state.range(1) == 1 ? RiemannRoad::Puncture : RiemannRoad::Boundary;
  if (state.range(1) >= 2) options.flow.metric = ConformalMetric::CirclePacking;
  if (state.range(1) == 3) options.flow.radii = PackingRadii::Circumradius;
  RiemannMapResult result;
  for (auto _ : state) result = riemannMap(disk, options);
  countMap(state, disk.mesh(), result.image);
  countFlow(state, result);
  state.SetLabel(std::string(kDisks[state.range(0)]) + " " + riemannRoadName(options.road) + " " +
                 conformalMetricName(options.flow.metric));
}
BENCHMARK(riemann)
    ->ArgsProduct({{0, 1, 2, 3}, {0, 1, 2, 3}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

void circleDomain(benchmark::State& state) {
  const PolyAnnulusMesh surface(
      readOff(sharedData(std::string("meshes/poly_annulus/") + kPolyAnnuli[state.range(0)] + ".off")));
  CircleDomainOptions options;
  options.road = static_cast<CircleDomainRoad>(state.range(1));
  CircleDomainResult result;
  for (auto _ : state) result = circleDomainMap(surface, options);
  countMap(state, surface.mesh(), result.image);
  countFlow(state, result);
  state.counters["rounds"] = result.rounds;
  state.counters["roundness"] = result.roundness;
  state.SetLabel(std::string(kPolyAnnuli[state.range(0)]) + " " + circleDomainRoadName(options.road));
}
BENCHMARK(circleDomain)
    ->ArgsProduct({{0, 1}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

void annulus(benchmark::State& state) {
  const AnnulusMesh mesh(readLegacyVtk(
      sharedData(std::string("colon/EdinGCA_3D_00020_CTC_inflated/large-intestine-") + kColon[state.range(0)] + ".vtk"),
      {0.808594, 0.808594, 0.7}));
  AnnulusMapResult result;
  for (auto _ : state) result = annulusMap(mesh);
  countMap(state, mesh.mesh(), result.image);
  countFlow(state, result);
  state.counters["modulus"] = result.modulus;
  state.counters["straightness"] = result.straightness;
  state.counters["pockets"] = result.pockets;
  state.counters["rectangle_flips"] = result.flippedRectangleFaces;
  state.counters["rectangle_pockets"] = result.rectanglePockets;
  state.SetLabel(kColon[state.range(0)]);
}
BENCHMARK(annulus)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
