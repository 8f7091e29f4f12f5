"""The flat map as a chart: sulcal shading, region contours and names, compass and scale."""
import re

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkProbeFilter, vtkStripper, vtkWindowedSincPolyDataFilter
from vtkmodules.vtkFiltersGeneral import vtkDiscreteFlyingEdges2D
from vtkmodules.vtkImagingGeneral import vtkImageEuclideanDistance, vtkImageGaussianSmooth
from vtkmodules.vtkRenderingCore import vtkBillboardTextActor3D

import arrays
import colours
import scenes
from render import View

RESOLUTION = 560  # pixels across the label image that contours and name places are taken from
BLUR = 3.5  # pixels, standard deviation: what is narrower than about twice that is not drawn


def view(map_, margin=1.10):
    """From above, upright, with room for the compass and the scale."""
    low, high = arrays.points(map_).min(axis=0), arrays.points(map_).max(axis=0)
    return View((low + high) / 2, (0, 0, -1), (0, 1, 0), tuple((high - low)[:2] * margin))


def shaded(map_, depth):
    """The map in sulcal grey."""
    return scenes.surface_actor(map_, colours.grey_bytes(colours.sulcal_grey(depth)), lit=False)


def label_image(map_, array):
    """The labels of a map on a square raster; 0 outside the map."""
    low, high = arrays.points(map_).min(axis=0)[:2], arrays.points(map_).max(axis=0)[:2]
    step = (high - low).max() / (RESOLUTION - 9)
    image = vtkImageData()
    image.SetDimensions(RESOLUTION, RESOLUTION, 1)
    image.SetSpacing(step, step, 1)
    image.SetOrigin(*((low + high) / 2 - step * (RESOLUTION - 1) / 2), 0)
    source = arrays.copy_of(map_)
    source.GetPointData().SetActiveScalars(array)
    probe = vtkProbeFilter()
    probe.SetInputData(image)
    probe.SetSourceData(source)
    probe.CategoricalDataOn()
    probe.Update()
    mapped = vtk_to_numpy(probe.GetValidPoints())
    labels = np.nan_to_num(vtk_to_numpy(probe.GetOutput().GetPointData().GetArray(array)))
    return _smoothed_labels(image, np.rint(labels).astype(np.int32), mapped)


def _smoothed_labels(image, labels, mapped):
    """Each pixel takes the label whose blurred region is strongest there: for drawing, not for statistics."""
    inside = np.zeros(len(labels), dtype=bool)
    inside[mapped] = True
    best, winner = np.zeros(len(labels), dtype=np.float32), np.zeros(len(labels), dtype=np.int32)
    blur = vtkImageGaussianSmooth()
    blur.SetDimensionality(2)
    blur.SetStandardDeviations(BLUR, BLUR, 0)
    blur.SetInputData(image)
    for label in np.unique(labels[inside]):
        region = numpy_to_vtk(((labels == label) & inside).astype(np.float32), deep=1)
        image.GetPointData().SetScalars(region)
        image.Modified()
        blur.Update()
        strength = vtk_to_numpy(blur.GetOutput().GetPointData().GetScalars())
        winner[strength > best] = label
        best = np.maximum(best, strength)
    image.GetPointData().SetScalars(numpy_to_vtk(np.where(inside, winner, 0), deep=1))
    return image


def contours(image):
    """Smooth border lines between the labels of an image."""
    labels = np.unique(vtk_to_numpy(image.GetPointData().GetScalars()))
    edges = vtkDiscreteFlyingEdges2D()
    edges.SetInputData(image)
    for k, label in enumerate(labels[labels > 0]):
        edges.SetValue(k, float(label))
    strips = vtkStripper()
    strips.SetInputConnection(edges.GetOutputPort())
    smooth = vtkWindowedSincPolyDataFilter()
    smooth.SetInputConnection(strips.GetOutputPort())
    smooth.SetNumberOfIterations(40)
    smooth.SetPassBand(0.02)
    smooth.Update()
    return smooth.GetOutput()


def name_places(image):
    """{label: (x, y, clearance)}: the point of each region that is farthest from its border, in map units."""
    labels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(RESOLUTION, RESOLUTION)
    clearance = _distance_to_borders(labels)
    origin, step = np.array(image.GetOrigin()[:2]), image.GetSpacing()[0]
    places = {}
    for label in np.unique(labels[labels > 0]):
        row, column = np.unravel_index(np.argmax(np.where(labels == label, clearance, -1)), labels.shape)
        x, y = origin + step * np.array([column, row])
        places[int(label)] = (x, y, clearance[row, column] * step)
    return places


def _distance_to_borders(labels):
    inside = np.ones(labels.shape, dtype=np.float64)
    for axis in (0, 1):
        change = np.diff(labels, axis=axis) != 0
        ahead = [slice(None), slice(None)]
        behind = [slice(None), slice(None)]
        ahead[axis], behind[axis] = slice(1, None), slice(None, -1)
        inside[tuple(ahead)][change] = 0
        inside[tuple(behind)][change] = 0
    image = vtkImageData()
    image.SetDimensions(labels.shape[1], labels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(inside.ravel(), deep=1))
    distance = vtkImageEuclideanDistance()
    distance.SetInputData(image)
    distance.SetDimensionality(2)
    distance.SetMaximumDistance(1e9)
    distance.ConsiderAnisotropyOff()
    distance.Update()
    return np.sqrt(vtk_to_numpy(distance.GetOutput().GetPointData().GetScalars())).reshape(labels.shape)


def name_actors(places, names):
    """The names of the regions, smaller where there is less room; none where there is too little."""
    actors = []
    for label, (x, y, clearance) in places.items():
        lines = re.sub("_[LR]$", "", names.get(label, str(label))).split("_")
        size = int(np.clip(2200 * clearance / max(4, max(map(len, lines))), 11, 19))
        if clearance > 0.018:
            actors.append(_words("\n".join(lines), (x, y, 0.02), size))
    return actors


def _words(text, place, size, bold=False):
    actor = vtkBillboardTextActor3D()
    actor.SetInput(text)
    actor.SetPosition(*place)
    style = actor.GetTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(size)
    style.SetBold(bold)
    style.SetColor(*colours.INK)
    style.SetJustificationToCentered()
    style.SetVerticalJustificationToCentered()
    style.SetBackgroundColor(1, 1, 1)
    style.SetBackgroundOpacity(0.55)
    return actor


def compass(map_, scale):
    """Arrows to where the cortex goes up (superior) and forward (anterior), in the mean over the map."""
    position = arrays.point_array(map_, "OriginalPoints")
    uv = arrays.points(map_)[:, :2]
    props = []
    centre, length = np.array([-0.86, 0.86]) * scale, 0.11 * scale
    for column, (ahead, back) in ((2, "SI"), (1, "AP")):
        direction = arrays.mean_gradient(uv, position[:, column])
        tips = centre + np.outer([1, -1], direction * length)
        props.append(scenes.line_actor(arrays.segments(np.column_stack([tips, [0.02, 0.02]])), 2.2))
        for tip, letter, sign in zip(tips, (ahead, back), (1, -1)):
            props.append(_words(letter, (*(tip + sign * direction * 0.035 * scale), 0.02), 20, bold=sign > 0))
    return props


def scale_bar(millimetres, scale):
    """A bar of 5 cm and a square of 1 cm², both true because areas are; `millimetres` per map unit."""
    cm = 10 / millimetres
    x, y = 0.70 * scale, -0.93 * scale
    ticks = [[(x + k * cm, y), (x + k * cm, y + 0.4 * cm)] for k in range(6)]
    path = [[(x, y), (x + 5 * cm, y)], *ticks]
    box = [(x, y + cm), (x + cm, y + cm), (x + cm, y + 2 * cm), (x, y + 2 * cm), (x, y + cm)]
    path += [[a, b] for a, b in zip(box, box[1:])]
    lines = arrays.segments(np.array([(*p, 0.02) for pair in path for p in pair]))
    words = [_words("1 cm", (x + 0.5 * cm, y - 0.7 * cm, 0.02), 15),
             _words("5 cm", (x + 5 * cm, y - 0.7 * cm, 0.02), 15),
             _words("1 cm²", (x + 2.4 * cm, y + 1.5 * cm, 0.02), 15)]
    return [scenes.line_actor(lines, 2.0), *words]
