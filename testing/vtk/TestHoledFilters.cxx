/// The conformal filters of surfaces with holes against Core, with their arrays and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <vtkAnnulusMap.h>
#include <vtkCircleDomainAuthalicMap.h>
#include <vtkCircleDomainLieFlow.h>
#include <vtkCircleDomainMap.h>
#include <vtkConformalFlowAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/authalic/CircleDomainAuthalicMap.h"
#include "Core/authalic/CircleDomainLieFlow.h"
#include "Core/authalic/PeriodicRectangleAuthalicMap.h"
#include "Core/authalic/PeriodicRectangleLieFlow.h"
#include "Core/conformal/AnnulusMap.h"
#include "Core/conformal/CircleDomainMap.h"
#include "support/HoledMeshes.h"
#include "support/VtkWords.h"

namespace {

using namespace authalic;
using authalic::testing::holedDisk;
using authalic::testing::revolutionMesh;
using authalic::testing::sphereMesh;
using authalic::testing::wordsOf;

TriangleMesh frustum() {
  return revolutionMesh(40, 6, [](double t) { return 2 - t; }, [](double t) { return 1.5 * t; });
}

TriangleMesh threeLoops() {
  TriangleMesh flat = holedDisk(24, {{{0.4, 0.1}, 0.2}, {{-0.3, -0.3}, 0.25}});
  Points3 points = flat.points();
  for (Eigen::Index v = 0; v < points.rows(); ++v) points(v, 2) = 0.3 * std::sin(3 * points(v, 0) + points(v, 1));
  return TriangleMesh(points, flat.faces());
}

template <class Filter>
vtkSmartPointer<Filter> on(const TriangleMesh& mesh) {
  const auto filter = vtkSmartPointer<Filter>::New();
  vtkNew<vtkPolyData> data;
  setMesh(data, mesh);
  filter->SetInputData(0, data);
  return filter;
}

double field(vtkDataObject* object, const char* name, int tuple = 0, int component = 0) {
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(tuple, component) : std::nan("");
}

/// The sentence with which a filter refuses.
std::string refusal(vtkSurfaceMapAlgorithm* filter, int kind) {
  const std::string text = wordsOf(filter);
  EXPECT_EQ(filter->GetErrorKind(), kind);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  return text;
}

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

}  // namespace

TEST(AnnulusMapFilter, GivesTheRingOfCoreAndTheModulusOfTheFrustum) {
  const AnnulusMesh annulus(frustum());
  const auto filter = on<vtkAnnulusMap>(annulus.mesh());
  filter->Update();
  const AnnulusMapResult core = annulusMap(annulus);
  EXPECT_EQ(toPlanarPoints(filter->GetOutput()), core.image);
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(filter->GetFlippedFaces(), 0);
  const double slant = std::hypot(1.0, 1.5);
  EXPECT_NEAR(field(filter->GetOutput(), "ConformalModulus"), slant * std::log(2.0) / (2 * M_PI), 1e-3);
  EXPECT_NEAR(field(filter->GetOutput(), "Height") / field(filter->GetOutput(), "Circumference"), core.modulus, 1e-12);
  EXPECT_NEAR(field(filter->GetOutput(), "Height") * field(filter->GetOutput(), "Circumference"),
              3 * M_PI * slant, 0.1);
  EXPECT_EQ(field(filter->GetOutput(), "InnerRadius"), core.innerRadius);
  EXPECT_LT(field(filter->GetOutput(), "Holonomy"), 1e-9);
  ASSERT_EQ(filter->GetOutput()->GetFieldData()->GetArray("Cut")->GetNumberOfTuples(), vtkIdType(core.cut.size()));
  EXPECT_EQ(field(filter->GetOutput(), "Cut", 1), core.cut[1]);
}

TEST(AnnulusMapFilter, OpensTheRectangleAlongTheCutWithSidesOnePeriodApart) {
  const AnnulusMesh annulus(frustum());
  const auto filter = on<vtkAnnulusMap>(annulus.mesh());
  filter->SetDomainToRectangle();
  filter->SetOuterVertex(annulus.loops()[1][3]);
  filter->SetStartVertex(annulus.loops()[1][5]);
  filter->Update();
  AnnulusMapOptions options;
  options.outerLoop = 1;
  options.startVertex = annulus.loops()[1][5];
  const AnnulusMapResult core = annulusMap(annulus, options);
  const Points2 image = toPlanarPoints(filter->GetOutput());
  EXPECT_EQ(image, core.rectangle.points);
  vtkDataArray* ids = filter->GetOutput()->GetPointData()->GetArray("OriginalPointIds");
  const int n = annulus.mesh().vertexCount();
  ASSERT_EQ(image.rows(), n + Eigen::Index(core.cut.size()));
  for (int v = 0; v < image.rows(); ++v) {
    const int original = int(ids->GetComponent(v, 0));
    if (v < n) { EXPECT_EQ(original, v); }
    EXPECT_NEAR(std::abs(image(v, 0) - image(original, 0)), v < n ? 0 : 1, 1e-14);
    EXPECT_EQ(image(v, 1), image(original, 1));
  }
  const int outer = annulus.loops()[1][5];
  EXPECT_EQ(image(outer, 1), 0);
}

TEST(HoledFilters, CarryScaleFactorsThatTheImageFollows) {
  const PolyAnnulusMesh surface(frustum());
  for (const bool rectangle : {true, false}) {
    vtkSmartPointer<vtkConformalFlowAlgorithm> filter = on<vtkCircleDomainMap>(surface.mesh());
    if (rectangle) {
      const auto annulus = on<vtkAnnulusMap>(surface.mesh());
      annulus->SetDomainToRectangle();
      filter = annulus;
    }
    filter->Update();
    ASSERT_EQ(field(filter->GetOutput(), "EdgeFlips"), 0);
    const TriangleMesh opened = surfaceOfMap(filter->GetOutput());
    const Points2 image = toPlanarPoints(filter->GetOutput());
    vtkDataArray* u = filter->GetOutput()->GetPointData()->GetArray("LogScaleFactor");
    ASSERT_NE(u, nullptr);
    for (Eigen::Index f = 0; f < opened.faces().rows(); ++f) {
      const int i = opened.faces()(f, 0), j = opened.faces()(f, 1);
      EXPECT_NEAR((image.row(i) - image.row(j)).norm(),
                  (opened.point(i) - opened.point(j)).norm() *
                      std::exp(0.5 * (u->GetComponent(i, 0) + u->GetComponent(j, 0))),
                  1e-8);
    }
  }
}

TEST(CircleDomainMapFilter, GivesTheImageAndTheCirclesOfCoreOnBothRoads) {
  const PolyAnnulusMesh surface(threeLoops());
  ASSERT_EQ(surface.loops().size(), 3u);
  for (const bool koebe : {false, true}) {
    const auto filter = on<vtkCircleDomainMap>(surface.mesh());
    CircleDomainOptions options;
    options.road = koebe ? CircleDomainRoad::Koebe : CircleDomainRoad::Curvature;
    options.outerLoop = 1;
    options.roundness = 1e-4;
    options.maxRounds = 20;
    options.normalisation = {DiskCentre::Face, 5, surface.loops()[1][2]};
    options.unfold = false;
    filter->SetRoad(koebe);
    filter->SetOuterVertex(surface.loops()[1][4]);
    filter->SetRoundnessTolerance(1e-4);
    filter->SetMaximumRounds(20);
    filter->SetCentreToFace();
    filter->SetCentreId(5);
    filter->SetStartVertex(surface.loops()[1][2]);
    filter->UnfoldOff();
    filter->Update();
    const CircleDomainResult core = circleDomainMap(surface, options);
    EXPECT_EQ(filter->GetStatus(), "converged");
    const Points2 image = toPlanarPoints(filter->GetOutput());
    EXPECT_EQ(image, core.image);
    EXPECT_EQ(field(filter->GetOutput(), "OuterLoop"), 1);
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("LogScaleFactor") == nullptr, koebe);
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector2d centre(field(filter->GetOutput(), "Circles", k, 0),
                                      field(filter->GetOutput(), "Circles", k, 1));
      for (const int v : surface.loops()[std::size_t(k)]) {
        EXPECT_NEAR((image.row(v) - centre).norm(), field(filter->GetOutput(), "Circles", k, 2), 1e-12);
      }
    }
  }
}

TEST(HoledFilters, GiveTheCommonRefinementOnRequest) {
  const TriangleMesh mesh = threeLoops();
  const auto filter = on<vtkCircleDomainMap>(mesh);
  filter->RefineOn();
  filter->Update();
  ASSERT_GT(field(filter->GetOutput(), "EdgeFlips"), 0);
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), mesh.faceCount());
  EXPECT_EQ(field(filter->GetOutput(), "FlippedFaces"), 0);
}

TEST(HoledFilters, RefuseOtherTopologiesAndBadOptionsInWords) {
  EXPECT_SAYS(refusal(on<vtkAnnulusMap>(threeLoops()), vtkSurfaceAlgorithm::SURFACE),
              "3 boundary loops: found a bound");
  EXPECT_SAYS(refusal(on<vtkAnnulusMap>(authalic::testing::bumpyDisk(6)), vtkSurfaceAlgorithm::SURFACE),
              "too few boundary loops");
  EXPECT_SAYS(refusal(on<vtkCircleDomainMap>(sphereMesh(2)), vtkSurfaceAlgorithm::SURFACE), "authalic cut");
  const auto inner = on<vtkCircleDomainMap>(threeLoops());
  inner->SetOuterVertex(0);
  EXPECT_SAYS(refusal(inner, vtkSurfaceAlgorithm::ARGUMENT), "none of the 3");
  const auto koebe = on<vtkCircleDomainMap>(threeLoops());
  koebe->SetRoadToKoebe();
  koebe->RefineOn();
  EXPECT_SAYS(refusal(koebe, vtkSurfaceAlgorithm::ARGUMENT), "common refinement");
  const auto start = on<vtkAnnulusMap>(frustum());
  start->SetStartVertex(100);
  EXPECT_SAYS(refusal(start, vtkSurfaceAlgorithm::ARGUMENT), "vertex 100");
}

TEST(HoledFilters, WarnAndGiveTheBestMapWhenTheyMayNotGoOn) {
  const TriangleMesh mesh = threeLoops();
  const auto filter = on<vtkCircleDomainMap>(mesh);
  filter->SetMaximumIterations(1);
  EXPECT_SAYS(wordsOf(filter), "Not converged");
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::NOT_CONVERGED);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), mesh.vertexCount());
}

TEST(CircleDomainAuthalicMapFilter, GivesTheImageOfCoreWithEveryOption) {
  const PolyAnnulusMesh surface(threeLoops());
  const auto filter = on<vtkCircleDomainAuthalicMap>(surface.mesh());
  filter->SetTolerance(0.1);
  filter->SetVertexTolerance(1e-8);
  filter->SetMaximumIterations(60);
  filter->AddHoleArea(0.15);
  filter->AddHoleArea(0.1);
  filter->Update();
  CircleDomainAuthalicMapOptions options;
  options.solve.tolerance = 0.1;
  options.solve.vertexTolerance = 1e-8;
  options.solve.maxIterations = 60;
  options.holeAreas = {0.15, 0.1};
  const auto core = circleDomainAuthalicMap(surface, TargetMeasure(surface.mesh()), options);
  EXPECT_EQ(filter->GetStatus(), "converged");
  EXPECT_EQ(toPlanarPoints(filter->GetOutput()), core.image);
  EXPECT_EQ(field(filter->GetOutput(), "HoleAreas", 1), 0.1);
  EXPECT_LT(field(filter->GetOutput(), "HoleResidual"), 1e-12);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(field(filter->GetOutput(), "Circles", k, 2), core.circles[std::size_t(k)].radius);
  filter->ClearHoleAreas();
  filter->AddHoleArea(1);
  EXPECT_SAYS(refusal(filter, vtkSurfaceAlgorithm::ARGUMENT), "each of the 2 holes");
  filter->FreeRadiiOn();
  EXPECT_SAYS(refusal(filter, vtkSurfaceAlgorithm::ARGUMENT), "free");
  const auto concentric = on<vtkCircleDomainAuthalicMap>(threeLoops());
  concentric->SetDomainToAnnulus();
  EXPECT_SAYS(refusal(concentric, vtkSurfaceAlgorithm::SURFACE), "2 boundary loops");
}

TEST(CircleDomainAuthalicMapFilter, HoldsCentresAndFreesRadiiAsCoreDoes) {
  const PolyAnnulusMesh surface(threeLoops());
  CircleDomainAuthalicMapOptions options;
  options.solve.tolerance = 0.1;
  for (const bool free : {false, true}) {
    const auto filter = on<vtkCircleDomainAuthalicMap>(surface.mesh());
    filter->SetTolerance(0.1);
    filter->SetHoldCentres(!free);
    filter->SetFreeRadii(free);
    filter->Update();
    options.holdCentres = !free;
    options.freeRadii = free;
    const auto core = circleDomainAuthalicMap(surface, TargetMeasure(surface.mesh()), options);
    EXPECT_EQ(toPlanarPoints(filter->GetOutput()), core.image);
    EXPECT_EQ(field(filter->GetOutput(), "HoleAreas", 1), core.holeAreas[1]);
  }
}

TEST(CircleDomainLieFlowFilter, GivesTheImageOfCoreWithItsOptions) {
  const PolyAnnulusMesh surface(threeLoops());
  const auto filter = on<vtkCircleDomainLieFlow>(surface.mesh());
  filter->SetTolerance(0.01);
  filter->SetFinishToUnfold();
  filter->SetMaximumIterations(8);
  filter->AddHoleArea(0.15);
  filter->AddHoleArea(0.1);
  filter->Update();
  CircleDomainLieFlowOptions options;
  options.flow.tolerance = 0.01;
  options.flow.finish = LieFlowFinish::Unfold;
  options.flow.maxIterations = 8;
  options.holeAreas = {0.15, 0.1};
  const auto core = circleDomainLieFlow(surface, TargetMeasure(surface.mesh()), options);
  EXPECT_EQ(toPlanarPoints(filter->GetOutput()), core.image);
  EXPECT_EQ(filter->GetFlippedFaces(), 0);
  EXPECT_LT(field(filter->GetOutput(), "HoleResidual"), 1e-12);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(field(filter->GetOutput(), "Circles", k, 2), core.circles[std::size_t(k)].radius);
  const auto concentric = on<vtkCircleDomainLieFlow>(threeLoops());
  concentric->SetDomainToAnnulus();
  EXPECT_SAYS(refusal(concentric, vtkSurfaceAlgorithm::SURFACE), "2 boundary loops");
}

TEST(PeriodicRectangleFilters, GiveTheOpenedImagesOfCoreAndRefuseWhatHasNoRectangle) {
  const AnnulusMesh annulus(frustum());
  const auto solve = on<vtkCircleDomainAuthalicMap>(annulus.mesh());
  solve->SetDomainToPeriodicRectangle();
  solve->SetOuterVertex(annulus.loops()[1][3]);
  solve->SetTolerance(0.05);
  solve->Update();
  PeriodicRectangleAuthalicMapOptions options;
  options.outerLoop = 1;
  options.solve.tolerance = 0.05;
  const auto core = periodicRectangleAuthalicMap(annulus, TargetMeasure(annulus.mesh()), options);
  EXPECT_EQ(solve->GetStatus(), "converged");
  EXPECT_EQ(toPlanarPoints(solve->GetOutput()), core.image);
  EXPECT_EQ(field(solve->GetOutput(), "OuterLoop"), 1);
  EXPECT_NEAR(field(solve->GetOutput(), "Height") / field(solve->GetOutput(), "Circumference"), core.height, 1e-12);
  EXPECT_EQ(field(solve->GetOutput(), "Cut", 1), core.cut[1]);
  vtkDataArray* ids = solve->GetOutput()->GetPointData()->GetArray("OriginalPointIds");
  ASSERT_NE(ids, nullptr);
  for (std::size_t v = 0; v < core.originalPointIds.size(); ++v) {
    EXPECT_EQ(ids->GetComponent(vtkIdType(v), 0), core.originalPointIds[v]);
  }
  const auto flow = on<vtkCircleDomainLieFlow>(annulus.mesh());
  flow->SetDomainToPeriodicRectangle();
  flow->SetMaximumIterations(8);
  flow->Update();
  PeriodicRectangleLieFlowOptions flowing;
  flowing.flow.maxIterations = 8;
  EXPECT_EQ(toPlanarPoints(flow->GetOutput()),
            periodicRectangleLieFlow(annulus, TargetMeasure(annulus.mesh()), flowing).image);
  flow->AddHoleArea(1);
  EXPECT_SAYS(refusal(flow, vtkSurfaceAlgorithm::ARGUMENT), "has none");
  const auto three = on<vtkCircleDomainAuthalicMap>(threeLoops());
  three->SetDomainToPeriodicRectangle();
  EXPECT_SAYS(refusal(three, vtkSurfaceAlgorithm::SURFACE), "3 boundary loops");
}
