/// @file
/// What becomes of the boundary loops in area-preserving maps of surfaces with holes.
#pragma once

#include <vector>

#include "Core/mesh/PolyAnnulusMesh.h"
#include "Core/numerics/CircleFit.h"

namespace authalic {

struct CircleDomainHoles {
  bool concentric = false;  ///< two loops only: the hole is in the middle of the disk
  int outerLoop = -1;       ///< loop of PolyAnnulusMesh::loops() that becomes the unit circle; −1 = the longest (mm)
  /// Areas of the holes, mm², one per loop but the outer one, in the order of loops(); what counts is their ratio to
  /// the area of the surface. Empty: of the cones that close them on the surface, tip in the mean of the loop.
  std::vector<double> holeAreas;

  /// @throws InvalidArgument naming the field that is outside its range, TopologyError when a concentric map is
  ///         asked of a surface that has not 2 loops
  void validate(const PolyAnnulusMesh& surface) const;
};

/// A surface with holes on the unit disk without round holes.
struct CircleDomainImage {
  Points2 image;                      ///< n×2; vertices in the order of the input
  std::vector<FittedCircle> circles;  ///< of every loop, in the order of loops()
  int outerLoop = 0;
  std::vector<double> holeAreas;      ///< mm², in the order of the options
  double holeResidual = 0;            ///< max |ln r| of the holes, r = share of the image / share that they should have
  int pockets = 0;                    ///< ears of the surface that lie in holes, see FoldedPockets
};

}  // namespace authalic
