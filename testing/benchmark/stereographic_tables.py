#!/usr/bin/python3
"""Transport to the sphere in a stereographic plane, from several poles, beside transport on the sphere itself.

    stereographic_tables.py COMMAND DATA [--mesh NAME ...]

COMMAND is the built `authalic`, DATA the folder of real test data. A row has the Newton steps, D_area, D_angle, folds
and the displacement Σ ν d² of one map, D_area, D_angle and folds after `--finish authalic`, and the CPU seconds of both
commands, conformal map, reading and writing included. Ends with 1 when a transport or a finish is not converged, a
cell is empty, or a finish leaves a fold.
"""
import argparse
import pathlib
import sys
import tempfile

import runs

MESHES = {"max_planck": "meshes/closed_g0/decimated-max.obj", "david": "meshes/closed_g0/david.off",
          "gargoyle": "meshes/closed_g0/gargoyle.obj", "bunny": "meshes/closed_g0/bunny.obj",
          "sphere_brain": "meshes/closed_g0/sphere_brain.off"}
STEREOGRAPHIC = ("--formulation", "stereographic")
WAYS = {"on the sphere": (), "largest face": STEREOGRAPHIC,
        **{pole: (*STEREOGRAPHIC, "--pole", *pole.split()) for pole in ("1 0 0", "0 1 0", "0 0 1")}}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--mesh", choices=MESHES, action="append")
    arguments = parser.parse_args()
    good = True
    print(runs.head("surface", "pole", "steps", "D_area", "D_angle", "folds", "displacement", "D_area finished",
                    "D_angle finished", "folds finished", "CPU s", "CPU s with the finish"))
    with tempfile.TemporaryDirectory() as folder:
        for name in arguments.mesh or MESHES:
            for way, words in WAYS.items():
                words = ("transport", "--domain", "sphere", *words)
                surface = arguments.data / MESHES[name]
                bare = runs.Run(arguments.command, surface, words, folder)
                done = runs.Run(arguments.command, surface, (*words, "--finish", "authalic"), folder)
                good &= all(run.report["status"] == "converged" for run in (bare, done))
                good &= bare.report["empty_cells"] == 0 and done.report["flips"] == 0
                print(runs.row(name, way, bare.report["iterations"], f"{bare.metrics['area_distortion']:.4f}",
                               f"{bare.metrics['angle_distortion']:.3f}", bare.report["flips"],
                               f"{bare.report['displacement_cost']:.3f}", f"{done.metrics['area_distortion']:.5f}",
                               f"{done.metrics['angle_distortion']:.3f}", done.report["flips"],
                               f"{bare.seconds:.1f}", f"{done.seconds:.1f}"), flush=True)
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
