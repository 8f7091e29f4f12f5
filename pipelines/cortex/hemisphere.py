"""What the job knows about one hemisphere when its pipeline has run."""
from dataclasses import dataclass, field

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

import arrays

INITIAL, AUTHALIC = "initial map", "area-preserving map"
SIDES = {"lh": "left", "rh": "right"}


@dataclass
class Hemisphere:
    side: str  # lh or rh
    white: vtkPolyData  # the closed surface, mm, with every sampled array
    topology: dict  # numbers of vtkSurfaceTopologyReport
    cut: dict  # numbers of vtkCutToDisk
    fields: list  # (point array, unit, meaning)
    regions: dict  # label: name, of the labels that occur
    maps: dict = field(default_factory=dict)  # INITIAL, AUTHALIC: output 0 of vtkElementGrid
    borders: dict = field(default_factory=dict)  # output 1: lines between elements
    cells: dict = field(default_factory=dict)  # output 2: one row per element
    tables: dict = field(default_factory=dict)  # vtkElementStatistics, ready to write

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
        return arrays.point_array(self.flat, "OriginalPointIds")

    def element_ratios(self, name):
        """Area over target area of each interior element of a map, whole squares only."""
        cells = self.cells[name]
        return arrays.cell_array(cells, "ElementAreaRatio")[arrays.cell_array(cells, "Interior") > 0]

    def numbers(self, name):
        """Field data of a map: distortion, status, elements."""
        return arrays.field_numbers(self.maps[name])
