"""Elements of equal area, and statistics of fields in them."""
import dataclasses
from typing import Any, Mapping, Optional

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray

from . import _arrays, _classes, _filters
from ._surfaces import Progress, to_polydata

Table = dict[str, Any]
SUMMARY = ("Elements", "GridColumns", "GridRows", "InteriorElements", "InteriorMaximumDeviation",
           "InteriorMeanDeviation", "MaximumDeviation", "MeanDeviation")


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class Elements:
    """Elements of a map: an isotropic grid on its image, pulled back to the surface.

    table       {column: (elements,) array}: element_id, area_mm2, centroid_x_mm ..., FIELD_mean ...
                (docs/arrays.md)
    regions     the same per label; {} without labels
    point_ids   (n,) element of the largest part of each vertex, from 1; 0 = none
    face_ids    (m,) the same for each face
    borders     (k, 2, 3) segments between elements on the surface, mm
    summary     elements, grid_columns, grid_rows, interior_elements, interior_maximum_deviation ... of the grid
    """
    table: Table
    regions: Table
    point_ids: np.ndarray
    face_ids: np.ndarray
    borders: np.ndarray
    summary: dict[str, Any]

    def __repr__(self) -> str:
        return f"Elements({len(self.table['element_id'])} elements, columns={list(self.table)})"


def elements(
        map: Any,  # pylint: disable=redefined-builtin
        fields: Optional[Mapping[str, Any]] = None,
        labels: Any = None,
        names: Optional[Mapping[int, str]] = None,
        *,
        count: Optional[int] = None,
        area: Optional[float] = None,
        hemisphere: Optional[str] = None,
        threads: int = 0,
        progress: Progress = None,
        **options: Any) -> Elements:
    """Divides a map into elements of equal area and summarises fields in them, weighted by area.

    map         SurfaceMap, or the vtkPolyData of a map filter
    fields      {name: (n,)} per vertex, NaN = n/a
    labels      (n,) int region of each vertex, 0 = none; `names` {label: name} of the regions to report
    count       how many elements are wanted; area  or the area of one, mm2. None = the default of vtkElementGrid
    hemisphere  "L" or "R" for the column hemi
    options     of vtkElementGrid: frame, merge_below

    Raises SurfaceError, InvalidArgument, Cancelled.
    """
    drawn = to_polydata(map)
    vertices = drawn.GetNumberOfPoints()
    _arrays.add_arrays(drawn.GetPointData(), fields or {}, vertices, "vertices")
    grid = _classes.vtkElementGrid()
    _filters.configure(grid, number_of_elements=count, element_area=area, threads=threads, **options)
    grid.SetInputData(drawn)
    _filters.warn(_filters.run(grid, progress)[1])
    statistics = _classes.vtkElementStatistics()
    _filters.configure(statistics, hemisphere=hemisphere, threads=threads)
    for name in fields or {}:
        statistics.AddFieldArray(name)
    divided = grid.GetOutput()
    if labels is not None:
        _arrays.add_arrays(divided.GetPointData(), {"Region": labels}, vertices, "vertices")
        statistics.SetLabelArrayName("Region")
        for label, name in (names or {}).items():
            statistics.AddRegion(int(label), name)
    statistics.SetInputData(divided)
    _filters.warn(_filters.run(statistics, progress)[1])
    return Elements(table_of(statistics.GetOutput(0)), table_of(statistics.GetOutput(1)),
                    _arrays.arrays_of(divided.GetPointData())["ElementId"],
                    _arrays.arrays_of(divided.GetCellData())["ElementId"], _segments(grid.GetOutput(1)),
                    _numbers(divided))


def table_of(table):
    """The columns of a vtkTable, {name: array}."""
    columns = {}
    for k in range(table.GetNumberOfColumns()):
        column = table.GetColumn(k)
        if isinstance(column, vtkStringArray):
            columns[column.GetName()] = np.array([column.GetValue(i) for i in range(column.GetNumberOfValues())])
        else:
            columns[column.GetName()] = vtk_to_numpy(column).copy()
    return columns


def _segments(lines):
    if lines.GetNumberOfLines() == 0:
        return np.zeros((0, 2, 3))
    ends = vtk_to_numpy(lines.GetLines().GetConnectivityArray()).reshape(-1, 2)
    return _arrays.points_of(lines)[ends]


def _numbers(divided):
    fields = _arrays.fields_of(divided)
    return {_filters.snake(name): fields[name] for name in SUMMARY}
