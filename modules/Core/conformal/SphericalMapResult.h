/// @file
/// What every road to the conformal sphere returns.
#pragma once

#include <vector>

#include "Core/base/Arrays.h"
#include "Core/base/Status.h"

namespace authalic {

struct SphericalMapResult {
  Points3 image;                   ///< n×3 on the unit sphere, faces counter-clockwise seen from outside
  Status status = Status::NotRun;
  int iterations = 0;
  std::vector<double> history;     ///< residual of every iterate, the start first; what it is depends on the road
  double residual = 0;             ///< the last of `history`
  int flippedFaces = 0;            ///< faces whose signed volume is not positive
  int flippedBeforeUnfolding = 0;  ///< the same before unfoldOnSphere; SphericalConformalMap only
  int unfoldedVertices = 0;        ///< vertices that unfoldOnSphere moved; SphericalConformalMap only
  double centreOfMass = 0;         ///< |Σ m_i y_i| / Σ m_i, m_i a third of the surface areas around vertex i
  int degenerateFaces = 0;         ///< faces without area on the surface, whose shape was clamped
  double seconds = 0;
};

}  // namespace authalic
