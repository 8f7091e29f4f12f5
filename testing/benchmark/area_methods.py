#!/usr/bin/python3
"""Every map of a disk side by side: areas, angles, folds and seconds.

    area_methods.py COMMAND DATA [--mesh NAME ...] [--method NAME ...] [--judge PROGRAM]

COMMAND is the built `authalic`, DATA the folder of real test data. Seconds are the user time of the whole command. With
--judge, PROGRAM SURFACE MAP must print JSON with the members D_area, face_sd, face_mean_abs_log, angle_err_deg and
flips of an independent evaluation; the script fails when they differ from the report, and with --angles when the angle
error of authalic is more than 3 % above that of the fixed point of the stretch energy.
"""
import argparse
import pathlib
import sys
import tempfile

import runs

METHODS = {"tutte": ["tutte"], "mean-value": ["mean-value"], "stretch": ["stretch"],
           "stretch-energy": ["stretch-energy"], "stretch-energy, held": ["stretch-energy", "--boundary", "held"],
           "lie-advection": ["lie-advection"], "lie-flow": ["lie-flow"], "authalic": ["authalic"],
           "riemann": ["riemann"], "slim": ["slim", "--domain", "disk"]}
ALLOWED = 1.03  # angle error of authalic by that of the fixed point


def cells(name, run):
    metrics = run.metrics
    return runs.row(name, f"{metrics['area_distortion']:.6g}", f"{metrics['face_area_ratio_sd']:.2g}",
                    f"{metrics['face_log_area_ratio_mean_abs']:.2g}", f"{metrics['angle_error_mean_degrees']:.2f}",
                    f"{metrics['as_rigid_as_possible']:.3g}", run.report["flips"], run.report["status"],
                    f"{run.seconds:.2f}")


def table(options, mesh, folder):
    """Prints the rows of one mesh; returns whether the judge agrees, and the angle error of every method."""
    surface, agrees, angles = options.data / runs.DISKS[mesh], True, {}
    print(f"\n{mesh}\n")
    print(runs.head("method", "D_area", "SD of r", "mean \\|ln r\\|", "angle error, degrees", "ARAP", "folds", "status",
                    "CPU s"))
    for name in options.method:
        run = runs.Run(options.command, surface, METHODS[name], folder)
        print(cells(name, run), flush=True)
        angles[name] = run.metrics["angle_error_mean_degrees"]
        agrees = agrees and (options.judge is None or run.judged(options.judge))
    return agrees, angles


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--mesh", action="append", choices=runs.DISKS)
    parser.add_argument("--method", action="append", choices=METHODS)
    parser.add_argument("--judge")
    parser.add_argument("--angles", action="store_true")
    options = parser.parse_args()
    options.method = options.method or list(METHODS)
    good, ratios = True, {}
    with tempfile.TemporaryDirectory() as folder:
        for mesh in options.mesh or runs.DISKS:
            agrees, angles = table(options, mesh, folder)
            good = good and agrees
            if "authalic" in angles and "stretch-energy" in angles:
                ratios[mesh] = angles["authalic"] / angles["stretch-energy"]
    for mesh, ratio in ratios.items():
        print(f"\n{mesh}: the angle error of authalic is {100 * (ratio - 1):+.1f} % of that of stretch-energy.")
    if options.judge:
        print("\nThe judge agrees." if good else "\nThe judge does not agree.")
    return 0 if good and not (options.angles and any(ratio > ALLOWED for ratio in ratios.values())) else 1


if __name__ == "__main__":
    sys.exit(main())
