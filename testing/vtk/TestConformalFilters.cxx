/// The planar conformal filters against Core on the same input, with their arrays and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkLeastSquaresConformalMap.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRiemannMap.h>
#include <vtkSymmetricDirichletMap.h>
#include <vtkYamabeMap.h>

#include "Conversion.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/conformal/YamabeMap.h"
#include "Core/geometry/Areas.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/initial/LeastSquaresConformalMap.h"
#include "Core/initial/SymmetricDirichletMap.h"
#include "support/TestMeshes.h"
#include "support/VtkWords.h"

namespace {

using namespace authalic;
using authalic::testing::bumpyDisk;
using authalic::testing::sphereMesh;
using authalic::testing::VtkWords;

vtkSmartPointer<vtkPolyData> polyData(const TriangleMesh& mesh) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  setMesh(result, mesh);
  return result;
}

double field(vtkDataObject* object, const char* name) {
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

template <class Filter>
vtkSmartPointer<Filter> on(const TriangleMesh& mesh) {
  const auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(0, polyData(mesh));
  return filter;
}

/// The filter has this image, bit by bit, and says the same of itself.
template <class Result>
void expectSame(vtkSurfaceMapAlgorithm* filter, const Result& result) {
  filter->Update();
  EXPECT_EQ(toPlanarPoints(filter->GetOutput()), result.image);
  EXPECT_EQ(filter->GetStatus(), statusName(result.status));
  EXPECT_EQ(filter->GetIterations(), result.iterations);
  EXPECT_EQ(filter->GetFlippedFaces(), result.flippedFaces);
}

/// A flat disk whose boundary is to turn at four vertices by π/2.
Eigen::VectorXd squareCurvature(const DiskMesh& disk) {
  Eigen::VectorXd curvature = Eigen::VectorXd::Zero(disk.mesh().vertexCount());
  const auto& boundary = disk.boundary();
  for (std::size_t k = 0; k < 4; ++k) curvature[boundary[k * boundary.size() / 4]] = M_PI / 2;
  return curvature;
}

void addCurvature(vtkSurfaceMapAlgorithm* filter, const Eigen::VectorXd& curvature) {
  vtkNew<vtkDoubleArray> array;
  array->SetName("Turns");
  for (const double value : curvature) array->InsertNextValue(value);
  vtkPolyData::SafeDownCast(filter->GetInputDataObject(0, 0))->GetPointData()->AddArray(array);
}

}  // namespace

TEST(ConformalFilters, GiveTheImageOfCore) {
  const DiskMesh disk(bumpyDisk(12));
  expectSame(on<vtkLeastSquaresConformalMap>(disk.mesh()), leastSquaresConformalMap(disk));
  expectSame(on<vtkYamabeMap>(disk.mesh()), yamabeMap(disk));
  expectSame(on<vtkRiemannMap>(disk.mesh()), riemannMap(disk));
  BarycentricMapOptions tutte;
  tutte.weights = BarycentricWeights::Uniform;
  expectSame(on<vtkSymmetricDirichletMap>(disk.mesh()),
             symmetricDirichletMap(disk, barycentricMap(disk, tutte).image));
}

TEST(ConformalFilters, HandOverEveryOption) {
  const DiskMesh disk(bumpyDisk(12));
  const auto lscm = on<vtkLeastSquaresConformalMap>(disk.mesh());
  LeastSquaresConformalMapOptions pins;
  pins.pins = ConformalPins::Spectral;
  pins.firstPin = disk.boundary()[3];
  pins.secondPin = disk.boundary()[20];
  pins.tolerance = 1e-6;
  pins.maxIterations = 50;
  lscm->SetPinsToSpectral();
  lscm->SetFirstPin(pins.firstPin);
  lscm->SetSecondPin(pins.secondPin);
  lscm->SetTolerance(pins.tolerance);
  lscm->SetMaximumIterations(pins.maxIterations);
  expectSame(lscm, leastSquaresConformalMap(disk, pins));

  const auto riemann = on<vtkRiemannMap>(disk.mesh());
  RiemannMapOptions options;
  options.road = RiemannRoad::Puncture;
  options.puncture = 5;
  options.normalisation = {DiskCentre::Face, 40, disk.boundary()[7]};
  options.unfold = false;
  options.flow.metric = ConformalMetric::CirclePacking;
  options.flow.radii = PackingRadii::Circumradius;
  options.flow.tolerance = 1e-6;
  options.flow.maxIterations = 90;
  riemann->SetRoadToPuncture();
  riemann->SetPuncturedFace(5);
  riemann->SetCentreToFace();
  riemann->SetCentreId(40);
  riemann->SetStartVertex(disk.boundary()[7]);
  riemann->UnfoldOff();
  riemann->SetMetricToCirclePacking();
  riemann->SetPackingRadiiToCircumradius();
  riemann->SetTolerance(1e-6);
  riemann->SetMaximumIterations(90);
  expectSame(riemann, riemannMap(disk, options));
}

TEST(SymmetricDirichletMapFilter, KeepsABoundaryThatIsFixed) {
  const DiskMesh disk(bumpyDisk(12));
  const auto filter = on<vtkSymmetricDirichletMap>(disk.mesh());
  filter->SetBoundaryToFixed();
  filter->SetInitialMethodToMeanValue();
  filter->Update();
  ASSERT_EQ(filter->GetStatus(), "converged");
  const Points2 initial = barycentricMap(disk).image;
  for (const int v : disk.boundary()) {
    EXPECT_LT((toPlanarPoints(filter->GetOutput()).row(v) - initial.row(v)).norm(), 1e-12);
  }
}

TEST(YamabeMapFilter, TurnsItsBoundaryAsAnArraySays) {
  const DiskMesh disk(bumpyDisk(10));
  const auto filter = on<vtkYamabeMap>(disk.mesh());
  YamabeMapOptions options;
  options.curvature = squareCurvature(disk);
  addCurvature(filter, options.curvature);
  filter->SetCurvatureArrayName("Turns");
  expectSame(filter, yamabeMap(disk, options));
  vtkDataArray* reached = filter->GetOutput()->GetPointData()->GetArray("Curvature");
  for (int v = 0; v < disk.mesh().vertexCount(); ++v) {
    EXPECT_NEAR(reached->GetComponent(v, 0), options.curvature[v], 1e-10);
  }
}

TEST(YamabeMapFilter, RefusesTargetsThatNoMetricHas) {
  const DiskMesh disk(bumpyDisk(6));
  const auto refused = [&](const Eigen::VectorXd& curvature, const char* why) {
    const auto filter = on<vtkYamabeMap>(disk.mesh());
    const VtkWords words(filter);
    addCurvature(filter, curvature);
    filter->SetCurvatureArrayName("Turns");
    filter->Update();
    EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::ARGUMENT) << why;
    EXPECT_TRUE(words.contain(why)) << words.text();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  Eigen::VectorXd curvature = squareCurvature(disk);
  curvature[disk.boundary()[0]] = 0.1;
  refused(curvature, "Gauss");
  curvature[disk.boundary()[0]] = 3.5;
  refused(curvature, "below");
  refused(Eigen::VectorXd::Constant(disk.mesh().vertexCount(), 0.1), "inner vertices");
  const auto filter = on<vtkYamabeMap>(disk.mesh());
  const VtkWords words(filter);
  filter->SetCurvatureArrayName("None");
  filter->Update();
  EXPECT_TRUE(words.contain("target curvature")) << words.text();
}

TEST(CurvatureFlowFilters, CarryScaleFactorsThatTheImageFollows) {
  const DiskMesh disk(authalic::testing::capMesh(8, 1.2));  // Delaunay from the start to the end
  for (const auto& filter : {vtkSmartPointer<vtkConformalFlowAlgorithm>(on<vtkYamabeMap>(disk.mesh())),
                             vtkSmartPointer<vtkConformalFlowAlgorithm>(on<vtkRiemannMap>(disk.mesh()))}) {
    filter->Update();
    ASSERT_EQ(field(filter->GetOutput(), "EdgeFlips"), 0);
    EXPECT_LE(field(filter->GetOutput(), "Holonomy"), 1e-9);
    const Points2 image = toPlanarPoints(filter->GetOutput());
    vtkDataArray* u = filter->GetOutput()->GetPointData()->GetArray("LogScaleFactor");
    for (int h = 0; h < 3 * disk.mesh().faceCount(); ++h) {
      const int i = disk.topology().tail(h), j = disk.topology().head(h);
      const double length = (disk.mesh().point(i) - disk.mesh().point(j)).norm();
      EXPECT_NEAR((image.row(i) - image.row(j)).norm(),
                  length * std::exp(0.5 * (u->GetComponent(i, 0) + u->GetComponent(j, 0))), 1e-8);
    }
  }
}

TEST(CurvatureFlowFilters, GiveTheCommonRefinementOnRequest) {
  const DiskMesh disk(bumpyDisk(12));
  const auto filter = on<vtkRiemannMap>(disk.mesh());
  filter->RefineOn();
  filter->Update();
  vtkPolyData* refined = filter->GetOutput();
  ASSERT_GT(field(refined, "EdgeFlips"), 0);
  ASSERT_GT(refined->GetNumberOfCells(), disk.mesh().faceCount());
  const DiskMesh mapped(toTriangleMesh(refined));  // still a disk, so one-to-one where nothing folds
  EXPECT_EQ(field(refined, "FlippedFaces"), 0);
  vtkDataArray* points = refined->GetPointData()->GetArray("OriginalPointIds");
  vtkDataArray* faces = refined->GetCellData()->GetArray("OriginalCellIds");
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(disk.mesh().faceCount());
  const Eigen::VectorXd areas = faceAreas(surfaceOfMap(refined));
  for (vtkIdType f = 0; f < refined->GetNumberOfCells(); ++f) shares[int(faces->GetComponent(f, 0))] += areas[f];
  EXPECT_LT((shares - faceAreas(disk.mesh())).cwiseAbs().maxCoeff(), 1e-12);
  for (int v = 0; v < disk.mesh().vertexCount(); ++v) EXPECT_EQ(points->GetComponent(v, 0), v);
  EXPECT_EQ(points->GetComponent(refined->GetNumberOfPoints() - 1, 0), -1);
}

TEST(ConformalFilters, GiveTheBestMapAndAWarningWhenTheyMayNotGoOn) {
  const DiskMesh disk(bumpyDisk(10));
  const auto check = [](vtkSurfaceMapAlgorithm* filter) {
    const VtkWords words(filter);
    filter->Update();
    EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::NOT_CONVERGED) << filter->GetClassName();
    EXPECT_EQ(filter->GetStatus(), "not-converged");
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_TRUE(words.contain("Not converged")) << words.text();
  };
  const auto yamabe = on<vtkYamabeMap>(disk.mesh());
  yamabe->SetMaximumIterations(1);
  check(yamabe);
  const auto slim = on<vtkSymmetricDirichletMap>(disk.mesh());
  slim->SetMaximumIterations(1);
  check(slim);
  const auto lscm = on<vtkLeastSquaresConformalMap>(disk.mesh());
  lscm->SetPinsToSpectral();
  lscm->SetMaximumIterations(1);
  check(lscm);
}

TEST(ConformalFilters, RefuseAClosedSurfaceAndBadOptionsInWords) {
  const auto refused = [](vtkSurfaceMapAlgorithm* filter, int kind, const char* why) {
    const VtkWords words(filter);
    filter->Update();
    EXPECT_EQ(filter->GetErrorKind(), kind) << filter->GetClassName() << why;
    EXPECT_TRUE(words.contain(why)) << words.text();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  const TriangleMesh sphere = sphereMesh(2), disk = bumpyDisk(6);
  refused(on<vtkLeastSquaresConformalMap>(sphere), vtkSurfaceAlgorithm::SURFACE, "disk is required");
  refused(on<vtkSymmetricDirichletMap>(sphere), vtkSurfaceAlgorithm::SURFACE, "disk is required");
  refused(on<vtkYamabeMap>(sphere), vtkSurfaceAlgorithm::SURFACE, "disk is required");
  refused(on<vtkRiemannMap>(sphere), vtkSurfaceAlgorithm::SURFACE, "disk is required");
  const auto lscm = on<vtkLeastSquaresConformalMap>(disk);
  lscm->SetFirstPin(0);
  lscm->SetSecondPin(1);
  refused(lscm, vtkSurfaceAlgorithm::ARGUMENT, "boundary");
  const auto riemann = on<vtkRiemannMap>(disk);
  riemann->SetCentreToVertex();
  refused(riemann, vtkSurfaceAlgorithm::ARGUMENT, "centre");
  const auto punctured = on<vtkRiemannMap>(disk);
  punctured->SetRoadToPuncture();
  punctured->RefineOn();
  refused(punctured, vtkSurfaceAlgorithm::ARGUMENT, "common refinement");
}

TEST(ConformalFilters, HaveTheSameBitsAtAnyThreadCount) {
  const TriangleMesh mesh = bumpyDisk(20);
  const auto check = [](const vtkSmartPointer<vtkSurfaceMapAlgorithm>& filter) {
    filter->SetThreads(1);
    filter->Update();
    const Points3 one = toPoints(filter->GetOutput());
    filter->SetThreads(2);
    filter->Update();
    EXPECT_EQ(one, toPoints(filter->GetOutput())) << filter->GetClassName();
  };
  check(on<vtkLeastSquaresConformalMap>(mesh));
  check(on<vtkSymmetricDirichletMap>(mesh));
  check(on<vtkYamabeMap>(mesh));
  check(on<vtkRiemannMap>(mesh));
}
