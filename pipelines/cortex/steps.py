"""Two steps of the job that VTK and Authalic have no filter for, written as VTK filters in Python."""
import numpy as np
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkWindowedSincPolyDataFilter

import arrays


class SulcalDepth(VTKPythonAlgorithmBase):
    """Adds the point array sulcal_depth: mm below (positive, sulci) a surface smoothed until it has no folds."""

    def __init__(self):
        super().__init__(inputType="vtkPolyData", outputType="vtkPolyData")

    def RequestData(self, _request, inputs, outputs):
        surface = vtkPolyData.GetData(inputs[0])
        pass_band = np.clip(2e-4 * arrays.face_areas(surface).mean()**0.5, 2e-4, 1e-3)
        smooth = vtkWindowedSincPolyDataFilter()
        smooth.SetInputData(surface)
        smooth.SetNumberOfIterations(int(0.08 / pass_band))
        smooth.SetPassBand(pass_band)
        smooth.NormalizeCoordinatesOn()
        normals = vtkPolyDataNormals()
        normals.SetInputConnection(smooth.GetOutputPort())
        normals.SplittingOff()
        normals.ConsistencyOff()
        normals.Update()
        reference = normals.GetOutput()
        outward = arrays.point_array(reference, "Normals")
        below = np.einsum("ij,ij->i", arrays.points(reference) - arrays.points(surface), outward)
        out = vtkPolyData.GetData(outputs)
        out.ShallowCopy(surface)
        arrays.add_point_array(out, "sulcal_depth", below)
        return 1


class UprightMap(VTKPythonAlgorithmBase):
    """Turns a map to the disk about its centre until, in the mean over the map, superior points up (+v)."""

    def __init__(self):
        super().__init__(inputType="vtkPolyData", outputType="vtkPolyData")

    def RequestData(self, _request, inputs, outputs):
        map_ = vtkPolyData.GetData(inputs[0])
        uv = arrays.points(map_)[:, :2]
        x, y = arrays.mean_gradient(uv, arrays.point_array(map_, "OriginalPoints")[:, 2])
        upright = np.column_stack([y * uv[:, 0] - x * uv[:, 1], x * uv[:, 0] + y * uv[:, 1], np.zeros(len(uv))])
        vtkPolyData.GetData(outputs).ShallowCopy(arrays.with_points(map_, upright))
        return 1
