#!/usr/bin/python3
"""Tables 1 to 3 of nadeem2017 in their form, and the whole curve of 11 balances, on closed meshes of the test data.

    balance_tables.py COMMAND DATA [--mesh NAME ...] [--judge PROGRAM]

COMMAND is the built `authalic`, DATA the folder of real test data. A model's row has D_angle and D_area of
`map balanced --domain sphere` at t = 0, 0.5 and 1, the latter also by transport alone, and the user seconds of each;
then the user seconds of `authalic balance` for 11 values, the largest count of folds along it, and whether both
distortions are monotone in t. Ends with 1 when a map is folded, D_area at t = 1 is above 2.001, a curve is not
monotone, or the judge does not agree.
"""
import argparse
import csv
import pathlib
import sys
import tempfile

import runs

MESHES = {"max_planck": "meshes/closed_g0/decimated-max.obj", "bunny": "meshes/closed_g0/bunny.obj",
          "gargoyle": "meshes/closed_g0/gargoyle.obj", "david": "meshes/closed_g0/david.off",
          "sphere_brain": "meshes/closed_g0/sphere_brain.off"}
BALANCES = ("0", "0.5", "1")
MOST = 2.001


def number(value):
    return f"{value:.6g}"


def curve(command, surface, folder):
    """(rows, user seconds) of `authalic balance` with its defaults."""
    path = pathlib.Path(folder) / "curve.tsv"
    code, seconds, _, said = runs.timed([command, "balance", str(surface), "-o", str(path), "--quiet"])
    if code != runs.OK:
        sys.exit(f"balance {surface} ended with {code}: {said}")
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter="\t")), seconds


def rises(values):
    return all(a < b for a, b in zip(values, values[1:]))


def measured(options, mesh, folder):
    """Whether the model keeps what is promised; prints its row."""
    surface = options.data / MESHES[mesh]
    found = [runs.Run(options.command, surface, ["balanced", "--domain", "sphere", "--balance", t], folder)
             for t in BALANCES]
    agree = not options.judge or found[-1].judged(options.judge)
    rows, seconds = curve(options.command, surface, folder)
    angles, areas = ([float(row[f"{name}_distortion"]) for row in rows] for name in ("angle", "area"))
    folds = max(int(row["flipped_faces"]) for row in rows + [{"flipped_faces": run.report["flips"]} for run in found])
    monotone = rises(angles) and rises([-area for area in areas])
    print(runs.row(mesh, f"{found[0].report['topology']['faces']:,}",
                   *(number(run.metrics["angle_distortion"]) for run in found),
                   *(number(run.metrics["area_distortion"]) for run in found),
                   f"{float(rows[-1]['transport_area_distortion']):.5g}, {rows[-1]['transport_flipped_faces']}",
                   *(f"{run.seconds:.1f}" for run in found), f"{seconds:.1f}", folds, "yes" if monotone else "no"),
          flush=True)
    return agree and monotone and folds == 0 and found[-1].metrics["area_distortion"] <= MOST


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--mesh", action="append", choices=MESHES)
    parser.add_argument("--judge")
    options = parser.parse_args()
    print(runs.head("model", "faces", *(f"D_angle, t = {t}" for t in BALANCES), *(f"D_area, t = {t}" for t in BALANCES),
                    "D_area, folds of transport alone, t = 1", *(f"CPU s, t = {t}" for t in BALANCES),
                    "CPU s, 11 values", "folds", "monotone"))
    with tempfile.TemporaryDirectory() as folder:
        kept = [measured(options, mesh, folder) for mesh in options.mesh or MESHES]
    return 0 if all(kept) else 1


if __name__ == "__main__":
    sys.exit(main())
