#!/usr/bin/python3
"""pipelines/paraview leaves a picture with something in each of its four views, a map, and a state that opens.

    check_pipeline.py ROOT
"""
import pathlib
import re
import sys
import tempfile

import numpy as np
from plugin_build import PluginBuild
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3]


def picture_errors(path):
    image = pixels(path)
    height, width = image.shape[0] // 2, image.shape[1] // 2
    for row in range(2):
        for column in range(2):
            view = image[row * height:(row + 1) * height, column * width:(column + 1) * width]
            drawn = np.mean(np.any(view < 250, axis=2))
            if not 0.05 < drawn < 0.9:
                yield f"the view in row {row} from below, column {column}: {drawn:.1%} is drawn on"


def map_errors(path, printed):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    fields = reader.GetOutput().GetFieldData()
    area = fields.GetArray("TotalAreaDistortion").GetValue(0)
    if fields.GetArray("Elements").GetValue(0) < 300 or f"D_area {area:.6g}" not in printed:
        yield f"map.vtp: {fields.GetArray('Elements').GetValue(0)} elements, D_area {area}, not what was printed"


def violations(build, folder):
    printed = build.draw("pvbatch", "flatten.py", "--surface", f"{build.fixtures}/bumpy_disk.off", "--out", folder)
    yield from picture_errors(folder / "flattened.png")
    yield from map_errors(folder / "map.vtp", printed)
    opened = build.draw("pvpython", "open_state.py", "--state", folder / "flattened.pvsm")
    before = re.search(r"Area-preserving map: (.*)", printed).group(1)
    after = re.search(r"Area-preserving map: (.*)", opened).group(1)
    if before != after:
        yield f"the state that was saved gives {after} instead of {before}"


def main():
    with tempfile.TemporaryDirectory() as folder:
        found = list(violations(PluginBuild(sys.argv[1]), pathlib.Path(folder)))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
