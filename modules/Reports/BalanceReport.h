/// @file
/// The curve of balanced maps as a table.
#pragma once

#include "Core/authalic/BalanceCurve.h"
#include "Reports/Json.h"
#include "Reports/Table.h"

namespace authalic {

/// One row per balance: balance, angle_distortion, area_distortion, angle_error_mean_degrees, flipped_faces; the same
/// four of the map before its finish with transport_ in front; status.
[[nodiscard]] Table balanceTable(const BalanceCurve& curve);

/// What stands beside the table: Curve, with version, status, seconds (conformal, maps: one per row, total) and
/// options, and a description of every column. Only the seconds differ between two runs on the same input.
[[nodiscard]] Json balanceReport(const BalanceCurve& curve, const Json& options);

}  // namespace authalic
