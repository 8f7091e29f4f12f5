"""Every class of the compiled modules by its own name."""
import importlib
import pathlib

__all__ = []

for _path in sorted(pathlib.Path(__file__).parent.glob("vtkAuthalic*.so")):
    _module = importlib.import_module("." + _path.name.split(".")[0], __package__)
    for _name in sorted(vars(_module)):
        if _name.startswith("vtk"):
            globals()[_name] = getattr(_module, _name)
            __all__.append(_name)
