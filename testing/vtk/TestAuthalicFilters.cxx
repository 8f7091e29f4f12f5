/// The authalic filters against Core on the same input, with their arrays and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <vtkAuthalicMap.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFlatConeAuthalicMap.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphericalAuthalicMap.h>
#include <vtkSphericalLieAdvection.h>
#include <vtkSphericalLieFlow.h>
#include <vtkToroidalAuthalicMap.h>

#include "Conversion.h"
#include "Core/authalic/AuthalicMap.h"
#include "Core/authalic/FlatConeAuthalicMap.h"
#include "Core/authalic/SphericalAuthalicMap.h"
#include "Core/authalic/SphericalLieFlow.h"
#include "Core/authalic/ToroidalAuthalicMap.h"
#include "Core/conformal/RiemannMap.h"
#include "support/HighGenusMeshes.h"
#include "support/TestMeshes.h"
#include "support/TorusMeshes.h"

namespace {

using namespace authalic;
using authalic::testing::bumpyDisk;
using authalic::testing::slabMesh;
using authalic::testing::sphereMesh;
using authalic::testing::torusMesh;

vtkSmartPointer<vtkPolyData> polyData(const TriangleMesh& mesh) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  setMesh(result, mesh);
  return result;
}

TriangleMesh ellipsoid() {
  const TriangleMesh sphere = sphereMesh(4);
  return TriangleMesh(sphere.points() * Eigen::Vector3d(1, 1.5, 2.2).asDiagonal(), sphere.faces());
}

double field(vtkDataObject* object, const char* name, int component = 0) {
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(component, 0) : std::nan("");
}

template <class Filter>
vtkSmartPointer<Filter> mapped(const TriangleMesh& mesh) {
  const auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(0, polyData(mesh));
  filter->Update();
  return filter;
}

}  // namespace

TEST(AuthalicFilters, GiveTheImageOfCore) {
  const TriangleMesh disk = bumpyDisk(12), sphere = ellipsoid();
  EXPECT_EQ(toPlanarPoints(mapped<vtkAuthalicMap>(disk)->GetOutput()),
            authalicMap(DiskMesh(disk), TargetMeasure(disk)).image);
  EXPECT_EQ(toPoints(mapped<vtkSphericalAuthalicMap>(sphere)->GetOutput()),
            sphericalAuthalicMap(SphereMesh(sphere), TargetMeasure(sphere)).image);
}

TEST(SphericalLieFilters, GiveTheImageOfCoreAndItsNumbers) {
  const TriangleMesh sphere = ellipsoid();
  const auto flow = mapped<vtkSphericalLieFlow>(sphere);
  const auto core = sphericalLieFlow(SphereMesh(sphere), TargetMeasure(sphere));
  EXPECT_EQ(toPoints(flow->GetOutput()), core.image);
  EXPECT_EQ(flow->GetStatus(), "converged");
  EXPECT_EQ(flow->GetFlippedFaces(), 0);
  EXPECT_EQ(field(flow->GetOutput(), "EdgeFlips"), core.edgeFlips);
  EXPECT_EQ(field(flow->GetOutput(), "FinishIterations"), core.finishIterations);
  const auto advection = mapped<vtkSphericalLieAdvection>(sphere);
  EXPECT_EQ(toPoints(advection->GetOutput()), sphericalLieAdvection(SphereMesh(sphere), TargetMeasure(sphere)).image);
  EXPECT_EQ(advection->GetIterations(), advection->GetNumberOfSteps());
}

TEST(SphericalLieFilters, TakeTheirOptionsAndAnInitialMap) {
  const TriangleMesh sphere = ellipsoid();
  const auto flow = vtkSmartPointer<vtkSphericalLieFlow>::New();
  flow->SetInputData(0, polyData(sphere));
  flow->SetInputData(1, polyData(sphereMesh(4)));
  flow->SetFinishToNone();
  flow->SetMaximumIterations(2);
  flow->SetStepRatio(0.3);
  flow->Update();
  DiscreteLieFlowOptions options;
  options.finish = LieFlowFinish::None;
  options.maxIterations = 2;
  options.stepRatio = 0.3;
  const auto core = sphericalLieFlow(SphereMesh(sphere), TargetMeasure(sphere), options, sphereMesh(4).points());
  EXPECT_EQ(toPoints(flow->GetOutput()), core.image);
  EXPECT_NE(flow->GetReport().find("\"initial\": \"given\""), std::string::npos) << flow->GetReport();
}

TEST(AuthalicFilters, AreExactByTheirOwnReport) {
  const auto filter = mapped<vtkAuthalicMap>(bumpyDisk(12));
  vtkPolyData* map = filter->GetOutput();
  EXPECT_LT(field(map, "VertexMaxAbsLog"), 1e-9);
  EXPECT_LT(field(map, "FaceResidual"), filter->GetTolerance());
  EXPECT_EQ(field(map, "FlippedFaces"), 0);
}

TEST(AuthalicFilters, BalanceAnglesAgainstAreas) {
  double area = 1e300, angle = 0;
  for (const double balance : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const auto filter = vtkSmartPointer<vtkAuthalicMap>::New();
    filter->SetInputData(0, polyData(bumpyDisk(12)));
    filter->SetBalance(balance);
    filter->SetTolerance(0.03);
    filter->Update();
    EXPECT_EQ(filter->GetStatus(), "converged") << balance;
    EXPECT_EQ(filter->GetFlippedFaces(), 0) << balance;
    EXPECT_LT(filter->GetTotalAreaDistortion(), area) << balance;
    EXPECT_GT(filter->GetTotalAngleDistortion(), angle) << balance;
    area = filter->GetTotalAreaDistortion();
    angle = filter->GetTotalAngleDistortion();
    if (balance > 0) continue;
    const Points2 conformal = riemannMap(DiskMesh(bumpyDisk(12))).image;
    EXPECT_LT((toPlanarPoints(filter->GetOutput()) - conformal).cwiseAbs().maxCoeff(), 1e-12);
  }
  EXPECT_LT(area, 2.001);
}

TEST(ToroidalAuthalicFilter, OpensTheTorusAndSaysWhereEveryPointComesFrom) {
  const TriangleMesh torus = torusMesh(30, 14);
  const auto input = polyData(torus);
  vtkNew<vtkDoubleArray> thickness;
  thickness->SetName("Thickness");
  for (int v = 0; v < torus.vertexCount(); ++v) thickness->InsertNextValue(v);
  input->GetPointData()->AddArray(thickness);
  vtkNew<vtkToroidalAuthalicMap> filter;
  filter->SetInputData(input);
  filter->SetTolerance(0.05);
  filter->Update();
  vtkPolyData* map = filter->GetOutput();
  AuthalicMapOptions options;
  options.tolerance = 0.05;
  const ToroidalAuthalicMapResult core = toroidalAuthalicMap(TorusMesh(torus), TargetMeasure(torus), options);
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(toPlanarPoints(map), core.image);
  EXPECT_EQ(map->GetNumberOfPolys(), torus.faceCount());
  auto* ids = vtkIdTypeArray::SafeDownCast(map->GetPointData()->GetArray("OriginalPointIds"));
  ASSERT_NE(ids, nullptr);
  ASSERT_GT(ids->GetNumberOfTuples(), torus.vertexCount());
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i) {
    EXPECT_EQ(map->GetPointData()->GetArray("Thickness")->GetComponent(i, 0), static_cast<double>(ids->GetValue(i)));
  }
  EXPECT_LT(field(map, "VertexMaxAbsLog"), 1e-9);
  EXPECT_LT(field(map, "SeamError"), 1e-12);
  EXPECT_EQ(map->GetFieldData()->GetArray("Periods")->GetNumberOfTuples(), 4);
  const int copy = torus.vertexCount();
  EXPECT_EQ(surfaceOfMap(map).point(copy), torus.point(static_cast<int>(ids->GetValue(copy))));
}

TEST(ToroidalAuthalicFilter, BecomesTextureCoordinatesOfTheOpenedSurface) {
  vtkNew<vtkToroidalAuthalicMap> filter;
  filter->SetInputData(polyData(torusMesh(30, 14)));
  filter->SetTolerance(0.05);
  filter->SetOutputModeToTextureCoordinates();
  filter->Update();
  ASSERT_NE(filter->GetOutput()->GetPointData()->GetTCoords(), nullptr);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 30 * 14);
}

TEST(ToroidalAuthalicFilter, RefusesASphere) {
  const auto filter = mapped<vtkToroidalAuthalicMap>(sphereMesh(2));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(FlatConeFilter, OpensTheSurfaceAndSaysHowItsSeamsFit) {
  const TriangleMesh surface = slabMesh(2, 4);
  vtkNew<vtkFlatConeAuthalicMap> filter;
  filter->SetInputData(polyData(surface));
  filter->SetTolerance(0.05);
  filter->Update();
  vtkPolyData* map = filter->GetOutput();
  AuthalicMapOptions options;
  options.tolerance = 0.05;
  const FlatConeAuthalicMapResult core = flatConeAuthalicMap(HighGenusMesh(surface), TargetMeasure(surface), options);
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(toPlanarPoints(map), core.image);
  EXPECT_EQ(map->GetNumberOfPolys(), surface.faceCount());
  EXPECT_LT(field(map, "VertexMaxAbsLog"), 1e-9);
  vtkDataArray* ids = map->GetPointData()->GetArray("OriginalPointIds");
  vtkDataArray* pairs = map->GetFieldData()->GetArray("SeamPairs");
  vtkDataArray* motions = map->GetFieldData()->GetArray("SeamMotions");
  ASSERT_EQ(motions->GetNumberOfTuples(), static_cast<vtkIdType>(core.seams.size()));
  ASSERT_GT(pairs->GetNumberOfTuples(), 0);
  for (vtkIdType i = 0; i < pairs->GetNumberOfTuples(); ++i) {
    const auto seam = static_cast<vtkIdType>(pairs->GetComponent(i, 0)),
               one = static_cast<vtkIdType>(pairs->GetComponent(i, 1)),
               other = static_cast<vtkIdType>(pairs->GetComponent(i, 2));
    EXPECT_EQ(ids->GetComponent(one, 0), ids->GetComponent(other, 0));
    const double angle = motions->GetComponent(seam, 0), c = std::cos(angle), s = std::sin(angle);
    double x[3], y[3];
    map->GetPoint(one, x);
    map->GetPoint(other, y);
    EXPECT_NEAR(c * x[0] - s * x[1] + motions->GetComponent(seam, 1), y[0], 1e-9);
    EXPECT_NEAR(s * x[0] + c * x[1] + motions->GetComponent(seam, 2), y[1], 1e-9);
  }
  double curvature = 0;
  for (int v = 0; v < surface.vertexCount(); ++v) {
    curvature += 2 * M_PI - map->GetPointData()->GetArray("ConeAngle")->GetComponent(v, 0);
  }
  EXPECT_NEAR(curvature, -4 * M_PI, 1e-9);
}

TEST(FlatConeFilter, RefusesATorus) {
  const auto filter = mapped<vtkFlatConeAuthalicMap>(torusMesh(9, 9));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}
