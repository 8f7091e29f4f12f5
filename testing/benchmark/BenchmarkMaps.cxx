#include <benchmark/benchmark.h>

#include <map>

#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/distortion/Distortion.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/initial/LeastSquaresConformalMap.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

#ifdef AUTHALIC_HAVE_LIBIGL
#include <igl/boundary_loop.h>
#include <igl/harmonic.h>
#include <igl/lscm.h>
#include <igl/map_vertices_to_circle.h>
#endif

using namespace authalic;
using namespace authalic::testing;

namespace {

const char* const kMeshes[] = {"camelhead", "human_face", "chinese_lion", "human_brain"};

const DiskMesh& mesh(std::int64_t which) {
  static std::map<std::int64_t, DiskMesh> meshes;
  const auto found = meshes.find(which);
  if (found != meshes.end()) return found->second;
  return meshes
      .emplace(which, DiskMesh(readOff(sharedData(std::string("meshes/open_disk/") + kMeshes[which] + ".off"))))
      .first->second;
}

void barycentric(benchmark::State& state) {
  const DiskMesh& disk = mesh(state.range(0));
  BarycentricMapOptions options;
  options.weights = static_cast<BarycentricWeights>(state.range(1));
  state.SetLabel(std::string(kMeshes[state.range(0)]) + " " + barycentricWeightsName(options.weights));
  for (auto _ : state) benchmark::DoNotOptimize(barycentricMap(disk, options));
}
BENCHMARK(barycentric)->ArgsProduct({{0, 1, 2, 3}, {0, 1, 2}})->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void leastSquaresConformal(benchmark::State& state) {
  const DiskMesh& disk = mesh(state.range(0));
  LeastSquaresConformalMapOptions options;
  options.pins = static_cast<ConformalPins>(state.range(1));
  state.SetLabel(std::string(kMeshes[state.range(0)]) + " " + conformalPinsName(options.pins));
  for (auto _ : state) benchmark::DoNotOptimize(leastSquaresConformalMap(disk, options));
}
BENCHMARK(leastSquaresConformal)
    ->ArgsProduct({{0, 1, 2, 3}, {0, 1}})->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

#ifdef AUTHALIC_HAVE_LIBIGL
void libiglLeastSquaresConformal(benchmark::State& state) {
  const Eigen::MatrixXd vertices = mesh(state.range(0)).mesh().points();
  const Eigen::MatrixXi faces = mesh(state.range(0)).mesh().faces();
  state.SetLabel(std::string(kMeshes[state.range(0)]) + " libigl LSCM");
  for (auto _ : state) {
    Eigen::VectorXi loop, pins(2);
    Eigen::MatrixXd places(2, 2), image;
    igl::boundary_loop(faces, loop);
    pins << loop[0], loop[loop.size() / 2];
    places << 0, 0, 1, 0;
    igl::lscm(vertices, faces, pins, places, image);
    benchmark::DoNotOptimize(image);
  }
}
BENCHMARK(libiglLeastSquaresConformal)->DenseRange(0, 3)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void libiglHarmonic(benchmark::State& state) {
  const Eigen::MatrixXd vertices = mesh(state.range(0)).mesh().points();
  const Eigen::MatrixXi faces = mesh(state.range(0)).mesh().faces();
  state.SetLabel(std::string(kMeshes[state.range(0)]) + " libigl harmonic");
  for (auto _ : state) {
    Eigen::VectorXi loop;
    Eigen::MatrixXd circle, image;
    igl::boundary_loop(faces, loop);
    igl::map_vertices_to_circle(vertices, loop, circle);
    igl::harmonic(vertices, faces, loop, circle, 1, image);
    benchmark::DoNotOptimize(image);
  }
}
BENCHMARK(libiglHarmonic)->DenseRange(0, 3)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
#endif

// Third argument: fixed step in thousandths, 0 = adaptive; the flow of the paper without a finish.
void lieFlow(benchmark::State& state, LieFlowFinish finish) {
  const DiskMesh& disk = mesh(state.range(0));
  const Points2 start = barycentricMap(disk).image;
  DiscreteLieFlowOptions options;
  options.finish = finish;
  options.fixedStep = 1e-3 * static_cast<double>(state.range(1));
  if (finish == LieFlowFinish::None) options.tolerance = 0.3, options.maxIterations = 700;
  for (auto _ : state) {
    const DiscreteLieFlowResult result = discreteLieFlow(disk, start, TargetMeasure(disk.mesh()), options);
    state.counters["iterations"] = result.iterations;
    state.counters["collapsed"] = result.collapsed;
    state.counters["folds_of_flow"] = result.flippedBeforeFinish;
    state.counters["folds"] = result.flippedFaces;
    state.counters["D_area"] = measureDistortion(disk.mesh(), result.image).summary.areaDistortion;
  }
  state.SetLabel(kMeshes[state.range(0)]);
}
BENCHMARK_CAPTURE(lieFlow, matched, LieFlowFinish::Match)
    ->ArgsProduct({{0, 1, 2, 3}, {0}})->Unit(benchmark::kSecond)->Iterations(1)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(lieFlow, bare, LieFlowFinish::None)
    ->ArgsProduct({{0, 1, 2}, {0, 100, 10, 1}})->Unit(benchmark::kSecond)->Iterations(1)->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
