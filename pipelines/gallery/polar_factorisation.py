#!/usr/bin/python3
"""The polar factorisation of a map (Brenier): F = (grad u) o s, u convex, s measure-preserving.

    polar_factorisation.py --disk face.off --method harmonic

An area-preserving map makes the unit disk of a surface; another map f of it to the disk is then a map F of the disk to
itself. Transport of the uniform measure to what F makes of it gives u, and s = (grad u)^-1 o F: the rearrangement that
is left when the expansion is taken out.
Printed and left in polar.tsv, for s at the middles of the cells of u and for s with the finish, which has no folds
and exact vertices: the largest |ln r| of the cells or vertex stars, D_area and folds of s; the largest distance of
grad u(s(x)) and F(x) over the vertices, and the share of them where it is 0; the sum of mass times squared distance
from F, of s and of the identity: of all measure-preserving maps s is the nearest one.
polar.png has the disk, s and F, coloured by the place in the disk.
"""
import argparse

import numpy as np

import authalic
import surfaces
from show import Gallery, by_place, write_text

CHUNK = 1000


def gradient(points, sites, heights):
    """grad u at points, u(x) = max over i of <x, y_i> + h_i."""
    highest = [np.argmax(part @ sites.T + heights, axis=1)
               for part in np.array_split(points, max(1, len(points) // CHUNK))]
    return sites[np.concatenate(highest)]


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    surfaces.add_options(parser)
    parser.add_argument("--disk", help="a disk to take as it is, instead of --surface")
    parser.add_argument("--method", default="harmonic", help="of the map to the unit disk (default: %(default)s)")
    return parser.parse_args()


def main():
    options = parse()
    options.out.mkdir(parents=True, exist_ok=True)
    disk = authalic.read_surface(options.disk) if options.disk else surfaces.disk(options)
    place = authalic.flatten(disk)
    given = authalic.flatten(disk, method=options.method)
    if given.metrics["flipped_faces"]:
        raise SystemExit(f"A map without folds is required, but {options.method} folds "
                         f"{given.metrics['flipped_faces']} faces; take another method.")
    middles = authalic.flatten(disk, method="transport", initial=given)
    finished = authalic.flatten(disk, method="transport", initial=given, finish="authalic")
    sites, masses = middles.point_arrays["Site"][:, :2], middles.point_arrays["CellArea"]
    heights = middles.point_arrays["Potential"].ravel() - (middles.image * sites).sum(axis=1)
    cells = np.log1p(middles.report["transport_residual"])
    header = ["s", "log_ratio_max", "area_distortion", "flipped_faces", "composition_max", "composition_exact_share",
              "cost", "cost_of_identity"]
    rows = [header]
    for name, found in (("middles of cells", middles), ("finished", finished)):
        rearrangement = authalic.measure_distortion(found.image, place.image, disk.faces)
        off = np.linalg.norm(gradient(found.image, sites, heights) - given.image, axis=1)
        exact = cells if found is middles else rearrangement.metrics["vertex_log_area_ratio_max_abs"]
        costs = [masses @ ((image - given.image)**2).sum(axis=1) for image in (found.image, place.image)]
        rows.append([name, f"{exact:.2g}", f"{rearrangement.metrics['area_distortion']:.5f}",
                     str(rearrangement.metrics["flipped_faces"]), f"{off.max():.2g}", f"{np.mean(off < 1e-12):.3f}",
                     *(f"{cost:.5g}" for cost in costs)])
    text = "\n".join("\t".join(row) for row in rows)
    print(text)
    write_text(options.out / "polar.tsv", text + "\n")
    gallery, colours = Gallery(), by_place(place.image)
    for caption, image in (("the disk, by place", place.image), ("s: measure-preserving", finished.image),
                           ("F = grad u of s", given.image)):
        gallery.add(caption, disk, image, rgb=colours)
    gallery.save(options.out / "polar.png")


if __name__ == "__main__":
    main()
