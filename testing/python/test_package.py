#!/usr/bin/python3
"""The Python package: every class by its own name, documented, and in a pipeline with VTK's own filters."""
import unittest

import authalic
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource

CLASSES = """vtkSurfaceFileReader vtkSurfaceFileWriter vtkVolumeFileReader vtkVolumeFileWriter
vtkVertexDataReader vtkVertexDataWriter vtkCorticalSurface vtkCutToDisk vtkBarycentricMap
vtkDiscreteLieFlow vtkMapDistortion vtkSurfaceTopologyReport
vtkSampleVolumeOnSurface vtkLabelsOnSurface vtkElementGrid vtkElementStatistics vtkRegionDensity
vtkCurvatureDensity""".split()


def sheet(resolution=12):
    source = vtkPlaneSource()
    source.SetResolution(resolution, resolution)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


class Package(unittest.TestCase):
    def test_has_every_class_with_a_docstring(self):
        for name in CLASSES:
            self.assertIn(name, authalic.__all__)
            self.assertGreater(len(getattr(authalic, name).__doc__), 200, name)

    def test_maps_a_sheet_in_a_pipeline(self):
        flow = authalic.vtkDiscreteLieFlow()
        flow.SetInputData(sheet())
        flow.Update()
        self.assertIn(flow.GetErrorKind(), (0, 4))
        output = flow.GetOutput()
        self.assertEqual(vtk_to_numpy(output.GetCellData().GetArray("Flipped")).sum(), 0)
        self.assertIn('"method": "lie-flow"', flow.GetReport())

    def test_reaches_element_tables_from_a_ball(self):
        ball = vtkSphereSource()
        ball.SetThetaResolution(40)
        ball.SetPhiResolution(40)
        cut = authalic.vtkCutToDisk()
        cut.SetInputConnection(ball.GetOutputPort())
        cut.SetRegionModeToPlane()
        cut.SetPlaneOrigin(0.3, 0, 0)
        flow = authalic.vtkDiscreteLieFlow()
        flow.SetInputConnection(cut.GetOutputPort())
        image = vtkImageData()
        image.SetDimensions(21, 21, 21)
        image.SetOrigin(-1, -1, -1)
        image.SetSpacing(0.1, 0.1, 0.1)
        image.AllocateScalars(10, 1)
        vtk_to_numpy(image.GetPointData().GetScalars())[:] = 3.0
        sample = authalic.vtkSampleVolumeOnSurface()
        sample.SetInputConnection(0, flow.GetOutputPort())
        sample.SetInputData(1, image)
        sample.SetArrayName("Three")
        grid = authalic.vtkElementGrid()
        grid.SetInputConnection(sample.GetOutputPort())
        grid.SetNumberOfElements(50)
        statistics = authalic.vtkElementStatistics()
        statistics.SetInputConnection(grid.GetOutputPort())
        statistics.Update()
        table = statistics.GetOutput()
        self.assertGreater(table.GetNumberOfRows(), 30)
        self.assertAlmostEqual(table.GetColumnByName("three_mean").GetValue(0), 3.0, 6)

    def test_an_error_is_an_error_kind_and_no_crash(self):
        said = []
        report = authalic.vtkSurfaceTopologyReport()
        report.AddObserver("ErrorEvent", lambda *_: said.append(1))
        report.SetInputData(vtkPolyData())
        report.Update()
        self.assertEqual(report.GetErrorKind(), report.SURFACE)
        self.assertTrue(said)


if __name__ == "__main__":
    unittest.main(verbosity=2)
