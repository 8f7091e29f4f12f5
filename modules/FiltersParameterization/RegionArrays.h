/// @file
/// Regions of interest as arrays: what vtkRegionDensity leaves and maps report on. Private to FiltersParameterization/.
#pragma once

#include <optional>
#include <vector>

#include "Core/authalic/RegionsOfInterest.h"
#include "Core/distortion/Distortion.h"
#include "Reports/Json.h"

class vtkPolyData;

namespace authalic {

/// The regions that the field data RegionNames, RegionFactors, RegionBlends and the point array RegionsOfInterest of a
/// surface say; none when one of them is not there or does not fit.
[[nodiscard]] std::vector<RegionOfInterest> regionsOf(vtkPolyData* surface);

/// Writes those arrays.
void setRegionsOfInterest(vtkPolyData* surface, const std::vector<RegionOfInterest>& regions);

/// For a map whose surface has regions: field data RegionSourceShares, RegionTargetShares and RegionImageShares.
/// @param target  m target measures, or empty for the surface areas
void addRegionShares(vtkPolyData* map, const TriangleMesh& surface, const DistortionArrays& distortion,
                     const Eigen::VectorXd& target);

/// [{name, factor, blend_mm, source_share, target_share, image_share}] of a map that has regions.
[[nodiscard]] std::optional<Json> regionsReport(vtkPolyData* map);

}  // namespace authalic
