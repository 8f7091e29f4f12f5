#!/usr/bin/python3
"""The discrete Lie flow against optimal transport, as su2019 compares them (section 6.5).

    flow_against_transport.py --disk head.off --centre 0 30 -930 --radius 12

A region of a disk gets several factors of its area. For each, both maps start from the harmonic map, which the flow
keeps however far it is from the areas; printed and left in flow.tsv are the cost of moving the masses by either (sum
of mass times squared distance from the harmonic map), the difference, the same without masses as su2019 has it, the
same with masses against transport with its finish, which like the flow has the areas of faces and no folds, and the
modulus of the Beltrami coefficient of psi = flow o transport^-1, 0 where psi keeps angles. flow.png has both maps
for the last factor (squares of equal area, the region in red) and the histograms of the moduli.
"""
import argparse

import numpy as np

import authalic
import surfaces
from show import Gallery, histograms, write_text

COLOURS = ((0.00, 0.35, 0.70), (0.34, 0.71, 0.91), (0.00, 0.62, 0.45), (0.80, 0.47, 0.65), (0.84, 0.37, 0.00))

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
surfaces.add_options(parser)
parser.add_argument("--disk", help="a disk to take as it is, instead of --surface")
parser.add_argument("--centre", type=float, nargs=3, metavar=("X", "Y", "Z"),
                    help="mm; default: the vertex in the middle of the harmonic map")
parser.add_argument("--radius", type=float, default=20.0, help="mm around the centre")
parser.add_argument("--factor", type=float, nargs="+", default=[0.25, 1.0, 4.0, 16.0])
options = parser.parse_args()

options.out.mkdir(parents=True, exist_ok=True)
disk = authalic.read_surface(options.disk) if options.disk else surfaces.disk(options)
start = authalic.flatten(disk, method="harmonic")
centre = options.centre or disk.points[np.argmin(np.linalg.norm(start.image, axis=1))]
rows, series, gallery = [], [], Gallery()
for factor, colour in zip(options.factor, COLOURS * 9):
    roi = (("sphere", *centre, options.radius), factor)
    flow = authalic.flatten(disk, method="lie-flow", roi=roi, initial="harmonic", keep_initial=True)
    moved = authalic.flatten(disk, method="transport", roi=roi, initial="harmonic")
    finished = authalic.flatten(disk, method="transport", roi=roi, initial="harmonic", finish="authalic",
                                on_not_converged="ignore")
    masses, sites = moved.point_arrays["CellArea"], moved.point_arrays["Site"][:, :2]
    costs = [masses @ ((found.image - sites)**2).sum(axis=1) for found in (flow, moved, finished)]
    sums = [((found.image - sites)**2).sum() for found in (flow, moved)]
    psi = authalic.measure_distortion(flow.image, moved.image, moved.faces)
    modulus = np.hypot(*psi.face_arrays["BeltramiCoefficient"].T)
    kept = modulus[np.isfinite(modulus) & (moved.face_arrays["Flipped"] == 0)]
    rows.append([f"{factor:g}", flow.status, moved.status, f"{costs[0]:.5g}", f"{costs[1]:.5g}",
                 f"{100 * (costs[0] / costs[1] - 1):.2f}", f"{100 * (sums[0] / sums[1] - 1):.2f}", f"{costs[2]:.5g}",
                 f"{100 * (costs[0] / costs[2] - 1):.2f}", f"{kept.mean():.3f}", f"{np.median(kept):.3f}",
                 f"{np.quantile(kept, 0.95):.3f}", str(moved.metrics["flipped_faces"])])
    series.append((f"factor {factor:g}", kept, colour))
header = ["factor", "flow_status", "transport_status", "flow_cost", "transport_cost", "difference_percent",
          "difference_without_masses_percent", "finished_cost", "finished_difference_percent", "beltrami_mean",
          "beltrami_p50", "beltrami_p95",
          "transport_flipped_faces"]
text = "\n".join("\t".join(row) for row in [header, *rows])
print(text)
write_text(options.out / "flow.tsv", text + "\n")
inside = np.ravel(moved.point_arrays["RegionsOfInterest"]) > 0
dark = np.floor(authalic.flatten(disk).image * 8).astype(int).sum(axis=1) % 2 == 1
rgb = np.where(inside[:, None], np.uint8([205, 92, 60]), np.uint8([205, 200, 190]))
rgb = np.where(dark[:, None], (0.75 * rgb).astype(np.uint8), rgb)
for caption, found in ((f"Lie flow, factor {options.factor[-1]:g}", flow), ("optimal transport", moved)):
    gallery.add(caption, disk, found.image, rgb=rgb)
gallery.add_prop_chart(histograms.histogram_actor(series, None, np.linspace(0, 1, 6), 0.02,
                                                  "Beltrami coefficient of psi", "modulus", "share of the faces in %"))
gallery.save(options.out / "flow.png")
