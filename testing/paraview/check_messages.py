#!/usr/bin/python3
"""What goes wrong arrives as a message of ParaView, in our sentence, and ParaView goes on.

    check_messages.py ROOT
"""
import re
import sys
import tempfile

from plugin_build import PluginBuild

# Case: level of the message, part of the sentence, ErrorKind.
EXPECTED = {
    "closed_surface": ("ERR", "A topological disk is required", 3),
    "quadrilaterals": ("ERR", "must consist of triangles; cell 0 has 4 corners", 3),
    "missing_array": ("ERR", "needs an array named 'Nowhere'", 2),
    "polygon_without_corners": ("ERR", "at least 3 finite corners", 2),
    "not_a_map": ("ERR", "needs an array named 'OriginalPoints'", 2),
    "not_converged": ("WARN", "Not converged", 4),
    "missing_file": ("ERR", "/nowhere/lh.white: The file does not exist", 5),
    "damaged_volume": ("ERR", "lacks NIfTI's magic word", 5),
    "values_of_another_surface": ("ERR", "1261 vertices of the surface is needed, but the file holds 3", 3),
    "unwritable_file": ("ERR", "/nowhere/cut.gii: The file cannot be created", None),
}


def violations(text):
    for name, (level, sentence, kind) in EXPECTED.items():
        part = re.search(rf"BEGIN {name}\n(.*?)END {name} (\S+)", text, flags=re.S)
        if part is None:
            yield f"{name}: did not run"
        elif not re.search(rf"{level}\|[^\n]*{re.escape(sentence)}", part.group(1)):
            yield f"{name}: no {level} with '{sentence}' in\n{part.group(1)}"
        elif kind is not None and part.group(2) != str(kind):
            yield f"{name}: ErrorKind {part.group(2)} instead of {kind}"
    if "survived" not in text:
        yield "ParaView did not survive"


def main():
    with tempfile.TemporaryDirectory() as folder:
        found = list(violations(PluginBuild(sys.argv[1]).run("pvpython", "fail_in_paraview.py", folder)))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
