#!/usr/bin/python3
# %% [markdown]
# # Authalic from Python
#
# Surfaces in, maps out, numpy arrays all the way. Run this file as it is, with the package on the path (see README.md
# beside it), or cell by cell in an editor that knows `# %%`.

# %%
import pathlib
import tempfile

import numpy as np

import authalic

data = pathlib.Path(__file__).resolve().parents[1] / "data"
out = pathlib.Path(tempfile.mkdtemp(prefix="authalic-"))

# %% [markdown]
# ## A surface
#
# `read_surface` knows FreeSurfer, GIFTI, OFF, PLY, OBJ, STL and VTK's formats. A `Surface` is arrays: `points` (n,
# 3) in mm, `faces` (m, 3), and what is known per vertex, per face and as a whole. Your own arrays do as well:
# every function takes `(points, faces)`, a `Surface`, or a `vtkPolyData`.

# %%
surface = authalic.read_surface(data / "folded_sphere.off")
print(surface)
report = authalic.topology(surface)
print(report["summary"], "-", round(report["area_mm2"] / 100), "cm2")

# %% [markdown]
# ## A disk
#
# A map of a disk needs a disk. The medial wall of a hemisphere is cut off by a label, an annotation, flags per
# vertex, or, here, a plane: a point and the normal towards the side that goes.

# %%
disk = authalic.cut_to_disk(surface, plane=((0, 0, -20), (0, 0, -1)))
print(authalic.topology(disk)["summary"])
assert np.array_equal(surface.points[disk.point_arrays["OriginalPointIds"]], disk.points)

# %% [markdown]
# ## A map
#
# `flatten` gives every vertex a place. `authalic`, the default, preserves areas; `methods()` lists the others with
# their options.

# %%
print(list(authalic.methods()))
flat = authalic.flatten(disk)
print(flat)
off = flat.face_arrays["AreaDistortion"]  # log2 of image share / share of area; 0 = preserved
print(f"areas are off by {2**np.abs(off).max() - 1:.1%} at most, by {2**np.abs(off).mean() - 1:.2%} on average")
assert flat.converged and flat.metrics["flipped_faces"] == 0

# %% [markdown]
# The harmonic map keeps angles instead, and areas suffer:

# %%
harmonic = authalic.flatten(disk, method="harmonic")
for name, result in (("harmonic", harmonic), ("authalic", flat)):
    area, angle = result.metrics["area_distortion"], result.metrics["angle_distortion"]
    print(f"{name:9} area {area:.3f}  angle {angle:.3f}  (ideal 2)")
assert flat.metrics["area_distortion"] < harmonic.metrics["area_distortion"]

# %% [markdown]
# ## A measure
#
# A density relative to the native area says which parts of the surface get more room.

# %%
near = np.linalg.norm(disk.points - disk.points[np.argmin(np.linalg.norm(flat.image, axis=1))], axis=1) < 12
larger = authalic.flatten(disk, measure=np.where(near, 4.0, 1.0), initial=flat, domain="disk")


def share(image):
    """Part of the image that faces inside the region cover."""
    a, b, c = (image[disk.faces[:, k]] for k in range(3))
    areas = np.abs(np.cross(b - a, c - a))
    return areas[near[disk.faces].all(axis=1)].sum() / areas.sum()


print(f"the region covers {share(flat.image):.1%} of the map, with the measure {share(larger.image):.1%}")
assert share(larger.image) > 2.5 * share(flat.image)

# %% [markdown]
# ## A volume, and elements of equal area
#
# Volumes have their affine, voxel index to scanner RAS mm. A vertex outside of it is NaN, never 0. `elements`
# divides the map into a grid whose preimages on the surface have equal areas, and summarises fields in them,
# weighted by area.

# %%
i, j, k = np.indices((50, 50, 50)) * 2.0 - 49.0
volume = authalic.Volume(np.sqrt(i**2 + j**2 + k**2),
                         np.array([[2, 0, 0, -49], [0, 2, 0, -49], [0, 0, 2, -49], [0, 0, 0, 1.0]]))
here = authalic.Surface(flat.points, flat.faces)  # the file states no space; made from arrays, it is ours to say
radius, coverage = authalic.sample_volume(here, volume)
elements = authalic.elements(flat, {"radius": radius}, count=60)
print(elements)
off = elements.summary["interior_maximum_deviation"]
print(f"{elements.summary['elements']} elements, inner ones equal to {off:.2%}")
assert np.nanmax(np.abs(radius - np.linalg.norm(flat.points, axis=1))) < 0.2

# %% [markdown]
# ## Failures are exceptions
#
# One sentence: what was required, what was found, where, what to do. Not converging is a warning and a status; the
# best map is there. `progress` is called often, and stops the work by returning False; so does Ctrl-C.

# %%
try:
    authalic.flatten(surface)
except authalic.SurfaceError as failure:
    print("SurfaceError:", failure)

try:
    authalic.flatten(disk, progress=lambda fraction, stage: fraction < 0.3)
except authalic.Cancelled as failure:
    print("Cancelled:", failure)

# %% [markdown]
# ## Files, and the VTK classes
#
# A map in a `.vtp` file keeps everything, for ParaView and for the command line. Every function runs a filter that
# joins any VTK pipeline by itself; `help(authalic.vtkAuthalicMap)` shows its ports, arrays and options.

# %%
authalic.write_surface(out / "map.vtp", flat)
exact = authalic.vtkAuthalicMap()
exact.SetInputData(disk.to_vtk())
exact.SetOutputModeToTextureCoordinates()  # the points stay the surface
exact.Update()
print(out / "map.vtp", "-", exact.GetOutput().GetPointData().GetTCoords().GetNumberOfTuples(), "texture coordinates")
