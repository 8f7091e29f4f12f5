/// Welding of two maps as a filter: the numbers of Core, where everything comes from, and failures in words.
#include <gtest/gtest.h>

#include <string>

#include <vtkBarycentricMap.h>
#include <vtkCellData.h>
#include <vtkConformalWelding.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/conformal/RiemannMap.h"
#include "Core/conformal/SphereNormalisation.h"
#include "Core/conformal/WeldedDisks.h"
#include "Core/topology/LevelSetCut.h"
#include "FieldArrays.h"
#include "support/TestMeshes.h"
#include "support/VtkWords.h"

namespace {

using namespace authalic;
using authalic::testing::bumpyDisk;
using authalic::testing::wavySphere;
using authalic::testing::wordsOf;

LevelSetCutResult halves() {
  const SphereMesh sphere(wavySphere(3));
  return levelSetCut(sphere, sphere.mesh().points().col(2));
}

/// A map as every filter leaves it: points are the image, OriginalPoints the surface.
vtkSmartPointer<vtkPolyData> mapOf(const DiskMesh& disk, const Points2& image) {
  auto map = vtkSmartPointer<vtkPolyData>::New();
  setMesh(map, disk.mesh());
  addArray(map->GetPointData(), "OriginalPoints", disk.mesh().points());
  setPoints(map, image);
  return map;
}

TEST(ConformalWeldingFilter, HasTheImageOfCoreAndSaysWhereEverythingComesFrom) {
  const LevelSetCutResult cut = halves();
  const DiskMesh& above = cut.above.disk;
  const DiskMesh& below = cut.below.disk;
  const Points2 first = riemannMap(above).image, second = riemannMap(below).image;
  vtkNew<vtkConformalWelding> filter;
  filter->SetInputData(0, mapOf(above, first));
  filter->SetInputData(1, mapOf(below, second));
  filter->Update();
  const WeldedDisks core = weldDisks(above, first, below, second, matchByPlace(above, below));
  vtkPolyData* sphere = filter->GetOutput();
  EXPECT_EQ(toPoints(sphere), normaliseSphere(core.surface.mesh(), core.image).image);
  EXPECT_EQ(numberField(sphere, "FlippedFaces"), 0);
  EXPECT_NEAR(numberField(sphere, "Coverage"), 1, 1e-9);
  EXPECT_LT(numberField(sphere, "BoundaryMismatch"), 1e-10);
  EXPECT_LE(numberField(sphere, "CentreOfMass"), 1e-10);
  EXPECT_EQ(numberField(sphere, "SeamPoints"), static_cast<double>(cut.seam.size()));
  const TriangleMesh whole = surfaceOfMap(sphere);
  vtkDataArray* ids = sphere->GetPointData()->GetArray("OriginalPointIds");
  vtkDataArray* disks = sphere->GetPointData()->GetArray("Disk");
  for (int i = 0; i < whole.vertexCount(); ++i) {
    const TriangleMesh& origin = (disks->GetComponent(i, 0) == 2 ? below : above).mesh();
    EXPECT_EQ(whole.point(i), origin.point(static_cast<int>(ids->GetComponent(i, 0))));
  }
  EXPECT_EQ(sphere->GetCellData()->GetArray("Disk")->GetComponent(above.mesh().faceCount(), 0), 2);
  EXPECT_EQ(sphere->GetCellData()->GetArray("OriginalCellIds")->GetComponent(above.mesh().faceCount() + 3, 0), 3);
  EXPECT_NE(filter->GetReport().find("\"histograms\""), std::string::npos);
  filter->NormaliseOff();
  filter->Update();
  EXPECT_EQ(toPoints(filter->GetOutput()), core.image);
}

TEST(ConformalWeldingFilter, GluesByNumbers) {
  const LevelSetCutResult cut = halves();
  const auto numbered = [](const CutHalf& half, int first) {
    const auto map = mapOf(half.disk, riemannMap(half.disk).image);
    std::vector<int> numbers(static_cast<std::size_t>(map->GetNumberOfPoints()), 0);
    for (std::size_t i = static_cast<std::size_t>(half.seamStart); i < numbers.size(); ++i) {
      numbers[i] = first + static_cast<int>(i) - half.seamStart;
    }
    addArray(map->GetPointData(), "Seam", numbers);
    return map;
  };
  vtkNew<vtkConformalWelding> filter;
  filter->SetInputData(0, numbered(cut.above, 7));
  filter->SetInputData(1, numbered(cut.below, 7));
  filter->Update();
  const Points3 byPlace = toPoints(filter->GetOutput());
  filter->SetSignatureArrayName("Seam");
  filter->Update();
  EXPECT_EQ(toPoints(filter->GetOutput()), byPlace);
  filter->SetInputData(1, numbered(cut.below, 8));
  EXPECT_NE(wordsOf(filter).find("has none that is still free"), std::string::npos);
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::SURFACE);
  filter->SetSignatureArrayName("Nowhere");
  EXPECT_NE(wordsOf(filter).find("Nowhere"), std::string::npos);
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::ARGUMENT);
}

TEST(ConformalWeldingFilter, RefusesMapsThatDoNotMeetAndSurfacesThatAreNoMaps) {
  const LevelSetCutResult cut = halves();
  vtkNew<vtkPolyData> plain;
  setMesh(plain, bumpyDisk(4));
  vtkNew<vtkBarycentricMap> other;
  other->SetInputData(plain);
  vtkNew<vtkConformalWelding> filter;
  filter->SetInputData(0, mapOf(cut.above.disk, riemannMap(cut.above.disk).image));
  filter->SetInputConnection(1, other->GetOutputPort());
  EXPECT_NE(wordsOf(filter).find("same number of vertices"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetReport(), "");
  filter->SetInputData(1, plain);
  EXPECT_NE(wordsOf(filter).find("OriginalPoints"), std::string::npos);
  other->SetDomainToSquare();
  filter->SetInputData(0, mapOf(cut.above.disk, 3 * riemannMap(cut.above.disk).image));
  filter->SetInputData(1, mapOf(cut.below.disk, riemannMap(cut.below.disk).image));
  EXPECT_NE(wordsOf(filter).find("unit disk"), std::string::npos);
}

}  // namespace
