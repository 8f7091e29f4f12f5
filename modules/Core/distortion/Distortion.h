/// @file
/// How much a map changes areas and angles: one definition of each metric, used everywhere.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "Core/distortion/Spread.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Distortion of every face and vertex of a map f from a surface to its image.
///
/// Both total areas are normalised to 1 first. A_t is the surface share of face t, ρ_t its target share (= A_t
/// unless a target is given), q_t its image share, r_t = q_t/ρ_t; σ1 ≥ |σ2| are the singular values of the face
/// Jacobian after the normalisation, σ2 < 0 on a folded face.
struct DistortionArrays {
  Eigen::VectorXd areaRatio;             ///< m: r_t, signed; NaN where the target share is 0
  Eigen::VectorXd logAreaRatio;          ///< m: log2 |r_t|; NaN where r_t is 0 or NaN
  Eigen::VectorXd sigmaMax, sigmaMin;    ///< m: σ1 and signed σ2; NaN on faces without surface area
  Eigen::VectorXd angleDistortion;       ///< m: σ1/|σ2| + |σ2|/σ1, ideal 2; NaN where undefined
  /// m: Beltrami coefficient μ = f_z̄/f_z, z along the first edge of the face (its modulus does not depend on that,
  /// its argument does); |μ| > 1 on folded faces; NaN where undefined.
  Eigen::VectorXcd beltrami;
  Eigen::MatrixX3d cornerLogAngleRatio;  ///< m×3: η = ln(image angle / surface angle)
  Eigen::MatrixX3d cornerAngleError;     ///< m×3: image angle − surface angle, degrees
  Eigen::VectorXd vertexLogAreaRatio;    ///< n: p_i = ln(image third-star share / target third-star share)
  Eigen::VectorXi flipped;               ///< m: 1 where the face is folded or has no area in the image
};

/// The numbers of every report. Sums run over faces with positive surface area.
struct DistortionSummary {
  double areaDistortion = 0;      ///< D_area = Σ ρ_t (|r_t| + 1/|r_t|), ideal 2
  double angleDistortion = 0;     ///< D_angle = Σ A_t (σ1/σ2 + σ2/σ1), ideal 2
  double symmetricDirichlet = 0;  ///< Σ A_t (σ1² + σ1⁻² + σ2² + σ2⁻²), ideal 4
  double asRigidAsPossible = 0;   ///< Σ A_t ((σ1 − 1)² + (σ2 − 1)²), ideal 0
  double areaErrorL2 = 0;         ///< (Σ (q_t − ρ_t)²)^½, the "Wasserstein" row of @cite su2019
  double faceMeanAbsLog = 0, faceMaxAbsLog = 0;      ///< of ln |r_t|, unweighted over faces
  double faceStandardDeviation = 0;                  ///< (Σ ρ_t (|r_t| − 1)²)^½
  double vertexMeanAbsLog = 0, vertexMaxAbsLog = 0;  ///< of p_i, unweighted over vertices
  double meanAngleError = 0;      ///< mean |image angle − surface angle| over corners, degrees
  double meanQuasiConformal = 0;  ///< mean K = σ1/|σ2| over faces
  double meanBeltrami = 0;        ///< mean (K − 1)/(K + 1) over faces
  Spread angleError;              ///< of |image angle − surface angle| over corners, degrees
  Spread quasiConformal;          ///< of K over faces
  Spread beltrami;                ///< of (K − 1)/(K + 1) over faces: |μ|, orientation left out
  int flippedFaces = 0;           ///< faces folded against the majority, or without area, in the image
  int degenerateFaces = 0;        ///< faces without surface area, left out of the angle sums
  bool finite = true;             ///< every image coordinate is finite
};

struct Distortion {
  DistortionArrays arrays;
  DistortionSummary summary;
};

/// Measures a planar map on its own connectivity. O(m).
///
/// @param surface  mesh with n vertices (mm) and m faces
/// @param image    n×2 planar image, any scale
/// @param target   m target measures (any scale, ≥ 0), or empty for the surface areas
/// @throws GeometryError when sizes do not match, the surface has no area, or a target is negative or not finite
///
/// A face counts as flipped against the orientation that most faces have, so that a mirrored image has none.
/// @cite su2019 (Table 1, with the area weights put right)
[[nodiscard]] Distortion measureDistortion(const TriangleMesh& surface, const Points2& image,
                                           const Eigen::VectorXd& target = {});

/// The same for a surface that was cut open: vertices with one original share one star, which the seam does not divide.
/// @param originals  n, vertex of the surface before the cut (0 … n − 1) of every vertex
[[nodiscard]] Distortion measureDistortion(const TriangleMesh& opened, const std::vector<int>& originals,
                                           const Points2& image, const Eigen::VectorXd& target = {});

/// Transport cost Σ m_i |x_i − y_i|² of moving the image x to the image y with vertex masses m.
/// @throws GeometryError when the lengths differ
[[nodiscard]] double transportCost(const Points2& from, const Points2& to, const Eigen::VectorXd& masses);

}  // namespace authalic
