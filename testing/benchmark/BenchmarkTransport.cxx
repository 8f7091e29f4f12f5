/// Optimal transport on scans: the whole map, start included.
#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "Core/authalic/TargetMeasure.h"
#include "Core/transport/OptimalTransportMap.h"
#include "Core/transport/SphericalTransportMap.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

const char* const kDisks[] = {"camelhead", "human_face", "chinese_lion", "human_brain"};

// Every face cut into four at the middles of its sides.
TriangleMesh refined(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> middles;
  std::vector<Eigen::Vector3d> added;
  const auto middle = [&](int a, int b) {
    const auto [found, fresh] =
        middles.try_emplace(std::minmax(a, b), mesh.vertexCount() + static_cast<int>(added.size()));
    if (fresh) added.push_back((mesh.point(a) + mesh.point(b)) / 2);
    return found->second;
  };
  Faces faces(4 * mesh.faceCount(), 3);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const int a = mesh.faces()(f, 0), b = mesh.faces()(f, 1), c = mesh.faces()(f, 2);
    const int x = middle(a, b), y = middle(b, c), z = middle(c, a);
    faces.middleRows(4 * f, 4) << a, x, z, b, y, x, c, z, y, x, y, z;
  }
  Points3 points(mesh.vertexCount() + static_cast<Eigen::Index>(added.size()), 3);
  points.topRows(mesh.vertexCount()) = mesh.points();
  for (std::size_t k = 0; k < added.size(); ++k) {
    points.row(mesh.vertexCount() + static_cast<Eigen::Index>(k)) = added[k].transpose();
  }
  return TriangleMesh(points, faces);
}

void transportOfDisk(benchmark::State& state) {
  TriangleMesh mesh = readOff(sharedData(std::string("meshes/open_disk/") + kDisks[state.range(0)] + ".off"));
  for (int k = 0; k < state.range(1); ++k) mesh = refined(mesh);
  const DiskMesh disk(mesh);
  const Eigen::VectorXd shares = TargetMeasure(disk.mesh()).vertices();
  for (auto _ : state) {
    const OptimalTransportMapResult map = optimalTransportMap(disk, shares);
    state.counters["steps"] = map.iterations;
    state.counters["residual"] = map.residual;
  }
  state.SetLabel(std::string(kDisks[state.range(0)]) + " " + std::to_string(disk.mesh().vertexCount()) + " vertices");
}
BENCHMARK(transportOfDisk)
    ->ArgsProduct({{0, 1, 2, 3}, {0}})->Args({3, 1})->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void transportOfSphere(benchmark::State& state) {
  const SphereMesh sphere(readOff(sharedData("meshes/closed_g0/sphere_brain.off")));
  const Eigen::VectorXd shares = TargetMeasure(sphere.mesh()).vertices();
  for (auto _ : state) {
    const SphericalTransportMapResult map = sphericalTransportMap(sphere, shares);
    state.counters["steps"] = map.iterations;
    state.counters["residual"] = map.residual;
  }
  state.SetLabel("sphere_brain " + std::to_string(sphere.mesh().vertexCount()) + " vertices");
}
BENCHMARK(transportOfSphere)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
