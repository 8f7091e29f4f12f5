#include "vtkElementStatistics.h"

#include <algorithm>

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include "Conversion.h"
#include "Core/base/Error.h"
#include "FilterGuard.h"
#include "Formats/AtomicFile.h"
#include "GridArrays.h"
#include "Reports/ElementReport.h"
#include "SurfaceFields.h"

vtkStandardNewMacro(vtkElementStatistics);

struct vtkElementStatistics::Tables {
  authalic::Table elements, regions;
  authalic::Json grid;
};

vtkElementStatistics::vtkElementStatistics() { this->SetNumberOfOutputPorts(2); }
vtkElementStatistics::~vtkElementStatistics() = default;

void vtkElementStatistics::AddFieldArray(const std::string& name, const std::string& units,
                                         const std::string& description) {
  this->Fields.push_back({name, units, description});
  this->Modified();
}

void vtkElementStatistics::ClearFieldArrays() {
  this->Fields.clear();
  this->Modified();
}

void vtkElementStatistics::AddRegion(int label, const std::string& name) {
  this->Regions.push_back({label, name});
  this->Modified();
}

void vtkElementStatistics::ClearRegions() {
  this->Regions.clear();
  this->Modified();
}

int vtkElementStatistics::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkElementStatistics::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  this->Results.reset();
  return authalic::runGuarded(this, outputs, this->Threads, this->ErrorKind, [&](const authalic::Execution& execution) {
    this->Compute(inputs, outputs, execution);
  });
}

void vtkElementStatistics::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                                   const authalic::Execution& execution) {
  vtkPolyData* map = vtkPolyData::GetData(inputs[0]);
  const authalic::TriangleMesh surface = authalic::surfaceOfMap(map);
  const authalic::ElementGrid grid =
      authalic::elementGrid(surface, authalic::toPlanarPoints(map), authalic::gridOptionsOf(map), execution);
  std::vector<authalic::SurfaceField> fields;
  std::vector<FieldName> names = this->Fields;
  if (names.empty()) {
    for (const std::string& name : authalic::sampledArrays(map)) names.push_back({name, "", ""});
  }
  for (const FieldName& name : names) {
    fields.push_back(authalic::surfaceField(map, name.Name));
    fields.back().units = name.Units;
    fields.back().description = name.Description;
  }
  authalic::SurfaceLabels labels;
  if (!this->LabelArrayName.empty()) {
    std::vector<authalic::RegionName> regions;
    for (const Region& region : this->Regions) regions.push_back({region.Label, region.Name});
    labels = authalic::surfaceLabels(map, this->LabelArrayName, regions);
  }
  auto tables = std::make_unique<Tables>();
  tables->grid = authalic::elementGridReport(grid);
  tables->elements = authalic::elementReport(authalic::elementTable(surface, grid, fields, labels), this->Hemisphere);
  if (!labels.labels.empty()) {
    tables->regions = authalic::regionReport(authalic::regionTable(surface, labels, fields), this->Hemisphere);
  }
  authalic::setTable(vtkTable::GetData(outputs, 0), tables->elements);
  authalic::setTable(vtkTable::GetData(outputs, 1), tables->regions);
  this->Results = std::move(tables);
}

bool vtkElementStatistics::WriteElements(const std::string& tsvPath) { return this->Write(tsvPath, false); }
bool vtkElementStatistics::WriteRegions(const std::string& tsvPath) { return this->Write(tsvPath, true); }

bool vtkElementStatistics::Write(const std::string& tsvPath, bool regions) {
  return authalic::runGuarded(this, nullptr, this->Threads, this->ErrorKind, [&](const authalic::Execution&) {
    if (!this->Results) throw authalic::InvalidArgument("There is no table to write; Update() must succeed first.");
    const authalic::Table& table = regions ? this->Results->regions : this->Results->elements;
    authalic::Json about = authalic::Json::object();
    about.set("Grid", this->Results->grid);
    const std::size_t dot = tsvPath.rfind('.'), slash = tsvPath.rfind('/');
    const bool hasEnding = dot != std::string::npos && (slash == std::string::npos || dot > slash);
    authalic::writeFileAtomically(tsvPath, table.tsv());
    authalic::writeFileAtomically((hasEnding ? tsvPath.substr(0, dot) : tsvPath) + ".json",
                                  table.sidecar(about).text());
  }) != 0;
}

void vtkElementStatistics::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fields:";
  for (const FieldName& field : this->Fields) os << " " << field.Name;
  os << "\n" << indent << "LabelArrayName: " << this->LabelArrayName << "\n";
  os << indent << "Regions: " << this->Regions.size() << "\n";
  os << indent << "Hemisphere: " << this->Hemisphere << "\n";
  os << indent << "Threads: " << this->Threads << "\n";
  os << indent << "ErrorKind: " << this->ErrorKind << "\n";
}
