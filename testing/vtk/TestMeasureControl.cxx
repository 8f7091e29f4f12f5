/// Regions of interest, curvature and local balance through the filters.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <vtkAuthalicMap.h>
#include <vtkCellData.h>
#include <vtkCurvatureDensity.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkLeastSquaresConformalMap.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRegionDensity.h>
#include <vtkSphericalAuthalicMap.h>
#include <vtkStringArray.h>
#include <vtkSurfaceFileReader.h>
#include <vtkToroidalAuthalicMap.h>

#include "Conversion.h"
#include "Core/authalic/RegionsOfInterest.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/geometry/Areas.h"
#include "Core/geometry/SphericalAreas.h"
#include "FieldArrays.h"
#include "support/SharedData.h"
#include "support/TestMeshes.h"
#include "support/TorusMeshes.h"
#include "support/VtkWords.h"

namespace {

using namespace authalic;
using authalic::testing::bumpyDisk;
using authalic::testing::sphereMesh;
using authalic::testing::torusMesh;
using authalic::testing::wordsOf;

vtkSmartPointer<vtkPolyData> polyData(const TriangleMesh& mesh) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  setMesh(result, mesh);
  std::vector<int> labels;
  for (int v = 0; v < mesh.vertexCount(); ++v) labels.push_back(mesh.points()(v, 0) > 0.2 ? 7 : 3);
  addArray(result->GetPointData(), "Label", labels);
  vtkNew<vtkStringArray> names;
  vtkNew<vtkIntArray> ids;
  names->SetName("LabelNames");
  ids->SetName("LabelIds");
  for (const auto& [name, id] : {std::pair("west", 3), {"east", 7}}) {
    names->InsertNextValue(name);
    ids->InsertNextValue(id);
  }
  result->GetFieldData()->AddArray(names);
  result->GetFieldData()->AddArray(ids);
  return result;
}

vtkSmartPointer<vtkRegionDensity> east(vtkPolyData* surface, double factor, double blend = 0) {
  const auto filter = vtkSmartPointer<vtkRegionDensity>::New();
  filter->SetInputData(surface);
  filter->SetRegionArrayName("Label");
  filter->AddRegionName("east");
  filter->SetFactor(factor);
  filter->SetBlend(blend);
  return filter;
}

double field(vtkDataObject* object, const char* name, int tuple = 0) {
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  return array && tuple < array->GetNumberOfTuples() ? array->GetComponent(tuple, 0) : std::nan("");
}

std::vector<char> eastOf(vtkPolyData* surface) {
  std::vector<char> inside;
  for (const int label : toIntegers(surface->GetPointData()->GetArray("Label"))) inside.push_back(label == 7);
  return inside;
}

/// Share of the vertices of a region in the image of a map, by a road of its own.
double imageShare(vtkPolyData* map, const Eigen::VectorXd& areas) {
  const Eigen::VectorXd stars =
      vertexStars(areas, toTriangleMesh(map).faces(), static_cast<int>(map->GetNumberOfPoints()));
  const std::vector<char> inside = eastOf(map);
  double sum = 0;
  for (int v = 0; v < stars.size(); ++v) sum += inside[static_cast<std::size_t>(v)] ? stars[v] : 0;
  return sum / stars.sum();
}

template <class Filter>
vtkSmartPointer<Filter> mapOf(vtkAlgorithm* density) {
  const auto map = vtkSmartPointer<Filter>::New();
  if constexpr (!std::is_same_v<Filter, vtkLeastSquaresConformalMap>) map->SetTolerance(0.1);  // few, regular faces
  map->SetInputConnection(0, density->GetOutputPort());
  map->SetMeasureArrayName("RegionDensity");
  map->Update();
  return map;
}

}  // namespace

TEST(RegionDensity, IsThatOfCore) {
  const TriangleMesh mesh = bumpyDisk(12);
  const auto surface = polyData(mesh);
  const auto filter = east(surface, 4, 0.3);
  filter->Update();
  const RegionsOfInterestDensity core = densityOfRegions(mesh, {}, {{"", eastOf(surface), 4, 0.3}});
  EXPECT_EQ(toVector(filter->GetOutput()->GetCellData()->GetArray("RegionDensity")), core.faces);
  EXPECT_EQ(field(filter->GetOutput(), "RegionTargetShares"), core.targetShares[0]);
  EXPECT_EQ(field(filter->GetOutput(), "RegionSourceShares"), core.sourceShares[0]);
  EXPECT_EQ(surface->GetCellData()->GetNumberOfArrays(), 0);
}

TEST(RegionDensity, IsReachedByTheExactMapOfEveryDomain) {
  for (const double factor : {0.25, 4.0, 16.0}) {
    const auto disk = mapOf<vtkAuthalicMap>(east(polyData(bumpyDisk(14)), factor));
    vtkPolyData* map = disk->GetOutput();
    const double s = field(map, "RegionSourceShares"), wanted = factor * s / (factor * s + 1 - s);
    EXPECT_EQ(disk->GetStatus(), "converged") << factor;
    EXPECT_EQ(disk->GetFlippedFaces(), 0) << factor;
    EXPECT_NEAR(field(map, "RegionImageShares"), wanted, 1e-9) << factor;
    EXPECT_NEAR(imageShare(map, signedFaceAreas(toPlanarPoints(map), toTriangleMesh(map).faces())), wanted, 1e-9);
  }
  const auto sphere = mapOf<vtkSphericalAuthalicMap>(east(polyData(sphereMesh(4)), 4, 0.2));
  vtkPolyData* ball = sphere->GetOutput();
  const double s = field(ball, "RegionSourceShares"), wanted = 4 * s / (4 * s + 1 - s);
  EXPECT_NEAR(imageShare(ball, signedSolidAngles(toPoints(ball), toTriangleMesh(ball).faces())), wanted, 1e-9);
  const auto torus = mapOf<vtkToroidalAuthalicMap>(east(polyData(torusMesh(30, 18)), 4));
  EXPECT_NEAR(field(torus->GetOutput(), "RegionImageShares"), field(torus->GetOutput(), "RegionTargetShares"), 1e-9);
}

TEST(RegionDensity, IsReportedByMapsThatDoNotControlAreasToo) {
  const auto map = mapOf<vtkLeastSquaresConformalMap>(east(polyData(bumpyDisk(12)), 4));
  EXPECT_GT(field(map->GetOutput(), "RegionTargetShares"), 1.3 * field(map->GetOutput(), "RegionImageShares"));
  for (const char* word : {"\"regions\"", "\"name\": \"Label:east\"", "\"factor\": 4", "\"source_share\"",
                           "\"target_share\"", "\"image_share\""}) {
    EXPECT_NE(map->GetReport().find(word), std::string::npos) << word;
  }
}

TEST(RegionDensity, JoinsOneUpstreamInEitherOrder) {
  const auto surface = polyData(bumpyDisk(14));
  const auto ball = [](double factor) {
    const auto filter = vtkSmartPointer<vtkRegionDensity>::New();
    filter->SetRegionModeToBall();
    filter->SetCentre(-0.5, 0, 0);
    filter->SetRadius(0.45);
    filter->SetFactor(factor);
    return filter;
  };
  const auto first = east(surface, 4), second = ball(2);
  second->SetInputConnection(first->GetOutputPort());
  second->SetMeasureArrayName("RegionDensity");  // as one would choose it in a panel
  second->Update();
  const auto other = ball(2);
  other->SetInputData(surface);
  const auto last = east(nullptr, 4);
  last->SetInputConnection(other->GetOutputPort());
  last->Update();
  const auto density = [](vtkRegionDensity* f) {
    return toVector(f->GetOutput()->GetCellData()->GetArray("RegionDensity"));
  };
  EXPECT_LT((density(second) - density(last)).cwiseAbs().maxCoeff(), 1e-9);
  vtkPolyData* output = second->GetOutput();
  const double a = field(output, "RegionSourceShares", 0), b = field(output, "RegionSourceShares", 1);
  EXPECT_NEAR(field(output, "RegionTargetShares", 0), 4 * a / (4 * a + 2 * b + 1 - a - b), 1e-12);
  EXPECT_NEAR(field(output, "RegionTargetShares", 1), 2 * b / (4 * a + 2 * b + 1 - a - b), 1e-12);
}

TEST(RegionDensity, MultipliesAMeasureOnPointsOrCells) {
  const auto surface = polyData(bumpyDisk(10));
  const TriangleMesh mesh = toTriangleMesh(surface);
  const Eigen::VectorXd onPoints = Eigen::VectorXd::LinSpaced(mesh.vertexCount(), 1, 2);
  addArray(surface->GetPointData(), "Points", onPoints);
  addArray(surface->GetCellData(), "Cells", meanOfCorners(mesh, onPoints));
  Eigen::VectorXd found[2];
  for (const int k : {0, 1}) {
    const auto filter = east(surface, 4);
    filter->SetMeasureArrayName(k == 0 ? "Points" : "Cells");
    filter->Update();
    found[k] = toVector(filter->GetOutput()->GetCellData()->GetArray("RegionDensity"));
  }
  EXPECT_LT((found[0] - found[1]).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GT(found[0].maxCoeff(), 6);
}

TEST(RegionDensity, RefusesInWords) {
  const auto surface = polyData(bumpyDisk(8));
  const auto refused = [&](const std::function<void(vtkRegionDensity*)>& spoil, const char* words) {
    const auto filter = east(surface, 4);
    spoil(filter);
    EXPECT_NE(wordsOf(filter).find(words), std::string::npos) << words;
    EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::ARGUMENT) << words;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << words;
  };
  refused([](auto* f) { f->AddRegionName("north"); }, "'north' is none; there are: west, east.");
  refused([](auto* f) { f->SetFactor(0); }, "positive, finite factor");
  refused([](auto* f) { f->SetFactor(std::nan("")); }, "positive, finite factor");
  refused([](auto* f) { f->SetBlend(-1); }, "blend of 0 mm or more");
  refused([](auto* f) { f->AddRegionName("west"); }, "it is everything");
  refused([](auto* f) { f->ClearRegionNames(); f->AddRegionValue(9); }, "it is empty");
  refused([](auto* f) { f->SetRegionArrayName("Nothing"); f->ClearRegionNames(); }, "Nothing");
  refused([](auto* f) { f->SetRegionArrayName(""); }, "set RegionArrayName");
  refused([](auto* f) { f->SetRegionModeToBall(); f->SetCentre(0, 0, 50); }, "must reach the surface");
  refused([](auto* f) { f->SetRegionModeToGeodesicBall(); f->SetRadius(-1); }, "radius above 0");
}

TEST(RegionDensity, HoldsOnScansWithFactorsFromAQuarterToSixteen) {
  const std::string path = authalic::testing::sharedData("meshes/open_disk/chinese_lion.off");
  AUTHALIC_NEEDS(path);
  vtkNew<vtkSurfaceFileReader> reader;
  reader->SetFileName(path.c_str());
  for (const double factor : {0.25, 16.0}) {
    vtkNew<vtkRegionDensity> density;
    density->SetInputConnection(reader->GetOutputPort());
    density->SetRegionModeToBall();
    density->SetCentre(-2.66, 32.96, -927.4);
    density->SetRadius(12);
    density->SetFactor(factor);
    density->SetBlend(6);
    const auto map = mapOf<vtkAuthalicMap>(density);
    const double s = field(map->GetOutput(), "RegionSourceShares");
    EXPECT_EQ(map->GetFlippedFaces(), 0);
    EXPECT_NEAR(field(map->GetOutput(), "RegionImageShares"), factor * s / (factor * s + 1 - s), 1e-9);
  }
}

TEST(CurvatureDensity, LeadsAMapToItsMeasure) {
  vtkNew<vtkCurvatureDensity> density;
  density->SetInputData(polyData(bumpyDisk(12)));
  vtkNew<vtkAuthalicMap> map;
  map->SetInputConnection(0, density->GetOutputPort());
  map->SetMeasureArrayName("CurvatureDensity");
  map->Update();
  EXPECT_EQ(map->GetStatus(), "converged");
  EXPECT_LT(field(map->GetOutput(), "VertexMaxAbsLog"), 1e-9);
  density->SetWeight(1);
  EXPECT_NE(wordsOf(density).find("from 0 to below 1"), std::string::npos);
  density->SetWeight(0.5);
  density->SetCurvatureArrayName("Missing");
  EXPECT_NE(wordsOf(density).find("Missing"), std::string::npos);
}

TEST(LocalBalance, KeepsAnglesWhereItIsZeroAndAreasWhereItIsOne) {
  const TriangleMesh mesh = bumpyDisk(16);
  const auto surface = polyData(mesh);
  addArray(surface->GetPointData(), "T", Eigen::VectorXd((mesh.points().col(0).array() > 0).cast<double>()));
  vtkNew<vtkAuthalicMap> map;
  map->SetInputData(0, surface);
  map->SetBalanceArrayName("T");
  map->Update();
  EXPECT_EQ(map->GetStatus(), "converged");
  EXPECT_EQ(map->GetFlippedFaces(), 0);
  const Eigen::VectorXd angle = toVector(map->GetOutput()->GetCellData()->GetArray("AngleDistortion"));
  const Eigen::VectorXd area = toVector(map->GetOutput()->GetCellData()->GetArray("AreaDistortion"));
  double angleLeft = 0, angleRight = 0, areaLeft = 0, areaRight = 0;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const bool right = mesh.points()(mesh.faces()(f, 0), 0) > 0.15;
    (right ? angleRight : angleLeft) += angle[f] - 2;
    (right ? areaRight : areaLeft) += std::abs(area[f] - area[0]);
  }
  EXPECT_LT(2 * angleLeft, angleRight);
  EXPECT_LT(2 * areaRight, areaLeft);
}

TEST(LocalBalance, OfOneNumberEverywhereIsTheBalance) {
  const TriangleMesh disk = bumpyDisk(10), sphere = sphereMesh(3);
  const auto check = [](auto one, auto other, const TriangleMesh& mesh) {
    const auto surface = polyData(mesh);
    addArray(surface->GetPointData(), "T", Eigen::VectorXd::Constant(mesh.vertexCount(), 0.25).eval());
    one->SetInputData(0, surface);
    one->SetBalance(0.25);
    other->SetInputData(0, surface);
    other->SetBalanceArrayName("T");
    one->Update();
    other->Update();
    EXPECT_EQ(toPoints(one->GetOutput()), toPoints(other->GetOutput()));
  };
  check(vtkSmartPointer<vtkAuthalicMap>::New(), vtkSmartPointer<vtkAuthalicMap>::New(), disk);
  check(vtkSmartPointer<vtkSphericalAuthalicMap>::New(), vtkSmartPointer<vtkSphericalAuthalicMap>::New(), sphere);
}

TEST(SphericalBalance, TradesAnglesForAreas) {
  const TriangleMesh sphere = sphereMesh(4);
  const TriangleMesh stretched(sphere.points() * Eigen::Vector3d(1, 1.5, 2.2).asDiagonal(), sphere.faces());
  double area = 1e300, angle = 0;
  for (const double balance : {0.0, 0.5, 1.0}) {
    vtkNew<vtkSphericalAuthalicMap> map;
    map->SetInputData(0, polyData(stretched));
    map->SetBalance(balance);
    map->Update();
    EXPECT_EQ(map->GetStatus(), "converged") << balance;
    EXPECT_EQ(map->GetFlippedFaces(), 0) << balance;
    EXPECT_LT(map->GetTotalAreaDistortion(), area) << balance;
    EXPECT_GT(map->GetTotalAngleDistortion(), angle) << balance;
    area = map->GetTotalAreaDistortion();
    angle = map->GetTotalAngleDistortion();
  }
}
