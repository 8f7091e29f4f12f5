#include "AuthalicReport.h"

#include <vtkPolyData.h>

#include "FieldArrays.h"

namespace authalic {

MapReport describeAuthalicMap(const AuthalicSolution& result, vtkPolyData* map) {
  MapReport report;
  report.method = "authalic";
  report.status = result.status;
  report.iterations = result.iterations;
  int vertexSteps = 0;
  for (const AuthalicIteration& step : result.history) {
    report.residuals.push_back(step.residual);
    vertexSteps += step.exact;
  }
  report.residuals.push_back(result.vertexResidual);
  report.seconds = {{"start", result.startSeconds}, {"faces", result.faceSeconds}, {"vertices", result.vertexSeconds}};
  report.more.set("face_residual", result.faceResidual);
  report.more.set("vertex_residual", result.vertexResidual);
  report.more.set("vertex_steps", vertexSteps);
  addField(map, "FaceResidual", result.faceResidual);
  addField(map, "VertexResidual", result.vertexResidual);
  return report;
}

void describeBalance(const Balance& balance, Json& options, vtkPolyData* map) {
  if (!balance.array.empty()) {
    options.set("balance", balance.array);
    return;
  }
  options.set("balance", balance.everywhere);
  addField(map, "Balance", balance.everywhere);
}

void addAuthalicOptions(Json& options, const AuthalicMapOptions& values) {
  options.set("tolerance", values.tolerance);
  options.set("vertex_tolerance", values.vertexTolerance);
  options.set("max_iterations", values.maxIterations);
}

}  // namespace authalic
