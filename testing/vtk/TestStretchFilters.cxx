/// The stretch filters against Core on the same input, with their arrays and refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStretchEnergyMap.h>
#include <vtkStretchMinimisation.h>

#include "Conversion.h"
#include "Core/authalic/StretchEnergyMap.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/initial/StretchMinimisation.h"
#include "support/TestMeshes.h"
#include "support/VtkWords.h"

namespace {

using namespace authalic;
using authalic::testing::bumpyDisk;
using authalic::testing::sphereMesh;
using authalic::testing::wordsOf;

vtkSmartPointer<vtkPolyData> polyData(const TriangleMesh& mesh) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  setMesh(result, mesh);
  return result;
}

template <class Filter>
vtkSmartPointer<Filter> on(const TriangleMesh& mesh) {
  const auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(0, polyData(mesh));
  return filter;
}

double field(vtkDataObject* object, const char* name) {
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

}  // namespace

TEST(StretchFilters, GiveTheImageOfCore) {
  const DiskMesh disk(bumpyDisk(12, 1.0));
  const auto little = on<vtkStretchMinimisation>(disk.mesh());
  little->SetWeightsToTutte();
  little->SetDomainToSquare();
  little->SetMaximumIterations(3);
  little->Update();
  StretchMinimisationOptions options;
  options.weights = BarycentricWeights::Uniform;
  options.domain = PlanarDomain::square();
  options.maxIterations = 3;
  const StretchMinimisationResult core = stretchMinimisation(disk, options);
  EXPECT_EQ(toPlanarPoints(little->GetOutput()), core.image);
  EXPECT_EQ(field(little->GetOutput(), "Stretch"), core.stretch);
  EXPECT_EQ(little->GetIterations(), core.iterations);

  const auto fixed = on<vtkStretchEnergyMap>(disk.mesh());
  fixed->SetBoundaryToHeld();
  fixed->SetTolerance(0.1);
  fixed->Update();
  StretchEnergyMapOptions held;
  held.boundary = StretchEnergyBoundary::Held;
  held.tolerance = 0.1;
  BarycentricMapOptions start;
  start.weights = BarycentricWeights::Harmonic;
  const Points2 initial = barycentricMap(disk, start).image;
  EXPECT_EQ(toPlanarPoints(fixed->GetOutput()),
            stretchEnergyMap(disk, initial, TargetMeasure(disk.mesh()), held).image);
}

TEST(StretchFilters, StartFromAGivenMap) {
  const TriangleMesh mesh = bumpyDisk(10);
  const auto first = on<vtkStretchEnergyMap>(mesh);
  first->SetMaximumIterations(3);
  const auto second = on<vtkStretchEnergyMap>(mesh);
  second->SetInputConnection(1, first->GetOutputPort());
  second->SetMaximumIterations(2);
  second->Update();
  const auto whole = on<vtkStretchEnergyMap>(mesh);
  whole->SetMaximumIterations(5);
  whole->Update();
  EXPECT_LT((toPlanarPoints(second->GetOutput()) - toPlanarPoints(whole->GetOutput())).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(StretchFilters, SayWhenTheyWereCutShort) {
  const auto filter = on<vtkStretchEnergyMap>(bumpyDisk(10));
  filter->SetMaximumIterations(1);
  EXPECT_NE(wordsOf(filter).find("Not converged"), std::string::npos);
  EXPECT_EQ(filter->GetStatus(), "not-converged");
  EXPECT_EQ(filter->GetErrorKind(), vtkSurfaceAlgorithm::NOT_CONVERGED);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(StretchFilters, RefuseClosedSurfacesAndBadOptions) {
  const auto closed = on<vtkStretchMinimisation>(sphereMesh(2));
  EXPECT_NE(wordsOf(closed).find("disk"), std::string::npos);
  EXPECT_EQ(closed->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(closed->GetErrorKind(), vtkSurfaceAlgorithm::SURFACE);
  const auto bad = on<vtkStretchEnergyMap>(bumpyDisk(6));
  bad->SetTolerance(0);
  EXPECT_NE(wordsOf(bad).find("olerance"), std::string::npos);
  EXPECT_EQ(bad->GetErrorKind(), vtkSurfaceAlgorithm::ARGUMENT);
}
