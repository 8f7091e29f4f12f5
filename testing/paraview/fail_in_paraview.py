"""Pipelines that must fail in words: each leaves its messages, and ParaView goes on.

    pvpython fail_in_paraview.py PLUGIN FIXTURES OUT
"""
import pathlib
import sys

from paraview import servermanager, simple


def closed_surface():
    return BarycentricMap(Input=simple.Sphere())


def quadrilaterals():
    return DiscreteLieFlow(Input=simple.Plane(XResolution=4, YResolution=4))


def missing_array(disk):
    return DiscreteLieFlow(Input=disk, MeasureArrayName="Nowhere")


def polygon_without_corners(disk):
    return BarycentricMap(Input=disk, Domain="Polygon")


def not_a_map(disk):
    return ElementGrid(Input=disk)


def not_converged(disk):
    return DiscreteLieFlow(Input=disk, MaximumIterations=0, Finish="None")


def missing_file():
    return SurfaceFileReader(FileName="/nowhere/lh.white")


def damaged_volume(out):
    path = pathlib.Path(out) / "damaged.nii"
    path.write_bytes(b"\x5c\x01\x00\x00" + bytes(400))
    return VolumeFileReader(FileName=str(path))


def values_of_another_surface(disk, out):
    path = pathlib.Path(out) / "three.txt"
    path.write_text("1\n2\n3\n")
    return VertexDataReader(Input=disk, FileName=str(path))


def unwritable_file(disk):
    return servermanager.writers.SurfaceFileWriter(Input=disk, FileName="/nowhere/cut.gii")


def main():
    plugin, fixtures, out = sys.argv[1:]
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    disk = SurfaceFileReader(FileName=fixtures + "/bumpy_disk.off")
    for make, arguments in ((closed_surface, ()), (quadrilaterals, ()), (missing_array, (disk,)),
                            (polygon_without_corners, (disk,)), (not_a_map, (disk,)), (not_converged, (disk,)),
                            (missing_file, ()), (damaged_volume, (out,)), (values_of_another_surface, (disk, out)),
                            (unwritable_file, (disk,))):
        proxy = make(*arguments)
        print("BEGIN", make.__name__, file=sys.stderr, flush=True)
        proxy.UpdatePipeline()
        proxy.UpdatePropertyInformation()
        kind = proxy.SMProxy.GetProperty("ErrorKind")
        print("END", make.__name__, kind.GetElement(0) if kind else "-", file=sys.stderr, flush=True)
    print("survived", flush=True)


main()
