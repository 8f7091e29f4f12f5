"""Authalic: area-preserving maps of cortical surfaces, as VTK filters.

Every class of the VTK modules is here by its own name and joins any VTK pipeline:

>>> import authalic
>>> flow = authalic.vtkDiscreteLieFlow()
>>> flow.SetInputData(surface)   # a vtkPolyData of triangles with one boundary loop
>>> flow.Update()
>>> image = flow.GetOutput()     # points are the image, point array OriginalPoints the surface

help(authalic.vtkDiscreteLieFlow) shows ports, arrays and options with their units and defaults.
"""
import importlib as _importlib
import pathlib as _pathlib

__version__ = "@PROJECT_VERSION@"
__all__ = []

for _path in sorted(_pathlib.Path(__file__).parent.glob("vtkAuthalic*.so")):
    _module = _importlib.import_module("." + _path.name.split(".")[0], __name__)
    for _name in sorted(vars(_module)):
        if _name.startswith("vtk"):
            globals()[_name] = getattr(_module, _name)
            __all__.append(_name)
