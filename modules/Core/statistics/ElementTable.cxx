#include "Core/statistics/ElementTable.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "Core/base/Error.h"

namespace authalic {

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

void requireCoverage(const SurfaceField& field) {
  for (std::size_t v = 0; v < field.coverage.size(); ++v) {
    if (!(field.coverage[v] >= 0.0 && field.coverage[v] <= 1.0)) {
      throw InvalidArgument("A coverage from 0 to 1 is required, but field '" + field.name + "' has " +
                            std::to_string(field.coverage[v]) + " at vertex " + std::to_string(v) + ".");
    }
  }
}

void requireFields(const TriangleMesh& surface, const std::vector<SurfaceField>& fields) {
  const auto n = static_cast<std::size_t>(surface.vertexCount());
  std::set<std::string> names;
  for (const SurfaceField& field : fields) {
    if (field.values.size() != n || (!field.coverage.empty() && field.coverage.size() != n)) {
      throw GeometryError("One value per vertex is required, but field '" + field.name + "' has " +
                          std::to_string(field.values.size()) + " values and " +
                          std::to_string(field.coverage.size()) + " coverages for " + std::to_string(n) +
                          " vertices; use the field of this surface.");
    }
    if (!names.insert(field.name).second) {
      throw InvalidArgument("Different field names are required, but '" + field.name +
                            "' is given twice; rename one of them.");
    }
    requireCoverage(field);
  }
}

void requireLabels(const TriangleMesh& surface, const SurfaceLabels& labels) {
  if (!labels.labels.empty() && labels.labels.size() != static_cast<std::size_t>(surface.vertexCount())) {
    throw GeometryError("One label per vertex is required, but there are " +
                        std::to_string(labels.labels.size()) + " for " +
                        std::to_string(surface.vertexCount()) + " vertices; use the labels of this surface.");
  }
  std::set<int> ids;
  for (const RegionName& region : labels.regions) {
    if (!ids.insert(region.id).second) {
      throw InvalidArgument("Different region ids are required, but " + std::to_string(region.id) + " ('" +
                            region.name + "') is given twice; correct the label table.");
    }
  }
}

void requireGridOf(const TriangleMesh& surface, const ElementGrid& grid) {
  if (grid.faceElement.size() != static_cast<std::size_t>(surface.faceCount()) ||
      grid.vertexElement.size() != static_cast<std::size_t>(surface.vertexCount())) {
    throw GeometryError("An element grid of this surface is required, but the grid was made on " +
                        std::to_string(grid.vertexElement.size()) + " vertices and " +
                        std::to_string(grid.faceElement.size()) + " faces and the surface has " +
                        std::to_string(surface.vertexCount()) + " and " +
                        std::to_string(surface.faceCount()) + "; make the grid again.");
  }
}

FieldStatistics statisticsOf(const SurfaceField& field, const std::vector<VertexWeight>& weights) {
  std::vector<WeightedValue> values;
  double covered = 0.0, total = 0.0;
  for (const VertexWeight& weight : weights) {
    const auto v = static_cast<std::size_t>(weight.vertex);
    total += weight.area;
    if (std::isnan(field.values[v])) continue;
    values.push_back({field.values[v], weight.area});
    covered += weight.area * (field.coverage.empty() ? 1.0 : field.coverage[v]);
  }
  FieldStatistics result;
  static_cast<WeightedStatistics&>(result) = weightedStatistics(values);
  result.coverage = total > 0.0 ? std::min(covered / total, 1.0) : 0.0;
  return result;
}

std::vector<FieldStatistics> statisticsOf(const std::vector<SurfaceField>& fields,
                                          const std::vector<VertexWeight>& weights) {
  std::vector<FieldStatistics> result;
  result.reserve(fields.size());
  for (const SurfaceField& field : fields) result.push_back(statisticsOf(field, weights));
  return result;
}

std::vector<SurfaceField> withoutValues(const std::vector<SurfaceField>& fields) {
  std::vector<SurfaceField> result;
  result.reserve(fields.size());
  for (const SurfaceField& field : fields)
    result.push_back({field.name, {}, {}, field.units, field.description});
  return result;
}

/// Index into `regions` of every vertex's label, or −1.
std::vector<int> regionOfVertices(const SurfaceLabels& labels) {
  std::map<int, int> indexOf;
  for (std::size_t r = 0; r < labels.regions.size(); ++r) indexOf[labels.regions[r].id] = static_cast<int>(r);
  std::vector<int> result;
  result.reserve(labels.labels.size());
  for (const int label : labels.labels) {
    const auto found = indexOf.find(label);
    result.push_back(found == indexOf.end() ? -1 : found->second);
  }
  return result;
}

void findMajority(ElementRow& row, const std::vector<VertexWeight>& weights,
                  const std::vector<int>& regions) {
  if (regions.empty()) return;
  std::map<int, double> areas;
  double total = 0.0;
  for (const VertexWeight& weight : weights) {
    total += weight.area;
    const int region = regions[static_cast<std::size_t>(weight.vertex)];
    if (region >= 0) areas[region] += weight.area;
  }
  double most = 0.0;
  for (const auto& [region, area] : areas) {
    if (area <= most) continue;
    most = area;
    row.majority = region;
  }
  if (total > 0.0) row.majorityFraction = std::min(most / total, 1.0);
}

ElementRow elementRow(const Element& element, int index) {
  ElementRow row;
  row.id = index + 1;
  row.i = element.i;
  row.j = element.j;
  row.uMin = element.lower[0];
  row.uMax = element.upper[0];
  row.vMin = element.lower[1];
  row.vMax = element.upper[1];
  row.centroid = element.centroid;
  row.area = element.area;
  row.areaRatio = element.targetArea > 0.0 ? element.area / element.targetArea : kNoValue;
  row.interior = element.interior;
  return row;
}

/// A third of the area of its faces for every vertex.
struct VertexStars {
  std::vector<double> area;
  double total = 0.0;
};

VertexStars vertexStars(const TriangleMesh& surface) {
  VertexStars stars;
  stars.area.assign(static_cast<std::size_t>(surface.vertexCount()), 0.0);
  for (int f = 0; f < surface.faceCount(); ++f) {
    const double area = 0.5 * (surface.corner(f, 1) - surface.corner(f, 0))
                                  .cross(surface.corner(f, 2) - surface.corner(f, 0))
                                  .norm();
    stars.total += area;
    for (int k = 0; k < 3; ++k) stars.area[static_cast<std::size_t>(surface.faces()(f, k))] += area / 3.0;
  }
  return stars;
}

}  // namespace

ElementTable elementTable(const TriangleMesh& surface, const ElementGrid& grid,
                          const std::vector<SurfaceField>& fields, const SurfaceLabels& labels) {
  requireGridOf(surface, grid);
  requireFields(surface, fields);
  requireLabels(surface, labels);
  const std::vector<int> regions = regionOfVertices(labels);
  ElementTable table;
  table.regions = labels.regions;
  table.fields = withoutValues(fields);
  for (std::size_t e = 0; e < grid.elements.size(); ++e) {
    const std::vector<VertexWeight> weights = vertexWeights(surface, grid, static_cast<int>(e));
    ElementRow row = elementRow(grid.elements[e], static_cast<int>(e));
    row.vertices = static_cast<int>(weights.size());
    row.fields = statisticsOf(fields, weights);
    findMajority(row, weights, regions);
    table.rows.push_back(std::move(row));
  }
  return table;
}

RegionTable regionTable(const TriangleMesh& surface, const SurfaceLabels& labels,
                        const std::vector<SurfaceField>& fields) {
  requireFields(surface, fields);
  requireLabels(surface, labels);
  const VertexStars stars = vertexStars(surface);
  const std::vector<int> regionOf = regionOfVertices(labels);
  std::vector<std::vector<VertexWeight>> members(labels.regions.size());
  for (std::size_t v = 0; v < regionOf.size(); ++v) {
    if (regionOf[v] < 0 || !(stars.area[v] > 0.0)) continue;
    members[static_cast<std::size_t>(regionOf[v])].push_back({static_cast<int>(v), stars.area[v]});
  }
  RegionTable table;
  table.fields = withoutValues(fields);
  for (std::size_t r = 0; r < members.size(); ++r) {
    RegionRow row;
    row.id = labels.regions[r].id;
    row.name = labels.regions[r].name;
    row.vertices = static_cast<int>(members[r].size());
    for (const VertexWeight& weight : members[r]) {
      row.area += weight.area;
      row.centroid += weight.area * surface.point(weight.vertex);
    }
    row.centroid =
        row.area > 0.0 ? Eigen::Vector3d(row.centroid / row.area) : Eigen::Vector3d::Constant(kNoValue);
    row.fraction = stars.total > 0.0 ? row.area / stars.total : 0.0;
    row.fields = statisticsOf(fields, members[r]);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace authalic
