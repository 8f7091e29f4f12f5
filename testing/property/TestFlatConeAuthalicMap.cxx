#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include "Core/authalic/FlatConeAuthalicMap.h"
#include "Core/base/Error.h"
#include "Core/distortion/Distortion.h"
#include "Core/geometry/Areas.h"
#include "support/HighGenusMeshes.h"
#include "support/TestMeshes.h"
#include "support/TorusMeshes.h"

using namespace authalic;
using namespace authalic::testing;

namespace {

// No symmetry.
TriangleMesh bumpySlab(int holes, int size) {
  const TriangleMesh slab = slabMesh(holes, size);
  Points3 points = slab.points() / size;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double x = points(i, 0), y = points(i, 1);
    points(i, 2) *= 1 + 0.3 * std::sin(x + 0.4 * y);
    points(i, 0) += 0.1 * std::sin(2 * y + 1);
  }
  return TriangleMesh(points, slab.faces());
}

// Every vertex off its place by up to half an edge: faces of every shape, folds in the conformal layout.
TriangleMesh roughSlab(int holes, int size, unsigned seed) {
  const TriangleMesh slab = slabMesh(holes, size);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  Points3 points = slab.points();
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] += uniform(random);
  return TriangleMesh(points, slab.faces());
}

AuthalicMapOptions coarse() {
  AuthalicMapOptions options;
  options.tolerance = 0.05;
  return options;
}

double area(const Points2& image, const Faces& faces) { return signedFaceAreas(image, faces).sum(); }

void expectExact(const HighGenusMesh& surface, const FlatConeAuthalicMapResult& result,
                 const Eigen::VectorXd& target = {}) {
  EXPECT_EQ(result.status, Status::Converged) << result.faceResidual << ' ' << result.vertexResidual;
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(result.seamError, 1e-9);
  EXPECT_LT(result.angleError, 1e-9);
  const CutGraph& cut = result.flat.cut;
  const TriangleMesh opened(surface.mesh().points()(cut.originalPointIds, Eigen::all), cut.faces);
  const Distortion distortion = measureDistortion(opened, cut.originalPointIds, result.image, target);
  EXPECT_LT(distortion.summary.vertexMaxAbsLog, 1e-9);
  EXPECT_LT(distortion.summary.areaDistortion, 2.0025);
  EXPECT_EQ(distortion.summary.flippedFaces, 0);
}

// How far the faces around a vertex reach when they are unfolded one after the other across the seams: radians.
double unfoldedAngle(const SurfaceTopology& topology, const FlatConeAuthalicMapResult& result, int corner) {
  const auto place = [&](int c) {
    const int v = result.flat.cut.faces.data()[c];
    return std::complex<double>(result.image(v, 0), result.image(v, 1));
  };
  RigidMotion unfold;
  const std::complex<double> centre = place(corner);
  double angle = 0;
  for (int c = corner;;) {
    const int last = SurfaceTopology::previous(c);
    const std::complex<double> from = unfold(place(SurfaceTopology::next(c))) - centre,
                               to = unfold(place(last)) - centre;
    EXPECT_LT(std::abs(unfold(place(c)) - centre), 1e-9);
    angle += std::arg(to / from);
    if (result.flat.cut.onCut[static_cast<std::size_t>(last)]) {
      unfold = unfold.after(result.flat.motions.across[static_cast<std::size_t>(last)].inverse());
    }
    c = topology.opposite(last);
    if (c == corner) break;
  }
  return angle;
}

}  // namespace

TEST(FlatConeSurface, HasTheCurvatureOfTheSurfaceInQuarterTurns) {
  for (const int genus : {2, 3}) {
    const HighGenusMesh surface(slabMesh(genus, 4));
    EXPECT_EQ(surface.genus(), genus);
    const FlatConeSurface flat = flatConeSurface(surface, SolverBackend::Automatic);
    double total = 0;
    for (const double curvature : flat.curvature) {
      EXPECT_DOUBLE_EQ(std::abs(curvature), 0.5 * M_PI);
      total += curvature;
    }
    EXPECT_NEAR(total, 2 * M_PI * (2 - 2 * genus), 1e-12);
    EXPECT_EQ(flat.flow.status, Status::Converged);
    EXPECT_EQ(flat.holonomy.parameters().size(), static_cast<int>(flat.cones.size()) - 1 + 2 * genus);
    const Points2 image = openImage(flat, surface.mesh().faces(), flat.places);
    EXPECT_NEAR(area(image, flat.cut.faces), 1, 1e-9);
    const Eigen::VectorXd angles = angleSums(surface.mesh().faces(), flat.cut, image);
    for (int v = 0; v < angles.size(); ++v) {
      const auto cone = std::find(flat.cones.begin(), flat.cones.end(), v);
      const double curvature =
          cone == flat.cones.end() ? 0 : flat.curvature[static_cast<std::size_t>(cone - flat.cones.begin())];
      EXPECT_NEAR(angles[v], 2 * M_PI - curvature, 1e-9) << v;
    }
  }
}

TEST(FlatConeSurface, HasTheLengthsOfItsConformalMetric) {
  // Where no edge was flipped, an edge is as long as its scale factors say: l e^{(u_i + u_j)/2}, one factor for all.
  const HighGenusMesh surface(bumpySlab(2, 6));
  const FlatConeSurface flat = flatConeSurface(surface, SolverBackend::Automatic);
  const Points2 image = openImage(flat, surface.mesh().faces(), flat.places);
  const SurfaceTopology& topology = surface.topology();
  std::vector<double> ratios;
  for (int h = 0; h < 3 * surface.mesh().faceCount(); ++h) {
    const int i = topology.tail(h), j = topology.head(h);
    const double length = (surface.mesh().point(j) - surface.mesh().point(i)).norm() *
                          std::exp(0.5 * (flat.flow.logScale[i] + flat.flow.logScale[j]));
    const auto corner = [&](int c) { return image.row(flat.cut.faces.data()[c]); };
    ratios.push_back((corner(SurfaceTopology::next(h)) - corner(h)).norm() / length);
  }
  std::vector<double> sorted = ratios;
  std::sort(sorted.begin(), sorted.end());
  const double scale = sorted[sorted.size() / 2];
  const auto same = std::count_if(ratios.begin(), ratios.end(),
                                  [&](double ratio) { return std::abs(ratio / scale - 1) < 1e-8; });
  EXPECT_GT(same, static_cast<long>(ratios.size() / 2));
}

TEST(FlatConeSurface, KeepsItsSeamsForOtherTranslations) {
  const HighGenusMesh surface(slabMesh(2, 4));
  FlatConeSurface flat = flatConeSurface(surface, SolverBackend::Automatic);
  Eigen::VectorXcd translations = flat.translations;
  for (Eigen::Index k = 0; k < translations.size(); ++k) {
    translations[k] += std::complex<double>(0.01 * std::sin(k + 1.0), 0.01 * std::cos(3.0 * k));
  }
  setMotions(flat, flat.holonomy.motions(surface.topology(), flat.cut, translations));
  const Points2 image = openImage(flat, surface.mesh().faces(), flat.places);
  for (const ConeSeam& seam : coneSeams(surface.topology(), flat, image)) EXPECT_LT(seam.error, 1e-12);
}

TEST(FlatConeAuthalicMap, IsExactAtEveryVertexAcrossTheSeams) {
  for (const int genus : {2, 3}) {
    const HighGenusMesh surface(bumpySlab(genus, 6));
    const FlatConeAuthalicMapResult result = flatConeAuthalicMap(surface, TargetMeasure(surface.mesh()), coarse());
    expectExact(surface, result);
    EXPECT_NEAR(area(result.image, result.flat.cut.faces), 1, 1e-12);
  }
}

TEST(FlatConeAuthalicMap, IsExactOnRoughSurfaces) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const HighGenusMesh two(roughSlab(2, 4, seed)), three(roughSlab(3, 4, seed));
    for (const HighGenusMesh* surface : {&two, &three}) {
      const FlatConeAuthalicMapResult result = flatConeAuthalicMap(*surface, TargetMeasure(surface->mesh()));
      expectExact(*surface, result);
      EXPECT_LT(result.faceResidual, 1e-2);
    }
  }
}

TEST(FlatConeAuthalicMap, GoesAroundEveryVertexOnceWhereTheStartIsFolded) {
  // Without folds and wrong all the same: faces that go around a vertex twice, and once too few around a cone.
  AuthalicMapOptions options = coarse();
  options.maxIterations = 4;
  for (const int genus : {2, 3}) {
    const TriangleMesh rough = roughSlab(genus, 3, 7);
    Points3 points = rough.points();
    points.col(0) *= 4;
    const HighGenusMesh surface(TriangleMesh(points, rough.faces()));
    const FlatConeAuthalicMapResult result = flatConeAuthalicMap(surface, TargetMeasure(surface.mesh()), options);
    EXPECT_EQ(result.flippedFaces, 0);
    EXPECT_LT(result.angleError, 1e-9);
  }
}

TEST(FlatConeAuthalicMap, LeavesTheRingOfEveryVertexWhole) {
  const HighGenusMesh surface(bumpySlab(2, 4));
  const FlatConeAuthalicMapResult result = flatConeAuthalicMap(surface, TargetMeasure(surface.mesh()), coarse());
  for (int corner = 0; corner < 3 * surface.mesh().faceCount(); ++corner) {
    const int v = surface.topology().tail(corner);
    const auto cone = std::find(result.flat.cones.begin(), result.flat.cones.end(), v);
    if (cone != result.flat.cones.end()) continue;
    EXPECT_NEAR(unfoldedAngle(surface.topology(), result, corner), 2 * M_PI, 1e-9);
  }
}

TEST(FlatConeAuthalicMap, PairsTheSidesOfEverySeamByOneRigidMotion) {
  const HighGenusMesh surface(bumpySlab(2, 4));
  const FlatConeAuthalicMapResult result = flatConeAuthalicMap(surface, TargetMeasure(surface.mesh()), coarse());
  std::size_t edges = 0;
  for (const ConeSeam& seam : result.seams) {
    ASSERT_EQ(seam.side.size(), seam.otherSide.size());
    edges += seam.side.size() - 1;
    EXPECT_NEAR(std::abs(seam.motion.turn), 1, 1e-12);
    for (std::size_t i = 0; i < seam.side.size(); ++i) {
      const auto original = [&](int v) { return result.flat.cut.originalPointIds[static_cast<std::size_t>(v)]; };
      EXPECT_EQ(original(seam.side[i]), original(seam.otherSide[i]));
    }
  }
  std::size_t halfEdges = 0;
  for (const char onCut : result.flat.cut.onCut) halfEdges += onCut != 0;
  EXPECT_EQ(2 * edges, halfEdges);
}

TEST(FlatConeAuthalicMap, GivesHalfOfTheSurfaceFourTimesItsDensity) {
  const HighGenusMesh surface(bumpySlab(2, 6));
  Eigen::VectorXd density(surface.mesh().vertexCount());
  for (int v = 0; v < density.size(); ++v) density[v] = surface.mesh().point(v)[0] > 2.5 ? 4 : 1;
  const TargetMeasure target = TargetMeasure::fromVertexDensity(surface.mesh(), density);
  expectExact(surface, flatConeAuthalicMap(surface, target, coarse()), target.faces());
}

TEST(FlatConeAuthalicMap, DoesNotDependOnPositionAndScale) {
  const TriangleMesh mesh = bumpySlab(2, 4);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const TriangleMesh moved((mesh.points() * turn.transpose() * 12.0).rowwise() + Eigen::RowVector3d(3, 4, 5),
                           mesh.faces());
  const FlatConeAuthalicMapResult one = flatConeAuthalicMap(HighGenusMesh(mesh), TargetMeasure(mesh), coarse()),
                                  other = flatConeAuthalicMap(HighGenusMesh(moved), TargetMeasure(moved), coarse());
  EXPECT_EQ(one.flat.cones, other.flat.cones);
  ASSERT_EQ(one.image.rows(), other.image.rows());
  // But for a translation, which is without effect on anything.
  const Points2 difference = one.image - other.image;
  EXPECT_LT((difference.rowwise() - difference.colwise().mean()).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(FlatConeAuthalicMap, GivesTheSameBitsTwiceAndOnOneThreadAndTwo) {
  const HighGenusMesh surface(bumpySlab(2, 4));
  const TargetMeasure target(surface.mesh());
  const Points2 image = flatConeAuthalicMap(surface, target, coarse(), Execution({}, {}, 1)).image;
  EXPECT_EQ(image, flatConeAuthalicMap(surface, target, coarse(), Execution({}, {}, 1)).image);
  EXPECT_EQ(image, flatConeAuthalicMap(surface, target, coarse(), Execution({}, {}, 2)).image);
}

TEST(FlatConeAuthalicMap, ReturnsAnUnfoldedIterateWhenCancelled) {
  const HighGenusMesh surface(bumpySlab(2, 4));
  bool solving = false;
  const Execution execution([&](double, const std::string& stage) { solving = solving || stage == "Matching faces"; },
                            [&] { return solving; });
  const FlatConeAuthalicMapResult result = flatConeAuthalicMap(surface, TargetMeasure(surface.mesh()), {}, execution);
  EXPECT_EQ(result.status, Status::Cancelled);
  EXPECT_EQ(result.flippedFaces, 0);
  EXPECT_LT(result.seamError, 1e-9);
}

TEST(FlatConeAuthalicMap, RefusesATargetOfAnotherSurface) {
  EXPECT_THROW((void)flatConeAuthalicMap(HighGenusMesh(slabMesh(2, 3)), TargetMeasure(slabMesh(2, 4))), GeometryError);
}

TEST(HighGenusMesh, SaysWhichMethodIsForFewerHandles) {
  const auto refusal = [](const TriangleMesh& mesh) -> std::string {
    try {
      (void)HighGenusMesh(mesh);
    } catch (const TopologyError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(refusal(sphereMesh(2)).find("genus 0); take a method for this genus, for a sphere"), std::string::npos);
  EXPECT_NE(refusal(torusMesh(9, 9)).find("genus 1); take a method for this genus, for a torus"), std::string::npos);
  EXPECT_NE(refusal(bumpyDisk(4)).find("a boundary loop too many"), std::string::npos);
}
