/// @file
/// Conformal maps that others start from. Private to FiltersParameterization/.
#pragma once

#include "Core/base/Execution.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/mesh/SphereMesh.h"

namespace authalic {

/// The Riemann map to the unit disk.
/// @param use     what needs it, for the message: "a balance below 1"
/// @param isDisk  whether the domain is the disk
/// @throws InvalidArgument when it is not; GeometryError when faces are folded and may not; CancelledError
[[nodiscard]] Points2 conformalImage(const DiskMesh& disk, bool isDisk, const char* use, bool foldsAllowed,
                                     const Execution& execution);

/// The conformal map to the unit sphere with its defaults.
/// @throws GeometryError when faces are folded; CancelledError
[[nodiscard]] Points3 conformalImage(const SphereMesh& sphere, const char* use, const Execution& execution);

}  // namespace authalic
