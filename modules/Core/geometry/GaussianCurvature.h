/// @file
/// Gaussian curvature of a surface at its vertices.
#pragma once

#include <Eigen/Core>

#include "Core/mesh/SurfaceTopology.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Angle defect per area, (2π − Σ angles at v) / star of v, 1/mm²; 0 on the boundary, where the defect is not a
/// curvature, and at vertices without area. Σ over a closed surface of curvature × star is 2πχ exactly
/// (Gauss–Bonnet). Values at single vertices need not converge (where valences
/// differ they do not); integrals over regions do. O(m). @cite meyer2003
[[nodiscard]] Eigen::VectorXd gaussianCurvature(const TriangleMesh& surface, const SurfaceTopology& topology);

}  // namespace authalic
