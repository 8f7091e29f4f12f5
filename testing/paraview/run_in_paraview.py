"""Runs the cases in pvpython or pvbatch, and leaves what their proxies give as NumPy files.

    pvpython run_in_paraview.py PLUGIN FIXTURES OUT [CASE ...]
"""
import pathlib
import sys

import numpy as np
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cases  # noqa: E402



def keywords(inputs, properties, made, folders):
    """Arguments of the proxy: inputs as ports, lists flat and by their plural name."""
    found = {name: simple.OutputPort(made[source], port) for name, source, port in inputs}
    for name, value in properties.items():
        if isinstance(value, list):
            found[name + "s"] = [part for item in value for part in (item if isinstance(item, tuple) else (item,))]
        else:
            found[name] = cases.placed(value, folders)
    return found


def information(proxy):
    """Values of the properties that say how the run ended, as far as the proxy has them."""
    proxy.UpdatePropertyInformation()
    found = {}
    for name in cases.RESULTS:
        item = proxy.SMProxy.GetProperty(name)
        if item:
            found["information:" + name] = np.array(item.GetElement(0))
    return found


def read_out(name, proxy, out):
    proxy.UpdatePipeline()
    for port in range(proxy.SMProxy.GetNumberOfOutputPorts()):
        found = information(proxy)
        if not cases.failed(found):
            found.update(cases.arrays_of(servermanager.Fetch(proxy, idx=port), vtk_to_numpy))
        np.savez(f"{out}/{name}.{port}.npz", **found)


def main():
    plugin, fixtures, out, *chosen = sys.argv[1:]
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    folders, made = {"FIXTURES": fixtures, "OUT": out}, {}
    for name, kind, inputs, properties in cases.all_cases():
        if chosen and name not in chosen:
            continue
        arguments = keywords(inputs, properties, made, folders)
        if kind.endswith("Writer"):
            getattr(servermanager.writers, kind)(**arguments).UpdatePipeline()
            continue
        made[name] = globals()[kind](**arguments)
        read_out(name, made[name], out)
    print("cases:", len(made), flush=True)


main()
