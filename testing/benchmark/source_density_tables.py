#!/usr/bin/python3
"""Transport to the unit disk from a piecewise linear density, on meshes of several sizes, beside the uniform source.

    source_density_tables.py COMMAND DATA [--mesh NAME ...]

COMMAND is the built `authalic`, DATA the folder of real test data. The density is 1 + 9 exp(-12 |x - (0.35, 0.25)|^2),
on rings of triangles. A row has the Newton steps, the residual, the transport cost by the mass of the source, folds,
and the CPU seconds, reading and writing included. Ends with 1 when a transport is not converged or a cell is empty.
"""
import argparse
import math
import pathlib
import sys
import tempfile

import runs

RINGS = (20, 80, 160)


def density(x, y):
    return 1 + 9 * math.exp(-12 * ((x - 0.35)**2 + (y - 0.25)**2))


def write_disk(path, rings):
    """The unit disk: a centre, then ring r of 6 r vertices; a legacy VTK file with the point array rho."""
    points, faces, first = [(0.0, 0.0)], [], [0]
    for r in range(1, rings + 1):
        first.append(len(points))
        points += [(math.cos(math.pi * k / (3 * r)) * r / rings, math.sin(math.pi * k / (3 * r)) * r / rings)
                   for k in range(6 * r)]
        for k in range(6 * r):
            side, step = divmod(k, r)
            outer = (first[r] + k, first[r] + (k + 1) % (6 * r))
            inner = [first[r - 1] + (side * (r - 1) + s) % max(1, 6 * (r - 1)) for s in (step, step + 1)]
            faces.append((*outer, inner[0]))
            if step + 1 < r:
                faces.append((inner[0], outer[1], inner[1]))
    lines = ["# vtk DataFile Version 3.0", "density", "ASCII", "DATASET POLYDATA", f"POINTS {len(points)} double"]
    lines += [f"{x!r} {y!r} 0" for x, y in points]
    lines += [f"POLYGONS {len(faces)} {4 * len(faces)}", *(f"3 {a} {b} {c}" for a, b, c in faces)]
    lines += [f"POINT_DATA {len(points)}", "SCALARS rho double 1", "LOOKUP_TABLE default"]
    path.write_text("\n".join([*lines, *(repr(density(*point)) for point in points)]) + "\n", encoding="ascii")
    return len(faces)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--mesh", choices=runs.DISKS, action="append")
    arguments = parser.parse_args()
    good = True
    print(runs.head("surface", "triangles of the source", "steps", "residual", "cost / mass", "folds", "CPU s"))
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "density.vtk"
        for name in arguments.mesh or runs.DISKS:
            for rings in (0, *RINGS):
                faces = write_disk(path, rings) if rings else "uniform"
                words = ("transport", "--source", str(path), "--source-density", "rho") if rings else ("transport",)
                found = runs.Run(arguments.command, arguments.data / runs.DISKS[name], words, folder)
                report = found.report
                good &= report["status"] == "converged" and report["empty_cells"] == 0
                cost = report["transport_cost"] / report.get("source_mass", math.pi)
                print(runs.row(name, faces, report["iterations"], f"{report['transport_residual']:.1e}", f"{cost:.4f}",
                               report["flips"], f"{found.seconds:.2f}"), flush=True)
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
