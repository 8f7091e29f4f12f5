/// @file
/// Where the exact area solve starts after a transport.
#pragma once

#include "Core/authalic/TargetMeasure.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/mesh/SphereMesh.h"

namespace authalic {

/// The image of a transport, or its sites where no face of theirs is folded and every star has its target already
/// (max |ln r_v| ≤ 1e-10), as at balance 0: moving vertices to the middles of their cells would only disturb them.
/// @param moved  n×2, by transport
/// @param sites  n×2, before it, as they were given: rounded again, small stars would not be exact; or empty
[[nodiscard]] const Points2& finishStart(const DiskMesh& disk, const TargetMeasure& target, const Points2& moved,
                                         const Points2& sites);

/// The same on the sphere: n×3.
[[nodiscard]] const Points3& finishStart(const SphereMesh& sphere, const TargetMeasure& target, const Points3& moved,
                                         const Points3& sites);

}  // namespace authalic
