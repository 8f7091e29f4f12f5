#!/usr/bin/python3
"""Transport in the plane from Voronoi's cells and from coarse to fine: Newton steps and CPU seconds of both.

    transport_start_tables.py COMMAND DATA [--shape NAME ...] [--faces N ...] [--folder FOLDER]

COMMAND is the built `authalic`, DATA the folder of real test data; meshes of N faces are those of growth.py, kept in
FOLDER; N = 0 is the scan as it is. Every mesh goes to the disk, to the square, to the disk with a region of interest of
factor 16, and from the source density of source_density_tables.py. CPU seconds are of the whole command, reading and
writing included. Ends with 1 when a transport is not converged, or the second takes more steps.
"""
import argparse
import pathlib
import sys
import tempfile

import growth
import runs
import source_density_tables

REGIONS = {"chinese_lion": "sphere:-2.66,32.96,-927.4,12=16", "human_brain": "sphere:17.4173,-86.2536,32.5424,20=16"}
STARTS = ("voronoi", "coarse-to-fine")
RINGS = 80


def cases(shape, density):
    yield "disk", ()
    yield "square", ("--domain", "square")
    if shape in REGIONS:
        yield "disk, region × 16", ("--roi", REGIONS[shape])
    yield "disk, source density", ("--source", str(density), "--source-density", "rho")


def levels(report):
    """Sites and Newton steps of the transports before the last, coarsest first."""
    return ", ".join(f"{level['sites']}: {level['iterations']}" for level in report["levels"][:-1])


def compare(command, surface, words, folder):
    """Both runs, and whether they are as they shall be."""
    found = [runs.Run(command, surface, ("transport", *words, "--start", start), folder) for start in STARTS]
    good = all(run.report["status"] == "converged" and run.report["empty_cells"] == 0 for run in found)
    return found, good and found[1].report["iterations"] <= found[0].report["iterations"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--shape", choices=runs.DISKS, action="append")
    parser.add_argument("--faces", type=int, nargs="+", default=[0, 100_000, 390_000])
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path(tempfile.gettempdir()))
    options = parser.parse_args()
    sizes, good = options.faces, True
    print(runs.head("surface, vertices", "transport", "steps from Voronoi's cells", "from coarse to fine", "t",
                    "coarser sites: steps", "CPU s from Voronoi's cells", "from coarse to fine"))
    with tempfile.TemporaryDirectory() as folder:
        density = pathlib.Path(folder) / "density.vtk"
        source_density_tables.write_disk(density, RINGS)
        for shape in options.shape or runs.DISKS:
            options.faces = [faces for faces in sizes if faces]
            surfaces = [options.data / runs.DISKS[shape]] * (0 in sizes) + growth.series(options, shape)
            for surface in surfaces:
                for title, words in cases(shape, density):
                    (before, after), right = compare(options.command, surface, words, folder)
                    good &= right
                    last = after.report["levels"][-1]
                    print(runs.row(f"{shape}, {last['sites']:,}", title, before.report["iterations"],
                                   last["iterations"], f"{last['voronoi_part']:g}", levels(after.report),
                                   f"{before.seconds:.2f}", f"{after.seconds:.2f}"), flush=True)
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
