#include "vtkDiscreteLieFlow.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/authalic/DiscreteLieFlow.h"
#include "Core/initial/BarycentricMap.h"
#include "Core/mesh/DiskMesh.h"
#include "LieFlowReport.h"
#include "MapArrays.h"

vtkStandardNewMacro(vtkDiscreteLieFlow);

static_assert(static_cast<int>(authalic::BarycentricWeights::MeanValue) == vtkDiscreteLieFlow::MEAN_VALUE);
static_assert(static_cast<int>(authalic::LieFlowFinish::Match) == vtkDiscreteLieFlow::MATCH);

vtkDiscreteLieFlow::vtkDiscreteLieFlow() {
  this->SetNumberOfInputPorts(2);
  const authalic::DiscreteLieFlowOptions defaults;
  this->Tolerance = defaults.tolerance;
  this->MaximumIterations = defaults.maxIterations;
  this->FlowTolerance = defaults.flowTolerance;
  this->StepRatio = defaults.stepRatio;
  this->FixedStep = defaults.fixedStep;
  this->KeepInitial = defaults.keepInitial;
  this->Finish = static_cast<int>(defaults.finish);
  this->MaximumFinishIterations = defaults.maxFinishIterations;
}

int vtkDiscreteLieFlow::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1) info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

authalic::DiscreteLieFlowOptions vtkDiscreteLieFlow::Options() const {
  authalic::DiscreteLieFlowOptions options;
  options.domain = this->MakeDomain();
  options.tolerance = this->Tolerance;
  options.maxIterations = this->MaximumIterations;
  options.flowTolerance = this->FlowTolerance;
  options.stepRatio = this->StepRatio;
  options.fixedStep = this->FixedStep;
  options.keepInitial = this->KeepInitial;
  options.finish = static_cast<authalic::LieFlowFinish>(this->Finish);
  options.maxFinishIterations = this->MaximumFinishIterations;
  options.validate();
  return options;
}

authalic::Json vtkDiscreteLieFlow::DescribeAllOptions(bool initialMapGiven) const {
  authalic::Json options = this->DescribeOptions();
  const auto weights = static_cast<authalic::BarycentricWeights>(this->InitialMethod);
  options.set("initial", initialMapGiven ? "given" : authalic::barycentricWeightsName(weights));
  authalic::addLieFlowOptions(options, this->Options());
  options.set("keep_initial", this->KeepInitial);
  return options;
}

void vtkDiscreteLieFlow::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                 const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::DiscreteLieFlowOptions options = this->Options();
  const authalic::DiskMesh disk(authalic::toTriangleMesh(input));
  const authalic::TargetMeasure target = authalic::targetMeasureOf(input, disk.mesh(), this->MeasureArrayName);
  authalic::BarycentricMapResult initial;
  if (given) {
    initial.image = authalic::toPlanarPoints(given);
  } else {
    authalic::BarycentricMapOptions start;
    start.weights = static_cast<authalic::BarycentricWeights>(this->InitialMethod);
    start.domain = options.domain;
    initial = authalic::barycentricMap(disk, start, execution.part(0.0, 0.1));
  }
  const authalic::DiscreteLieFlowResult flow =
      authalic::discreteLieFlow(disk, initial.image, target, options, execution.part(0.1, 1.0));
  const authalic::Distortion distortion = authalic::fillMap(input, output, disk.mesh(), flow.image, target.shares());
  authalic::MapReport report = authalic::describeLieFlow(flow, output);
  report.seconds.insert(report.seconds.begin(), {"initial", initial.seconds});
  report.metrics = distortion.summary;
  report.topology = authalic::inspect(disk.mesh(), disk.topology());
  report.options = this->DescribeAllOptions(given != nullptr);
  this->Publish(output, report);
}

void vtkDiscreteLieFlow::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InitialMethod: " << this->InitialMethod << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "FlowTolerance: " << this->FlowTolerance << "\n";
  os << indent << "StepRatio: " << this->StepRatio << "\n";
  os << indent << "FixedStep: " << this->FixedStep << "\n";
  os << indent << "KeepInitial: " << this->KeepInitial << "\n";
  os << indent << "Finish: " << this->Finish << "\n";
  os << indent << "MaximumFinishIterations: " << this->MaximumFinishIterations << "\n";
}
