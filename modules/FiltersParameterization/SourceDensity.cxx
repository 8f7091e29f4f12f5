#include "SourceDensity.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "Conversion.h"
#include "Core/base/Error.h"
#include "FieldArrays.h"

namespace authalic {
namespace {

DiskMesh sourceMesh(vtkPolyData* mesh) {
  try {
    return DiskMesh(toTriangleMesh(mesh, "source mesh"));
  } catch (const TopologyError& error) {
    throw TopologyError("Source mesh: " + std::string(error.what()));
  }
}

}  // namespace

std::shared_ptr<const PiecewiseLinearDensity> sourceDensityOf(vtkPolyData* mesh, const std::string& array,
                                                              const PlanarDomain& domain) {
  const DiskMesh disk = sourceMesh(mesh);
  const Eigen::VectorXd values = toVector(requireArray(mesh->GetPointData(), array, 1, "source density"));
  return std::make_shared<const PiecewiseLinearDensity>(domain, disk, values);
}

void describeSource(const PiecewiseLinearDensity& density, MapReport& report, vtkPolyData* map) {
  report.more.set("source_mass", density.total());
  addField(map, "SourceMass", density.total());
}

}  // namespace authalic
