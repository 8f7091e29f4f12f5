/// @file
/// Surfaces and volumes between VTK's data objects and Core's plain arrays. Copies; nothing is ever shared.
#pragma once

#include <string>

#include "Core/imaging/Volume.h"
#include "Core/mesh/TriangleMesh.h"
#include "vtkAuthalicFiltersCommonModule.h"

class vtkImageData;
class vtkPolyData;

namespace authalic {

/// Points and triangles in the order of the input.
/// @param role  how messages call this input, e.g. "surface"
/// @throws GeometryError when there is nothing, when a polygon is not a triangle (name the first and say that
///         vtkTriangleFilter makes triangles), when there are lines, vertices or strips (cell arrays would no longer
///         be face arrays), or when TriangleMesh refuses.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT TriangleMesh toTriangleMesh(vtkPolyData* surface,
                                                                          const std::string& role = "surface");

/// The triangles alone, in the order of the input; indices and repeated vertices are not looked at.
/// @throws GeometryError as above, but for what TriangleMesh refuses
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT Faces toTriangles(vtkPolyData* surface,
                                                                const std::string& role = "surface");

/// The surface of a map: its point array OriginalPoints with the map's triangles.
/// @throws InvalidArgument when the array is not there
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT TriangleMesh surfaceOfMap(vtkPolyData* map);
/// surfaceOfMap() when there is an array OriginalPoints, else toTriangleMesh().
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT TriangleMesh surfaceOf(vtkPolyData* surfaceOrMap);

/// Replaces points (double precision) and triangles of `output`; its arrays are left alone.
VTKAUTHALICFILTERSCOMMON_EXPORT void setMesh(vtkPolyData* output, const TriangleMesh& mesh);
/// Replaces the points (double precision) alone.
VTKAUTHALICFILTERSCOMMON_EXPORT void setPoints(vtkPolyData* output, const Points3& points);
/// The same with z = 0.
VTKAUTHALICFILTERSCOMMON_EXPORT void setPoints(vtkPolyData* output, const Points2& points);

/// The points as n×3.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT Points3 toPoints(vtkPolyData* surface);
/// x and y of the points.
/// @throws GeometryError when the points do not lie in the plane z = 0.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT Points2 toPlanarPoints(vtkPolyData* map);

/// First component of the named point array (the active scalars when `array` is empty), with the image's origin,
/// spacing, direction matrix and extent as voxelToWorld.
/// @throws GeometryError when there is no such array or no voxel.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT ScalarVolume toScalarVolume(vtkImageData* image,
                                                                          const std::string& array = {});
/// The same, rounded to integers.
[[nodiscard]] VTKAUTHALICFILTERSCOMMON_EXPORT LabelVolume toLabelVolume(vtkImageData* image,
                                                                        const std::string& array = {});

}  // namespace authalic
