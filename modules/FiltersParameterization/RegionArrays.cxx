#include "RegionArrays.h"

#include <cmath>

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include "Core/geometry/Areas.h"
#include "FieldArrays.h"

namespace authalic {
namespace {

const char* const kFlags = "RegionsOfInterest";

std::vector<double> numbers(vtkPolyData* surface, const std::string& name) {
  const Eigen::MatrixXd values = matrixField(surface, name);
  return {values.data(), values.data() + values.size()};
}

}  // namespace

std::vector<RegionOfInterest> regionsOf(vtkPolyData* surface) {
  auto* names = vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray("RegionNames"));
  vtkDataArray* flags = surface->GetPointData()->GetArray(kFlags);
  const std::vector<double> factors = numbers(surface, "RegionFactors"), blends = numbers(surface, "RegionBlends");
  std::vector<RegionOfInterest> regions;
  if (!names || !flags || flags->GetNumberOfComponents() != names->GetNumberOfValues() ||
      factors.size() != static_cast<std::size_t>(names->GetNumberOfValues()) || blends.size() != factors.size()) {
    return regions;
  }
  for (int r = 0; r < flags->GetNumberOfComponents(); ++r) {
    const auto index = static_cast<std::size_t>(r);
    RegionOfInterest region{names->GetValue(r), {}, factors[index], blends[index]};
    for (vtkIdType v = 0; v < flags->GetNumberOfTuples(); ++v) region.inside.push_back(flags->GetComponent(v, r) != 0);
    regions.push_back(std::move(region));
  }
  return regions;
}

void setRegionsOfInterest(vtkPolyData* surface, const std::vector<RegionOfInterest>& regions) {
  vtkNew<vtkStringArray> names;
  vtkNew<vtkUnsignedCharArray> flags;
  names->SetName("RegionNames");
  flags->SetName(kFlags);
  flags->SetNumberOfComponents(static_cast<int>(regions.size()));
  flags->SetNumberOfTuples(surface->GetNumberOfPoints());
  std::vector<double> factors, blends;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    names->InsertNextValue(regions[r].name);
    factors.push_back(regions[r].factor);
    blends.push_back(regions[r].blend);
    for (std::size_t v = 0; v < regions[r].inside.size(); ++v) {
      flags->SetComponent(static_cast<vtkIdType>(v), static_cast<int>(r), regions[r].inside[v]);
    }
  }
  surface->GetFieldData()->AddArray(names);
  surface->GetPointData()->AddArray(flags);
  addField(surface, "RegionFactors", factors);
  addField(surface, "RegionBlends", blends);
}

void addRegionShares(vtkPolyData* map, const TriangleMesh& surface, const DistortionArrays& distortion,
                     const Eigen::VectorXd& target) {
  const std::vector<RegionOfInterest> regions = regionsOf(map);
  if (regions.empty() || regions.front().inside.size() != static_cast<std::size_t>(surface.vertexCount())) return;
  const Eigen::VectorXd areas = faceAreas(surface) / faceAreas(surface).sum();
  const Eigen::VectorXd wanted = target.size() > 0 ? (target / target.sum()).eval() : areas;
  const Eigen::VectorXd stars = vertexStars(wanted, surface.faces(), surface.vertexCount());
  Eigen::VectorXd image = stars.array() * distortion.vertexLogAreaRatio.array().exp();
  image = image.array().isFinite().select(image, 0);  // vertices without a target
  std::vector<double> sources, targets, images;
  for (const RegionOfInterest& region : regions) {
    sources.push_back(regionMeasure(areas, surface.faces(), region.inside));
    targets.push_back(regionMeasure(wanted, surface.faces(), region.inside));
    double inside = 0;
    for (Eigen::Index v = 0; v < image.size(); ++v) inside += region.inside[static_cast<std::size_t>(v)] ? image[v] : 0;
    images.push_back(inside / image.sum());
  }
  addField(map, "RegionSourceShares", sources);
  addField(map, "RegionTargetShares", targets);
  addField(map, "RegionImageShares", images);
}

std::optional<Json> regionsReport(vtkPolyData* map) {
  Json list = Json::array();
  const std::vector<double> sources = numbers(map, "RegionSourceShares"), targets = numbers(map, "RegionTargetShares"),
                            images = numbers(map, "RegionImageShares");
  const std::vector<RegionOfInterest> regions = regionsOf(map);
  if (regions.empty() || images.size() != regions.size()) return std::nullopt;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    list.add(Json::object()
                 .set("name", regions[r].name)
                 .set("factor", regions[r].factor)
                 .set("blend_mm", regions[r].blend)
                 .set("source_share", sources[r])
                 .set("target_share", targets[r])
                 .set("image_share", images[r]));
  }
  return list;
}

}  // namespace authalic
