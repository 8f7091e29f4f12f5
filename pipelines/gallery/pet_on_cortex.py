#!/usr/bin/python3
"""PET on the cortex: read the volume along the inward normal, flatten, and compare elements of equal area.

    pet_on_cortex.py --surface lh.white --region lh.cortex.label --keep --volume pet.nii.gz

Surface and volume must be in the same scanner RAS space; --space scanner-ras says so for files that do not.
Leaves pet.tsv (one row per element) and pet.png.
"""
import argparse
import pathlib

import numpy as np

import authalic
import surfaces
from show import Gallery, colours, write_text

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
surfaces.add_options(parser)
parser.add_argument("--volume", type=pathlib.Path, default=surfaces.FIXTURES / "phantom_t1.nii.gz",
                    help="PET, NIfTI or MGH (default: a phantom, whose left hemisphere is then the surface)")
parser.add_argument("--depths", type=float, nargs=2, default=(0, 4), metavar=("FROM", "TO"),
                    help="mm along the inward normal that are averaged (0 4; cortex above a white surface: -2.5 0)")
parser.add_argument("--elements", type=int, default=200, help="how many elements")
options = parser.parse_args()
options.out.mkdir(parents=True, exist_ok=True)

volume = authalic.read_volume(options.volume)
if options.volume == parser.get_default("volume"):
    white = authalic.cortical_surfaces(volume, target_faces=8000)["left"]
    disk = authalic.cut_to_disk(white, region="MedialWall")
else:
    disk = surfaces.disk(options)

# One number per vertex; a vertex outside the field of view is NaN, never 0.
pet, coverage = authalic.sample_volume(disk, volume, "along-normal", depths=(*options.depths, 0.5))
missing = np.isnan(pet).sum()
print(f"PET: quartiles {np.nanpercentile(pet, [25, 50, 75]).round(3)}, {missing} vertices without a value")

flat = authalic.flatten(disk.with_point_arrays({"PET": pet}))
elements = authalic.elements(flat, {"PET": pet}, count=options.elements, hemisphere="L")
print(f"{elements.summary['elements']} elements of {np.median(elements.table['area_mm2']):.1f} mm2; "
      f"the inner ones differ by {elements.summary['interior_maximum_deviation']:.2%} at most")

# Means are weighted by area: they do not depend on how dense the mesh is.
columns = ("element_id", "centroid_x_mm", "centroid_y_mm", "centroid_z_mm", "area_mm2", "pet_mean", "pet_sd",
           "pet_coverage")
rows = zip(*(elements.table[name] for name in columns))
write_text(options.out / "pet.tsv", "\n".join(["\t".join(columns), *("\t".join(map(str, row)) for row in rows), ""]))

means = np.append(elements.table["pet_mean"], np.nan)[elements.face_ids - 1]
shown = authalic.Surface(flat.points, flat.faces, flat.point_arrays, {**flat.face_arrays, "Mean": means})
table = colours.sequential(*np.nanpercentile(pet, [2, 98]))
gallery = Gallery()
gallery.add(f"{options.volume.name} on the cortex", shown, shown.points, surfaces.lateral(disk), None, "PET", table)
gallery.add("on the flat map", shown, flat.image, array="PET", table=table)
gallery.add("means of elements of equal area", shown, flat.image, array="Mean", table=table)
gallery.save(options.out / "pet.png")
