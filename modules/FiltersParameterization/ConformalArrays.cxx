#include "ConformalArrays.h"

#include <algorithm>
#include <string>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/base/Error.h"
#include "FieldArrays.h"
#include "MapArrays.h"

namespace authalic {

template <class Result>
MapReport describeFlowMap(const Result& result, vtkPolyData* map) {
  MapReport report;
  report.status = result.status;
  report.iterations = result.iterations;
  for (const YamabeIteration& step : result.history) report.residuals.push_back(step.residual);
  report.residuals.push_back(result.residual);
  report.seconds = {{"map", result.seconds}};
  report.more.set("curvature_residual", result.residual);
  report.more.set("holonomy", result.holonomy);
  report.more.set("edge_flips", result.edgeFlips);
  report.more.set("flipped_before_unfolding", result.flippedBeforeUnfolding);
  report.more.set("pockets", result.pockets);
  if (result.logScale.size() == map->GetNumberOfPoints()) {
    addArray(map->GetPointData(), "LogScale", result.logScale);
  }
  addField(map, "CurvatureResidual", result.residual);
  addField(map, "Holonomy", result.holonomy);
  addField(map, "EdgeFlips", result.edgeFlips);
  addField(map, "FlippedBeforeUnfolding", result.flippedBeforeUnfolding);
  addField(map, "Pockets", result.pockets);
  return report;
}

template MapReport describeFlowMap(const YamabeMapResult&, vtkPolyData*);
template MapReport describeFlowMap(const RiemannMapResult&, vtkPolyData*);
template MapReport describeFlowMap(const AnnulusMapResult&, vtkPolyData*);
template MapReport describeFlowMap(const CircleDomainResult&, vtkPolyData*);

int loopThrough(int vertex, const std::vector<std::vector<int>>& loops) {
  if (vertex == -1) return -1;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (std::find(loops[k].begin(), loops[k].end(), vertex) != loops[k].end()) return static_cast<int>(k);
  }
  throw InvalidArgument(
      "A vertex of a boundary loop is required as the outer vertex (-1: the longest loop), but vertex " +
      std::to_string(vertex) + " is on none of the " + std::to_string(loops.size()) +
      "; 'authalic info' lists them.");
}

void addCircles(const std::vector<FittedCircle>& circles, vtkPolyData* map, MapReport& report) {
  vtkNew<vtkDoubleArray> array;
  array->SetName("Circles");
  array->SetNumberOfComponents(3);
  std::vector<double> numbers, roundness;
  for (const FittedCircle& circle : circles) {
    array->InsertNextTuple3(circle.centre[0], circle.centre[1], circle.radius);
    numbers.insert(numbers.end(), {circle.centre[0], circle.centre[1], circle.radius});
    roundness.push_back(circle.deviation);
  }
  map->GetFieldData()->AddArray(array);
  addField(map, "CircleRoundness", roundness);
  report.more.set("circles", Json::arrayOf(numbers));
  report.more.set("circle_roundness", Json::arrayOf(roundness));
}

void fillRefinement(const std::optional<CommonRefinement>& refinement, vtkPolyData* map, vtkPolyData* output,
                    MapReport& report) {
  if (!refinement) return;
  setMesh(output, refinement->mesh);
  addArray(output->GetPointData(), "OriginalPoints", refinement->mesh.points());
  addIds(output->GetPointData(), "OriginalPointIds", refinement->originalPointIds);
  addIds(output->GetCellData(), "OriginalCellIds", refinement->originalFaceIds);
  setPoints(output, refinement->image);
  addDistortion(output, measureDistortion(refinement->mesh, refinement->image));
  addField(map, "RefinementFlippedFaces", refinement->flippedFaces);
  report.more.set("refinement_faces", refinement->mesh.faceCount());
  report.more.set("refinement_flipped_faces", refinement->flippedFaces);
}

}  // namespace authalic
