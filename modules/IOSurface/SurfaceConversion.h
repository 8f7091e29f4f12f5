/// @file
/// Surfaces, regions and volumes between Formats' plain structs and VTK's data objects. Private to IOSurface/.
#pragma once

#include <string>

#include <Eigen/Core>

#include "Core/imaging/Volume.h"
#include "Formats/Morphometry.h"
#include "Formats/SurfaceFile.h"
#include "vtkAuthalicIOSurfaceModule.h"

class vtkDataObject;
class vtkImageData;
class vtkPolyData;

namespace authalic {

/// Points (double precision), triangles and field data `CoordinateSpace`, `CoordinateSpaceReason`, the
/// metadata by their own names, and `VolumeGeometry` (18 numbers: dimensions, voxel size, xras, yras, zras,
/// c_ras) with `VolumeGeometryFile` when known.
VTKAUTHALICIOSURFACE_EXPORT void setSurface(vtkPolyData* output, const SurfaceFile& surface);

/// The way back. Field data that are absent leave the space unknown, the geometry invalid, the metadata
/// empty.
/// @throws GeometryError unless the surface consists of triangles alone
[[nodiscard]] VTKAUTHALICIOSURFACE_EXPORT SurfaceFile toSurfaceFile(vtkPolyData* surface);

/// The space, geometry and metadata of a data object's field data; no points, no faces.
[[nodiscard]] VTKAUTHALICIOSURFACE_EXPORT SurfaceFile spaceFields(vtkDataObject* object);

/// Changes the sign of x and y of every floating-point array of three components (normals, other coordinates), as
/// between RAS and LPS.
VTKAUTHALICIOSURFACE_EXPORT void mirrorVectors(vtkPolyData* surface);

/// The points alone, from and to VTK.
VTKAUTHALICIOSURFACE_EXPORT void copyPoints(vtkPolyData* from, SurfaceFile& to);
VTKAUTHALICIOSURFACE_EXPORT void setPoints(vtkPolyData* output, const SurfaceFile& surface);

/// Replaces the field data of setSurface().
VTKAUTHALICIOSURFACE_EXPORT void setSpaceFields(vtkDataObject* output, const SurfaceFile& surface);

/// Names, colours and ids of the regions of point array `array` as field data `<array>Names` (text),
/// `<array>Colors` (n × 4, 0–255) and `<array>Ids`.
VTKAUTHALICIOSURFACE_EXPORT void setRegions(vtkDataObject* output, const std::string& array,
                                            const std::vector<Region>& regions);
[[nodiscard]] VTKAUTHALICIOSURFACE_EXPORT std::vector<Region> toRegions(vtkDataObject* object,
                                                                        const std::string& array);

/// Dimensions, origin, spacing and direction matrix such that physical coordinates are scanner RAS mm. Extent starts at
/// 0. A sheared affine gives a direction matrix that is no rotation; VTK's transforms still hold.
VTKAUTHALICIOSURFACE_EXPORT void setLattice(vtkImageData* output, const std::array<int, 3>& dimensions,
                                            const Eigen::Matrix4d& affine);

/// Voxel (i, j, k) of the extent from 0 → physical coordinates.
[[nodiscard]] VTKAUTHALICIOSURFACE_EXPORT Eigen::Matrix4d affineOf(vtkImageData* volume);

}  // namespace authalic
