/// @file
/// The seams along which a flat cone surface is cut open.
#pragma once

#include <vector>

#include "Core/conformal/FlatConeSurface.h"

namespace authalic {

/// A path of the cut between two cones or branchings, whose two sides differ by one rigid motion.
struct ConeSeam {
  std::vector<int> side,
      otherSide;  ///< vertices of the disk in the same order along both; the disk lies left of `side`
  RigidMotion motion;                ///< takes `side` to `otherSide`
  double error = 0;                  ///< max |motion(x) − x'| over its vertices
};

/// All seams, in the order of their first half-edges. @param image  n'×2, of cut.faces. O(m)
[[nodiscard]] std::vector<ConeSeam> coneSeams(const SurfaceTopology& topology, const FlatConeSurface& flat,
                                              const Points2& image);

/// Sum of the corner angles around every vertex of the surface, radians: 2π but at cones.
/// @param image  n'×2, of cut.faces
[[nodiscard]] Eigen::VectorXd angleSums(const Faces& faces, const CutGraph& cut, const Points2& image);

}  // namespace authalic
