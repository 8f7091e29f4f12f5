"""Making a clean oriented manifold of a broken surface."""
import dataclasses
import json
from typing import Any, Optional

from . import _classes, _filters
from ._errors import AuthalicWarning, NotConvergedWarning
from ._surfaces import Progress, Surface, to_polydata


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class RepairedSurface(Surface):
    """A repaired surface and everything that was changed.

    changed       how many changes there were; 0 = points and faces are those of the input, bit for bit
    changes       {kind: {"count": n, "first": [{"ids", "place_mm", "length_mm" or "area_mm2"}, ...]}} of the kinds that
                  occurred, ids of the input: isolated_vertices, degenerate_faces, duplicate_faces, seams, t_junctions,
                  non_manifold_edges, non_manifold_vertices, stray_components, flipped_faces, inside_out_components,
                  holes, handles (all of these, of the others the first 100)
    remaining     what the surface still has that some maps refuse ("2 components"); empty = nothing
    summary       one line per kind; empty when nothing was changed
    report        everything that the filter reports: topology of the result, options, rounds ...
    point_arrays  with OriginalPointIds, face_arrays with OriginalCellIds: vertex and face of the input, -1 = new;
                  other arrays have the values beside where something is new
    """
    changed: int = 0
    changes: dict[str, Any] = dataclasses.field(default_factory=dict)
    remaining: str = ""
    summary: str = ""
    report: dict[str, Any] = dataclasses.field(default_factory=dict)

    def __repr__(self) -> str:
        return (f"RepairedSurface({len(self.points)} vertices, {len(self.faces)} faces, "
                f"changed={ {kind: entry['count'] for kind, entry in self.changes.items()} }, "
                f"remaining={self.remaining!r})")


def repair(points: Any,
           faces: Any = None,
           *,
           largest_hole: Optional[float] = None,
           largest_handle: Optional[float] = None,
           stray_share: Optional[float] = None,
           progress: Progress = None,
           **options: Any) -> RepairedSurface:
    """A clean oriented manifold from a broken surface, with a list of everything that was changed.

    points, faces   arrays, or one Surface or vtkPolyData: triangles, however broken
    largest_hole    boundary loops up to this length are filled, mm; 0 = none, negative (default) = a tenth of the
                    square root of the area
    largest_handle  handles whose shortest loop is at most this long are cut and capped, mm; 0 = none, negative
                    (default) = all
    stray_share     components with less than this fraction of the largest one's area are removed; 1 = keep one
    progress        progress(fraction, stage); returning False cancels
    options         of vtkSurfaceRepair: sew_seams, junction_tolerance

    Points never move; a clean surface comes back as it is. What is left that some maps refuse is an AuthalicWarning.
    Raises SurfaceError with the reason when a surface cannot be repaired (one-sided, triangles that do not meet),
    InvalidArgument, Cancelled.

    >>> disk = authalic.repair(authalic.read_surface("colon.vtk"))
    >>> [handle["place_mm"] for handle in disk.changes["handles"]["first"]]
    """
    algorithm = _classes.vtkSurfaceRepair()
    _filters.configure(algorithm, largest_hole=largest_hole, largest_handle=largest_handle, stray_share=stray_share,
                       **options)
    algorithm.SetInputData(to_polydata(points, faces))
    kind, doubts = _filters.run(algorithm, progress)
    _filters.warn(doubts, NotConvergedWarning if kind == _filters.NOT_CONVERGED else AuthalicWarning)
    report = json.loads(algorithm.GetReport())
    surface = Surface.from_vtk(algorithm.GetOutput())
    return RepairedSurface(surface.points, surface.faces, surface.point_arrays, surface.face_arrays, surface.fields,
                           report["changed"], report["changes"], report["remaining"], algorithm.GetSummary().strip(),
                           report)
