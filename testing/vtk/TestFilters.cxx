/// Filters against Core on the same input: same numbers, inputs untouched, failures in words, abort, re-execution.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include <vtkBarycentricMap.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCorticalSurface.h>
#include <vtkCutToDisk.h>
#include <vtkDataArray.h>
#include <vtkDiscreteLieFlow.h>
#include <vtkDoubleArray.h>
#include <vtkElementGrid.h>
#include <vtkElementStatistics.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkLabelsOnSurface.h>
#include <vtkMapDistortion.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSampleVolumeOnSurface.h>
#include <vtkStringArray.h>
#include <vtkSurfaceTopologyReport.h>
#include <vtkTable.h>

#include "Conversion.h"
#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/distortion/Distortion.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/mesh/MeshReport.h"
#include "Core/sampling/ElementGrid.h"
#include "Core/sampling/VolumeSampling.h"
#include "Core/topology/CutToDisk.h"
#include "FieldArrays.h"
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

/// x + 2y + 3z at the voxel centres of a grid that contains the unit ball.
vtkSmartPointer<vtkImageData> linearVolume() {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(31, 31, 31);
  image->SetOrigin(-3, -3, -3);
  image->SetSpacing(0.2, 0.2, 0.2);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i) {
    double p[3];
    image->GetPoint(i, p);
    values->InsertNextValue(p[0] + 2 * p[1] + 3 * p[2]);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

double field(vtkDataObject* object, const char* name) {
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

std::string textField(vtkDataObject* object, const char* name) {
  auto* array = vtkStringArray::SafeDownCast(object->GetFieldData()->GetAbstractArray(name));
  return array ? std::string(array->GetValue(0)) : std::string();
}

template <class Filter>
std::string failureOf(Filter* filter, int kind) {
  const VtkWords words(filter);
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), kind);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  return words.text();
}

TEST(BarycentricMapFilter, HasTheImageOfCore) {
  const DiskMesh disk(bumpyDisk(8));
  vtkNew<vtkBarycentricMap> filter;
  filter->SetInputData(polyData(disk.mesh()));
  for (int method = 0; method < 3; ++method) {
    filter->SetMethod(method);
    filter->Update();
    BarycentricMapOptions options;
    options.weights = static_cast<BarycentricWeights>(method);
    EXPECT_EQ(toPlanarPoints(filter->GetOutput()), barycentricMap(disk, options).image) << method;
  }
}

TEST(BarycentricMapFilter, LeavesItsInputUntouchedAndPassesArrays) {
  const auto input = polyData(bumpyDisk(6));
  addArray(input->GetPointData(), "Mine",
           std::vector<double>(static_cast<std::size_t>(input->GetNumberOfPoints()), 7.0));
  addField(input, "Note", std::string("kept"));
  const Points3 before = toPoints(input);
  vtkNew<vtkBarycentricMap> filter;
  filter->SetInputData(input);
  filter->Update();
  EXPECT_EQ(toPoints(input), before);
  EXPECT_EQ(input->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(input->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(input->GetFieldData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Mine")->GetComponent(3, 0), 7.0);
  EXPECT_EQ(textField(filter->GetOutput(), "Note"), "kept");
  EXPECT_EQ(surfaceOfMap(filter->GetOutput()).points(), before);
}

TEST(BarycentricMapFilter, MapsToEveryDomain) {
  vtkNew<vtkBarycentricMap> filter;
  filter->SetInputData(polyData(bumpyDisk(6)));
  filter->SetDomainToRectangle();
  filter->SetAspect(3);
  filter->Update();
  EXPECT_NEAR(filter->GetOutput()->GetBounds()[1], 3.0, 1e-12);
  filter->SetDomainToPolygon();
  for (const auto& corner : {std::pair{0.0, 0.0}, {4.0, 0.0}, {0.0, 5.0}}) {
    filter->AddPolygonCorner(corner.first, corner.second);
  }
  filter->Update();
  EXPECT_NEAR(filter->GetOutput()->GetBounds()[3], 5.0, 1e-12);
  EXPECT_EQ(field(filter->GetOutput(), "FlippedFaces"), 0);
}

TEST(EveryMap, CanBeTextureCoordinatesOfItsSurface) {
  const auto input = polyData(bumpyDisk(6));
  vtkNew<vtkBarycentricMap> filter;
  filter->SetInputData(input);
  filter->SetDomainToRectangle();
  filter->Update();
  const Points3 image = toPoints(filter->GetOutput());
  filter->SetOutputModeToTextureCoordinates();
  filter->Update();
  vtkPolyData* textured = filter->GetOutput();
  EXPECT_EQ(toPoints(textured), toPoints(input));
  EXPECT_EQ(textured->GetPointData()->GetArray("OriginalPoints"), nullptr);
  vtkDataArray* coordinates = textured->GetPointData()->GetTCoords();
  ASSERT_NE(coordinates, nullptr);
  ASSERT_EQ(coordinates->GetNumberOfComponents(), 2);
  for (int v = 0; v < image.rows(); ++v) {  // [0, 2] × [0, 1] scaled by one factor
    EXPECT_EQ(coordinates->GetComponent(v, 0), static_cast<float>(image(v, 0) / 2));
    EXPECT_EQ(coordinates->GetComponent(v, 1), static_cast<float>(image(v, 1) / 2));
  }
  EXPECT_EQ(field(textured, "FlippedFaces"), 0);
}

TEST(BarycentricMapFilter, RefusesAClosedSurfaceInWords) {
  vtkNew<vtkBarycentricMap> filter;
  filter->SetInputData(polyData(sphereMesh(2)));
  const std::string words = failureOf(filter.Get(), vtkSurfaceAlgorithm::SURFACE);
  EXPECT_NE(words.find("boundary"), std::string::npos) << words;
}

TEST(BarycentricMapFilter, RecoversAfterAnError) {
  vtkNew<vtkBarycentricMap> filter;
  filter->SetInputData(polyData(sphereMesh(1)));
  failureOf(filter.Get(), vtkSurfaceAlgorithm::SURFACE);
  filter->SetInputData(polyData(bumpyDisk(4)));
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::NONE);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), polyData(bumpyDisk(4))->GetNumberOfPoints());
}

TEST(SurfaceInput, RefusesAQuadrilateralAndSaysWhatMakesTriangles) {
  vtkNew<vtkPolyData> quad;
  setPoints(quad, Points3(Points3::Identity(4, 3)));
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({0, 1, 2, 3});
  quad->SetPolys(cells);
  vtkNew<vtkSurfaceTopologyReport> filter;
  filter->SetInputData(quad);
  EXPECT_NE(failureOf(filter.Get(), vtkSurfaceAlgorithm::SURFACE).find("vtkTriangleFilter"), std::string::npos);
}

TEST(SurfaceInput, RefusesLinesAndNothingAtAll) {
  vtkNew<vtkSurfaceTopologyReport> filter;
  filter->SetInputData(vtkNew<vtkPolyData>());
  EXPECT_NE(failureOf(filter.Get(), vtkSurfaceAlgorithm::SURFACE).find("empty"), std::string::npos);
  const auto mixed = polyData(bumpyDisk(2));
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({0, 1});
  mixed->SetLines(lines);
  filter->SetInputData(mixed);
  EXPECT_NE(failureOf(filter.Get(), vtkSurfaceAlgorithm::SURFACE).find("triangles alone"), std::string::npos);
}

TEST(SurfaceInput, RefusesCoordinatesThatAreNotNumbers) {
  const auto broken = polyData(bumpyDisk(2));
  broken->GetPoints()->SetPoint(3, std::nan(""), 0, 0);
  vtkNew<vtkSurfaceTopologyReport> filter;
  filter->SetInputData(broken);
  EXPECT_NE(failureOf(filter.Get(), vtkSurfaceAlgorithm::SURFACE).find("3"), std::string::npos);
}

TEST(TopologyReportFilter, CountsWhatCoreCounts) {
  vtkNew<vtkSurfaceTopologyReport> filter;
  filter->SetInputData(polyData(bumpyDisk(5)));
  filter->Update();
  EXPECT_EQ(field(filter->GetOutput(), "EulerCharacteristic"), 1);
  EXPECT_EQ(field(filter->GetOutput(), "BoundaryLoops"), 1);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("BoundaryLoop")->GetComponent(0, 0), 0);
  EXPECT_NE(filter->GetReport().find("\"genus\""), std::string::npos);
}

TEST(MapDistortionFilter, MeasuresWhatCoreMeasures) {
  const DiskMesh disk(bumpyDisk(6));
  const Points2 image = barycentricMap(disk).image;
  const auto map = polyData(disk.mesh());
  setPoints(map, image);
  vtkNew<vtkMapDistortion> filter;
  filter->SetInputData(0, map);
  filter->SetInputData(1, polyData(disk.mesh()));
  filter->DetailsOn();
  filter->Update();
  const Distortion core = measureDistortion(disk.mesh(), image);
  EXPECT_EQ(field(filter->GetOutput(), "TotalAreaDistortion"), core.summary.areaDistortion);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("AreaDistortion")->GetComponent(5, 0),
            core.arrays.logAreaRatio[5]);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("BeltramiCoefficient")->GetComponent(5, 1),
            core.arrays.beltrami[5].imag());
}

TEST(MapDistortionFilter, NeedsTheSurfaceOfAMap) {
  const auto map = polyData(authalic::testing::diskMesh(3));
  vtkNew<vtkMapDistortion> filter;
  filter->SetInputData(0, map);
  EXPECT_NE(failureOf(filter.Get(), vtkSurfaceAlgorithm::ARGUMENT).find("OriginalPoints"), std::string::npos);
}

TEST(LieFlowFilter, HasTheImageOfCoreAndItsDefaults) {
  const DiskMesh disk(bumpyDisk(10));
  vtkNew<vtkDiscreteLieFlow> filter;
  filter->SetInputData(polyData(disk.mesh()));
  filter->Update();
  BarycentricMapOptions start;
  start.weights = BarycentricWeights::Uniform;
  const DiscreteLieFlowOptions defaults;
  const auto flow = discreteLieFlow(disk, barycentricMap(disk, start).image, TargetMeasure(disk.mesh()), defaults);
  EXPECT_EQ(toPlanarPoints(filter->GetOutput()), flow.image);
  EXPECT_EQ(textField(filter->GetOutput(), "Status"), statusName(flow.status));
  EXPECT_EQ(filter->GetTolerance(), defaults.tolerance);
  EXPECT_EQ(filter->GetMaximumIterations(), defaults.maxIterations);
  EXPECT_EQ(filter->GetStepRatio(), defaults.stepRatio);
  EXPECT_EQ(filter->GetKeepInitial(), defaults.keepInitial);
}

TEST(LieFlowFilter, GivesTheBestIterateAndAWarningWhenItMayNotGoOn) {
  vtkNew<vtkDiscreteLieFlow> filter;
  const VtkWords words(filter);
  filter->SetInputData(polyData(bumpyDisk(8)));
  filter->SetMaximumIterations(1);
  filter->SetMaximumFinishIterations(0);
  filter->SetTolerance(1e-9);
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::NOT_CONVERGED);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_NE(words.text().find("Not converged"), std::string::npos);
}

TEST(LieFlowFilter, GivesARegionTheShareThatItsDensityAsksFor) {
  const TriangleMesh mesh = bumpyDisk(14);
  std::vector<double> density(static_cast<std::size_t>(mesh.faceCount()), 1.0);
  for (std::size_t f = 0; f < density.size() / 4; ++f) density[f] = 4.0;
  const auto input = polyData(mesh);
  addArray(input->GetCellData(), "Density", density);
  vtkNew<vtkDiscreteLieFlow> filter;
  filter->SetInputData(input);
  filter->SetMeasureArrayName("Density");
  filter->Update();
  const TargetMeasure target =
      TargetMeasure::fromFaceDensity(mesh, Eigen::Map<Eigen::VectorXd>(density.data(), mesh.faceCount()));
  double share = 0, wanted = 0, all = 0;
  const Points2 image = toPlanarPoints(filter->GetOutput());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const Eigen::RowVector2d a = image.row(mesh.faces()(f, 0)), b = image.row(mesh.faces()(f, 1)) - a,
                             c = image.row(mesh.faces()(f, 2)) - a;
    const double area = 0.5 * (b[0] * c[1] - b[1] * c[0]);
    all += area;
    if (density[static_cast<std::size_t>(f)] > 1) {
      share += area;
      wanted += target.faces()[f];
    }
  }
  EXPECT_NEAR(share / all / wanted, 1.0, 0.01);
}

TEST(LieFlowFilter, RefusesAMissingMeasureAndABadOption) {
  vtkNew<vtkDiscreteLieFlow> filter;
  filter->SetInputData(polyData(bumpyDisk(4)));
  filter->SetMeasureArrayName("Nowhere");
  EXPECT_NE(failureOf(filter.Get(), vtkSurfaceAlgorithm::ARGUMENT).find("Nowhere"), std::string::npos);
  filter->SetMeasureArrayName("");
  filter->SetStepRatio(2.0);
  failureOf(filter.Get(), vtkSurfaceAlgorithm::ARGUMENT);
}

TEST(LieFlowFilter, StopsWhenAborted) {
  vtkNew<vtkDiscreteLieFlow> filter;
  filter->SetInputData(polyData(bumpyDisk(20)));
  filter->SetTolerance(1e-12);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Update();
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::CANCELLED);
}

TEST(LieFlowFilter, HasTheSameBitsAtAnyThreadCount) {
  vtkNew<vtkDiscreteLieFlow> filter;
  filter->SetInputData(polyData(bumpyDisk(10)));
  filter->SetThreads(1);
  filter->Update();
  const Points3 one = toPoints(filter->GetOutput());
  filter->SetThreads(2);
  filter->Update();
  EXPECT_EQ(toPoints(filter->GetOutput()), one);
}

TEST(CutToDiskFilter, CutsWhereCoreCuts) {
  const TriangleMesh ball = sphereMesh(4);
  vtkNew<vtkCutToDisk> filter;
  filter->SetInputData(polyData(ball));
  filter->SetRegionModeToPlane();
  filter->SetPlaneOrigin(0, 0, -0.5);
  filter->SetPlaneNormal(0, 0, -1);
  filter->Update();
  const CutToDiskResult core = cutToDisk(ball, verticesBeyondPlane(ball, {0, 0, -0.5}, {0, 0, -1}));
  EXPECT_EQ(toTriangleMesh(filter->GetOutput()).faces(), core.mesh.faces());
  EXPECT_EQ(filter->GetLoopSmoothing(), CutToDiskOptions().loopSmoothing);
  vtkDataArray* ids = filter->GetOutput()->GetPointData()->GetArray("OriginalPointIds");
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i) {
    EXPECT_EQ(ball.point(static_cast<int>(ids->GetComponent(i, 0))), core.mesh.point(static_cast<int>(i)));
  }
}

TEST(CutToDiskFilter, TakesLabelsAndCarriesArrays) {
  const TriangleMesh ball = sphereMesh(4);
  std::vector<int> labels;
  for (int i = 0; i < ball.vertexCount(); ++i) labels.push_back(ball.point(i)[2] < -0.5 ? 7 : 3);
  const auto input = polyData(ball);
  addArray(input->GetPointData(), "Label", labels);
  vtkNew<vtkCutToDisk> filter;
  filter->SetInputData(input);
  filter->SetRegionArrayName("Label");
  filter->AddRegionValue(7);
  filter->SetLoopSmoothing(0);
  filter->Update();
  const vtkIdType removed = filter->GetOutput()->GetNumberOfPoints();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Label")->GetRange()[1], 3);
  filter->ClearRegionValues();
  filter->AddRegionValue(3);
  filter->KeepRegionOn();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), removed);
}

TEST(CutToDiskFilter, NamesTheArraysThatAreThere) {
  const auto input = polyData(sphereMesh(2));
  addArray(input->GetPointData(), "Sulc", std::vector<double>(static_cast<std::size_t>(input->GetNumberOfPoints())));
  vtkNew<vtkCutToDisk> filter;
  filter->SetInputData(input);
  EXPECT_NE(failureOf(filter.Get(), vtkSurfaceAlgorithm::ARGUMENT).find("Sulc"), std::string::npos);
}

TEST(SampleVolumeFilter, ReadsALinearFieldExactlyAndTheSurfaceOfAMap) {
  const TriangleMesh mesh = bumpyDisk(6);
  vtkNew<vtkBarycentricMap> map;
  map->SetInputData(polyData(mesh));
  vtkNew<vtkSampleVolumeOnSurface> filter;
  filter->SetInputConnection(0, map->GetOutputPort());
  filter->SetInputData(1, linearVolume());
  filter->SetArrayName("T");
  filter->Update();
  vtkDataArray* values = filter->GetOutput()->GetPointData()->GetArray("T");
  for (int i = 0; i < mesh.vertexCount(); ++i) {
    EXPECT_NEAR(values->GetComponent(i, 0), mesh.point(i).dot(Eigen::Vector3d(1, 2, 3)), 1e-5);
  }
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("TCoverage")->GetRange()[0], 1.0);
  EXPECT_EQ(filter->GetDepthTo(), VolumeSamplingOptions().depthTo);
}

TEST(SampleVolumeFilter, NeedsTheOtherSurfaceToSampleBetween) {
  vtkNew<vtkSampleVolumeOnSurface> filter;
  filter->SetInputData(0, polyData(bumpyDisk(3)));
  filter->SetInputData(1, linearVolume());
  filter->SetModeToBetweenSurfaces();
  EXPECT_NE(failureOf(filter.Get(), vtkSurfaceAlgorithm::ARGUMENT).find("port 2"), std::string::npos);
}

TEST(LabelsOnSurfaceFilter, FindsTheNearestLabelledVoxel) {
  const auto volume = linearVolume();
  vtkDataArray* values = volume->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i) {
    values->SetComponent(i, 0, volume->GetPoint(i)[0] > 0 ? 5 : 0);
  }
  vtkNew<vtkLabelsOnSurface> filter;
  filter->SetInputData(0, polyData(bumpyDisk(4)));
  filter->SetInputData(1, volume);
  filter->SetMaximumDistance(0.3);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Label")->GetRange()[1], 5);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Label")->GetRange()[0], 0);
}

TEST(ElementPipeline, ReachesTablesWhoseAreasSumToTheSurface) {
  const TriangleMesh mesh = bumpyDisk(12);
  vtkNew<vtkDiscreteLieFlow> map;
  map->SetInputData(polyData(mesh));
  map->SetDomainToSquare();
  vtkNew<vtkSampleVolumeOnSurface> sample;
  sample->SetInputConnection(0, map->GetOutputPort());
  sample->SetInputData(1, linearVolume());
  vtkNew<vtkElementGrid> grid;
  grid->SetInputConnection(sample->GetOutputPort());
  grid->SetNumberOfElements(25);
  vtkNew<vtkElementStatistics> statistics;
  statistics->SetInputConnection(grid->GetOutputPort());
  statistics->Update();
  vtkTable* table = statistics->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 25);
  double sum = 0;
  for (vtkIdType r = 0; r < 25; ++r) sum += table->GetValueByName(r, "area_mm2").ToDouble();
  EXPECT_NEAR(sum, inspect(mesh).area, 1e-9 * sum);
  EXPECT_NE(table->GetColumnByName("sample_mean"), nullptr);
  EXPECT_EQ(grid->GetOutput(2)->GetNumberOfCells(), 25);
  EXPECT_GT(grid->GetOutput(1)->GetNumberOfLines(), 0);
  EXPECT_EQ(vtkNew<vtkElementGrid>()->GetNumberOfElements(), ElementGridOptions().elements);
}

TEST(ElementPipeline, StatisticsAskForTheGridFirst) {
  vtkNew<vtkBarycentricMap> map;
  map->SetInputData(polyData(bumpyDisk(4)));
  vtkNew<vtkElementStatistics> statistics;
  const VtkWords words(statistics);
  statistics->SetInputConnection(map->GetOutputPort());
  statistics->Update();
  EXPECT_EQ(statistics->GetErrorKind(), vtkSurfaceAlgorithm::ARGUMENT);
  EXPECT_NE(words.text().find("vtkElementGrid"), std::string::npos);
  EXPECT_FALSE(statistics->WriteElements("never.tsv"));
}

TEST(CorticalSurfaceFilter, RefusesAnEmptyVolume) {
  vtkNew<vtkCorticalSurface> filter;
  filter->SetInputData(vtkNew<vtkImageData>());
  failureOf(filter.Get(), vtkSurfaceAlgorithm::SURFACE);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 0);
}

template <class Filter>
void expectPrints() {
  vtkNew<Filter> filter;
  std::ostringstream out;
  filter->Print(out);
  EXPECT_NE(out.str().find("ErrorKind: 0"), std::string::npos) << filter->GetClassName();
}

TEST(EveryFilter, PrintsItself) {
  expectPrints<vtkBarycentricMap>();
  expectPrints<vtkDiscreteLieFlow>();
  expectPrints<vtkMapDistortion>();
  expectPrints<vtkSurfaceTopologyReport>();
  expectPrints<vtkCutToDisk>();
  expectPrints<vtkCorticalSurface>();
  expectPrints<vtkSampleVolumeOnSurface>();
  expectPrints<vtkLabelsOnSurface>();
  expectPrints<vtkElementGrid>();
  expectPrints<vtkElementStatistics>();
}

}  // namespace
