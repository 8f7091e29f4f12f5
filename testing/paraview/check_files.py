#!/usr/bin/python3
"""ParaView finds our readers and writers by the names of files.

    check_files.py ROOT
"""
import json
import sys
import tempfile

from plugin_build import PluginBuild

SURFACE, VOLUME = "SurfaceFileReader", "VolumeFileReader"
# Name: reader, writer; None = not ours to say.
EXPECTED = {
    "a.gii": (SURFACE, "SurfaceFileWriter"), "lh.midthickness.surf.gii": (SURFACE, "SurfaceFileWriter"),
    "a.gii.gz": (SURFACE, None), "a.off": (SURFACE, "SurfaceFileWriter"), "lh.white": (SURFACE, "SurfaceFileWriter"),
    "rh.pial": (SURFACE, "SurfaceFileWriter"), "lh.sphere.reg": (SURFACE, None),
    "a.inflated": (SURFACE, "SurfaceFileWriter"),
    "a.nii": (VOLUME, None), "a.nii.gz": (VOLUME, None), "orig.mgz": (VOLUME, None), "orig.mgh": (VOLUME, None),
    "a.mz3": (SURFACE, "SurfaceFileWriter"), "lh.annot": (None, "VertexDataWriter"),
    "lh.thickness": (None, "VertexDataWriter"), "rh.curv": (None, "VertexDataWriter"),
}


def violations(found):
    for name, (reader, writer) in EXPECTED.items():
        readers, actual_writer = found[name]
        if reader and readers != [reader]:
            yield f"{name} is read by {readers} instead of {reader}"
        if writer and actual_writer != writer:
            yield f"{name} is written by {actual_writer} instead of {writer}"
    if found["points"] != [1261, 1261]:
        yield f"opened, saved and opened again: {found['points']} points instead of 1261"


def main():
    with tempfile.TemporaryDirectory() as folder:
        text = PluginBuild(sys.argv[1]).run("pvpython", "files_in_paraview.py", folder, *EXPECTED)
    line = next(line for line in text.splitlines() if line.startswith("RESULT "))
    found = list(violations(json.loads(line[len("RESULT "):])))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
