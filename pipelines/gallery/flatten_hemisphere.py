#!/usr/bin/python3
"""A FreeSurfer hemisphere becomes an area-preserving flat map.

    flatten_hemisphere.py --surface lh.pial --region lh.cortex.label --keep
    flatten_hemisphere.py --surface lh.pial --region lh.aparc.annot --values unknown corpuscallosum

Leaves map.vtp (ParaView), map.json (everything about the map) and map.png.
"""
import argparse
import json

import authalic
import surfaces
from show import Gallery, by_place, colours, write_text

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
surfaces.add_options(parser)
options = parser.parse_args()

# The medial wall is no cortex: without it a hemisphere is a topological disk.
disk = surfaces.disk(options)
print(f"{disk.fields['KeptArea'] / 100:.1f} cm2 of cortex, {disk.fields['RemovedArea'] / 100:.1f} cm2 cut off")

# Every vertex gets a place in the unit disk; areas keep their proportions.
flat = authalic.flatten(disk, progress=lambda fraction, stage: print(f"\r{fraction:4.0%} {stage:30}", end=""))
print(f"\r{flat}")

# 0 = the area is preserved, 1 = twice as large as it should be (log2).
off = flat.face_arrays["AreaDistortion"]
print(f"areas: {abs(off).max():.3f} at most, flipped faces: {flat.metrics['flipped_faces']}")

authalic.write_surface(options.out / "map.vtp", flat)
write_text(options.out / "map.json", json.dumps(flat.report, indent=1))
gallery = Gallery()
place = by_place(flat.image)
gallery.add("cortex, coloured by its place on the map", disk, disk.points, surfaces.lateral(disk), place)
gallery.add("flat map", flat, flat.image, rgb=place)
gallery.add("log2 area distortion", flat, flat.image, array="AreaDistortion", table=colours.diverging(1.0))
gallery.save(options.out / "map.png")
