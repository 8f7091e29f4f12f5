#!/usr/bin/python3
"""Time and memory of the authalic map from 10K to 400K faces of the same shapes, and how they grow.

    growth.py COMMAND DATA [--domain disk|sphere] [--shape NAME ...] [--faces N ...] [--folder FOLDER]
              [--plot PICTURE.png]

COMMAND is the built `authalic`, DATA the folder of real test data. A shape is subdivided (Loop) to at least 350,000
faces and decimated (quadric error) from there, for the sphere with its boundary filled; meshes found in FOLDER are not
made again. Seconds are the user time of `authalic map authalic`, memory its peak resident set. The exponent is that of
the least-squares line through the logarithms. --plot draws both axes logarithmic, and needs an X server.
"""
import argparse
import pathlib
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkQuadricDecimation, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkFillHolesFilter, vtkLoopSubdivisionFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import runs

DENSE = 350_000
SHAPES = {"disk": ("chinese_lion", "human_brain", "camelhead"), "sphere": ("chinese_lion", "gargoyle", "david")}
CLOSED = {"gargoyle": "meshes/closed_g0/gargoyle.obj", "david": "meshes/closed_g0/david.off"}
COLOURS = [(0, 89, 178), (214, 94, 0), (0, 140, 90), (120, 60, 140)]


def read_off(path):
    """The triangles of an OFF file."""
    numbers = np.array(path.read_text().split()[1:], dtype=float)
    n, m = int(numbers[0]), int(numbers[1])
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(numbers[3:3 + 3 * n].reshape(n, 3).copy(), deep=1))
    faces = vtkCellArray()
    for face in numbers[3 + 3 * n:3 + 3 * n + 4 * m].reshape(m, 4).astype(int):
        faces.InsertNextCell(3, face[1:].tolist())
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(faces)
    return surface


def read(path):
    if path.suffix == ".off":
        return read_off(path)
    reader = vtkOBJReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def filtered(algorithm, surface):
    algorithm.SetInputData(surface)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(algorithm.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def closed(surface):
    holes, normals = vtkFillHolesFilter(), vtkPolyDataNormals()
    holes.SetHoleSize(1e9)
    normals.SplittingOff()
    normals.ConsistencyOn()
    return filtered(normals, filtered(holes, surface))


def dense(surface):
    while surface.GetNumberOfPolys() < DENSE:
        subdivision = vtkLoopSubdivisionFilter()
        subdivision.SetNumberOfSubdivisions(1)
        surface = filtered(subdivision, surface)
    return surface


def series(options, shape, close=False):
    """The files of a shape, coarse to fine; makes those that are missing."""
    name = f"{shape}_closed" if close else shape
    files = [options.folder / f"{name}_{faces // 1000}K.vtp" for faces in options.faces]
    finest = None
    for faces, path in zip(options.faces, files):
        if path.exists():
            continue
        if finest is None:
            surface = read(options.data / {**runs.DISKS, **CLOSED}[shape])
            finest = dense(closed(surface) if close else surface)
        decimation = vtkQuadricDecimation()
        decimation.VolumePreservationOn()
        decimation.SetTargetReduction(max(0.0, 1 - faces / finest.GetNumberOfPolys()))
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(filtered(decimation, finest))
        writer.SetFileName(str(path))
        writer.Write()
    return files


def measured(options, shape):
    """Rows of (faces, seconds, MB) of one shape, printed on the way."""
    found = []
    for path in series(options, shape, options.domain == "sphere"):
        with tempfile.TemporaryDirectory() as folder:
            run = runs.Run(options.command, path, ["authalic", "--domain", options.domain], folder)
        faces, megabytes = run.report["topology"]["faces"], run.kilobytes / 1024
        print(runs.row(shape, f"{faces:,}", run.report["status"], run.report["iterations"],
                       f"{run.metrics['area_distortion'] - 2:.1e}", run.report["flips"], f"{run.seconds:.2f}",
                       f"{megabytes:.0f}"), flush=True)
        found.append((faces, run.seconds, megabytes))
    return np.array(found)


def exponent(x, y):
    return np.polyfit(np.log(x), np.log(y), 1)[0]


def draw(tables, picture):
    """Seconds against faces, both logarithmic, with a line of slope 1.3 beside them."""
    from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
    from vtkmodules.vtkCommonDataModel import vtkTable
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
    from vtkmodules.vtkViewsContext2D import vtkContextView
    import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401  VTK's factory for charts
    view, chart = vtkContextView(), vtkChartXY()
    view.GetScene().AddItem(chart)
    view.GetRenderWindow().SetSize(900, 600)
    view.GetRenderWindow().SetMultiSamples(0)
    first = min(table[0, 1] / table[0, 0] ** 1.3 for table in tables.values())
    x = np.array([1e4, 4e5])
    curves = {f"{shape} (exponent {exponent(t[:, 0], t[:, 1]):.2f})": t[:, :2] for shape, t in tables.items()}
    curves["slope 1.3"] = np.column_stack([x, first * x ** 1.3])
    columns = []
    for (label, curve), colour in zip(curves.items(), COLOURS[:len(tables)] + [(130, 130, 130)]):
        table = vtkTable()
        for name, column in (("x", curve[:, 0]), (label, curve[:, 1])):
            array = numpy_to_vtk(np.log10(column), deep=1)
            array.SetName(name)
            table.AddColumn(array)
        columns.append(table)
        plot = chart.AddPlot(vtkChart.LINE)
        plot.SetInputData(table, 0, 1)
        plot.SetColor(*colour, 255)
        plot.SetWidth(3)
        plot.SetMarkerStyle(4 if label != "slope 1.3" else 0)
    ticks = {vtkAxis.BOTTOM: ("faces", [10_000, 25_000, 50_000, 100_000, 200_000, 400_000]),
             vtkAxis.LEFT: ("user seconds", [0.1, 0.3, 1, 3, 10, 30, 100])}
    for side, (title, places) in ticks.items():
        label_axis(chart.GetAxis(side), title, places)
    chart.SetShowLegend(True)
    chart.GetLegend().SetHorizontalAlignment(0)
    view.GetRenderWindow().SetOffScreenRendering(1)
    view.GetRenderWindow().Render()
    grabbed, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    grabbed.SetInput(view.GetRenderWindow())
    writer.SetInputConnection(grabbed.GetOutputPort())
    writer.SetFileName(str(picture))
    writer.Write()


def label_axis(axis, title, places):
    from vtkmodules.vtkCommonCore import vtkStringArray
    labels = vtkStringArray()
    for place in places:
        labels.InsertNextValue(f"{place // 1000}K" if place >= 1000 else f"{place:g}")
    axis.SetTitle(title)
    axis.SetBehavior(1)
    axis.SetRange(np.log10(places[0]), np.log10(places[-1]) + 0.05)
    axis.SetCustomTickPositions(numpy_to_vtk(np.log10(np.array(places, dtype=float)), deep=1), labels)
    for text in (axis.GetTitleProperties(), axis.GetLabelProperties()):
        text.SetFontFamilyToArial()
        text.SetBold(False)
        text.SetFontSize(16)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--domain", choices=SHAPES, default="disk")
    parser.add_argument("--shape", action="append", choices=[*runs.DISKS, *CLOSED])
    parser.add_argument("--faces", action="append", type=int)
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--plot", type=pathlib.Path)
    options = parser.parse_args()
    options.faces = options.faces or [10_000, 25_000, 50_000, 100_000, 200_000, 400_000]
    with tempfile.TemporaryDirectory() as folder:
        options.folder = options.folder or pathlib.Path(folder)
        print(runs.head("shape", "faces", "status", "steps", "D_area − 2", "folds", "user s", "MB"))
        tables = {shape: measured(options, shape) for shape in options.shape or SHAPES[options.domain]}
    for shape, table in tables.items():
        if len(table) > 1:
            print(f"\n{shape}: seconds grow as faces^{exponent(table[:, 0], table[:, 1]):.2f}, "
                  f"memory as faces^{exponent(table[:, 0], table[:, 2]):.2f}.")
    if options.plot:
        draw(tables, options.plot)
    return 0


if __name__ == "__main__":
    sys.exit(main())
