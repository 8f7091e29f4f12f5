/// @file
/// The histograms of a map as field data (docs/arrays.md). Private to FiltersParameterization/.
#pragma once

#include <optional>

#include "Core/distortion/Histogram.h"

class vtkDataObject;

namespace authalic {

/// Field arrays VertexAreaHistogram, FaceAreaHistogram, AngleRatioHistogram, AngleErrorHistogram and BeltramiHistogram
/// with three components: lower edge, upper edge and count of each bin; then three more tuples for the values below
/// (lower edge −∞), above (upper edge ∞) and undefined (edges NaN).
void addHistograms(vtkDataObject* map, const DistortionHistograms& histograms);

/// What addHistograms left on the map; nothing when one is missing.
[[nodiscard]] std::optional<DistortionHistograms> histogramsOf(vtkDataObject* map);

}  // namespace authalic
