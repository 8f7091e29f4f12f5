/// @file
/// Area-weighted statistics of surface fields per element and per label region.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "Core/mesh/TriangleMesh.h"
#include "Core/sampling/ElementGrid.h"
#include "Core/statistics/WeightedStatistics.h"

namespace authalic {

/// One number per vertex.
struct SurfaceField {
  std::string name;
  std::vector<double> values;    ///< n; NaN = n/a
  std::vector<double> coverage;  ///< n, in [0, 1], or empty: 1 wherever there is a value
  std::string units;             ///< "" = unknown
  std::string description;
};

/// A region of an atlas.
struct RegionName {
  int id = 0;
  std::string name;
};

/// One label per vertex. Labels that `regions` does not name mean "unlabelled".
struct SurfaceLabels {
  std::vector<int> labels;          ///< n
  std::vector<RegionName> regions;  ///< ids without repeats
};

/// Statistics of one field over one element or region.
struct FieldStatistics : WeightedStatistics {
  double coverage = 0.0;  ///< area-weighted mean of the vertices' coverage, 0 where a vertex has no value
};

struct ElementRow {
  int id = 0;  ///< index in the grid + 1, so that 0 can mean "no element" in label files
  int i = 0, j = 0;
  double uMin = 0, uMax = 0, vMin = 0, vMax = 0;
  Eigen::Vector3d centroid{0, 0, 0};  ///< area-weighted, RAS mm; need not lie on the surface
  int vertices = 0;                   ///< vertices that carry weight in the element
  double area = 0.0;                  ///< mm²
  double areaRatio = 0.0;             ///< area / target area
  bool interior = false;
  /// Index into the regions of the named label with the largest area (ties: the first); −1 = none.
  int majority = -1;
  double majorityFraction = std::numeric_limits<double>::quiet_NaN();  ///< its share of the element's area
  std::vector<FieldStatistics> fields;
};

struct RegionRow {
  int id = 0;
  std::string name;
  Eigen::Vector3d centroid{0, 0, 0};  ///< area-weighted mean of its vertices, RAS mm; NaN without vertices
  int vertices = 0;
  double area = 0.0;      ///< mm²
  double fraction = 0.0;  ///< of the surface area
  std::vector<FieldStatistics> fields;
};

struct ElementTable {
  std::vector<ElementRow> rows;
  std::vector<RegionName> regions;
  std::vector<SurfaceField> fields;  ///< names, units and descriptions; values and coverage are left empty
};

struct RegionTable {
  std::vector<RegionRow> rows;
  std::vector<SurfaceField> fields;  ///< as in ElementTable
};

/// Statistics of every field over every element.
///
/// A vertex weighs in an element by the integral of its hat function over the element (vertexWeights), so
/// that the mean is the exact mean of the piecewise linear field, whatever the density of the mesh. Vertices
/// that are n/a are left out and lower the coverage; an element without any valid vertex has n = 0 and n/a
/// throughout. See WeightedStatistics for the definitions of sd and median.
///
/// @throws GeometryError when a field or the labels do not have one value per vertex, or the grid is of
///         another mesh.
/// @throws InvalidArgument when a region id or a field name is repeated, or a coverage lies outside [0, 1].
[[nodiscard]] ElementTable elementTable(const TriangleMesh& surface, const ElementGrid& grid,
                                        const std::vector<SurfaceField>& fields,
                                        const SurfaceLabels& labels = {});

/// The same over the regions of an atlas: a vertex belongs to the region of its label with a third of the
/// area of each of its faces. Rows are in the order of `labels.regions`; a region that does not occur has
/// area 0 and n/a.
[[nodiscard]] RegionTable regionTable(const TriangleMesh& surface, const SurfaceLabels& labels,
                                      const std::vector<SurfaceField>& fields);

}  // namespace authalic
