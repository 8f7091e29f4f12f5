/// The repair of broken surfaces through its filter.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <vtkAuthalicMap.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSurfaceRepair.h>

#include "Conversion.h"
#include "Core/topology/SurfaceRepair.h"
#include "FieldArrays.h"
#include "Reports/RepairReport.h"
#include "support/TestMeshes.h"
#include "support/TorusMeshes.h"
#include "support/VtkWords.h"

namespace {

using namespace authalic;
using authalic::testing::bumpyDisk;
using authalic::testing::sphereMesh;
using authalic::testing::torusMesh;
using authalic::testing::wordsOf;

/// With the number of every point and cell as data.
vtkSmartPointer<vtkPolyData> numbered(const Points3& points, const Faces& faces) {
  const auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (Eigen::Index v = 0; v < points.rows(); ++v) places->InsertNextPoint(points(v, 0), points(v, 1), points(v, 2));
  vtkNew<vtkCellArray> cells;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const vtkIdType ids[3] = {faces(f, 0), faces(f, 1), faces(f, 2)};
    cells->InsertNextCell(3, ids);
  }
  result->SetPoints(places);
  result->SetPolys(cells);
  std::vector<int> pointNumbers, cellNumbers;
  for (int v = 0; v < points.rows(); ++v) pointNumbers.push_back(v);
  for (int f = 0; f < faces.rows(); ++f) cellNumbers.push_back(f);
  addArray(result->GetPointData(), "Number", pointNumbers);
  addArray(result->GetCellData(), "Number", cellNumbers);
  addField(result, "Subject", std::string("one"));
  return result;
}

/// A torus with a vertex that no face uses, a face twice, and one turned.
vtkSmartPointer<vtkPolyData> brokenTorus() {
  const TriangleMesh torus = torusMesh(24, 8);
  Points3 points(torus.vertexCount() + 1, 3);
  points << torus.points(), 9, 9, 9;
  Faces faces(torus.faceCount() + 1, 3);
  faces << torus.faces(), torus.faces().row(40);
  std::swap(faces(10, 0), faces(10, 1));
  return numbered(points, faces);
}

double field(vtkPolyData* surface, const char* name, int component = 0) {
  vtkDataArray* array = surface->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, component) : std::nan("");
}

}  // namespace

TEST(SurfaceRepairFilter, IsThatOfCore) {
  const auto input = brokenTorus();
  vtkNew<vtkSurfaceRepair> filter;
  filter->SetInputData(input);
  filter->Update();
  const SurfaceRepair core = repairSurface(toPoints(input), toTriangles(input));
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(toPoints(output), core.mesh.points());
  EXPECT_EQ(toTriangles(output), core.mesh.faces());
  EXPECT_EQ(toIntegers(output->GetPointData()->GetArray("OriginalPointIds")), core.originalPointIds);
  EXPECT_EQ(toIntegers(output->GetCellData()->GetArray("OriginalCellIds")), core.originalFaceIds);
  EXPECT_EQ(filter->GetReport(), repairReport(core, {}).text());
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::NONE);
}

TEST(SurfaceRepairFilter, ListsHandlesWithPlaceAndLength) {
  vtkNew<vtkSurfaceRepair> filter;
  filter->SetInputData(brokenTorus());
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const SurfaceRepair core = repairSurface(toPoints(brokenTorus()), toTriangles(brokenTorus()));
  const auto handle = std::find_if(core.changes.begin(), core.changes.end(),
                                   [](const auto& change) { return change.kind == RepairKind::Handle; });
  ASSERT_NE(handle, core.changes.end());
  EXPECT_EQ(field(output, "RepairChanges"), 4);
  EXPECT_EQ(field(output, "HandleLengths"), handle->size);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(field(output, "HandlePlaces", k), handle->place[k]);
  for (const char* words : {"1 isolated vertex removed", "1 duplicate face removed", "1 face turned round",
                            "1 handle cut and capped"}) {
    EXPECT_NE(filter->GetSummary().find(words), std::string::npos) << filter->GetSummary();
  }
}

TEST(SurfaceRepairFilter, CarriesArraysToWhatItMakes) {
  vtkNew<vtkSurfaceRepair> filter;
  filter->SetInputData(brokenTorus());
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const auto check = [](vtkDataSetAttributes* data, const char* ids, int mostNew) {
    const std::vector<int> numbers = toIntegers(data->GetArray("Number")), originals = toIntegers(data->GetArray(ids));
    ASSERT_EQ(numbers.size(), originals.size());
    int made = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      EXPECT_GE(numbers[i], 0);
      if (originals[i] < 0) {
        ++made;
      } else {
        EXPECT_EQ(numbers[i], originals[i]);
      }
    }
    EXPECT_EQ(made, mostNew);
  };
  check(output->GetPointData(), "OriginalPointIds", 0);
  check(output->GetCellData(), "OriginalCellIds", 2 * 6);  // two caps on loops of 8 edges
  EXPECT_NE(output->GetFieldData()->GetAbstractArray("Subject"), nullptr);
}

TEST(SurfaceRepairFilter, LeavesACleanSurfaceAsItIs) {
  const TriangleMesh disk = bumpyDisk(8);
  const auto input = numbered(disk.points(), disk.faces());
  vtkNew<vtkSurfaceRepair> filter;
  filter->SetInputData(input);
  EXPECT_EQ(wordsOf(filter), "");
  EXPECT_EQ(toPoints(filter->GetOutput()), disk.points());
  EXPECT_EQ(toTriangles(filter->GetOutput()), disk.faces());
  EXPECT_EQ(filter->GetSummary(), "");
  EXPECT_EQ(field(filter->GetOutput(), "RepairChanges"), 0);
}

TEST(SurfaceRepairFilter, StandsBeforeAMap) {
  const TriangleMesh disk = bumpyDisk(8);
  Faces faces(disk.faceCount() + 1, 3);
  faces << disk.faces(), disk.faces().row(3);
  vtkNew<vtkSurfaceRepair> repair;
  repair->SetInputData(numbered(disk.points(), faces));
  vtkNew<vtkAuthalicMap> broken, clean, map;
  broken->SetInputData(numbered(disk.points(), faces));
  EXPECT_NE(wordsOf(broken).find("authalic repair"), std::string::npos);
  for (const auto& filter : {broken.Get(), clean.Get(), map.Get()}) filter->SetTolerance(0.1);  // few, regular faces
  map->SetInputConnection(repair->GetOutputPort());
  map->Update();
  clean->SetInputData(numbered(disk.points(), disk.faces()));
  clean->Update();
  EXPECT_EQ(toPoints(map->GetOutput()), toPoints(clean->GetOutput()));
}

TEST(SurfaceRepairFilter, WarnsOfWhatIsLeft) {
  const TriangleMesh sphere = sphereMesh(2);
  Points3 points(2 * sphere.vertexCount(), 3);
  points << sphere.points(), sphere.points().rowwise() + Eigen::RowVector3d(5, 0, 0);
  Faces faces(2 * sphere.faceCount(), 3);
  faces << sphere.faces(), sphere.faces().array() + sphere.vertexCount();
  vtkNew<vtkSurfaceRepair> filter;
  filter->SetInputData(numbered(points, faces));
  const std::string words = wordsOf(filter);
  EXPECT_NE(words.find("2 components"), std::string::npos) << words;
  EXPECT_NE(words.find("StrayShare"), std::string::npos) << words;
  filter->SetInputData(brokenTorus());
  filter->SetLargestHandle(0);
  EXPECT_NE(wordsOf(filter).find("genus 1"), std::string::npos);
}

TEST(SurfaceRepairFilter, RefusesWhatCannotBeRepairedAndRecovers) {
  const TriangleMesh sphere = sphereMesh(1);
  Points3 apart(3 * sphere.faceCount(), 3);
  Faces faces(sphere.faceCount(), 3);
  for (int f = 0; f < sphere.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) apart.row(3 * f + k) = (1 + 0.1 * f) * sphere.corner(f, k).transpose();
    faces.row(f) << 3 * f, 3 * f + 1, 3 * f + 2;
  }
  vtkNew<vtkSurfaceRepair> filter;
  filter->SetInputData(numbered(apart, faces));
  EXPECT_NE(wordsOf(filter).find("share no edge"), std::string::npos);
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::SURFACE);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetReport(), "");
  EXPECT_EQ(filter->GetSummary(), "");
  filter->SetInputData(brokenTorus());
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::NONE);
  EXPECT_EQ(field(filter->GetOutput(), "RepairChanges"), 4);
}

TEST(SurfaceRepairFilter, TakesItsDefaultsFromCore) {
  vtkNew<vtkSurfaceRepair> filter;
  const SurfaceRepairOptions defaults;
  EXPECT_EQ(filter->GetSewSeams(), defaults.sewSeams);
  EXPECT_EQ(filter->GetJunctionTolerance(), defaults.junctionTolerance);
  EXPECT_EQ(filter->GetStrayShare(), defaults.strayShare);
  EXPECT_EQ(filter->GetLargestHole(), defaults.largestHole);
  EXPECT_EQ(filter->GetLargestHandle(), defaults.largestHandle);
}
