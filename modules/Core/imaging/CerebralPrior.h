/// @file
/// Where deep structures, the hindbrain and the cerebrum lie for certain, in the coordinates of BrainFrame.
/// Private to imaging/.
///
/// Used where labels are missing or do not name a structure (the AAL atlas names neither ventricles nor
/// brainstem). The regions are simple solids measured on an average brain: prisms and ellipsoids with 3–5 mm
/// of tolerance.
#pragma once

#include <Eigen/Core>

namespace authalic {

/// Between the corpus callosum and the cut through the midbrain, up to 14 mm from the midline, and around the
/// lentiform nucleus and the thalamus: whatever is not white here is to be filled (ventricles, fornix,
/// subcortical grey matter).
[[nodiscard]] bool inDeepFill(const Eigen::Vector3d& frame);

/// Around the insula's white matter, the capsules and the claustrum.
[[nodiscard]] bool inLateralFill(const Eigen::Vector3d& frame);

/// Certainly brainstem or cerebellum: the brainstem's column below the plane through the midbrain, and the
/// cerebellar core.
[[nodiscard]] bool inHindbrainCore(const Eigen::Vector3d& frame);

/// Certainly cerebrum: above the tentorium and the midbrain, or in front of and lateral to the brainstem.
[[nodiscard]] bool inCerebrumCore(const Eigen::Vector3d& frame);

}  // namespace authalic
