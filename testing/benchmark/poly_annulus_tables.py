#!/usr/bin/python3
"""Table 1 of su2016 in its form: transport of surfaces with 2 to 7 boundary loops, scans and closed meshes with holes
punched into them.

    poly_annulus_tables.py COMMAND DATA [--mesh NAME ...] [--judge PROGRAM]

COMMAND is the built `authalic`, DATA the folder of real test data. A model's row has its loops and faces, the Newton
steps until the largest error of a cell, an area in the unit disk as in the paper, is below 1e-6 and below 1e-12, the
smallest error that was reached, and that relative to the mean cell; CPU seconds of the whole command, conformal map,
reading and writing included; D_area and folds of the transport, and of its finish, with its CPU seconds. Ends with 1
when an error stays above 1e-12, a cell is empty, a transport takes more than 5 CPU seconds, a finish is not converged
or leaves a fold, or the judge does not agree with the finished maps.
"""
import argparse
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

import runs

# name: (mesh, holes to punch, their radius in edges)
MODELS = {"sophie": ("meshes/poly_annulus/sophie.off", 0, 0), "alex_3": ("meshes/poly_annulus/alex_3.off", 0, 0),
          "camelhead": ("meshes/open_disk/camelhead.off", 2, 4),
          "human_face": ("meshes/open_disk/human_face.off", 3, 5),
          "max_planck": ("meshes/closed_g0/decimated-max.obj", 5, 4), "david": ("meshes/closed_g0/david.off", 7, 5),
          "gargoyle": ("meshes/closed_g0/gargoyle.obj", 7, 7)}
LOOSE, TIGHT, MOST_SECONDS = 1e-6, 1e-12, 5
FLOOR = "1e-14"  # of a mean cell: below what double precision gives, so that the transport ends where nothing is gained


def read_off(path):
    words = path.read_text(encoding="utf-8").split()
    n, m = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * n], dtype=float).reshape(n, 3)
    return points, np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)[:, 1:]


def write_off(path, points, faces):
    used = np.unique(faces)
    number = np.full(len(points), -1)
    number[used] = np.arange(len(used))
    lines = [f"OFF\n{len(used)} {len(faces)} 0", *(f"{x!r} {y!r} {z!r}" for x, y, z in points[used].tolist()),
             *(f"3 {a} {b} {c}" for a, b, c in number[faces])]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def boundary(faces, count):
    """Flags of the vertices with an edge that only one face has."""
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges, times = np.unique(edges, axis=0, return_counts=True)
    flags = np.zeros(count, dtype=bool)
    flags[edges[times == 1]] = True
    return flags


def grown(flags, faces, steps):
    for _ in range(steps):
        flags = flags.copy()
        flags[faces[flags[faces].any(axis=1)]] = True
    return flags


def punched(points, faces, holes, size):
    """The mesh without `holes` round patches, as far from each other and from its boundary as can be."""
    margin = grown(boundary(faces, len(points)), faces, 3 * size)
    free = np.flatnonzero(~margin)
    distance = np.linalg.norm(points[free] - points[free].mean(axis=0), axis=1)
    if margin.any():
        distance = np.linalg.norm(points[free, None] - points[margin][None, ::20], axis=2).min(axis=1)
    gone = np.zeros(len(points), dtype=bool)
    for _ in range(holes):
        seed = free[np.argmax(distance)]
        distance = np.minimum(distance, np.linalg.norm(points[free] - points[seed], axis=1))
        start = np.zeros(len(points), dtype=bool)
        start[seed] = True
        gone |= grown(start, faces, size)
    kept = faces[~gone[faces].any(axis=1)]
    while True:
        ears = boundary(kept, len(points))[kept].all(axis=1)
        if not ears.any():
            return kept
        kept = kept[~ears]


def model(name, command, data, folder):
    """Path of the surface."""
    mesh, holes, size = MODELS[name]
    if not holes:
        return data / mesh
    whole, path = folder / "whole.off", folder / f"{name}.off"
    subprocess.run([command, "convert", str(data / mesh), str(whole), "--quiet"], check=True)
    points, faces = read_off(whole)
    write_off(path, points, punched(points, faces, holes, size))
    return path


def measured(options, name, folder):
    """Whether the model keeps what is promised; prints its row."""
    surface = model(name, options.command, options.data, folder)
    words = ["transport", "--domain", "circle-domain"]
    bare = runs.Run(options.command, surface, [*words, "--tolerance", FLOOR, "--max-iterations", "40"], folder)
    done = runs.Run(options.command, surface, [*words, "--finish", "authalic"], folder)
    agree = not options.judge or done.judged(options.judge)
    loops, topology = len(bare.report["circles"]) // 3, bare.report["topology"]
    mean = math.pi / (topology["vertices"] + loops - 1)
    errors = [mean * residual for residual in bare.report["residual_history"]]
    steps = [next((k for k, error in enumerate(errors) if error < most), None) for most in (LOOSE, TIGHT)]
    print(runs.row(name, loops, f"{topology['faces']:,}", *steps, f"{min(errors):.1e}", f"{min(errors) / mean:.1e}",
                   f"{bare.seconds:.1f}", f"{bare.metrics['area_distortion']:.4f}, {bare.report['flips']}",
                   f"{done.metrics['area_distortion']:.5f}, {done.report['flips']}", f"{done.seconds:.1f}"), flush=True)
    return (agree and None not in steps and bare.report["empty_cells"] == 0 and bare.seconds <= MOST_SECONDS
            and done.report["status"] == "converged" and done.report["flips"] == 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--mesh", action="append", choices=MODELS)
    parser.add_argument("--judge")
    options = parser.parse_args()
    print(runs.head("model", "loops", "faces", "steps to 1e-6", "to 1e-12", "smallest error", "/ mean cell", "CPU s",
                    "D_area, folds", "D_area, folds after the finish", "CPU s with it"))
    with tempfile.TemporaryDirectory() as folder:
        kept = [measured(options, name, pathlib.Path(folder)) for name in options.mesh or MODELS]
    return 0 if all(kept) else 1


if __name__ == "__main__":
    sys.exit(main())
