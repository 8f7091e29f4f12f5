/// @file
/// Patches around the few faces that hold up all others: folded, much too small, or far off. Private to authalic/.
#pragma once

#include "Core/authalic/AreaFunctional.h"
#include "Core/authalic/FaceMatch.h"
#include "Core/authalic/Patches.h"
#include "Core/authalic/TargetMeasure.h"
#include "Core/initial/Unfold.h"
#include "Core/mesh/DiskMesh.h"
#include "Core/mesh/SphereMesh.h"
#include "Core/numerics/SparseSolver.h"

namespace authalic {

/// Shares of its target below which a face is opened, and which it has then in its patch.
struct Narrowness {
  double narrow = 0.1, open = 0.3;
};

/// For starts that are far from their targets, as those of long limbs on the sphere and of surfaces with holes are:
/// nothing is wrong with a tenth there.
inline constexpr Narrowness kCollapsing{0.01, 0.03};

/// A start without folds and without faces that are much too small, from one with few of both.
///
/// Behind a neck of a few edges, or in needles, a harmonic map folds faces or leaves them 1e-3 of their share and less.
/// They are few, but every step of a match of all faces ends where the first of them would collapse. In a patch of a
/// few rings around them such steps cost next to nothing, and only the patch waits for them: what is strongly
/// nonlinear is eliminated before the global steps begin @cite cai2002.
///
/// Collapsed faces are revived (reviveCollapsedFaces) and folded ones unfolded; what unfolding has left collapsed is
/// revived again. Where no fold is left, areas are then matched in patches of 4, 8 and 16 rings around the faces that
/// have less than a tenth of their share, the rest held: FaceMatch brings the faces of a patch to their part of the
/// area that the patch has. A patch ends when each of its faces has a third of that, or when nothing moves.
/// @param image  n×2
/// @return the image and its folds; they are left only where unfold() leaves some
[[nodiscard]] UnfoldResult openNarrowFaces(const DiskMesh& disk, const Points2& image, const TargetMeasure& target,
                                           SolverBackend backend, const Execution& execution);

/// The same patches in an image of any domain.
/// @param image  no face folded; stays so
void openNarrowFaces(const AreaFunctional& areas, const TargetMeasure& target, const Points3& surface,
                     SolverBackend backend, Coordinates& image, const Narrowness& narrowness,
                     const Execution& execution = {});

/// On the unit sphere, kCollapsing.
/// @param image  n×3, no face folded; stays so
void openNarrowFacesOnSphere(const SphereMesh& sphere, const TargetMeasure& target, SolverBackend backend,
                             Points3& image);

/// The faces with r outside of ½ … 2, where they are at most 2 % of all and have 70 % of D_area − 2; otherwise none. A
/// bulb behind a narrow neck, 390 of the 300,000 faces of a cortex, can take fifty steps of all faces.
[[nodiscard]] FaceFlags farFaces(const AreaFunctional& areas, const Eigen::VectorXd& targets, const Coordinates& image);

/// Face steps in patches of 8 rings around them, until all their faces have 0.6 of their share there.
/// @param image  no face folded; stays so
/// @return whether D_area − 2 is less by a fifth; otherwise the image is as it was
bool matchFarFaces(const FaceFlags& far, const AreaFunctional& areas, const Eigen::VectorXd& targets,
                   const Points3& surface, SolverBackend backend, Shapes shapes, Coordinates& image);

}  // namespace authalic
