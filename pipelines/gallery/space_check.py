#!/usr/bin/python3
"""Is the surface where the volume is? Its outline on three slices, and what the volume holds on either side of it.

    space_check.py --surface lh.white --volume T1.mgz

A surface that is shifted, mirrored or in another space shows at once. Leaves space.png; the patient's left is on the
left. Where a file does not say its space, --space scanner-ras (tk-ras, lps) says it.
"""
import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter
from vtkmodules.vtkRenderingCore import vtkActor, vtkImageActor, vtkPolyDataMapper, vtkPropAssembly

import authalic
import surfaces
from show import Gallery

# Of each slice: the axis it is across, and the two that are drawn to the right and up.
SLICES = {"sagittal, x": (0, 1, 2), "coronal, y": (1, 0, 2), "axial, z": (2, 0, 1)}
STEP = 0.5  # mm per pixel of a slice


def values_at(volume, points):
    """Trilinear values of a volume at points (n, 3), NaN outside."""
    inverse = np.linalg.inv(volume.affine)
    index = points @ inverse[:3, :3].T + inverse[:3, 3]
    size = np.array(volume.values.shape)
    inside = ((index >= 0) & (index <= size - 1)).all(axis=1)
    low = np.clip(np.floor(index).astype(int), 0, np.maximum(size - 2, 0))
    part = index - low
    total = np.zeros(len(points))
    for corner in np.ndindex(2, 2, 2):
        share = np.where(corner, part, 1 - part).prod(axis=1)
        total += np.where(share, share * volume.values[tuple(np.minimum(low + corner, size - 1).T)], 0.0)
    return np.where(inside, total, np.nan)


def corners_of(volume):
    """The box of the volume in scanner RAS: lowest and highest corner."""
    ends = [(0, n - 1) for n in volume.values.shape]
    corners = np.array(np.meshgrid(*ends)).reshape(3, -1).T @ volume.affine[:3, :3].T + volume.affine[:3, 3]
    return corners.min(axis=0), corners.max(axis=0)


def slice_actor(volume, axes, place, window):
    """The plane across axes[0] at `place`, as grey values, in the plane of the other two."""
    across, right, up = axes
    low, high = corners_of(volume)
    u, v = (np.arange(low[axis], high[axis], STEP) for axis in (right, up))
    points = np.zeros((len(v), len(u), 3))
    points[..., across], points[..., right], points[..., up] = place, u[None, :], v[:, None]
    grey = values_at(volume, points.reshape(-1, 3))
    grey = np.nan_to_num(255 * np.clip((grey - window[0]) / max(window[1] - window[0], 1e-12), 0, 1)).astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(len(u), len(v), 1)
    image.SetOrigin(u[0], v[0], -1)
    image.SetSpacing(STEP, STEP, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(grey, deep=1))
    actor = vtkImageActor()
    actor.SetInputData(image)
    return actor


def outline(surface, axes, place):
    """Where the surface meets the plane, in the same two axes."""
    plane = vtkPlane()
    plane.SetOrigin(*(np.eye(3)[axes[0]] * place))
    plane.SetNormal(*np.eye(3)[axes[0]])
    cutter = vtkCutter()
    cutter.SetCutFunction(plane)
    cutter.SetInputData(surface.to_vtk())
    cutter.Update()
    lines = cutter.GetOutput()
    for i in range(lines.GetNumberOfPoints()):
        point = lines.GetPoint(i)
        lines.GetPoints().SetPoint(i, point[axes[1]], point[axes[2]], 1.0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(lines)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(1.0, 0.75, 0.0)
    actor.GetProperty().SetLineWidth(3)
    actor.GetProperty().LightingOff()
    return actor


def normals_of(surface):
    """Unit normals per vertex, outward."""
    a, b, c = surface.points[surface.faces].swapaxes(0, 1)
    faces = np.cross(b - a, c - a)
    normals = np.zeros_like(surface.points)
    for corner in range(3):
        np.add.at(normals, surface.faces[:, corner], faces)
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--surface", type=pathlib.Path, help="any surface (default: that of the phantom's left hemisphere)")
parser.add_argument("--volume", type=pathlib.Path, default=surfaces.FIXTURES / "phantom_t1.nii.gz",
                    help="NIfTI or MGH (default: a phantom)")
parser.add_argument("--space", default="as-stated", help="of the surface, where its file does not say")
parser.add_argument("--at", type=float, nargs=3, metavar=("X", "Y", "Z"),
                    help="where the slices meet, mm (default: the middle of the surface)")
parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/gallery"), help="folder")
options = parser.parse_args()
options.out.mkdir(parents=True, exist_ok=True)

volume = authalic.read_volume(options.volume)
if options.surface:
    surface = authalic.read_surface(options.surface, options.space)
else:
    surface = authalic.cortical_surfaces(volume, target_faces=8000)["left"]
for name, thing in (("surface", surface), ("volume", volume)):
    print(f"{name}: {thing.fields.get('CoordinateSpace', 'unknown')} ({thing.fields.get('CoordinateSpaceReason', '')})")
    if thing.fields.get("CoordinateSpace") == "unknown":
        raise authalic.InvalidArgument(f"The space of the {name} is unknown; say it with --space.")

# A white surface has brighter voxels inside than outside; a surface in the wrong place has the same on both sides.
normals = normals_of(surface)
inside, outside = (values_at(volume, surface.points + depth * normals) for depth in (-1.5, 1.5))
seen = np.isfinite(inside) & np.isfinite(outside)
print(f"{seen.mean():.1%} of the vertices lie in the volume; 1.5 mm inside {inside[seen].mean():.4g}, "
      f"outside {outside[seen].mean():.4g} on average")

middle = np.array(options.at) if options.at else (surface.points.min(axis=0) + surface.points.max(axis=0)) / 2
window = np.nanpercentile(volume.values[np.isfinite(volume.values)], (1, 99.5))
low, high = corners_of(volume)
gallery = Gallery()
for words, axes in SLICES.items():
    both = vtkPropAssembly()
    both.AddPart(slice_actor(volume, axes, middle[axes[0]], window))
    both.AddPart(outline(surface, axes, middle[axes[0]]))
    gallery.add_prop(f"{words} = {middle[axes[0]]:.1f} mm", both, np.array([low[[*axes[1:]]], high[[*axes[1:]]]]))
gallery.save(options.out / "space.png")
