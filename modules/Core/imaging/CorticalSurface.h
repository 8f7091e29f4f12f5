/// @file
/// From a T1 image to one genus-0 white surface per hemisphere.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "Core/base/Execution.h"
#include "Core/geometry/SurfaceSmoothing.h"
#include "Core/imaging/WhiteMatter.h"
#include "Core/mesh/TriangleMesh.h"

namespace authalic {

/// Choices of extractCorticalSurfaces.
struct CorticalSurfaceOptions {
  WhiteMatterOptions whiteMatter;
  double sealing =
      1.0;  ///< tunnels through white matter up to about twice this many voxels wide are sealed, 0…5
  SmoothingOptions smoothing;    ///< of each surface
  int targetFaces = 280000;      ///< faces per hemisphere after decimation; 0 = no decimation
  double medialWallReach = 1.5;  ///< mm from a cut or filled voxel within which a vertex belongs to the
                                 ///< medial wall; at least one voxel

  /// @throws InvalidArgument naming the first field out of range
  void validate() const;
};

/// One hemisphere.
struct HemisphereSurface {
  TriangleMesh mesh;             ///< scanner RAS mm, faces counter-clockwise from outside
  std::vector<char> medialWall;  ///< per vertex: 1 = comes from the midline cut or a filled structure, not
                                 ///< from a grey–white border
  int eulerCharacteristic = 0;   ///< 2 by construction
  double area = 0;               ///< mm²
  double volume = 0;             ///< mm³ enclosed
  double medialWallShare = 0;    ///< of the area
  std::size_t voxels =
      0;  ///< white or filled voxels of the hemisphere before the topology was made spherical
  std::size_t filledVoxels = 0;  ///< of which filled
  std::size_t cutVoxels = 0;     ///< taken away to cut handles
  std::size_t sealedVoxels = 0;  ///< added to seal tunnels
  int extractedFaces = 0;        ///< faces before decimation
  int turnedFaces = 0;           ///< faces turned by more than 90° by smoothing
  int prunedSpikes = 0;          ///< spikes cut off (PruneSpikes.h)
  int prunedFaces = 0;           ///< faces that went with them; each spike left one face
};

/// What extractCorticalSurfaces found.
struct CorticalSurfaceResult {
  HemisphereSurface left, right;
  IntensityClasses classes;  ///< as used
  BrainFrame frame;
  double brainVolume = 0;                               ///< mm³
  std::vector<std::pair<std::string, double>> seconds;  ///< per stage
  std::vector<std::string> warnings;                    ///< sentences; empty when everything looks plausible
};

/// Extracts the white surface of both hemispheres.
///
/// Segmentation: see WhiteMatter.h. Topology: a set is grown inside each hemisphere's white matter by simple
/// points, the deepest voxels first (HomotopicGrowing.h), so that it has no handle and no cavity; loops are
/// cut at their thinnest place, small tunnels sealed. Surface: the zero of a field that is the normalised
/// contrast (T1 − θ)/(white − grey) where its sign agrees with the grown set, and a blurred indicator of the
/// set where it does not, extracted by Isosurface.h: sub-voxel accurate and of exactly the set's topology.
/// Then volume-preserving smoothing (SurfaceSmoothing.h), topology-preserving decimation (Decimation.h) and pruning of
/// the spikes that no map can make good triangles of (PruneSpikes.h).
///
/// Guarantees: each surface is closed, manifold, connected, χ = 2, outward; deterministic, same bits at any
/// thread count. The medial wall is one region, and so is its complement. Not guaranteed: absence of
/// self-intersections where two sulcal banks touch; anatomical truth where the image has none: read the
/// warnings.
///
/// @param t1      scalar T1, skull-stripped unless labels are given; NaN = outside
/// @param labels  regions on any grid, or nullptr
/// @throws InvalidArgument, GeometryError as segmentWhiteMatter; CancelledError
/// @cite dale1999 @cite bertrand1994 @cite han2003
[[nodiscard]] CorticalSurfaceResult extractCorticalSurfaces(const ScalarVolume& t1, const LabelVolume* labels,
                                                            const CorticalSurfaceOptions& options = {},
                                                            const Execution& execution = {});

}  // namespace authalic
