#!/usr/bin/python3
"""Every proxy gives, bit by bit, what its class gives in VTK alone, and writes the same files.

    compare_with_vtk.py LAUNCHER ROOT

Runs the cases in ParaView (LAUNCHER is pvpython, pvbatch, or mpi for two processes), runs them again with the package
`authalic`, and compares. Exits 1 with one line per difference.
"""
import pathlib
import sys
import tempfile

import authalic
import cases
import numpy as np
from plugin_build import PluginBuild
from vtkmodules.util.numpy_support import vtk_to_numpy

VOLATILE = {"field:Report"}  # holds seconds


def run_case(kind, inputs, properties, made, folders):
    filter_ = getattr(authalic, "vtk" + kind)()
    for port, (_, source, output) in enumerate(inputs):
        filter_.SetInputConnection(port, made[source].GetOutputPort(output))
    for name, value in properties.items():
        if isinstance(value, list):
            for item in value:
                getattr(filter_, "Add" + name)(*(item if isinstance(item, tuple) else (item,)))
        else:
            getattr(filter_, "Set" + name)(cases.placed(value, folders))
    filter_.Write() if kind.endswith("Writer") else filter_.Update()
    return filter_


def information(filter_):
    return {"information:" + name: np.array(getattr(filter_, "Get" + name)())
            for name in cases.RESULTS if hasattr(filter_, "Get" + name)}


def differences(where, expected, actual):
    for name in sorted((set(expected) | set(actual)) - VOLATILE):
        if name not in expected or name not in actual:
            yield f"{where} {name}: only in {'VTK' if name in expected else 'ParaView'}"
        elif expected[name].shape != actual[name].shape:
            yield f"{where} {name}: {expected[name].shape} in VTK, {actual[name].shape} in ParaView"
        elif not np.array_equal(expected[name], actual[name], equal_nan=expected[name].dtype.kind == "f"):
            yield f"{where} {name}: other values"


def compare(folder, fixtures):
    folders = {"FIXTURES": fixtures, "OUT": str(folder / "vtk")}
    made, compared = {}, 0
    for name, kind, inputs, properties in cases.all_cases():
        made[name] = run_case(kind, inputs, properties, made, folders)
        if kind.endswith("Writer"):
            written = pathlib.Path(cases.placed(properties["FileName"], folders))
            if written.read_bytes() != (folder / "paraview" / written.name).read_bytes():
                yield f"{name}: the files differ"
            continue
        for port in range(made[name].GetNumberOfOutputPorts()):
            expected = information(made[name])
            if not cases.failed(expected):
                expected.update(cases.arrays_of(made[name].GetOutputDataObject(port), vtk_to_numpy))
            with np.load(folder / "paraview" / f"{name}.{port}.npz") as actual:
                yield from differences(f"{name}.{port}", expected, dict(actual))
            compared += len(expected)
    print(f"{len(made)} cases, {compared} arrays compared")


def main():
    launcher, root = sys.argv[1:3]
    build = PluginBuild(root)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for side in ("vtk", "paraview"):
            (folder / side).mkdir()
        build.run(launcher, "run_in_paraview.py", folder / "paraview")
        violations = list(compare(folder, build.fixtures))
    print("\n".join(violations))
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
