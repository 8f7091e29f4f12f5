#include "vtkDiskMapAlgorithm.h"

#include "Core/geometry/PlanarDomain.h"
#include "Reports/Json.h"

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

void vtkDiskMapAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Domain: " << this->Domain << "\n";
  os << indent << "Aspect: " << this->Aspect << "\n";
  os << indent << "PolygonCorners: " << this->GetNumberOfPolygonCorners() << "\n";
}
