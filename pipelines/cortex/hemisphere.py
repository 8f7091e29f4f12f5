"""What the job knows about one hemisphere when its pipeline has run."""
from dataclasses import dataclass, field

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

import arrays

INITIAL, AUTHALIC = "initial map", "area-preserving map"
SIDES = {"lh": "left", "rh": "right"}


@dataclass
class Hemisphere:
    side: str  # lh or rh
    topology: dict  # numbers of vtkSurfaceTopologyReport
    fields: list  # (point array, unit, meaning)
    white: vtkPolyData = None  # the closed surface, mm, with every sampled array
    cut: dict = field(default_factory=dict)  # numbers of vtkCutToDisk
    regions: dict = field(default_factory=dict)  # label: name, of the labels that occur
    maps: dict = field(default_factory=dict)  # INITIAL, AUTHALIC: output 0 of vtkElementGrid
    borders: dict = field(default_factory=dict)  # output 1: lines between elements
    cells: dict = field(default_factory=dict)  # output 2: one row per element
    tables: dict = field(default_factory=dict)  # vtkElementStatistics, ready to write

    def keep(self, name, elements):
        """Keeps the three outputs of a vtkElementGrid under the name of its map."""
        self.maps[name] = elements.GetOutput(0)
        self.borders[name] = elements.GetOutput(1)
        self.cells[name] = elements.GetOutput(2)

    def names_present(self, names):
        """{label: name} of the labels that occur on the surface; a number where there is no name."""
        labels = arrays.point_array(self.white, "Label")
        if labels is None:
            return {}
        return {int(k): names.get(int(k), f"region {int(k)}") for k in np.unique(labels[labels > 0])}

    @property
    def flat(self):
        return self.maps[AUTHALIC]

    def vertex_values(self, array, missing=np.nan):
        """A point array of the flat map in the full vertex order of the white surface."""
        values = arrays.point_array(self.flat, array)
        full = np.full(self.white.GetNumberOfPoints(), missing, dtype=np.result_type(values, type(missing)))
        full[self.original_ids()] = values
        return full

    def original_ids(self):
        """Vertex of the white surface for each vertex of the maps."""
        ids = arrays.point_array(self.flat, "OriginalPointIds")
        return np.arange(self.flat.GetNumberOfPoints()) if ids is None else ids

    def element_ratios(self, name):
        """Area over target area of each interior element of a map, whole squares only."""
        cells = self.cells[name]
        return arrays.cell_array(cells, "ElementAreaRatio")[arrays.cell_array(cells, "Interior") > 0]

    def numbers(self, name):
        """Field data of a map: distortion, status, elements."""
        return arrays.field_numbers(self.maps[name])

    def shown_field(self):
        """The field of the picture: the T1 in the cortex, else the first there is."""
        by_name = {entry[0]: entry for entry in self.fields}
        return by_name.get("t1_cortex", self.fields[0])

    def element_column(self, array, statistic):
        """A column of the element table of the area-preserving map, one number per element."""
        table = self.tables[AUTHALIC].GetOutput(0)
        return vtk_to_numpy(table.GetColumnByName(f"{array}_{statistic}")).astype(float)
