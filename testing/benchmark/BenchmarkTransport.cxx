/// Optimal transport on scans: the whole map, start included; geogram's from the same sites when it is there.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "Core/authalic/TargetMeasure.h"
#include "Core/transport/OptimalTransportMap.h"
#include "Core/transport/SphericalTransportMap.h"
#include "support/OffFile.h"
#include "support/SharedData.h"

#ifdef AUTHALIC_HAVE_GEOGRAM
#include <exploragram/optimal_transport/optimal_transport_2d.h>
#include <geogram/basic/command_line.h>
#include <geogram/basic/command_line_args.h>
#include <geogram/basic/logger.h>
#include <geogram/mesh/mesh.h>
#endif

using namespace authalic;
using namespace authalic::testing;

namespace {

const char* const kDisks[] = {"camelhead", "human_face", "chinese_lion", "human_brain"};

DiskMesh scan(std::int64_t which) {
  return DiskMesh(readOff(sharedData(std::string("meshes/open_disk/") + kDisks[which] + ".off")));
}

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
  TriangleMesh mesh = scan(state.range(0)).mesh();
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

OptimalTransportMapOptions toSquare(double tolerance) {
  OptimalTransportMapOptions options;
  options.domain = PlanarDomain::square();
  options.tolerance = tolerance;
  return options;
}

// To 10^−k of the mean.
void transportToSquare(benchmark::State& state) {
  const DiskMesh disk = scan(state.range(0));
  const Eigen::VectorXd shares = TargetMeasure(disk.mesh()).vertices();
  const OptimalTransportMapOptions options = toSquare(std::pow(10.0, -static_cast<double>(state.range(1))));
  for (auto _ : state) {
    const OptimalTransportMapResult map = optimalTransportMap(disk, shares, options);
    state.counters["steps"] = map.iterations;
    state.counters["residual"] = map.residual;
  }
  state.SetLabel(kDisks[state.range(0)]);
}
BENCHMARK(transportToSquare)
    ->ArgsProduct({{0, 1, 2, 3}, {2, 9}})->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

#ifdef AUTHALIC_HAVE_GEOGRAM
// From our harmonic map, which is not timed, to what geogram calls 10⁻² (the root of the mean square of the cells).
// The residual, as ours the largest, is that of our diagram for its weights.
void geogramToSquare(benchmark::State& state) {
  const DiskMesh disk = scan(state.range(0));
  const Eigen::VectorXd shares = TargetMeasure(disk.mesh()).vertices();
  OptimalTransportMapOptions options = toSquare(1e-2);
  options.maxIterations = 0;
  const OptimalTransportMapResult start = optimalTransportMap(disk, shares, options);
  GEO::initialize();
  GEO::CmdLine::import_arg_group("standard");
  GEO::CmdLine::import_arg_group("algo");
  GEO::Logger::instance()->set_quiet(true);
  GEO::Mesh square;
  square.vertices.set_dimension(3);
  for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(1.0, 1.0), std::pair(0.0, 1.0)}) {
    const double corner[] = {x, y, 0};
    square.vertices.create_vertex(corner);
  }
  square.facets.create_triangle(0, 1, 2);
  square.facets.create_triangle(0, 2, 3);
  square.facets.connect();
  const auto count = static_cast<GEO::index_t>(disk.mesh().vertexCount());
  const Points2& sites = start.sites;
  Eigen::VectorXd weights(disk.mesh().vertexCount());
  for (auto _ : state) {
    GEO::OptimalTransportMap2d transport(&square);
    transport.set_points(count, sites.data(), 2);
    for (GEO::index_t i = 0; i < count; ++i) transport.set_nu(i, shares[static_cast<Eigen::Index>(i)]);
    transport.set_epsilon(1e-2);
    transport.set_regularization(0);
    transport.set_Newton(true);
    transport.set_verbose(false);
    transport.optimize(1000);
    for (GEO::index_t i = 0; i < count; ++i) weights[static_cast<Eigen::Index>(i)] = transport.weight(i);
  }
  const Heights heights = (0.5 * (weights - sites.rowwise().squaredNorm())).cast<long double>();
  state.counters["residual"] = optimalTransportMap(disk, shares, options, sites, {}, heights).residual;
  state.SetLabel(kDisks[state.range(0)]);
}
BENCHMARK(geogramToSquare)->DenseRange(0, 3)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
#endif

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
