#include "vtkCutToDisk.h"

#include <algorithm>

#include <vtkCellData.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/topology/CutToDisk.h"
#include "FieldArrays.h"

vtkStandardNewMacro(vtkCutToDisk);

vtkCutToDisk::vtkCutToDisk() {
  const authalic::CutToDiskOptions defaults;
  this->LargestRegionOnly = defaults.largestRegionOnly;
  this->LoopSmoothing = defaults.loopSmoothing;
}

void vtkCutToDisk::AddRegionValue(int value) {
  this->RegionValues.push_back(value);
  this->Modified();
}

void vtkCutToDisk::ClearRegionValues() {
  this->RegionValues.clear();
  this->Modified();
}

std::vector<char> vtkCutToDisk::MarkedByArray(vtkPolyData* input) const {
  const std::vector<int> labels =
      authalic::toIntegers(authalic::requireArray(input->GetPointData(), this->RegionArrayName, 1, "region"));
  const auto inRegion = [this](int label) {
    if (this->RegionValues.empty()) return label != 0;
    return std::find(this->RegionValues.begin(), this->RegionValues.end(), label) != this->RegionValues.end();
  };
  std::vector<char> marked(labels.size());
  std::transform(labels.begin(), labels.end(), marked.begin(),
                 [&](int label) { return static_cast<char>(inRegion(label) != this->KeepRegion); });
  return marked;
}

void vtkCutToDisk::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                           const authalic::Execution& execution) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::TriangleMesh surface = authalic::toTriangleMesh(input);
  const std::vector<char> remove =
      this->RegionMode == ARRAY ? this->MarkedByArray(input)
                                : authalic::verticesBeyondPlane(surface, Eigen::Vector3d(this->PlaneOrigin),
                                                                Eigen::Vector3d(this->PlaneNormal));
  authalic::CutToDiskOptions options;
  options.largestRegionOnly = this->LargestRegionOnly;
  options.loopSmoothing = this->LoopSmoothing;
  const authalic::CutToDiskResult cut = authalic::cutToDisk(surface, remove, options, execution);
  authalic::setMesh(output, cut.mesh);
  authalic::gatherArrays(input->GetPointData(), cut.originalPointIds, output->GetPointData());
  authalic::gatherArrays(input->GetCellData(), cut.originalFaceIds, output->GetCellData());
  authalic::addIds(output->GetPointData(), "OriginalPointIds", cut.originalPointIds);
  authalic::addIds(output->GetCellData(), "OriginalCellIds", cut.originalFaceIds);
  authalic::passFields(input, output);
  authalic::addField(output, "RemovedArea", cut.removedArea);
  authalic::addField(output, "KeptArea", cut.keptArea);
  authalic::addField(output, "LoopLength", cut.loopLength);
  authalic::addField(output, "RemovedRegions", cut.removedRegions);
  authalic::addField(output, "IgnoredRegions", cut.ignoredRegions);
  authalic::addField(output, "FilledIslands", cut.filledIslands);
}

void vtkCutToDisk::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RegionMode: " << (this->RegionMode == ARRAY ? "Array" : "Plane") << "\n";
  os << indent << "RegionArrayName: " << this->RegionArrayName << "\n";
  os << indent << "RegionValues:";
  for (const int value : this->RegionValues) os << " " << value;
  os << "\n";
  os << indent << "KeepRegion: " << (this->KeepRegion ? "On" : "Off") << "\n";
  os << indent << "PlaneOrigin: " << this->PlaneOrigin[0] << " " << this->PlaneOrigin[1] << " "
     << this->PlaneOrigin[2] << "\n";
  os << indent << "PlaneNormal: " << this->PlaneNormal[0] << " " << this->PlaneNormal[1] << " "
     << this->PlaneNormal[2] << "\n";
  os << indent << "LargestRegionOnly: " << (this->LargestRegionOnly ? "On" : "Off") << "\n";
  os << indent << "LoopSmoothing: " << this->LoopSmoothing << "\n";
}
