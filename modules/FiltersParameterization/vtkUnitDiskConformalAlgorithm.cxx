#include "vtkUnitDiskConformalAlgorithm.h"

#include "Core/conformal/DiskNormalisation.h"
#include "Reports/Json.h"

static_assert(static_cast<int>(authalic::DiskCentre::Face) == vtkUnitDiskConformalAlgorithm::FACE);

authalic::DiskNormalisation vtkUnitDiskConformalAlgorithm::Normalisation() const {
  return {static_cast<authalic::DiskCentre>(this->Centre), this->CentreId, this->StartVertex};
}

authalic::Json vtkUnitDiskConformalAlgorithm::DescribeDisk(const char* domain) const {
  authalic::Json options = this->DescribeFlow(domain);
  options.set("centre", authalic::diskCentreName(static_cast<authalic::DiskCentre>(this->Centre)));
  if (this->Centre != AREA_CENTROID) options.set("centre_id", this->CentreId);
  return options.set("start_vertex", this->StartVertex).set("refine", this->Refine);
}

void vtkUnitDiskConformalAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Centre: " << this->Centre << "\n";
  os << indent << "CentreId: " << this->CentreId << "\n";
  os << indent << "StartVertex: " << this->StartVertex << "\n";
  os << indent << "Refine: " << (this->Refine ? "On" : "Off") << "\n";
}
