#include "vtkSurfaceRepair.h"

#include <vtkCellData.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/topology/SurfaceRepair.h"
#include "FieldArrays.h"
#include "Reports/RepairReport.h"

vtkStandardNewMacro(vtkSurfaceRepair);

namespace {

void addChanges(vtkPolyData* output, const authalic::SurfaceRepair& repair) {
  std::vector<double> lengths;
  Eigen::MatrixXd places(repair.count(authalic::RepairKind::Handle), 3);
  for (const authalic::RepairChange& change : repair.changes) {
    if (change.kind != authalic::RepairKind::Handle) continue;
    places.row(static_cast<Eigen::Index>(lengths.size())) = change.place.transpose();
    lengths.push_back(change.size);
  }
  authalic::addField(output, "RepairChanges", static_cast<int>(repair.changes.size()));
  authalic::addField(output, "HandlePlaces", places);
  authalic::addField(output, "HandleLengths", lengths);
  authalic::addField(output, "Status", std::string(authalic::statusName(repair.status)));
}

}  // namespace

vtkSurfaceRepair::vtkSurfaceRepair() {
  const authalic::SurfaceRepairOptions defaults;
  this->SewSeams = defaults.sewSeams;
  this->JunctionTolerance = defaults.junctionTolerance;
  this->StrayShare = defaults.strayShare;
  this->LargestHole = defaults.largestHole;
  this->LargestHandle = defaults.largestHandle;
}

void vtkSurfaceRepair::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                               const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->Summary.clear();
  this->Report.clear();
  authalic::SurfaceRepairOptions options;
  options.sewSeams = this->SewSeams;
  options.junctionTolerance = this->JunctionTolerance;
  options.strayShare = this->StrayShare;
  options.largestHole = this->LargestHole;
  options.largestHandle = this->LargestHandle;
  const authalic::Faces faces = authalic::toTriangles(input);
  const authalic::SurfaceRepair repair =
      authalic::repairSurface(authalic::toPoints(input), faces, options, execution);
  authalic::setMesh(output, repair.mesh);
  authalic::gatherArrays(input->GetPointData(), repair.pointSources, output->GetPointData());
  authalic::gatherArrays(input->GetCellData(), repair.faceSources, output->GetCellData());
  authalic::addIds(output->GetPointData(), "OriginalPointIds", repair.originalPointIds);
  authalic::addIds(output->GetCellData(), "OriginalCellIds", repair.originalFaceIds);
  authalic::passFields(input, output);
  addChanges(output, repair);
  for (const std::string& line : authalic::repairLines(repair)) this->Summary += line + "\n";
  this->Report = authalic::repairReport(repair, options).text();
  if (repair.status == authalic::Status::NotConverged) this->ErrorKind = NOT_CONVERGED;
  const std::string remaining = repair.remaining();
  if (remaining.empty()) return;
  const char* help = repair.after.components.size() > 1 ? "; StrayShare 1 keeps the largest component only" : "";
  vtkWarningMacro(<< "The repaired surface still has " << remaining << help << ".");
}

void vtkSurfaceRepair::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SewSeams: " << (this->SewSeams ? "On" : "Off") << "\n";
  os << indent << "JunctionTolerance: " << this->JunctionTolerance << "\n";
  os << indent << "StrayShare: " << this->StrayShare << "\n";
  os << indent << "LargestHole: " << this->LargestHole << "\n";
  os << indent << "LargestHandle: " << this->LargestHandle << "\n";
  os << indent << "Summary: " << this->Summary << "\n";
}
