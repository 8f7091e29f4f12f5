"""Surfaces spread over several processes, examined and mapped; prints what came of it as one line of JSON.

    pvbatch distribute_in_paraview.py PLUGIN FIXTURES
"""
import json
import sys

from paraview import servermanager, simple


def told(proxy, *names):
    proxy.UpdatePipeline()
    proxy.UpdatePropertyInformation()
    return [proxy.SMProxy.GetProperty(name).GetElement(0) for name in names]


def pieces(proxy):
    """Points on each process."""
    proxy.UpdatePipeline()
    ids = simple.ProcessIdScalars(Input=proxy)
    ids.UpdatePipeline()
    array = servermanager.Fetch(ids).GetPointData().GetArray("ProcessId")
    values = [array.GetValue(i) for i in range(array.GetNumberOfTuples())]
    return [values.count(rank) for rank in range(max(values) + 1)]


def main():
    plugin, fixtures = sys.argv[1:3]
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    disk = SurfaceFileReader(FileName=fixtures + "/bumpy_disk.off")
    spread = simple.ExtractSurface(Input=simple.RedistributeDataSet(Input=disk, GenerateGlobalCellIds=0))
    sphere = simple.Sphere(ThetaResolution=40, PhiResolution=30)
    tutte = {"Method": "Tutte"}
    whole, joined = BarycentricMap(Input=disk, **tutte), BarycentricMap(Input=spread, **tutte)
    result = {
        "disk pieces": pieces(disk), "spread pieces": pieces(spread), "sphere pieces": pieces(sphere),
        "disk summary": told(SurfaceTopologyReport(Input=disk), "Summary"),
        "spread summary": told(SurfaceTopologyReport(Input=spread), "Summary"),
        "sphere summary": told(SurfaceTopologyReport(Input=sphere), "Summary"),
        "whole map": told(whole, "Status", "TotalAreaDistortion", "TotalAngleDistortion", "FlippedFaces"),
        "joined map": told(joined, "Status", "TotalAreaDistortion", "TotalAngleDistortion", "FlippedFaces"),
        "joined map pieces": pieces(joined),
        "refused": told(BarycentricMap(Input=sphere), "Status", "ErrorKind"),
    }
    print("RESULT " + json.dumps(result), flush=True)


main()
