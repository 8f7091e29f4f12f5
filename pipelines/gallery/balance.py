#!/usr/bin/python3
"""Between angles and areas: the curve by which a balance is chosen, and maps along it.

    balance.py --surface lh.pial
    balance.py --surface lh.pial --region lh.cortex.label --keep --disk --show 0.2 0.9

A closed surface goes to the sphere; with --disk it is cut open and goes to the disk. Leaves curve.tsv, curve.json
(options and seconds) and balance.png: the maps of --show coloured by their area distortion, and the curve.
"""
import argparse
import json

import numpy as np

import authalic
import surfaces
from show import Gallery, colours, write_text

COLOURS = ((0.84, 0.37, 0.00), (0.00, 0.35, 0.70), (0.55, 0.55, 0.55))  # Okabe and Ito: angles, areas; transport alone

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
surfaces.add_options(parser)
parser.add_argument("--disk", action="store_true", help="cut the surface open (see --region) and map it to the disk")
parser.add_argument("--balances", type=int, default=11, help="how many balances (default: %(default)s)")
parser.add_argument("--show", type=float, nargs="+", default=[0.0, 0.5, 1.0], help="balances whose maps are drawn")
options = parser.parse_args()

options.out.mkdir(parents=True, exist_ok=True)
surface = surfaces.disk(options) if options.disk else authalic.read_surface(options.surface, options.space)
curve = authalic.balance_curve(surface, balances=np.linspace(0, 1, options.balances))
columns = list(curve.table)
rows = [columns] + [[f"{value:.9g}" if isinstance(value, float) else str(value) for value in row]
                    for row in zip(*(column.tolist() for column in curve.table.values()))]
text = "\n".join("\t".join(row) for row in rows) + "\n"
write_text(options.out / "curve.tsv", text)
write_text(options.out / "curve.json", json.dumps(curve.report, indent=2) + "\n")
print(text, end="")
print(f"{curve.status}; {curve.report['seconds']['total']:.1f} s for {options.balances} maps")

gallery = Gallery()
for balance in options.show:
    found = authalic.flatten(surface, method="balanced", domain="disk" if options.disk else "sphere", balance=balance)
    gallery.add(f"t = {balance:g}: log2 area distortion", found, found.image, direction=surfaces.lateral(surface),
                array="AreaDistortion", table=colours.diverging(3.0))
series = [(name, curve.table["balance"], np.maximum(curve.table[column] - 2, 1e-9), colour) for name, column, colour in
          (("angles", "angle_distortion", COLOURS[0]), ("areas", "area_distortion", COLOURS[1]),
           ("areas, transport alone", "transport_area_distortion", COLOURS[2]))]
low, high = (np.log10([f(values) for _, _, values, _ in series]) for f in (np.min, np.max))
ticks = 10.0 ** np.arange(np.floor(low.min()), np.ceil(high.max()) + 1)
gallery.add_curves(series, np.linspace(0, 1, 6), ticks, "distortion - 2", "balance t", "0 = kept")
gallery.save(options.out / "balance.png")
