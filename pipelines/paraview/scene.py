"""What the pictures show: two maps of one cortex, and both again on the cortex itself, in one scale of colours."""
from paraview.simple import (CreateLayout, CreateView, GetColorTransferFunction, GetScalarBar, OutputPort, Calculator,
                             Render, ResetCamera, SaveScreenshot, Show, Text, AssignViewToLayout, Contour)

TITLES = ("Mean-value map", "Area-preserving map")
SIZE = (1500, 1500)
LIMIT = 3.0  # log2: blue = one eighth of its share of area, red = eight times
INK = [0.12, 0.12, 0.14]
DISTORTION = ("POINTS", "VertexAreaDistortion")


def colours():
    """Blue – light grey – red, symmetric: grey = area preserved."""
    table = GetColorTransferFunction(DISTORTION[1])
    table.ApplyPreset("Cool to Warm", True)
    table.RescaleTransferFunction(-LIMIT, LIMIT)
    table.AutomaticRescaleRangeMode = "Never"
    return table
