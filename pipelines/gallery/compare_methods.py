#!/usr/bin/python3
"""Methods compared on one surface: what happens to areas, what to angles, and how long it takes.

    compare_methods.py --surface lh.pial --region lh.cortex.label --keep --methods mean-value authalic

Leaves methods.tsv and methods.png (the first two methods).
"""
import argparse
import time

import authalic
import surfaces
from show import Gallery, colours, write_text

METRICS = ("area_distortion", "angle_distortion", "face_log_area_ratio_max_abs", "angle_error_mean_degrees",
           "flipped_faces")

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
surfaces.add_options(parser)
parser.add_argument("--methods",
                    nargs="+",
                    default=["mean-value", "authalic"],
                    help=f"of {', '.join(authalic.methods())}")
options = parser.parse_args()

disk = surfaces.disk(options)
rows, maps = [], {}
for method in options.methods:
    begin = time.process_time()
    maps[method] = authalic.flatten(disk, method=method)
    rows.append([method, maps[method].status, *(f"{maps[method].metrics[name]:.4g}" for name in METRICS),
                 f"{time.process_time() - begin:.2f}"])
table = "\n".join("\t".join(row) for row in [["method", "status", *METRICS, "cpu_s"], *rows])
print(table)
write_text(options.out / "methods.tsv", table + "\n")

gallery = Gallery()
for method in options.methods[:2]:
    gallery.add(f"{method}: log2 area distortion", maps[method], maps[method].image, array="AreaDistortion",
                table=colours.diverging(3.0))
    gallery.add(f"{method}: angle distortion", maps[method], maps[method].image, array="AngleDistortion",
                table=colours.sequential(2.0, 4.0))
gallery.save(options.out / "methods.png")
