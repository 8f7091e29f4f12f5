"""Surfaces as arrays: files, per-vertex data, topology, cutting to a disk."""
import dataclasses
import json
import os
from typing import Any, Callable, Mapping, Optional, Sequence, Union

import numpy as np

from . import _arrays, _classes, _filters
from ._errors import InvalidArgument

Progress = Optional[Callable[[float, str], Any]]
Path = Union[str, "os.PathLike[str]"]


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class Surface:
    """A triangle surface with everything that is known per vertex, per face and as a whole.

    points        (n, 3) float, mm
    faces         (m, 3) int, vertex indices from 0, counter-clockwise seen from outside
    point_arrays  {name: (n,) or (n, k)}
    face_arrays   {name: (m,) or (m, k)}
    fields        {name: text, number, list of texts or array}: CoordinateSpace, AnatomicalStructurePrimary ...
    """
    points: np.ndarray
    faces: np.ndarray
    point_arrays: dict[str, np.ndarray] = dataclasses.field(default_factory=dict)
    face_arrays: dict[str, np.ndarray] = dataclasses.field(default_factory=dict)
    fields: dict[str, Any] = dataclasses.field(default_factory=dict)

    @classmethod
    def from_vtk(cls, polydata: Any) -> "Surface":
        """Copies a vtkPolyData of triangles."""
        return cls(_arrays.points_of(polydata), _arrays.faces_of(polydata),
                   _arrays.arrays_of(polydata.GetPointData()), _arrays.arrays_of(polydata.GetCellData()),
                   _arrays.fields_of(polydata))

    def to_vtk(self) -> Any:
        """A vtkPolyData with copies of everything, for any VTK filter."""
        points = _arrays.coordinates(self.points)
        mesh = _arrays.polydata(points, _arrays.corners(self.faces, len(points)))
        _arrays.add_arrays(mesh.GetPointData(), self.point_arrays, len(points), "vertices")
        _arrays.add_arrays(mesh.GetCellData(), self.face_arrays, len(self.faces), "faces")
        _arrays.add_fields(mesh, self.fields)
        return mesh

    def with_point_arrays(self, arrays: Mapping[str, Any]) -> "Surface":
        """The same surface with further arrays per vertex; those of the same name are replaced."""
        return dataclasses.replace(self, point_arrays={**self.point_arrays, **arrays})

    def __repr__(self) -> str:
        return (f"{type(self).__name__}({len(self.points)} vertices, {len(self.faces)} faces, "
                f"point_arrays={list(self.point_arrays)}, face_arrays={list(self.face_arrays)})")


def to_polydata(points: Any, faces: Any = None) -> Any:
    """What a function was given as its surface: (points, faces), or one object with to_vtk(), or a vtkPolyData."""
    if hasattr(points, "to_vtk"):
        mesh = points.to_vtk()
    elif hasattr(points, "GetPolys"):
        mesh = points.NewInstance()
        mesh.ShallowCopy(points)
    else:
        if faces is None:
            raise InvalidArgument("A surface is needed: points and faces, a Surface, or a vtkPolyData.")
        return Surface(points, faces).to_vtk()
    if faces is not None:
        raise InvalidArgument(
            "faces are given twice; leave them out where the first argument is a surface with faces.")
    return mesh


def read_surface(path: Path, space: str = "as-stated", *, whole: Optional[Path] = None,
                 volume: Optional[Path] = None) -> Surface:
    """Reads a triangle surface of any known format, in scanner RAS mm where the file says how.

    path   FreeSurfer (lh.pial ..., .patch.3d, .patch.flat), .gii, .gii.gz, .mz3, .off, .ply, .obj, .vtp, .vtk, .stl
    space  "as-stated": believe the file; "scanner-ras", "tk-ras", "lps" or "voxel" (indices, whole numbers at
           the middles of voxels): the coordinates are in that space whatever it says
    whole  the surface that a FreeSurfer patch was cut from, which has its faces
    volume the volume whose tk-ras or voxels the coordinates are; None = by the geometry that the file carries

    fields["CoordinateSpace"] is "scanner-ras" or "unknown". Raises FormatError, SurfaceError, InvalidArgument.
    """
    reader = _classes.vtkSurfaceFileReader()
    reader.SetFileName(os.fspath(path))
    _filters.configure(reader, assume_space=space, whole_file_name=None if whole is None else os.fspath(whole),
                       volume_file_name=None if volume is None else os.fspath(volume))
    _filters.warn(_filters.run(reader)[1])
    return Surface.from_vtk(reader.GetOutput())


def write_surface(path: Path, points: Any, faces: Any = None, *, space: str = "scanner-ras") -> list[str]:
    """Writes a surface in the format that the file name asks for, whole or not at all.

    points, faces  arrays, or one Surface, SurfaceMap or vtkPolyData; .vtp and .vtk keep every array
    space          "scanner-ras", or "lps" as ITK and 3D Slicer have it (.vtp, .vtk, .ply, .obj, .stl)

    Returns what the format had no room for, one sentence each. Raises FormatError when it cannot be written,
    InvalidArgument.
    """
    writer = _classes.vtkSurfaceFileWriter()
    _filters.configure(writer, write_space=space)
    return write_with(writer, path, to_polydata(points, faces))


def write_with(writer: Any, path: Path, thing: Any) -> list[str]:
    """Runs a writer; returns what it could not keep."""
    writer.SetFileName(os.fspath(path))
    writer.SetInputData(thing)
    _filters.warn(_filters.run(writer, execute=writer.Write)[1], stacklevel=4)
    return [writer.GetLoss(i) for i in range(writer.GetNumberOfLosses())]


def read_vertex_data(path: Path, surface: Any = None, name: Optional[str] = None, *,
                     structure: Optional[str] = None) -> Surface:
    """Adds the per-vertex data of a file to the surface they belong to.

    path       FreeSurfer curv, thickness, sulc, .annot, .label, .w, .mgh; .func.gii, .shape.gii, .label.gii; CIFTI-2
               .dscalar.nii, .dlabel.nii, .dtseries.nii; .mz3; text
    surface    Surface or vtkPolyData with as many vertices as the file has values; None = the data alone, with
               points at the origin and no faces
    name       of the array; default: the name in the file, else of the file (lh.thickness -> thickness)
    structure  which surface of a CIFTI file: CortexLeft ...; default: that of the surface

    Annotations come with fields["NAMENames"] and fields["NAMEIds"]. Raises FormatError, SurfaceError.
    """
    reader = _classes.vtkVertexDataReader()
    reader.SetFileName(os.fspath(path))
    if name:
        reader.SetArrayName(name)
    _filters.configure(reader, structure=structure)
    if surface is not None:
        reader.SetInputData(to_polydata(surface))
    _filters.warn(_filters.run(reader)[1])
    return Surface.from_vtk(reader.GetOutput())


def write_vertex_data(path: Path, surface: Any, *names: str) -> list[str]:
    """Writes point arrays of a surface as per-vertex data, whole or not at all.

    path   .func.gii, .shape.gii (any number of arrays), .label.gii, .annot, .label, .w, .mgh, .mgz, .txt;
           anything else is FreeSurfer's curv (one array)
    names  of the arrays; none = every array of one component

    Returns what the format had no room for, one sentence each. Raises FormatError, InvalidArgument when there is no
    such array.
    """
    writer = _classes.vtkVertexDataWriter()
    for name in names:
        writer.AddArrayName(name)
    return write_with(writer, path, to_polydata(surface))


def topology(points: Any, faces: Any = None) -> dict[str, Any]:
    """Topology, size and defects of any set of triangles, however broken; each defect with its ids and place.

    Keys: vertices, edges, faces, euler_characteristic, genus (None where the surface is no oriented manifold),
    oriented_manifold, area_mm2, volume_mm3, bounds_mm, components, boundary_loops, non_manifold_edges,
    inconsistent_edges, non_manifold_vertices, isolated_vertices, degenerate_faces, duplicate_faces, summary.
    Raises SurfaceError for an empty surface and coordinates that are not finite.
    """
    report = _classes.vtkSurfaceTopologyReport()
    report.SetInputData(to_polydata(points, faces))
    _filters.warn(_filters.run(report)[1])
    return json.loads(report.GetReport())


def cut_to_disk(points: Any,
                faces: Any = None,
                *,
                region: Any = None,
                values: Sequence[Union[int, str]] = (),
                keep: bool = False,
                plane: Optional[tuple[Sequence[float], Sequence[float]]] = None,
                progress: Progress = None,
                **options: Any) -> Surface:
    """Opens a closed surface by removing a region (the medial wall), so that what is left is a disk.

    points, faces  arrays, or one Surface or vtkPolyData of genus 0
    region         one label or flag per vertex, or the name of such a point array
    values         labels that form the region, or their names where an annotation was read; none = every label but
                   0
    keep           the region is what to keep (a cortex label)
    plane          (point, normal) instead of a region: removes the side that the normal points to, mm
    progress       progress(fraction, stage); returning False cancels
    options        of vtkCutToDisk: largest_region_only, loop_smoothing

    point_arrays["OriginalPointIds"] and face_arrays["OriginalCellIds"] say where each vertex and face comes from;
    fields have RemovedArea, KeptArea, LoopLength and counts. Raises SurfaceError, InvalidArgument, Cancelled.
    """
    mesh = to_polydata(points, faces)
    cut = _classes.vtkCutToDisk()
    _set_region(cut, mesh, region, plane)
    for value in values:
        cut.AddRegionValue(_label(mesh, cut.GetRegionArrayName(), value))
    _filters.configure(cut, keep_region=bool(keep), **options)
    cut.SetInputData(mesh)
    _filters.warn(_filters.run(cut, progress)[1])
    return Surface.from_vtk(cut.GetOutput())


def _set_region(cut, mesh, region, plane):
    if (region is None) == (plane is None):
        raise InvalidArgument("Either a region or a plane is needed to say what to remove.")
    if plane is not None:
        origin, normal = (_arrays.numbers(vector, "plane", (3,)) for vector in plane)
        cut.SetRegionModeToPlane()
        cut.SetPlaneOrigin(*origin)
        cut.SetPlaneNormal(*normal)
    elif isinstance(region, str):
        cut.SetRegionArrayName(region)
    else:
        _arrays.add_arrays(mesh.GetPointData(), {"Region": region}, mesh.GetNumberOfPoints(), "vertices")
        cut.SetRegionArrayName("Region")


def _label(mesh, array, value):
    """The number of a label: itself, or that of its name in the table that came with the array."""
    if not isinstance(value, str):
        return int(_arrays.numbers([value], "values", (1,), int)[0])
    fields = _arrays.fields_of(mesh)
    names = list(np.atleast_1d(fields.get(array + "Names", [])))
    if value not in names:
        raise InvalidArgument(f"values must be labels or names of regions of '{array}'; '{value}' is neither. "
                              f"There are: {', '.join(names) or 'no names'}.")
    return int(np.atleast_1d(fields[array + "Ids"])[names.index(value)])


def require_space(**given):
    """Refuses to bring objects together when one of them says that its space is unknown."""
    for name, mesh in given.items():
        if mesh is not None and _arrays.fields_of(mesh).get("CoordinateSpace") == "unknown":
            raise InvalidArgument(
                f"The {name} must be in scanner RAS mm, but it does not say in which space it is; where you "
                'know, say so: read_surface(path, space="scanner-ras").')
