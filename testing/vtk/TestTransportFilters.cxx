/// The filters of optimal transport against Core on the same input, with their arrays and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include <vtkBalanceCurve.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkOptimalTransportMap.h>
#include <vtkPointData.h>
#include <vtkPolyAnnulusTransportMap.h>
#include <vtkPolyData.h>
#include <vtkSphericalTransportMap.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include "Conversion.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/geometry/Areas.h"
#include "Core/transport/OptimalTransportMap.h"
#include "Core/transport/PolyAnnulusTransportMap.h"
#include "Core/transport/SphericalTransportMap.h"
#include "FieldArrays.h"
#include "support/HoledMeshes.h"
#include "support/TestMeshes.h"
#include "support/VtkWords.h"

namespace {

using namespace authalic;
using authalic::testing::bumpyDisk;
using authalic::testing::diskMesh;
using authalic::testing::holedDisk;
using authalic::testing::sphereMesh;
using authalic::testing::VtkWords;
using authalic::testing::wavySphere;

class TransportFilters : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PowerDiagram::available()) GTEST_SKIP() << "CGAL was not built in";
  }
};

vtkSmartPointer<vtkPolyData> polyData(const TriangleMesh& mesh) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  setMesh(result, mesh);
  return result;
}

double field(vtkDataObject* object, const char* name) {
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

double drawnArea(vtkPolyData* cells, int cell) {
  vtkPoints* points = cells->GetCell(cell)->GetPoints();
  Points2 corners(points->GetNumberOfPoints(), 2);
  for (Eigen::Index k = 0; k < corners.rows(); ++k) corners.row(k) << points->GetPoint(k)[0], points->GetPoint(k)[1];
  return polygonArea(corners);
}

}  // namespace

TEST_F(TransportFilters, GiveTheImageAndTheCellsOfCore) {
  const DiskMesh disk(bumpyDisk(10));
  const OptimalTransportMapResult core = optimalTransportMap(disk, TargetMeasure(disk.mesh()).vertices());
  vtkNew<vtkOptimalTransportMap> filter;
  filter->SetInputData(0, polyData(disk.mesh()));
  filter->Update();
  vtkPolyData* map = filter->GetOutput(0);
  EXPECT_EQ(toPlanarPoints(map), core.image);
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(filter->GetErrorKind(), vtkOptimalTransportMap::NONE);
  EXPECT_EQ(field(map, "TransportCost"), core.transportCost);
  EXPECT_LE(field(map, "TransportResidual"), 1e-9);
  EXPECT_EQ(field(map, "EmptyCells"), 0);
  for (const char* name : {"Site", "CellArea", "Potential"}) EXPECT_TRUE(map->GetPointData()->HasArray(name)) << name;
  vtkPolyData* cells = filter->GetOutput(1);
  ASSERT_EQ(cells->GetNumberOfPolys(), disk.mesh().vertexCount());
  EXPECT_EQ(cells->GetPointData()->GetArray("Potential")->GetNumberOfTuples(), cells->GetNumberOfPoints());
  vtkDataArray* exact = cells->GetCellData()->GetArray("Area");
  vtkDataArray* ids = cells->GetCellData()->GetArray("SiteIds");
  for (int i = 0; i < disk.mesh().vertexCount(); ++i) {
    EXPECT_EQ(ids->GetComponent(i, 0), i);
    EXPECT_EQ(exact->GetComponent(i, 0), core.cellAreas[i]);
    EXPECT_NEAR(drawnArea(cells, i), core.cellAreas[i], 1e-5);
  }
}

TEST_F(TransportFilters, StartWhereTheyAreToldAndReportTheLevels) {
  const DiskMesh disk(bumpyDisk(10));
  OptimalTransportMapOptions options;
  options.start = TransportStart::CoarseToFine;
  const OptimalTransportMapResult core = optimalTransportMap(disk, TargetMeasure(disk.mesh()).vertices(), options);
  ASSERT_EQ(core.levels.size(), 2U);
  vtkNew<vtkOptimalTransportMap> filter;
  EXPECT_EQ(filter->GetStart(), vtkOptimalTransportMap::AUTOMATIC);
  filter->SetInputData(0, polyData(disk.mesh()));
  filter->Update();
  EXPECT_NE(filter->GetReport().find("\"start\": \"automatic\""), std::string::npos);
  EXPECT_NE(filter->GetReport().find("\"voronoi_part\": 1"), std::string::npos);
  filter->SetStartToCoarseToFine();
  filter->Update();
  EXPECT_EQ(toPlanarPoints(filter->GetOutput(0)), core.image);
  EXPECT_NE(filter->GetReport().find("\"start\": \"coarse-to-fine\""), std::string::npos);
  EXPECT_NE(filter->GetReport().find("\"sites\": " + std::to_string(core.levels[0].sites)), std::string::npos);
  vtkNew<vtkPolyAnnulusTransportMap> holed;
  holed->SetStartToVoronoi();
  EXPECT_EQ(holed->GetStart(), vtkPolyAnnulusTransportMap::VORONOI);
}

TEST_F(TransportFilters, RemoveFoldsAndErrorsOfFacesWhenAskedTo) {
  vtkNew<vtkOptimalTransportMap> filter;
  filter->SetInputData(0, polyData(bumpyDisk(14, 1.5)));
  filter->Update();
  const double bare = filter->GetTotalAreaDistortion(), moved = field(filter->GetOutput(), "DisplacementCost");
  EXPECT_TRUE(std::isnan(field(filter->GetOutput(), "FinishedCost")));
  filter->SetFinishToAuthalic();
  filter->Update();
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(filter->GetFlippedFaces(), 0);
  EXPECT_LT(filter->GetTotalAreaDistortion(), bare);
  EXPECT_LT(filter->GetTotalAreaDistortion(), 2.0002);
  EXPECT_EQ(field(filter->GetOutput(), "DisplacementCost"), moved);
  EXPECT_GT(field(filter->GetOutput(), "FinishedCost"), moved);
}

TEST_F(TransportFilters, TakeASourceDensityFromAMeshWithAPointArray) {
  const DiskMesh disk(bumpyDisk(10)), plane(diskMesh(7));
  const Eigen::VectorXd density = plane.mesh().points().col(0).array() + 1.5;
  OptimalTransportMapOptions options;
  options.source = std::make_shared<const PiecewiseLinearDensity>(options.domain, plane, density);
  const OptimalTransportMapResult core = optimalTransportMap(disk, TargetMeasure(disk.mesh()).vertices(), options);
  const vtkSmartPointer<vtkPolyData> mesh = polyData(plane.mesh());
  addArray(mesh->GetPointData(), "Density", density);
  vtkNew<vtkOptimalTransportMap> filter;
  filter->SetInputData(0, polyData(disk.mesh()));
  filter->SetInputData(2, mesh);
  filter->SetSourceDensityArrayName("Density");
  filter->Update();
  vtkPolyData* map = filter->GetOutput(0);
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(toPlanarPoints(map), core.image);
  EXPECT_EQ(field(map, "TransportCost"), core.transportCost);
  EXPECT_NEAR(field(map, "SourceMass"), 1.5 * M_PI, 1e-13);
  EXPECT_EQ(toVector(map->GetPointData()->GetArray("CellMass")), core.cellMasses);
  EXPECT_EQ(toVector(map->GetPointData()->GetArray("CellArea")), core.cellAreas);
  EXPECT_EQ(toVector(filter->GetOutput(1)->GetCellData()->GetArray("Mass")), core.cellMasses);
  EXPECT_NE(filter->GetReport().find("\"source_density\": \"Density\""), std::string::npos);
}

TEST_F(TransportFilters, RefuseSourceDensitiesThatCannotBe) {
  const vtkSmartPointer<vtkPolyData> mesh = polyData(diskMesh(7)), closed = polyData(sphereMesh(2));
  addArray(mesh->GetPointData(), "Density", Eigen::VectorXd::Ones(mesh->GetNumberOfPoints()).eval());
  addArray(mesh->GetPointData(), "Zero", Eigen::VectorXd::Zero(mesh->GetNumberOfPoints()).eval());
  addArray(closed->GetPointData(), "Density", Eigen::VectorXd::Ones(closed->GetNumberOfPoints()).eval());
  vtkNew<vtkOptimalTransportMap> filter;
  filter->SetInputData(0, polyData(bumpyDisk(6)));
  const VtkWords words(filter);
  const auto kindWith = [&](vtkPolyData* source, const char* array) {
    filter->SetInputData(2, source);
    filter->SetSourceDensityArrayName(array);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints() == 0, filter->GetErrorKind() != 0);
    return filter->GetErrorKind();
  };
  EXPECT_EQ(kindWith(mesh, ""), vtkOptimalTransportMap::ARGUMENT);
  EXPECT_EQ(kindWith(nullptr, "Density"), vtkOptimalTransportMap::ARGUMENT);
  EXPECT_EQ(kindWith(mesh, "Other"), vtkOptimalTransportMap::ARGUMENT);
  EXPECT_EQ(kindWith(mesh, "Zero"), vtkOptimalTransportMap::ARGUMENT);
  EXPECT_EQ(kindWith(closed, "Density"), vtkOptimalTransportMap::SURFACE);
  EXPECT_EQ(kindWith(mesh, "Density"), vtkOptimalTransportMap::NONE);
  filter->SetDomainToSquare();
  EXPECT_EQ(kindWith(mesh, "Density"), vtkOptimalTransportMap::SURFACE);
  filter->SetDomainToDisk();
  filter->SetFinishToAuthalic();
  EXPECT_EQ(kindWith(mesh, "Density"), vtkOptimalTransportMap::ARGUMENT);
  filter->SetFinishToNone();
  filter->SetBalance(0.5);
  EXPECT_EQ(kindWith(mesh, "Density"), vtkOptimalTransportMap::ARGUMENT);
}

TEST_F(TransportFilters, TakeTheirSitesFromAGivenMapOrTheRiemannMap) {
  const vtkSmartPointer<vtkPolyData> surface = polyData(bumpyDisk(10));
  vtkNew<vtkOptimalTransportMap> first, second;
  first->SetInputData(0, surface);
  first->SetInitialMethodToRiemann();
  first->Update();
  EXPECT_EQ(first->GetStatus(), "converged");
  vtkNew<vtkPolyData> sites;
  sites->CopyStructure(surface);
  vtkNew<vtkPoints> points;
  points->SetData(first->GetOutput()->GetPointData()->GetArray("Site"));
  sites->SetPoints(points);
  second->SetInputData(0, surface);
  second->SetInputData(1, sites);
  second->Update();
  EXPECT_LT((toPlanarPoints(first->GetOutput()) - toPlanarPoints(second->GetOutput())).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(TransportFilters, SayWhatTheyCannotDo) {
  const vtkSmartPointer<vtkPolyData> surface = polyData(bumpyDisk(6));
  vtkNew<vtkOptimalTransportMap> filter;
  const VtkWords words(filter);
  filter->SetInputData(0, surface);
  filter->SetTolerance(0);
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkOptimalTransportMap::ARGUMENT);
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfPoints() + filter->GetOutput(1)->GetNumberOfPoints(), 0);
  filter->SetTolerance(1e-9);
  filter->SetDomainToSquare();
  filter->SetInitialMethodToRiemann();
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkOptimalTransportMap::ARGUMENT);
  filter->SetInitialMethodToHarmonic();
  filter->SetMaximumIterations(0);
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkOptimalTransportMap::NOT_CONVERGED);
  EXPECT_EQ(filter->GetStatus(), "not-converged");
  filter->SetInputData(0, polyData(sphereMesh(2)));
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkOptimalTransportMap::SURFACE);
}

TEST_F(TransportFilters, MapClosedSurfacesToTheSphereAsCoreDoes) {
  const SphereMesh sphere(wavySphere(3));
  const SphericalTransportMapResult core = sphericalTransportMap(sphere, TargetMeasure(sphere.mesh()).vertices());
  vtkNew<vtkSphericalTransportMap> filter;
  filter->SetInputData(0, polyData(sphere.mesh()));
  filter->Update();
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(toPoints(filter->GetOutput()), core.image);
  EXPECT_EQ(field(filter->GetOutput(), "TransportCost"), core.transportCost);
  vtkPolyData* cells = filter->GetOutput(1);
  ASSERT_EQ(cells->GetNumberOfPolys(), sphere.mesh().vertexCount());
  for (int i = 0; i < sphere.mesh().vertexCount(); ++i) {
    EXPECT_EQ(cells->GetCellData()->GetArray("Area")->GetComponent(i, 0), core.cellAreas[i]);
  }
  filter->SetFinishToAuthalic();
  filter->Update();
  EXPECT_EQ(filter->GetFlippedFaces(), 0);
  EXPECT_LT(filter->GetTotalAreaDistortion(), 2.001);
  EXPECT_GT(field(filter->GetOutput(), "FinishedCost"), 0);
  const VtkWords words(filter);
  filter->SetInputData(0, polyData(bumpyDisk(4)));
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkSphericalTransportMap::SURFACE);
}

TEST_F(TransportFilters, MapClosedSurfacesInAStereographicPlaneAsCoreDoes) {
  const SphereMesh sphere(wavySphere(3));
  SphericalTransportMapOptions options;
  options.formulation = SphereFormulation::Stereographic;
  options.pole = Eigen::Vector3d(0.1, -2, 0.3);
  const auto core = sphericalTransportMap(sphere, TargetMeasure(sphere.mesh()).vertices(), options);
  vtkNew<vtkSphericalTransportMap> filter;
  filter->SetInputData(0, polyData(sphere.mesh()));
  filter->SetFormulationToStereographic();
  filter->SetPole(0.1, -2, 0.3);
  filter->Update();
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(toPoints(filter->GetOutput()), core.image);
  EXPECT_TRUE(std::isnan(field(filter->GetOutput(), "TransportCost")));  // it is infinite: there is no such field
  EXPECT_EQ(filter->GetReport().find("transport_cost"), std::string::npos);
  EXPECT_NE(filter->GetReport().find("\"formulation\": \"stereographic\""), std::string::npos);
  EXPECT_GT(field(filter->GetOutput(), "DisplacementCost"), 0);
  vtkDataArray* pole = filter->GetOutput()->GetFieldData()->GetArray("Pole");
  ASSERT_NE(pole, nullptr);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(pole->GetComponent(0, k), core.pole[k]);
  vtkPolyData* cells = filter->GetOutput(1);
  ASSERT_EQ(cells->GetNumberOfPolys(), sphere.mesh().vertexCount());
  for (int i = 0; i < sphere.mesh().vertexCount(); ++i) {
    EXPECT_EQ(cells->GetCellData()->GetArray("Area")->GetComponent(i, 0), core.cellAreas[i]);
  }
  filter->SetFinishToAuthalic();
  filter->SetBalance(0.5);
  filter->Update();
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(filter->GetFlippedFaces(), 0);
}

TEST_F(TransportFilters, RefusePolesWithoutAProjection) {
  vtkNew<vtkSphericalTransportMap> filter;
  filter->SetInputData(0, polyData(wavySphere(2)));
  filter->SetPole(0, 0, 1);
  const VtkWords words(filter);
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkSphericalTransportMap::ARGUMENT);
  filter->SetFormulationToStereographic();
  filter->SetPole(0, std::nan(""), 1);
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkSphericalTransportMap::ARGUMENT);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 0);
}

TEST_F(TransportFilters, BalanceAnglesAgainstAreas) {
  const auto check = [](auto map, const TriangleMesh& mesh) {
    double area = 1e300, angle = 0;
    map->SetFinishToAuthalic();
    for (const double balance : {0.0, 0.5, 1.0}) {
      map->SetInputData(0, polyData(mesh));
      map->SetBalance(balance);
      map->Update();
      EXPECT_EQ(map->GetStatus(), "converged") << balance;
      EXPECT_EQ(map->GetFlippedFaces(), 0) << balance;
      EXPECT_LT(map->GetTotalAreaDistortion(), area) << balance;
      EXPECT_GT(map->GetTotalAngleDistortion(), angle) << balance;
      if (balance < 1) {
        EXPECT_EQ(field(map->GetOutput(), "Balance"), balance);
      }
      area = map->GetTotalAreaDistortion();
      angle = map->GetTotalAngleDistortion();
    }
  };
  const auto disk = vtkSmartPointer<vtkOptimalTransportMap>::New();
  disk->SetInitialMethodToRiemann();
  check(disk, bumpyDisk(20));
  const TriangleMesh round = sphereMesh(4);
  check(vtkSmartPointer<vtkSphericalTransportMap>::New(),
        TriangleMesh(round.points() * Eigen::Vector3d(1, 1.5, 2.2).asDiagonal(), round.faces()));
}

TEST_F(TransportFilters, BalanceFromPlaceToPlaceAsOneNumberEverywhereDoes) {
  const auto check = [](auto one, auto other, const TriangleMesh& mesh) {
    const auto surface = polyData(mesh);
    vtkNew<vtkDoubleArray> weights;
    weights->SetName("T");
    for (int i = 0; i < mesh.vertexCount(); ++i) weights->InsertNextValue(0.25);
    surface->GetPointData()->AddArray(weights);
    for (auto filter : {one, other}) filter->SetInputData(0, surface);
    one->SetBalance(0.25);
    other->SetBalanceArrayName("T");
    one->Update();
    other->Update();
    EXPECT_EQ(toPoints(one->GetOutput()), toPoints(other->GetOutput()));
    weights->SetValue(3, 1.5);
    weights->Modified();
    surface->Modified();
    const VtkWords words(other);
    other->Update();
    EXPECT_EQ(other->GetErrorKind(), vtkOptimalTransportMap::ARGUMENT);
    EXPECT_EQ(other->GetOutput()->GetNumberOfPoints(), 0);
  };
  check(vtkSmartPointer<vtkOptimalTransportMap>::New(), vtkSmartPointer<vtkOptimalTransportMap>::New(), bumpyDisk(8));
  check(vtkSmartPointer<vtkSphericalTransportMap>::New(), vtkSmartPointer<vtkSphericalTransportMap>::New(),
        wavySphere(3));
}

TEST_F(TransportFilters, GiveTheCurveOfBalancesAsATable) {
  vtkNew<vtkBalanceCurve> curve;
  curve->SetInputData(polyData(bumpyDisk(10)));
  curve->SetNumberOfBalances(3);
  curve->Update();
  vtkTable* table = curve->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 3);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(table->GetValueByName(k, "balance").ToDouble(), 0.5 * k);
    EXPECT_EQ(table->GetValueByName(k, "flipped_faces").ToInt(), 0);
    EXPECT_EQ(table->GetValueByName(k, "status").ToString(), "converged");
  }
  EXPECT_LT(table->GetValueByName(2, "area_distortion").ToDouble(), 2.001);
  EXPECT_NE(curve->GetText().find("angle_error_mean_degrees"), std::string::npos);
  EXPECT_NE(curve->GetReport().find("cell_tolerance"), std::string::npos);
  curve->AddBalance(0.3);
  curve->Update();
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  EXPECT_EQ(table->GetValueByName(0, "balance").ToDouble(), 0.3);
  const VtkWords words(curve);
  curve->AddBalance(1.5);
  curve->Update();
  EXPECT_EQ(curve->GetErrorKind(), 2);
  EXPECT_EQ(table->GetNumberOfRows(), 0);
  EXPECT_TRUE(curve->GetText().empty() && curve->GetReport().empty());
}

TEST_F(TransportFilters, FillHolesWithMassesAndGiveTheImageAndTheCellsOfCore) {
  const PolyAnnulusMesh surface(holedDisk(20, {{{0.4, 0.1}, 0.2}, {{-0.3, -0.3}, 0.25}}));
  PolyAnnulusTransportOptions options;
  options.holeAreas = {0.2, 0.1};
  options.outerLoop = 0;
  const auto core = polyAnnulusTransportMap(surface, TargetMeasure(surface.mesh()).vertices(), options);
  vtkNew<vtkPolyAnnulusTransportMap> filter;
  filter->SetInputData(0, polyData(surface.mesh()));
  filter->AddHoleArea(0.2);
  filter->AddHoleArea(0.1);
  filter->SetOuterVertex(surface.loops()[0][1]);
  filter->Update();
  vtkPolyData* map = filter->GetOutput(0);
  const int n = surface.mesh().vertexCount();
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(toPlanarPoints(map), core.image);
  EXPECT_EQ(field(map, "TransportCost"), core.transportCost);
  EXPECT_LT(field(map, "HoleResidual"), 1e-9);
  EXPECT_EQ(map->GetFieldData()->GetArray("HoleAreas")->GetComponent(1, 0), 0.1);
  for (const char* name : {"Site", "CellArea", "Potential"}) EXPECT_TRUE(map->GetPointData()->HasArray(name)) << name;
  vtkPolyData* cells = filter->GetOutput(1);
  ASSERT_EQ(cells->GetNumberOfPolys(), n + 2);
  for (const int i : {0, n - 1, n, n + 1}) {
    EXPECT_EQ(cells->GetCellData()->GetArray("SiteIds")->GetComponent(i, 0), i);
    EXPECT_NEAR(drawnArea(cells, i), core.cellAreas[i], 1e-5);
  }
}

TEST_F(TransportFilters, MakeHolesRoundWithTheShareThatIsAskedFor) {
  const TriangleMesh mesh = holedDisk(20, {{{0.4, 0.1}, 0.2}, {{-0.3, -0.3}, 0.25}});
  vtkNew<vtkPolyAnnulusTransportMap> filter;
  filter->SetInputData(0, polyData(mesh));
  filter->SetHoleShare(0.3);
  filter->SetFinishToAuthalic();
  filter->Update();
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(filter->GetFlippedFaces(), 0);
  EXPECT_LT(filter->GetTotalAreaDistortion(), 2.0002);
  vtkDataArray* holes = filter->GetOutput()->GetFieldData()->GetArray("HoleAreas");
  const double sum = holes->GetComponent(0, 0) + holes->GetComponent(1, 0);
  EXPECT_NEAR(sum / (sum + faceAreas(mesh).sum()), 0.3, 1e-12);
  EXPECT_LT(field(filter->GetOutput(), "HoleResidual"), 1e-12);
}

TEST_F(TransportFilters, RefuseHolesThatDoNotBelong) {
  vtkNew<vtkPolyAnnulusTransportMap> filter;
  const VtkWords words(filter);
  filter->SetInputData(0, polyData(holedDisk(12, {{{0.4, 0.1}, 0.2}})));
  filter->SetHoleShare(1.5);
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkPolyAnnulusTransportMap::ARGUMENT);
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 0);
  filter->SetHoleShare(0);
  filter->SetInputData(0, polyData(sphereMesh(2)));
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkPolyAnnulusTransportMap::SURFACE);
}
