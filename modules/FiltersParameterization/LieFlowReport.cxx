#include "LieFlowReport.h"

#include <utility>

#include <vtkPolyData.h>

#include "FieldArrays.h"

namespace authalic {

MapReport describeLieFlow(const LieFlowSolution& flow, vtkPolyData* map) {
  MapReport report;
  report.method = "lie-flow";
  report.status = flow.status;
  report.iterations = flow.iterations;
  for (const LieFlowIteration& step : flow.history) report.residuals.push_back(step.residual);
  report.residuals.push_back(flow.residual);
  report.seconds = {{"start", flow.startSeconds},
                    {"flow", flow.flowSeconds},
                    {"unfold", flow.unfoldSeconds},
                    {"finish", flow.finishSeconds}};
  report.more.set("residual", flow.residual);
  report.more.set("balanced_start", flow.balancedStart);
  report.more.set("finish_iterations", flow.finishIterations);
  report.more.set("flipped_before_finish", flow.flippedBeforeFinish);
  report.more.set("flow_undone", flow.flowUndone);
  report.more.set("edge_flips", flow.edgeFlips);
  report.more.set("collapsed", flow.collapsed);
  addField(map, "FinishIterations", flow.finishIterations);
  addField(map, "FlippedBeforeFinish", flow.flippedBeforeFinish);
  addField(map, "EdgeFlips", flow.edgeFlips);
  return report;
}

void addLieFlowOptions(Json& options, const DiscreteLieFlowOptions& values) {
  static const char* const finishes[] = {"none", "unfold", "match"};
  options.set("tolerance", values.tolerance);
  options.set("max_iterations", values.maxIterations);
  options.set("flow_tolerance", values.flowTolerance);
  options.set("step_ratio", values.stepRatio);
  options.set("fixed_step", values.fixedStep);
  options.set("finish", finishes[static_cast<int>(values.finish)]);
  options.set("max_finish_iterations", values.maxFinishIterations);
}

MapReport describeLieAdvection(const LieAdvectionSolution& advection, vtkPolyData* map) {
  MapReport report;
  report.method = "lie-advection";
  report.status = advection.status;
  report.iterations = advection.iterations;
  for (const LieFlowIteration& step : advection.history) report.residuals.push_back(step.residual);
  report.residuals.push_back(advection.residual);
  report.seconds = {{"start", advection.startSeconds},
                    {"advection", advection.advectionSeconds},
                    {"unfold", advection.unfoldSeconds}};
  const std::pair<const char*, int> numbers[] = {{"ShortenedSteps", advection.shortenedSteps},
                                                 {"FlippedBeforeUnfolding", advection.flippedBeforeUnfolding},
                                                 {"EdgeFlips", advection.edgeFlips}};
  for (const auto& [name, value] : numbers) addField(map, name, value);
  report.more.set("residual", advection.residual);
  report.more.set("slowed_vertices", advection.slowedVertices);
  report.more.set("shortened_steps", advection.shortenedSteps);
  report.more.set("flipped_before_unfolding", advection.flippedBeforeUnfolding);
  report.more.set("edge_flips", advection.edgeFlips);
  return report;
}

}  // namespace authalic
