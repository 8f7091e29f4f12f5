/// @file
/// Maps of surfaces with holes by optimal transport: a circle domain, its holes filled with masses of their own.
#pragma once

#include <vector>

#include "Core/conformal/CircleDomainMap.h"
#include "Core/transport/SemiDiscreteTransport.h"

namespace authalic {

struct PolyAnnulusTransportOptions : SemiDiscreteTransportOptions {
  int outerLoop = -1;  ///< loop of PolyAnnulusMesh::loops() that becomes the unit circle; −1 = the longest (mm)
  /// Areas of the holes, mm², one per loop but the outer one, in the order of loops(); what counts is their ratio to
  /// the area of the surface. Empty: of the cones that close them on the surface, tip in the mean of the loop.
  std::vector<double> holeAreas;
  /// Part of the disk that all holes get together, in (0, 1): in proportion to holeAreas, or, when these are empty, to
  /// the disks that the conformal map leaves out. 0 = as large as holeAreas say.
  double holeShare = 0;

  /// @throws InvalidArgument naming the field that is outside its range, or a share for no hole.
  void validate(const PolyAnnulusMesh& surface) const;
};

struct PolyAnnulusTransportResult : TransportSolution {
  Points2 image;                      ///< n×2
  Points2 sites;                      ///< (n + m)×2: the conformal map, then the centres of its m holes
  Eigen::VectorXd masses;             ///< n + m, sum π
  Eigen::VectorXd cellAreas;          ///< n + m
  Eigen::VectorXd potential;          ///< n + m: u at the image, and in the middle of each hole
  CellPolygons cells;                 ///< n + m outlines, arcs sampled
  std::vector<FittedCircle> circles;  ///< of every loop in the conformal map, in the order of loops()
  Points2 holeCentres;                ///< m×2: centroids of the cells of the holes
  std::vector<double> holeAreas;      ///< m, mm²: masses of the holes per mass of a mm² of surface
  int outerLoop = 0;
  std::vector<int> pockets;           ///< vertices of ears that lie in holes of the conformal map, see FoldedPockets
  double transportCost = 0;           ///< W₂² = Σ ∫_{W_i} |x − y_i|² dx, holes included
  int emptyCells = 0;
  int flippedFaces = 0;               ///< of the image: exact cells do not keep faces from folding
  double startSeconds = 0, transportSeconds = 0;
};

/// The area-preserving (or measure-controlled) map of a surface of genus 0 with k = m + 1 loops by optimal transport
/// @cite su2016: a conformal map φ to the unit disk without m round holes B(p_j, r_j) (circleDomainMap), sites φ(v_i)
/// with masses a μ_i and p_j with masses b_j,
///
///     a Σ μ_i + Σ b_j = π,
///
/// and heights such that every cell has its mass (semiDiscreteTransport): holes are filled, so that the source is the
/// uniform measure of the whole disk. `holeAreas` H: b_j = a H_j, μ_i in mm². `holeShare` s: Σ b_j = π s, the rest is
/// the surface; without holeAreas b_j = b π r_j², the paper's choice with b = s / Σ r_j² and a = π (1 − s) / Σ μ_i.
///
/// The cell of a hole is convex: it is the hole of the image. Image of vertex i = centroid of its cell; vertices of the
/// outer loop go from there to the nearest point of the circle, of an inner loop to the nearest point of their hole.
///
/// @param shares  n, > 0, sum 1: of the surface, for each vertex (TargetMeasure::vertices())
///
/// Guarantees: cells, those of the holes included, have their areas to `tolerance`; none is empty; loops on the circle
/// and on the outlines of the holes, but for vertices of ears on inner loops (`pockets`). Not guaranteed: that faces
/// keep their areas, or do not fold (flippedFaces), or that holes are round — finishCircleDomain() started from this
/// image sees to all three.
/// Complexity: that of circleDomainMap and semiDiscreteTransport. When cancelled in the conformal map, the image is
/// empty.
/// @throws InvalidArgument from options; GeometryError when there is not one share per vertex, a loop is shrunk to a
///         point of double precision, or two vertices have one conformal image; SolverError
[[nodiscard]] PolyAnnulusTransportResult polyAnnulusTransportMap(const PolyAnnulusMesh& surface,
                                                                 const Eigen::VectorXd& shares,
                                                                 const PolyAnnulusTransportOptions& options = {},
                                                                 const Execution& execution = {});

}  // namespace authalic
