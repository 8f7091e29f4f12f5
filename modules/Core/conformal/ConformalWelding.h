/// @file
/// Conformal welding: two unit disks glued along their circles into one sphere, by the zipper.
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <vector>

#include "Core/base/Arrays.h"
#include "Core/base/Execution.h"
#include "Core/conformal/Zipper.h"

namespace authalic {

/// Which boundary points of two unit disks belong together: n pairs e^{iα_k} ~ e^{iβ_k}.
///
/// The two surfaces lie on the two sides of one seam, so that α runs counter-clockwise and β clockwise. The pairs are
/// kept as arcs between neighbours, whose relative accuracy survives where the angles themselves crowd together.
struct WeldingSignature {
  Eigen::VectorXd firstArcs;   ///< n arcs > 0 of disk 1 (radians, sum 2π); arc k leads from point k to point k + 1
  Eigen::VectorXd secondArcs;  ///< n arcs > 0 of disk 2, each walked clockwise
  double firstStart = 0;       ///< α_0
  double secondStart = 0;      ///< β_0

  /// @param first, second  n angles each; α may wrap past 2π once upwards, β once downwards
  /// @throws InvalidArgument when the sizes differ, n < 3, or an angle does not advance the right way
  [[nodiscard]] static WeldingSignature fromAngles(const Eigen::VectorXd& first, const Eigen::VectorXd& second);
  /// @param first, second  n×2 points each, as far as their direction from 0 goes: matched boundary points, walked
  ///        counter-clockwise on disk 1 and clockwise on disk 2
  /// @throws InvalidArgument as fromAngles, and when a point is 0 or not finite
  [[nodiscard]] static WeldingSignature fromPoints(const Points2& first, const Points2& second);

  [[nodiscard]] Eigen::VectorXd firstAngles() const;   ///< n angles α_k, ascending from α_0
  [[nodiscard]] Eigen::VectorXd secondAngles() const;  ///< n angles β_k, descending from β_0
  /// @throws InvalidArgument when there are fewer than 3 pairs, the sizes differ, or the arcs are not positive and of
  ///         sum 2π
  void validate() const;
};

/// What can be measured on a finished welding; distances are chords of the unit sphere (stereographic projection).
struct WeldingAccuracy {
  /// max |Φ1(e^{iα_k}) − Φ2(e^{iβ_k})|: rounding, for the zipper glues the pairs exactly.
  double boundaryMismatch = 0;
  /// max |Φ1 − Φ2| at the middles of the arcs of disk 1, the partner on disk 2 being found by cubic interpolation of
  /// the signature: how far the n pairs are from having resolved a smooth signature.
  double midpointMismatch = 0;
};

/// Where points of the sphere come from.
struct WeldingPreimages {
  Points2 points;            ///< n×2, in the closed unit disk
  std::vector<char> second;  ///< n flags: 0 = on disk 1, 1 = on disk 2
};

/// The unit disk as the upper half-plane, with v_0 at ∞, v_1 at −1 and v_2 at 0: ζ = c (i (1 + w)/(1 − w) − x), where
/// w = z/v_0 on disk 1 and its conjugate on disk 2, whose boundary is walked the other way.
class HalfPlaneChart {
 public:
  using Complex = std::complex<double>;
  HalfPlaneChart() = default;
  HalfPlaneChart(const Eigen::VectorXd& arcs, double start, bool clockwise);

  /// Distances on the axis from v_2 to v_3, from v_3 to v_4, … to v_{n−1}.
  [[nodiscard]] const Eigen::VectorXd& gaps() const noexcept { return gaps_; }
  [[nodiscard]] Complex toHalfPlane(Complex point) const;
  [[nodiscard]] Complex toDisk(Complex point) const;

 private:
  Eigen::VectorXd gaps_;
  Complex origin_{1};  ///< v_0
  double secondAngle_ = M_PI;  ///< from v_0 to v_2
  double scale_ = 1;
  bool clockwise_ = false;
};

/// The conformal maps Φ1 of disk 1 onto the inside and Φ2 of disk 2 onto the outside of one closed curve, with
///
///     Φ1(e^{iα_k}) = Φ2(e^{iβ_k}),   k = 0 … n − 1.
///
/// They exist and are unique up to a Möbius transformation in the limit of a quasi-symmetric signature
/// @cite sharon2006. Computed by the zipper @cite marshall2007 in the upper half-plane, with the open seam on the real
/// axis, its last closed point (the tip) at 0 and v_0 at ∞. Closing the pair a > 0 > −b sends it to 0 and its
/// arcs [0, a], [−b, 0] onto a slit orthogonal to the axis:
///
///     g(z) = ½ (a + b) p q (p + q) / (b p + a q),   p = √(z − a),  q = √(z + b),   Im ≥ 0,
///
/// which is z ↦ √(m² − 1) after the Möbius map m of (a, 0, −b) to (1, 0, −1), followed by the one that puts v_0 back
/// to ∞ (the formulas of @cite nadeem2017 corrected). p and q lie in the closed first quadrant: no sum cancels.
/// The unglued points are carried as gaps between neighbours, whose new lengths are again sums of positive terms, so
/// that n steps cost each gap a relative error of order n ε, however unequal the gaps are.
///
/// Guarantees: the pairs coincide up to rounding; the signature of a Möbius map of the disk gives a circle for every n.
/// Between the pairs the arcs are matched by the zipper's own interpolation: for smooth signatures the error of the
/// curve falls as n^−2.5 (measured), see `accuracy`. Does not resample; does not check that the signature is resolved.
///
/// Normalisation: Φ1(0) = 0, Φ2(0) = ∞, Φ1(e^{iα_0}) = 1, unless changed by `withCurvePointsAt`.
/// Complexity: O(n²) to build, O(n) per point to evaluate (14 ns per step and point).
class ConformalWelding {
 public:
  using Complex = std::complex<double>;

  /// @throws InvalidArgument from WeldingSignature::validate
  /// @throws GeometryError when the arcs are so unequal that the seam cannot be told from a point in double precision
  /// @throws CancelledError when the caller stops
  explicit ConformalWelding(WeldingSignature signature, const Execution& execution = {});

  [[nodiscard]] const WeldingSignature& signature() const noexcept { return signature_; }
  /// n points: the common image of the k-th pair, in the plane.
  [[nodiscard]] Eigen::VectorXcd curve() const;
  /// The same on the unit sphere, n×3.
  [[nodiscard]] Points3 curveOnSphere() const;

  /// Φ1 or Φ2 at points of the closed unit disk, n×2; outside by less than 1e-9 is taken to the circle.
  /// ∞ has infinite real part. Runs on all threads of the execution, with the same bits.
  /// @throws InvalidArgument when a point lies outside the disk or is not finite
  [[nodiscard]] Eigen::VectorXcd mapFirst(const Points2& points, const Execution& execution = {}) const;
  [[nodiscard]] Eigen::VectorXcd mapSecond(const Points2& points, const Execution& execution = {}) const;

  /// The same followed by (2x, 2y, 1 − |w|²) / (1 + |w|²): unit vectors, n×3; 0 goes to (0, 0, 1), ∞ to (0, 0, −1), and
  /// the sphere seen from outside keeps the orientation of the disks (the projection of @cite nadeem2017 reverses it).
  [[nodiscard]] Points3 mapFirstToSphere(const Points2& points, const Execution& execution = {}) const;
  [[nodiscard]] Points3 mapSecondToSphere(const Points2& points, const Execution& execution = {}) const;

  /// The disk and the point that each point of the plane comes from; points on the curve may fall to either side.
  /// @throws InvalidArgument when a point is NaN
  [[nodiscard]] WeldingPreimages inverse(const Eigen::VectorXcd& images) const;

  /// The same welding followed by the Möbius transformation that takes three curve points to three places.
  /// @throws InvalidArgument when an index is out of range or used twice, or two places are equal or not finite
  [[nodiscard]] ConformalWelding withCurvePointsAt(const std::array<int, 3>& points,
                                                   const std::array<Complex, 3>& places) const;

  /// Measured by evaluating both maps; O(n²), about four times the cost of the construction.
  [[nodiscard]] WeldingAccuracy accuracy(const Execution& execution = {}) const;

 private:
  enum class Side { First, Second };
  /// A point of the Riemann sphere: numerator and denominator.
  using Projective = Eigen::Vector2cd;

  [[nodiscard]] std::vector<Projective> evaluate(Side side, const Points2& points, const Execution& execution) const;
  void traceCurve(const Execution& execution);

  WeldingSignature signature_;
  std::array<HalfPlaneChart, 2> charts_;
  Zipper zipper_;
  std::vector<Projective> tips_;  ///< the curve as the zipper leaves it
  Eigen::Matrix2cd after_;        ///< the Möbius transformation that normalises it
};

}  // namespace authalic
