"""Colours of the pictures: perceptually uniform, told apart by colour-blind readers, grey for anatomy."""
import numpy as np
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

GYRUS, SULCUS = 0.88, 0.42  # grey levels of the two ends of the sulcal shading
NEUTRAL = (0.80, 0.77, 0.73)  # what is not mapped
INK = (0.10, 0.10, 0.12)

# Every 32nd colour of viridis (S. van der Walt and N. Smith, CC0).
VIRIDIS = [(0.267, 0.005, 0.329), (0.278, 0.176, 0.483), (0.223, 0.334, 0.549), (0.166, 0.463, 0.558),
           (0.123, 0.582, 0.547), (0.190, 0.709, 0.479), (0.452, 0.821, 0.343), (0.762, 0.876, 0.137),
           (0.993, 0.906, 0.144)]


def lab_to_rgb(lab):
    """CIELAB (D65) to sRGB in [0, 1], n×3; colours outside the gamut are clipped."""
    lab = np.asarray(lab, dtype=float)
    fy = (lab[:, 0] + 16) / 116
    f = np.stack([fy + lab[:, 1] / 500, fy, fy - lab[:, 2] / 200], axis=1)
    xyz = np.where(f > 6 / 29, f**3, 3 * (6 / 29)**2 * (f - 4 / 29)) * [0.95047, 1.0, 1.08883]
    rgb = xyz @ np.array([[3.2406, -0.9689, 0.0557], [-1.5372, 1.8758, -0.2040], [-0.4986, 0.0415, 1.0570]])
    rgb = np.clip(rgb, 0, 1)
    return np.where(rgb <= 0.0031308, 12.92 * rgb, 1.055 * rgb**(1 / 2.4) - 0.055)


def domain_colours(uv, shade):
    """One colour per place of the map (direction = hue, distance = saturation), times a shade."""
    reach = np.abs(uv).max()
    lab = np.column_stack([np.full(len(uv), 74.0), 58 * uv[:, 0] / reach, 58 * uv[:, 1] / reach])
    return to_bytes(lab_to_rgb(lab) * shade[:, None])


def distinct(count):
    """Colours for labels: hues a golden angle apart, lightness in three steps."""
    k = np.arange(count)
    hue = k * np.pi * (3 - 5**0.5)
    return to_bytes(lab_to_rgb(np.column_stack([55 + 12 * (k % 3), 45 * np.cos(hue), 45 * np.sin(hue)])))


def sulcal_grey(depth):
    """Grey level per vertex: light gyri and dark sulci, between the 5th and the 95th percentile."""
    low, high = np.percentile(depth, [5, 95])
    return GYRUS + (SULCUS - GYRUS) * np.clip((depth - low) / max(high - low, 1e-9), 0, 1)


def grey_bytes(level):
    return to_bytes(np.repeat(np.asarray(level)[:, None], 3, axis=1))


def to_bytes(rgb):
    return np.clip(np.rint(np.asarray(rgb) * 255), 0, 255).astype(np.uint8)


def diverging(limit):
    """Blue – light grey – red over [−limit, limit], made by VTK's interpolation in Msh space."""
    ramp = vtkColorTransferFunction()
    ramp.SetColorSpaceToDiverging()
    ramp.AddRGBPoint(-limit, 0.230, 0.299, 0.754)
    ramp.AddRGBPoint(limit, 0.706, 0.016, 0.150)
    return _table(ramp, -limit, limit)


def sequential(low, high):
    """Viridis over [low, high]."""
    ramp = vtkColorTransferFunction()
    for k, colour in enumerate(VIRIDIS):
        ramp.AddRGBPoint(low + (high - low) * k / (len(VIRIDIS) - 1), *colour)
    return _table(ramp, low, high)


def _table(ramp, low, high, n=256):
    table = vtkLookupTable()
    table.SetNumberOfTableValues(n)
    table.SetRange(low, high)
    for k in range(n):
        table.SetTableValue(k, *ramp.GetColor(low + (high - low) * k / (n - 1)), 1.0)
    table.SetNanColor(*NEUTRAL, 1.0)
    return table
