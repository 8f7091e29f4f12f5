/// @file
/// Triangle surfaces in files: FreeSurfer, GIFTI, OFF, PLY and OBJ, and the space their coordinates live in.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "Formats/Space.h"

namespace authalic {

/// A surface as its file holds it.
struct SurfaceFile {
  std::vector<double> points;  ///< 3n, x y z of each vertex in `space`, mm
  std::vector<int> faces;      ///< 3m, vertex indices, counter-clockwise seen from outside
  CoordinateSpace space = CoordinateSpace::Unknown;
  std::string spaceReason = "nothing in the file says which space its coordinates live in";
  VolumeGeometry geometry;                      ///< of the volume the surface was made from; check `valid`
  std::map<std::string, std::string> metadata;  ///< GIFTI names: AnatomicalStructurePrimary, GeometricType …
  std::string notRead;  ///< what else the file holds: "2 tags of FreeSurfer", "arrays of other kinds" …; may be empty

  [[nodiscard]] std::size_t vertexCount() const noexcept { return points.size() / 3; }
  [[nodiscard]] std::size_t faceCount() const noexcept { return faces.size() / 3; }
};

/// Reads a FreeSurfer surface (triangle, old and new quadrangle), a GIFTI surface, an MZ3 or ASCII OFF file, a
/// PLY file or a Wavefront OBJ file, gzipped or not; the kind is found from the content, OBJ alone from its name.
/// Of OBJ only vertices and faces are read: texture seams do not tear the surface.
///
/// Guarantees: every face index lies in [0, n); order of vertices and faces as in the file (polygons of OFF
/// and quadrangles of FreeSurfer become triangles in place). Coordinates are passed as they are, NaN
/// included: TriangleMesh refuses those.
///
/// Which space (decided by what the file states, never guessed):
///  - FreeSurfer: "useRealRAS" set → scanner RAS; volume geometry in the footer → tkRAS; else unknown.
///  - GIFTI: DataSpace NIFTI_XFORM_SCANNER_ANAT → scanner RAS; else VolGeom with a centre → tkRAS; else
///  unknown.
///    CoordinateSystemTransformMatrix is not applied (nor do Workbench and nibabel).
///  - OFF, PLY, OBJ: a comment "SPACE=RAS" (scanner RAS) or "SPACE=LPS", as 3D Slicer writes; else unknown.
///  - MZ3: unknown.
/// @throws FormatError when the file is missing, of another kind, truncated or inconsistent
[[nodiscard]] SurfaceFile readSurface(const std::string& path);

/// What 3D Slicer's comment in the header of a mesh says; Unknown without one.
[[nodiscard]] CoordinateSpace spaceComment(const std::string& header);
/// "SPACE=RAS", "SPACE=LPS", or empty for spaces that the comment has no word for.
[[nodiscard]] const char* spaceComment(CoordinateSpace space) noexcept;

/// Brings points to scanner RAS: x = D P⁻¹ x_tk + c_ras for tkRAS (VolumeGeometry::tkRasToScanner), likewise
/// for voxel indices (VolumeGeometry::voxelToScanner); of LPS the first two coordinates change their sign.
/// A surface of unknown space stays untouched and unknown unless `assume` asserts a space, which also
/// overrides what the file says.
/// @throws FormatError when tkRAS or voxels are asserted but the surface carries no volume geometry
void toScannerRas(SurfaceFile& surface, std::optional<CoordinateSpace> assume = {});

/// Turns scanner RAS into LPS; a surface of another space stays as it is.
void toLps(SurfaceFile& surface);

/// Brings points from scanner RAS to tkRAS, where FreeSurfer keeps them; a surface of another space or without
/// volume geometry stays as it is.
void toTkRas(SurfaceFile& surface);

/// FreeSurfer triangle file. With a valid geometry the coordinates are stored in tkRAS with that geometry;
/// scanner RAS without geometry is stored as is and marked useRealRAS; unknown space is stored as is,
/// unmarked. Coordinates become 32-bit; metadata are lost. Written whole or not at all.
/// @throws FormatError when the file cannot be written or there are too many vertices or faces for it
void writeFreeSurferSurface(const std::string& path, const SurfaceFile& surface);

/// ASCII OFF with all digits of the doubles. Space, geometry and metadata are lost (readers of OFF seldom expect
/// comments). Written whole or not at all.
/// @throws FormatError when the file cannot be written
void writeOff(const std::string& path, const SurfaceFile& surface);

/// Binary little-endian PLY with double coordinates. Scanner RAS and LPS are stated in a comment; geometry and metadata
/// are lost.
/// @throws FormatError when the file cannot be written
void writePly(const std::string& path, const SurfaceFile& surface);

/// Wavefront OBJ with all digits of the doubles; space and losses as for PLY.
/// @throws FormatError when the file cannot be written
void writeObj(const std::string& path, const SurfaceFile& surface);

}  // namespace authalic
