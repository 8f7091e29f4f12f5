#!/usr/bin/python3
"""Tables of two papers in their form, on the meshes of the test data.

    published_tables.py iterations COMMAND DATA [--limit N] [--step X ...]    su2019, Table 2
    published_tables.py energies COMMAND DATA                                 su2019, Table 4
    published_tables.py ratios COMMAND DATA                                   su2016, Table 2

COMMAND is the built `authalic`, DATA the folder of real test data. `iterations` counts steps of the Lie flow of the
paper (nothing after it) until the residual of the flowing stars is 0.1, with fixed steps and with the adaptive one;
c: the mesh collapsed, s: stalled, > N: not there within the limit. `energies` has circles and squares, as the paper.
`ratios` has the area ratios of faces, every face counting the same. Seconds are the user time of the whole command.
"""
import argparse
import pathlib
import sys
import tempfile

import runs

MESHES = {**runs.DISKS, "cowhead": "meshes/open_disk/cowhead.obj",
          "maxFace": "meshes/open_disk/maxFace.obj"}
FLOW = ["lie-flow", "--finish", "none", "--tolerance", "0.1"]
ENERGIES = {"lie-flow, circle": ["lie-flow"], "authalic, circle": ["authalic"],
            "stretch, square": ["stretch", "--domain", "square"],
            "lie-flow, square": ["lie-flow", "--domain", "square"],
            "authalic, square": ["authalic", "--domain", "square"]}


def steps(run, limit):
    """The entry of Table 2: the last residual of a report is that of the input's faces, the others are the flow's."""
    for k, residual in enumerate(run.report["residual_history"][:-1]):
        if residual <= 0.1:
            return str(k)
    if run.report["residual"] <= 0.1:
        return str(run.report["iterations"])
    if run.report["collapsed"]:
        return "c"
    return f"> {limit}" if run.report["iterations"] >= limit else "s"


def iterations(options, folder):
    limit = str(options.limit)
    print(runs.head("model", "faces", *(f"step {step}" for step in options.step), "adaptive"))
    for mesh in options.mesh:
        found = [runs.Run(options.command, options.data / MESHES[mesh], FLOW + ["--max-iterations", limit, *words],
                          folder) for words in [["--fixed-step", step] for step in options.step] + [[]]]
        faces = found[0].report["topology"]["faces"]
        print(runs.row(mesh, f"{faces:,}", *(steps(run, options.limit) for run in found)), flush=True)


def energies(options, folder):
    print(runs.head("model", "faces", "vertices", "method", "D_area", "symmetric Dirichlet", "ARAP", "folds", "CPU s"))
    for mesh in options.mesh:
        for name, words in ENERGIES.items():
            run = runs.Run(options.command, options.data / MESHES[mesh], words, folder)
            topology, metrics = run.report["topology"], run.metrics
            print(runs.row(mesh, f"{topology['faces']:,}", f"{topology['vertices']:,}", name,
                           f"{metrics['area_distortion']:.5g}", f"{metrics['symmetric_dirichlet']:.3g}",
                           f"{metrics['as_rigid_as_possible']:.3g}", run.report["flips"], f"{run.seconds:.1f}"),
                  flush=True)


def face_ratios(image):
    """Image share / surface share of every face that has one, from the cell array of a map."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(image)
    reader.Update()
    logs = vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("AreaDistortion"))
    return 2.0 ** logs[logs == logs]


def ratios(options, folder):
    methods = ("authalic", "stretch")
    print(runs.head("model", "vertices", "faces", *(f"{name}: s, max, average, std" for name in methods)))
    for mesh in options.mesh:
        entries = []
        for name in methods:
            run = runs.Run(options.command, options.data / MESHES[mesh], [name], folder)
            r = face_ratios(run.image)
            entries.append(f"{run.seconds:.2f}, {r.max():.4f}, {r.mean():.4f}, {r.std():.4f}")
        topology = run.report["topology"]
        print(runs.row(mesh, f"{topology['vertices']:,}", f"{topology['faces']:,}", *entries), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    tables = {"iterations": iterations, "energies": energies, "ratios": ratios}
    parser.add_argument("table", choices=tables)
    parser.add_argument("command")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--mesh", action="append", choices=MESHES)
    parser.add_argument("--limit", type=int, default=400)
    parser.add_argument("--step", action="append")
    options = parser.parse_args()
    options.mesh, options.step = options.mesh or list(MESHES), options.step or ["0.1", "0.01", "0.001"]
    with tempfile.TemporaryDirectory() as folder:
        tables[options.table](options, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
