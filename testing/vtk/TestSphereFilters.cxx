/// The conformal map of a sphere as a filter: the numbers of Core, its defaults, and failures in words.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMapDistortion.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphericalConformalMap.h>

#include "Conversion.h"
#include "Core/conformal/SphericalConformalMap.h"
#include "Core/distortion/SphericalDistortion.h"
#include "FieldArrays.h"
#include "Reports/MapReport.h"
#include "support/TestMeshes.h"
#include "support/VtkWords.h"

namespace {

using namespace authalic;
using authalic::testing::bumpyDisk;
using authalic::testing::wavySphere;
using authalic::testing::wordsOf;

vtkSmartPointer<vtkPolyData> polyData(const TriangleMesh& mesh) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  setMesh(result, mesh);
  return result;
}

std::string withoutSpace(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c); }), text.end());
  return text;
}

TEST(SphericalConformalMapFilter, HasTheImageOfCoreByEveryRoad) {
  const SphereMesh sphere(wavySphere(3));
  vtkNew<vtkSphericalConformalMap> filter;
  filter->SetInputData(polyData(sphere.mesh()));
  for (int road = 0; road < 4; ++road) {
    filter->SetInitialMethod(road);
    filter->Update();
    SphericalConformalMapOptions options;
    options.road = static_cast<SphereRoad>(road);
    const SphericalMapResult core = sphericalConformalMap(sphere, options);
    EXPECT_EQ(toPoints(filter->GetOutput()), core.image) << road;
    EXPECT_EQ(textField(filter->GetOutput(), "InitialMethod"), sphereRoadName(options.road));
    EXPECT_EQ(filter->GetTotalAngleDistortion(),
              measureSphericalDistortion(sphere.mesh(), core.image).summary.angleDistortion);
    EXPECT_LE(numberField(filter->GetOutput(), "CentreOfMass"), 1e-10);
    EXPECT_NEAR(numberField(filter->GetOutput(), "Coverage"), 1, 1e-12);
  }
}

TEST(SphericalConformalMapFilter, PutsTwoLandmarksWhereTheyBelong) {
  vtkNew<vtkSphericalConformalMap> filter;
  filter->SetInputData(polyData(wavySphere(3)));
  filter->SetRotationToLandmarks();
  filter->SetNorthVertex(5);
  filter->SetMeridianVertex(40);
  filter->Update();
  const Points3 image = toPoints(filter->GetOutput());
  EXPECT_NEAR((image.row(5) - Eigen::RowVector3d(0, 0, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR(image(40, 1), 0, 1e-12);
  EXPECT_GT(image(40, 0), 0);
}

TEST(SphericalConformalMapFilter, TakesItsDefaultsFromCore) {
  const SphericalConformalMapOptions defaults;
  vtkNew<vtkSphericalConformalMap> filter;
  EXPECT_EQ(filter->GetInitialMethod(), static_cast<int>(defaults.road));
  EXPECT_EQ(filter->GetTimeStep(), defaults.flow.timeStep);
  EXPECT_EQ(filter->GetCorrectedShare(), defaults.stereographic.correctedShare);
  EXPECT_EQ(filter->GetRotation(), static_cast<int>(defaults.normalisation.rotation));
  filter->SetInputData(polyData(wavySphere(2)));
  filter->Update();
  std::ostringstream tolerance;
  tolerance << "\"max_iterations\": " << defaults.harmonic.maxIterations;
  EXPECT_NE(filter->GetReport().find(tolerance.str()), std::string::npos);
}

TEST(SphericalConformalMapFilter, RefusesADiskSayingWhatWasFoundAndWhere) {
  vtkNew<vtkSphericalConformalMap> filter;
  filter->SetInputData(polyData(bumpyDisk(4)));
  const std::string words = wordsOf(filter);
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::SURFACE);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  for (const char* said : {"topological sphere is required", "boundary loop", "mm", "close it"}) {
    EXPECT_NE(words.find(said), std::string::npos) << words;
  }
}

TEST(SphericalConformalMapFilter, RefusesLandmarksThatAreMissingSuperfluousOrNotThere) {
  vtkNew<vtkSphericalConformalMap> filter;
  filter->SetInputData(polyData(wavySphere(2)));
  filter->SetRotationToLandmarks();
  EXPECT_NE(wordsOf(filter).find("landmark"), std::string::npos);
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::ARGUMENT);
  filter->SetNorthVertex(1);
  filter->SetMeridianVertex(1000000);
  EXPECT_NE(wordsOf(filter).find("1000000"), std::string::npos);
  filter->SetRotationToNone();
  EXPECT_NE(wordsOf(filter).find("landmark"), std::string::npos);
}

TEST(SphericalConformalMapFilter, WarnsAndGivesTheBestIterateWhenItMayNotGoOn) {
  vtkNew<vtkSphericalConformalMap> filter;
  filter->SetInputData(polyData(wavySphere(3)));
  filter->SetMaximumIterations(1);
  for (const int road : {vtkSphericalConformalMap::HARMONIC, vtkSphericalConformalMap::MEAN_CURVATURE_FLOW,
                         vtkSphericalConformalMap::WELDING}) {
    filter->SetInitialMethod(road);
    EXPECT_NE(wordsOf(filter).find("Not converged"), std::string::npos) << road;
    EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::NOT_CONVERGED);
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(StatisticsOfAMap, AreThoseOfCoreInArraysFieldsAndReport) {
  const SphereMesh sphere(wavySphere(3));
  vtkNew<vtkSphericalConformalMap> filter;
  filter->SetInputData(polyData(sphere.mesh()));
  filter->Update();
  vtkPolyData* map = filter->GetOutput();
  const SphericalDistortion core = measureSphericalDistortion(sphere.mesh(), toPoints(map));
  vtkDataArray* beltrami = map->GetCellData()->GetArray("BeltramiCoefficient");
  ASSERT_EQ(beltrami->GetNumberOfComponents(), 2);
  for (const int f : {0, 77, sphere.mesh().faceCount() - 1}) {
    EXPECT_EQ(beltrami->GetComponent(f, 0), core.arrays.beltrami[f].real());
    EXPECT_EQ(beltrami->GetComponent(f, 1), core.arrays.beltrami[f].imag());
  }
  EXPECT_EQ(numberField(map, "AngleErrorStandardDeviation"), core.summary.angleError.standardDeviation);
  EXPECT_EQ(matrixField(map, "QuasiConformalPercentiles")(4, 0), core.summary.quasiConformal.percentiles[4]);
  const DistortionHistograms histograms = distortionHistograms(core.arrays);
  const Eigen::MatrixXd rows = matrixField(map, "AngleErrorHistogram");
  ASSERT_EQ(rows.rows(), 180 + 3);
  EXPECT_EQ(rows.col(2).sum(), 3 * sphere.mesh().faceCount());
  EXPECT_EQ(rows(90, 2), static_cast<double>(histograms.angleError.counts[90]));
  const std::string report = filter->GetReport(), expected = histogramReport(histograms).text(false);
  EXPECT_NE(withoutSpace(report).find(withoutSpace(expected)), std::string::npos);
  EXPECT_NE(report.find("\"angle_error_p95_degrees\""), std::string::npos);
}

TEST(MapDistortionFilter, MeasuresASphereOfAnyRadiusAsTheMapItself) {
  vtkNew<vtkSphericalConformalMap> map;
  map->SetInputData(polyData(wavySphere(3)));
  map->Update();
  vtkNew<vtkPolyData> large;
  large->DeepCopy(map->GetOutput());
  setPoints(large, Points3(100 * toPoints(large)));
  vtkNew<vtkMapDistortion> filter;
  filter->SetInputData(large);
  filter->Update();
  EXPECT_EQ(toPoints(filter->GetOutput()), toPoints(large));
  for (const char* name : {"TotalAngleDistortion", "TotalAreaDistortion", "MeanAngleError", "Coverage"}) {
    EXPECT_NEAR(numberField(filter->GetOutput(), name), numberField(map->GetOutput(), name), 1e-10) << name;
  }
}

TEST(MapDistortionFilter, RefusesAnImageThatIsNeitherInThePlaneNorOnASphere) {
  vtkNew<vtkMapDistortion> filter;
  const auto shape = polyData(wavySphere(2));
  filter->SetInputData(0, shape);
  filter->SetInputData(1, shape);
  const std::string words = wordsOf(filter);
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::SURFACE);
  EXPECT_NE(words.find("plane z = 0, or on a sphere"), std::string::npos) << words;
}

TEST(SphericalConformalMapFilter, HasTheSameBitsAtAnyThreadCount) {
  vtkNew<vtkSphericalConformalMap> filter;
  filter->SetInputData(polyData(wavySphere(3)));
  filter->SetInitialMethodToWelding();
  filter->SetThreads(1);
  filter->Update();
  const Points3 one = toPoints(filter->GetOutput());
  filter->SetThreads(2);
  filter->Update();
  EXPECT_EQ(toPoints(filter->GetOutput()), one);
}

}  // namespace
