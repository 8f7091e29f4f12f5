#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "Core/authalic/SphericalAuthalicMap.h"
#include "Core/conformal/SphericalConformalMap.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Formats/SurfaceFile.h"
#include "support/SharedData.h"
#include "support/TestMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

const char* const kSurfaces[] = {"meshes/closed_g0/decimated-max.obj",      "meshes/closed_g0/bunny.obj",
                                 "meshes/closed_g0/gargoyle.obj",           "meshes/closed_g0/david.off",
                                 "meshes/closed_g0/sphere_brain.off",       "cortex/fsaverage5_gifti/pial_left.gii.gz",
                                 "cortex/fsaverage6_fs/lh.pial",            "cortex/subject1_fs/lh.pialsurface6"};

const SphereMesh& surface(std::int64_t which) {
  static std::map<std::int64_t, SphereMesh> surfaces;
  const auto found = surfaces.find(which);
  if (found != surfaces.end()) return found->second;
  const SurfaceFile file = readSurface(sharedData(kSurfaces[which]));
  const auto n = static_cast<Eigen::Index>(file.vertexCount()), m = static_cast<Eigen::Index>(file.faceCount());
  TriangleMesh mesh(Eigen::Map<const Points3>(file.points.data(), n, 3),
                    Eigen::Map<const Faces>(file.faces.data(), m, 3));
  return surfaces.emplace(which, SphereMesh(std::move(mesh))).first->second;
}

void sphericalConformal(benchmark::State& state) {
  const SphereMesh& sphere = surface(state.range(0));
  SphericalConformalMapOptions options;
  options.road = static_cast<SphereRoad>(state.range(1));
  for (auto _ : state) {
    const SphericalMapResult result = sphericalConformalMap(sphere, options);
    const SphericalDistortion distortion = measureSphericalDistortion(sphere.mesh(), result.image);
    state.counters["iterations"] = result.iterations;
    state.counters["unfolded"] = result.flippedBeforeUnfolding;
    state.counters["folds"] = distortion.flippedByVolume;
    state.counters["D_angle"] = distortion.summary.angleDistortion;
    state.counters["degrees"] = distortion.summary.meanAngleError;
    state.counters["seconds_of_map"] = result.seconds;
  }
  state.SetLabel(std::string(kSurfaces[state.range(0)]) + " " + sphereRoadName(options.road));
}
BENCHMARK(sphericalConformal)
    ->ArgsProduct({{0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2}})->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

// Capsules of 2 n circumferences, `around` edges around: how long limbs may be.
void limbs(benchmark::State& state) {
  const auto around = static_cast<int>(state.range(0));
  const SphereMesh sphere(capsuleMesh(around, state.range(1) / 2.0, static_cast<unsigned>(state.range(2))));
  const TargetMeasure target(sphere.mesh());
  for (auto _ : state) {
    const SphericalAuthalicMapResult result = sphericalAuthalicMap(sphere, target);
    state.counters["faces"] = sphere.mesh().faceCount();
    state.counters["converged"] = result.status == Status::Converged;
    state.counters["iterations"] = result.iterations;
    state.counters["excess"] = result.faceResidual * result.faceResidual;
    state.counters["degrees"] = measureSphericalDistortion(sphere.mesh(), result.image).summary.meanAngleError;
  }
}
BENCHMARK(limbs)
    ->ArgNames({"around", "twice_n", "seed"})->ArgsProduct({{16, 24, 32, 48}, {2, 4, 6, 8}, {1, 2, 3}})
    ->Iterations(1)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
