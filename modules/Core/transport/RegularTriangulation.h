/// @file
/// The dual of a power diagram: the seam behind which the library that finds it lives. Private to transport/.
#pragma once

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

#include "Core/base/Arrays.h"

namespace authalic {

/// Connectivity of the regular triangulation of weighted sites; −1 stands for the site at infinity.
struct RegularConnectivity {
  int dimension = 0;                          ///< 2; 1 when all sites lie on one line; 0 for one visible site
  std::vector<std::array<int, 3>> corners;    ///< counter-clockwise; infinite faces included (dimension 2 only)
  std::vector<std::array<int, 3>> neighbours; ///< face beyond the edge opposite corner k
  std::vector<int> faceOf;                    ///< per site: one of its faces, −1 when its cell is empty
  std::vector<int> line;                      ///< dimension < 2: the visible sites in their order along the line
};

/// Finds the regular triangulation of the same sites again and again, for weights that change.
class RegularTriangulation {
 public:
  virtual ~RegularTriangulation() = default;

  /// Sites lifted to (y, |y|² − W), W = |y|² + 2 h: the lower hull, by exact predicates. O(n log n).
  [[nodiscard]] virtual RegularConnectivity triangulate(const Eigen::VectorXd& heights) const = 0;
};

/// CGAL's @cite cgal2022 regular triangulation.
/// @param sites  n×2, no two in one place
/// @throws InvalidArgument when CGAL was not built in
[[nodiscard]] std::unique_ptr<RegularTriangulation> makeRegularTriangulation(const Points2& sites);

/// Whether this build contains a library for it.
[[nodiscard]] bool regularTriangulationAvailable() noexcept;

}  // namespace authalic
