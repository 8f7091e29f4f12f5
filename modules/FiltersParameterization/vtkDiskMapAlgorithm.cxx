#include "vtkDiskMapAlgorithm.h"

#include <vtkPolyData.h>

#include "Core/geometry/PlanarDomain.h"
#include "FieldArrays.h"
#include "FilterGuard.h"
#include "Reports/MapReport.h"

void vtkDiskMapAlgorithm::AddPolygonCorner(double x, double y) {
  this->PolygonCorners.insert(this->PolygonCorners.end(), {x, y});
  this->Modified();
}

void vtkDiskMapAlgorithm::ClearPolygonCorners() {
  this->PolygonCorners.clear();
  this->Modified();
}

authalic::PlanarDomain vtkDiskMapAlgorithm::MakeDomain() const {
  using authalic::PlanarDomain;
  switch (this->Domain) {
    case SQUARE: return PlanarDomain::square();
    case RECTANGLE: return PlanarDomain::rectangle(this->Aspect);
    case POLYGON:
      return PlanarDomain::polygon(Eigen::Map<const authalic::Points2>(this->PolygonCorners.data(),
                                                                       this->GetNumberOfPolygonCorners(), 2));
    default: return PlanarDomain::disk();
  }
}

authalic::Json vtkDiskMapAlgorithm::DescribeOptions() const {
  using authalic::Json;
  static const char* const names[] = {"disk", "square", "rectangle", "polygon"};
  Json options = Json::object();
  options.set("domain", names[this->Domain]);
  if (this->Domain == RECTANGLE) options.set("aspect", this->Aspect);
  if (this->Domain == POLYGON) options.set("corners", Json::arrayOf(this->PolygonCorners));
  options.set("measure", this->MeasureArrayName);
  return options;
}

void vtkDiskMapAlgorithm::Publish(vtkPolyData* map, const authalic::MapReport& report) {
  authalic::addField(map, "Method", report.method);
  authalic::addField(map, "Residuals", report.residuals);
  this->Report = authalic::mapReport(report).text();
  this->ErrorKind = authalic::reportStatus(this, map, report.status, report.iterations);
}

std::string vtkDiskMapAlgorithm::GetStatus() { return authalic::textField(this->GetOutput(), "Status"); }

int vtkDiskMapAlgorithm::GetIterations() {
  return static_cast<int>(authalic::numberField(this->GetOutput(), "Iterations"));
}

double vtkDiskMapAlgorithm::GetTotalAreaDistortion() {
  return authalic::numberField(this->GetOutput(), "TotalAreaDistortion");
}

double vtkDiskMapAlgorithm::GetTotalAngleDistortion() {
  return authalic::numberField(this->GetOutput(), "TotalAngleDistortion");
}

int vtkDiskMapAlgorithm::GetFlippedFaces() {
  return static_cast<int>(authalic::numberField(this->GetOutput(), "FlippedFaces"));
}

void vtkDiskMapAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Domain: " << this->Domain << "\n";
  os << indent << "Aspect: " << this->Aspect << "\n";
  os << indent << "PolygonCorners: " << this->GetNumberOfPolygonCorners() << "\n";
  os << indent << "MeasureArrayName: " << this->MeasureArrayName << "\n";
}
