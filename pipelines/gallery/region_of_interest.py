#!/usr/bin/python3
"""A region of interest enlarged: it gets so many times the share of the map that its area has, exactly.

    region_of_interest.py --surface lh.pial --region lh.cortex.label --keep --radius 20 --gain 4 16 --blend 6
    region_of_interest.py --disk head.off --centre 0 30 -930 --radius 12
    region_of_interest.py --surface lh.pial --region lh.cortex.label --keep --roi lh.aparc.annot precentral

Leaves region.png: the region on the surface, on the area-preserving map, and on a map for every gain, without and with
the blend; prints the share of the region on each.
"""
import argparse

import numpy as np

import authalic
import surfaces
from show import Gallery

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
surfaces.add_options(parser)
parser.add_argument("--disk", help="a disk to take as it is, instead of --surface")
parser.add_argument("--radius", type=float, default=20.0, help="mm around the centre")
parser.add_argument("--centre", type=float, nargs=3, metavar=("X", "Y", "Z"),
                    help="mm; default: the vertex in the middle of the map")
parser.add_argument("--roi", nargs=2, metavar=("FILE", "NAME"), help="a region of an annotation instead of a ball")
parser.add_argument("--gain", type=float, nargs="+", default=[4.0])
parser.add_argument("--blend", type=float, default=0.0, help="width of the transition at the border, mm")
parser.add_argument("--look", type=float, nargs=3, help="direction in which the surface is seen")
options = parser.parse_args()

options.out.mkdir(parents=True, exist_ok=True)
disk = authalic.read_surface(options.disk) if options.disk else surfaces.disk(options)
plain = authalic.flatten(disk)
if options.roi:
    disk = authalic.read_vertex_data(options.roi[0], disk, name="Parcels")
    region = ("Parcels", options.roi[1])
else:
    centre = options.centre or disk.points[np.argmin(np.linalg.norm(plain.image, axis=1))]
    region = ("sphere", *centre, options.radius)

maps = {}
for gain in options.gain:
    for blend in sorted({0.0, options.blend}):
        maps[gain, blend] = authalic.flatten(disk, roi=(region, gain), roi_blend=blend)
first = next(iter(maps.values()))
inside = np.ravel(first.point_arrays["RegionsOfInterest"]) > 0
gallery = Gallery()


def patches(image):
    """Squares of equal size on the map, light and dark, the region in red: what the map makes of areas."""
    dark = np.floor(image * 8).astype(int).sum(axis=1) % 2 == 1
    rgb = np.where(inside[:, None], np.uint8([205, 92, 60]), np.uint8([205, 200, 190]))
    return np.where(dark[:, None], (0.82 * rgb).astype(np.uint8), rgb)


def add(caption, result):
    gallery.add(caption, disk, result.image, rgb=patches(plain.image))


outward = 1.0 if disk.points[inside].mean(axis=0)[0] < disk.points[:, 0].mean() else -1.0
gallery.add("the region", disk, disk.points, options.look or (outward, 0, 0), rgb=patches(plain.image))
add(f"area-preserving: {first.report['regions'][0]['source_share']:.1%}", plain)
for (gain, blend), found in maps.items():
    shares = found.report["regions"][0]
    print(f"share of the region: {shares['source_share']:.2%} area-preserving, {shares['image_share']:.2%} with the "
          f"measure (gain {gain:g}, blend {blend:g} mm; target {shares['target_share']:.2%}, "
          f"{found.metrics['flipped_faces']} flipped faces, largest stretch of a face "
          f"{found.face_arrays['AngleDistortion'].max():.3g}, {found.status})")
    add(f"x {gain:g}{f', blend {blend:g} mm' if blend else ''}: {shares['image_share']:.1%}", found)
gallery.save(options.out / "region.png")
