#include "vtkRegionDensity.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include "Conversion.h"
#include "Core/base/Error.h"
#include "FieldArrays.h"
#include "MapArrays.h"
#include "RegionArrays.h"

vtkStandardNewMacro(vtkRegionDensity);

namespace {

const char* const kDensity = "RegionDensity";
constexpr vtkIdType kNamesShown = 12;

/// The value of a label by its name in the table that came with the array.
double valueOf(vtkPolyData* surface, const std::string& array, const std::string& name) {
  vtkFieldData* fields = surface->GetFieldData();
  auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray((array + "Names").c_str()));
  vtkDataArray* ids = fields->GetArray((array + "Ids").c_str());
  if (!names || !ids || ids->GetNumberOfTuples() != names->GetNumberOfValues()) {
    throw authalic::InvalidArgument("A table of region names is required to find '" + name + "', but the array '" +
                                    array + "' has none; give its value as a number.");
  }
  std::string some;
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i) {
    if (names->GetValue(i) == name) return ids->GetComponent(i, 0);
    if (i < kNamesShown) some += (i > 0 ? ", " : "") + names->GetValue(i);
  }
  const vtkIdType more = names->GetNumberOfValues() - kNamesShown;
  throw authalic::InvalidArgument("The name of a region of '" + array + "' is required, but '" + name +
                                  "' is none; there are: " + some +
                                  (more > 0 ? " and " + std::to_string(more) + " more." : "."));
}

std::vector<char> insideByArray(vtkPolyData* surface, const std::string& array, const std::vector<double>& values) {
  vtkDataArray* labels = authalic::requireArray(surface->GetPointData(), array, 1, "region");
  std::vector<char> inside(static_cast<std::size_t>(labels->GetNumberOfTuples()));
  for (std::size_t v = 0; v < inside.size(); ++v) {
    const double label = labels->GetComponent(static_cast<vtkIdType>(v), 0);
    const auto same = [&](double value) { return static_cast<float>(value) == static_cast<float>(label); };
    inside[v] = values.empty() ? label != 0 : std::any_of(values.begin(), values.end(), same);
  }
  return inside;
}

std::string textOf(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

/// The density per face that a measure means, as targetMeasureOf() would take it; empty for none.
Eigen::VectorXd baseDensity(vtkPolyData* input, const authalic::TriangleMesh& mesh, const std::string& name) {
  if (name.empty()) return {};
  if (!input->GetPointData()->HasArray(name.c_str()) && input->GetCellData()->HasArray(name.c_str())) {
    return authalic::toVector(authalic::requireArray(input->GetCellData(), name, 1, "measure"));
  }
  static_cast<void>(authalic::targetMeasureOf(input, mesh, name));  // refuses what cannot be a measure
  return authalic::meanOfCorners(mesh, authalic::toVector(input->GetPointData()->GetArray(name.c_str())));
}

}  // namespace

void vtkRegionDensity::AddRegionValue(double value) {
  this->RegionValues.push_back(value);
  this->Modified();
}

void vtkRegionDensity::ClearRegionValues() {
  this->RegionValues.clear();
  this->Modified();
}

void vtkRegionDensity::AddRegionName(const char* name) {
  if (!name || !*name) return;
  this->RegionNames.emplace_back(name);
  this->Modified();
}

void vtkRegionDensity::ClearRegionNames() {
  this->RegionNames.clear();
  this->Modified();
}

std::string vtkRegionDensity::Label() const {
  if (!this->RegionLabel.empty()) return this->RegionLabel;
  if (this->RegionMode != ARRAY) {
    return std::string(this->RegionMode == BALL ? "sphere:" : "geodesic:") + textOf(this->Centre[0]) + "," +
           textOf(this->Centre[1]) + "," + textOf(this->Centre[2]) + "," + textOf(this->Radius);
  }
  std::string label = this->RegionArrayName;
  std::string separator = ":";
  for (const std::string& name : this->RegionNames) label += std::exchange(separator, "+") + name;
  for (const double value : this->RegionValues) label += std::exchange(separator, "+") + textOf(value);
  return label;
}

std::vector<char> vtkRegionDensity::Inside(vtkPolyData* input, const authalic::TriangleMesh& mesh) const {
  const Eigen::Vector3d centre(this->Centre[0], this->Centre[1], this->Centre[2]);
  if (this->RegionMode == BALL) return authalic::ballOnSurface(mesh, centre, this->Radius);
  if (this->RegionMode == GEODESIC_BALL) return authalic::geodesicBallOnSurface(mesh, centre, this->Radius);
  if (this->RegionArrayName.empty()) {
    throw authalic::InvalidArgument("A point array that marks the region is required; set RegionArrayName.");
  }
  std::vector<double> values = this->RegionValues;
  for (const std::string& name : this->RegionNames) values.push_back(valueOf(input, this->RegionArrayName, name));
  return insideByArray(input, this->RegionArrayName, values);
}

void vtkRegionDensity::Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
                               const authalic::Execution&) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const authalic::TriangleMesh mesh = authalic::toTriangleMesh(input);
  std::vector<authalic::RegionOfInterest> regions = authalic::regionsOf(input);
  const bool own = !this->MeasureArrayName.empty() && this->MeasureArrayName != kDensity;
  const std::string measure = own ? this->MeasureArrayName : authalic::textField(input, "RegionMeasure");
  regions.push_back({this->Label(), this->Inside(input, mesh), this->Factor, this->Blend});
  const authalic::RegionsOfInterestDensity density =
      authalic::densityOfRegions(mesh, baseDensity(input, mesh, measure), regions);
  output->ShallowCopy(input);
  authalic::setRegionsOfInterest(output, regions);
  authalic::addArray(output->GetCellData(), kDensity, density.faces);
  const auto shares = [&](const char* name, const Eigen::VectorXd& values) {
    authalic::addField(output, name, std::vector<double>(values.data(), values.data() + values.size()));
  };
  shares("RegionSourceShares", density.sourceShares);
  shares("RegionTargetShares", density.targetShares);
  if (!measure.empty()) authalic::addField(output, "RegionMeasure", measure);
}

void vtkRegionDensity::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Region: " << this->Label() << "\n";
  os << indent << "RegionMode: " << this->RegionMode << "\n";
  os << indent << "RegionArrayName: " << this->RegionArrayName << "\n";
  os << indent << "Centre: " << this->Centre[0] << " " << this->Centre[1] << " " << this->Centre[2] << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Factor: " << this->Factor << "\n";
  os << indent << "Blend: " << this->Blend << "\n";
  os << indent << "MeasureArrayName: " << this->MeasureArrayName << "\n";
}
