#!/usr/bin/python3
"""A closed surface of genus 0 on the sphere with its angles kept, by two roads, and what happens to angles and areas.

    conformal_sphere.py --surface lh.pial --roads harmonic welding

Leaves sphere.vtp (the map by the first road), roads.tsv, and sphere.png: the same colour is the same place on the
surface and on the sphere; the modulus of the Beltrami coefficient; histograms of both distortions.
"""
import argparse
import pathlib
import time

import numpy as np

import authalic
import surfaces
from show import Gallery, colours, write_text

METRICS = ("angle_distortion", "angle_error_mean_degrees", "angle_error_sd_degrees", "angle_error_p50_degrees",
           "angle_error_p95_degrees", "quasi_conformal_mean", "beltrami_mean", "area_distortion", "flipped_faces")
ROADS = ("harmonic", "stereographic", "mean-curvature-flow", "welding")

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--surface", default=surfaces.FIXTURES / "folded_sphere.off", type=pathlib.Path,
                    help="closed surface: FreeSurfer, GIFTI, OFF ... (default: a folded sphere)")
parser.add_argument("--roads", nargs=2, default=["harmonic", "welding"], help=f"two of {', '.join(ROADS)}")
parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/gallery"),
                    help="folder (default: %(default)s)")
options = parser.parse_args()

options.out.mkdir(parents=True, exist_ok=True)
surface = authalic.read_surface(options.surface)
rows, maps = [], {}
for road in options.roads:
    begin = time.process_time()
    maps[road] = authalic.flatten(surface, method="sphere", initial=road)
    rows.append([road, maps[road].status, *(f"{maps[road].metrics[name]:.4g}" for name in METRICS),
                 f"{time.process_time() - begin:.2f}"])
table = "\n".join("\t".join(row) for row in [["road", "status", *METRICS, "cpu_s"], *rows])
print(table)
write_text(options.out / "roads.tsv", table + "\n")

first = maps[options.roads[0]]
authalic.write_surface(options.out / "sphere.vtp", first.to_vtk())

by_place = colours.to_bytes(colours.lab_to_rgb(
    np.column_stack([65 + 18 * first.image[:, 2], 55 * first.image[:, 0], 55 * first.image[:, 1]])))
first.face_arrays["BeltramiModulus"] = np.linalg.norm(first.face_arrays["BeltramiCoefficient"], axis=1)
side = surfaces.lateral(surface)
gallery = Gallery()
gallery.add("the surface", first, first.points, side, rgb=by_place)
gallery.add("its conformal sphere", first, first.image, side, rgb=by_place)
gallery.add("modulus of the Beltrami coefficient", first, first.points, side, array="BeltramiModulus",
            table=colours.sequential(0.0, 0.1))
gallery.add_chart(maps, "angle_error_degrees", np.arange(-10, 11, 5), "Angles of triangles",
                  "on the sphere - on the surface, degrees")
gallery.add_chart(maps, "face_log_area_ratio", np.arange(-4, 5, 2), "Areas of triangles",
                  "ln (share of the sphere / share of the surface)", bins=2)
gallery.save(options.out / "sphere.png")
