#!/usr/bin/python3
"""A broken surface made a clean manifold: repaired.vtp, and repair.json with every change and its place.

    repair_surface.py --surface colon.vtk --scale 0.808594 0.808594 0.7

Leaves repair.png where a handle was cut: the whole surface with its handles, and one of them before and after.
"""
import argparse
import dataclasses
import json
import pathlib

import numpy as np
from vtkmodules.vtkCommonCore import vtkLookupTable

import authalic
import surfaces
from show import Gallery, write_text

GREY, RED = (200, 200, 200), (210, 40, 40)


def around(surface, place, reach):
    """The part of a surface within `reach` of a place, and its vertices and faces there."""
    near = np.linalg.norm(surface.points - place, axis=1) < reach
    inside = np.flatnonzero(near[surface.faces].all(axis=1))
    vertices, faces = np.unique(surface.faces[inside], return_inverse=True)
    new = (surface.face_arrays.get("OriginalCellIds", np.zeros(len(surface.faces)))[inside] < 0).astype(int)
    return authalic.Surface(surface.points[vertices], faces.reshape(-1, 3), face_arrays={"New": new}), vertices


def marked(count, vertices):
    """Grey, but red at some vertices."""
    rgb = np.full((count, 3), GREY, np.uint8)
    rgb[vertices] = RED
    return rgb


def grey_and_red():
    table = vtkLookupTable()
    table.SetNumberOfTableValues(2)
    table.SetTableRange(0, 1)
    for k, colour in enumerate((GREY, RED)):
        table.SetTableValue(k, *np.array(colour) / 255)
    return table


def draw(surface, repaired, path):
    handles = repaired.changes["handles"]["first"]
    shown = max(handles, key=lambda handle: handle["length_mm"])
    loop, place = surface.points[shown["ids"]], np.array(shown["place_mm"])
    through = np.linalg.svd(loop - place)[2][2]  # the loop is seen as a round hole
    reach = shown["length_mm"]
    gallery = Gallery()
    near = np.concatenate([np.flatnonzero(np.linalg.norm(surface.points - handle["place_mm"], axis=1) < reach / 2)
                           for handle in handles])
    broad = np.linalg.svd(surface.points - surface.points.mean(axis=0), full_matrices=False)[2][2]
    gallery.add(f"handles: {len(handles)}", surface, surface.points, broad, marked(len(surface.points), near))
    before, vertices = around(surface, place, reach)
    gallery.add("one of them", before, before.points, through, marked(len(vertices), np.isin(vertices, shown["ids"])))
    after, _ = around(repaired, place, reach)
    gallery.add_prop("cut and capped", gallery.faces(after, "New", grey_and_red()), before.points, through)
    gallery.save(path)


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--surface", default=surfaces.FIXTURES / "torus.off", type=pathlib.Path,
                    help="triangles, however broken (default: a torus)")
parser.add_argument("--scale", nargs=3, type=float, default=(1, 1, 1), metavar="MM", help="mm per unit of the file")
parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/gallery"),
                    help="folder (default: %(default)s)")
options = parser.parse_args()
options.out.mkdir(parents=True, exist_ok=True)
given = authalic.read_surface(options.surface)
given = dataclasses.replace(given, points=given.points * options.scale)
result = authalic.repair(given)
print(result.summary or "nothing to repair")
authalic.write_surface(options.out / "repaired.vtp", result)
write_text(options.out / "repair.json", json.dumps(result.report, indent=1) + "\n")
print(f"now: {result.report['topology']['summary']}")
if "handles" in result.changes:
    draw(given, result, options.out / "repair.png")
