/// @file
/// Element and region statistics as tables.
#pragma once

#include <string>

#include "Core/sampling/ElementGrid.h"
#include "Core/statistics/ElementTable.h"
#include "Reports/Table.h"

namespace authalic {

/// Columns element_id, hemi, u_min, u_max, v_min, v_max, centroid_x_mm, centroid_y_mm, centroid_z_mm,
/// n_vertices, area_mm2, area_ratio, label_majority, label_fraction, grid_i, grid_j, interior; then per field
/// FIELD_n, FIELD_mean, FIELD_sd, FIELD_median, FIELD_min, FIELD_max, FIELD_coverage, FIELD its name in
/// snake_case.
/// @param hemi  "L", "R" or "" (n/a)
/// @throws InvalidArgument when two field names are the same in snake_case.
[[nodiscard]] Table elementReport(const ElementTable& elements, const std::string& hemi);

/// Columns label_id, label_name, hemi, centroid_x_mm, centroid_y_mm, centroid_z_mm, n_vertices, area_mm2,
/// area_fraction; then the columns of each field as above.
[[nodiscard]] Table regionReport(const RegionTable& regions, const std::string& hemi);

/// Columns of the grid and |area / target − 1|: what a report says about how equal the elements are.
[[nodiscard]] Json elementGridReport(const ElementGrid& grid);

}  // namespace authalic
