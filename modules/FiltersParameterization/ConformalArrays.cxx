#include "ConformalArrays.h"

#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
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
  addArray(map->GetPointData(), "LogScale", result.logScale);
  addField(map, "CurvatureResidual", result.residual);
  addField(map, "Holonomy", result.holonomy);
  addField(map, "EdgeFlips", result.edgeFlips);
  addField(map, "FlippedBeforeUnfolding", result.flippedBeforeUnfolding);
  addField(map, "Pockets", result.pockets);
  return report;
}

template MapReport describeFlowMap(const YamabeMapResult&, vtkPolyData*);
template MapReport describeFlowMap(const RiemannMapResult&, vtkPolyData*);

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
