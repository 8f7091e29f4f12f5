#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "Core/conformal/ConformalWelding.h"
#include "Core/conformal/HarmonicSphereMap.h"
#include "Core/conformal/StereographicSphereMap.h"
#include "Core/conformal/WeldedSphereMap.h"
#include "Core/distortion/SphericalDistortion.h"
#include "Core/geometry/LaplacianEigenfunctions.h"
#include "Formats/SurfaceFile.h"
#include "support/EllipseMaps.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

const char* const kMeshes[] = {"meshes/closed_g0/decimated-max.obj",
                               "meshes/closed_g0/david.off",
                               "meshes/closed_g0/bunny.obj",
                               "meshes/closed_g0/gargoyle.obj",
                               "meshes/closed_g0/sphere_brain.off",
                               "cortex/fsaverage5_gifti/pial_left.gii.gz",
                               "cortex/fsaverage6_fs/lh.pial",
                               "cortex/subject1_fs/lh.pialsurface6"};

const SphereMesh& mesh(std::int64_t which) {
  static std::map<std::int64_t, SphereMesh> meshes;
  const auto found = meshes.find(which);
  if (found != meshes.end()) return found->second;
  const SurfaceFile file = readSurface(sharedData(kMeshes[which]));
  const Points3 points =
      Eigen::Map<const Points3>(file.points.data(), static_cast<Eigen::Index>(file.vertexCount()), 3);
  const Faces faces = Eigen::Map<const Faces>(file.faces.data(), static_cast<Eigen::Index>(file.faceCount()), 3);
  return meshes.emplace(which, SphereMesh(TriangleMesh(points, faces))).first->second;
}

void count(benchmark::State& state, const SphereMesh& sphere, const Points3& image) {
  const DistortionSummary summary = measureSphericalDistortion(sphere.mesh(), image).summary;
  state.SetLabel(kMeshes[state.range(0)]);
  state.counters["faces"] = sphere.mesh().faceCount();
  state.counters["degrees"] = summary.meanAngleError;
  state.counters["D_angle"] = summary.angleDistortion;
  state.counters["folds"] = summary.flippedFaces;
}

void weldedSphere(benchmark::State& state) {
  const SphereMesh& sphere = mesh(state.range(0));
  WeldedSphereMapResult result;
  for (auto _ : state) result = weldedSphereMap(sphere);
  count(state, sphere, result.image);
  state.counters["folds_before"] = result.flippedBeforeUnfolding;
  state.counters["seam"] = result.seamPoints;
  state.counters["mismatch"] = result.accuracy.boundaryMismatch;
}
BENCHMARK(weldedSphere)->DenseRange(0, 7)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void harmonicSphere(benchmark::State& state) {
  const SphereMesh& sphere = mesh(state.range(0));
  SphericalMapResult result;
  for (auto _ : state) result = harmonicSphereMap(sphere, stereographicSphereMap(sphere).image);
  count(state, sphere, result.image);
}
BENCHMARK(harmonicSphere)->DenseRange(0, 7)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void firstEigenfunction(benchmark::State& state) {
  const SphereMesh& sphere = mesh(state.range(0));
  LaplacianEigenfunctionsOptions options;
  options.tolerance = 1e-4;
  for (auto _ : state) state.counters["solves"] = laplacianEigenfunctions(sphere.mesh(), options).solves;
  state.SetLabel(kMeshes[state.range(0)]);
}
BENCHMARK(firstEigenfunction)->Arg(4)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

WeldingSignature ellipseSignature(int n, double m) {
  const EllipseMaps ellipse(m);
  Eigen::VectorXd alpha(n), beta(n);
  for (int k = 0; k < n; ++k) {
    const double t = 2 * M_PI * (k + 0.3) / n;
    alpha[k] = ellipse.innerAngle(t);
    beta[k] = -t;
  }
  return WeldingSignature::fromAngles(alpha, beta);
}

/// The curve against the ellipse (1.5 cos t, 0.5 sin t).
void zipper(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const double m = 0.5;
  const WeldingSignature signature = ellipseSignature(n, m);
  Eigen::VectorXcd exact(n);
  for (int k = 0; k < n; ++k) {
    const double t = 2 * M_PI * (k + 0.3) / n;
    exact[k] = std::polar(1.0, t) + m * std::polar(1.0, -t);
  }
  for (auto _ : state) benchmark::DoNotOptimize(ConformalWelding(signature));
  const std::array<int, 3> ids{0, n / 3, 2 * n / 3};
  const ConformalWelding welding =
      ConformalWelding(signature).withCurvePointsAt(ids, {exact[ids[0]], exact[ids[1]], exact[ids[2]]});
  state.counters["curve_error"] = (welding.curve() - exact).cwiseAbs().maxCoeff();
  const WeldingAccuracy accuracy = welding.accuracy();
  state.counters["mismatch"] = accuracy.boundaryMismatch;
  state.counters["midpoints"] = accuracy.midpointMismatch;
}
BENCHMARK(zipper)->Arg(100)->Arg(400)->Arg(1600)->Arg(6400)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void zipperEvaluation(benchmark::State& state) {
  const ConformalWelding welding(ellipseSignature(1000, 0.5));
  const Points2 points = Points2::Random(10000, 2) * 0.7;
  for (auto _ : state) benchmark::DoNotOptimize(welding.mapFirst(points, Execution({}, {}, 1)));
  state.SetLabel("10,000 points through 1,000 pairs");
}
BENCHMARK(zipperEvaluation)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
