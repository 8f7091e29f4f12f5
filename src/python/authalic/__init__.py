"""Authalic: area-preserving, measure-controlled and conformal maps of cortical and colon surfaces.

Functions take and return numpy arrays:

>>> import authalic
>>> surface = authalic.read_surface("lh.pial")
>>> surface = authalic.read_vertex_data("lh.cortex.label", surface, name="cortex")
>>> disk = authalic.cut_to_disk(surface, region="cortex", keep=True)
>>> map = authalic.flatten(disk)                  # or flatten(points, faces, method=..., domain=...)
>>> map.image, map.status, map.metrics["flipped_faces"]

    files      read_surface, write_surface, read_vertex_data, write_vertex_data, read_volume, write_volume
    surfaces   topology, repair, cut_to_disk, cortical_surfaces
    maps       flatten, methods, measure_distortion, balance_curve
    sampling   sample_volume, labels_on_surface, elements
    results    Surface, RepairedSurface, SurfaceMap, Volume, Samples, Elements, Distortion, BalanceCurve
    failures   Error: InvalidArgument, SurfaceError, SolverError, FormatError, Cancelled, NotConverged;
               AuthalicWarning: NotConvergedWarning

They run the VTK classes of this package (vtkAuthalicMap ...), which join any VTK pipeline by themselves;
help() shows their ports, arrays and options with units and defaults. Coordinates are scanner RAS in mm.
"""
from . import _classes
from ._classes import *  # noqa: F403
from ._elements import Elements, elements
from ._errors import (AuthalicWarning, Cancelled, Error, FormatError, InvalidArgument, NotConverged,
                      NotConvergedWarning, SolverError, SurfaceError)
from ._maps import BalanceCurve, Distortion, SurfaceMap, balance_curve, flatten, measure_distortion, methods
from ._repair import RepairedSurface, repair
from ._surfaces import (Surface, cut_to_disk, read_surface, read_vertex_data, topology, write_surface,
                        write_vertex_data)
from ._volumes import Samples, Volume, cortical_surfaces, labels_on_surface, read_volume, sample_volume, write_volume

__version__ = "@PROJECT_VERSION@"
__all__ = [
    "AuthalicWarning",
    "BalanceCurve",
    "Cancelled",
    "Distortion",
    "Elements",
    "Error",
    "FormatError",
    "InvalidArgument",
    "NotConverged",
    "NotConvergedWarning",
    "RepairedSurface",
    "Samples",
    "SolverError",
    "Surface",
    "SurfaceError",
    "SurfaceMap",
    "Volume",
    "balance_curve",
    "cortical_surfaces",
    "cut_to_disk",
    "elements",
    "flatten",
    "labels_on_surface",
    "measure_distortion",
    "methods",
    "read_surface",
    "read_vertex_data",
    "read_volume",
    "repair",
    "sample_volume",
    "topology",
    "write_surface",
    "write_vertex_data",
    "write_volume",
]
__all__ += _classes.__all__

for _failure in (AuthalicWarning, Cancelled, Error, FormatError, InvalidArgument, NotConverged, NotConvergedWarning,
                 SolverError, SurfaceError):
    _failure.__module__ = __name__  # a trace shows authalic.SurfaceError
