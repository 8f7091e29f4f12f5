#!/usr/bin/python3
"""A region of interest enlarged: a measure gives it four times the share of the map that its area has.

    region_of_interest.py --surface lh.pial --region lh.cortex.label --keep --radius 20 --gain 4

Leaves region.png; prints the share of the region before and after.
"""
import argparse

import numpy as np

import authalic
import surfaces
from show import Gallery

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
surfaces.add_options(parser)
parser.add_argument("--radius", type=float, default=20.0, help="mm around the vertex")
parser.add_argument("--vertex", type=int, help="of the disk; default: the one in the middle of the map")
parser.add_argument("--gain", type=float, default=4.0)
options = parser.parse_args()

disk = surfaces.disk(options)
plain = authalic.flatten(disk)
middle = options.vertex if options.vertex is not None else int(np.argmin(np.linalg.norm(plain.image, axis=1)))
inside = np.linalg.norm(disk.points - disk.points[middle], axis=1) < options.radius

# The measure is a density relative to the native area, one number per vertex; a soft edge spares the triangles
# there.
distance = np.linalg.norm(disk.points - disk.points[middle], axis=1)
edge = np.clip((distance - 0.8 * options.radius) / (0.4 * options.radius), 0, 1)
larger = authalic.flatten(disk, measure=options.gain + (1 - options.gain) * edge, initial=plain)


def share(image):
    """The part of the map that the region covers."""
    a, b, c = (image[disk.faces[:, k]] for k in range(3))
    areas = np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    return areas[inside[disk.faces].all(axis=1)].sum() / areas.sum()


print(f"share of the region: {share(plain.image):.2%} area-preserving, {share(larger.image):.2%} with the measure")
print(f"flipped faces: {plain.metrics['flipped_faces']} and {larger.metrics['flipped_faces']}")

rgb = np.where(inside[:, None], np.uint8([205, 92, 60]), np.uint8([205, 200, 190]))
outward = 1.0 if disk.points[middle, 0] < disk.points[:, 0].mean() else -1.0
gallery = Gallery()
gallery.add("the region", disk, disk.points, (outward, 0, 0), rgb)
gallery.add(f"area-preserving: {share(plain.image):.1%}", disk, plain.image, rgb=rgb)
gallery.add(f"enlarged: {share(larger.image):.1%}", disk, larger.image, rgb=rgb)
gallery.save(options.out / "region.png")
