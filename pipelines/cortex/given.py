"""Starting from a surface that is there already, instead of a T1 (option --surface)."""
import re

import numpy as np

import arrays
import authalic
from stages import StageError

CORTEX = "Cortex"  # point array of the option --cortex
MEDIAL_SHARE = 0.08  # of the width of the hemisphere lies beyond the plane that opens it


def surface(options, stages):
    """{side: (filter, output port)} of the surface, with the arrays of --cortex and --labels."""
    last = authalic.vtkSurfaceFileReader()
    last.SetFileName(str(options.surface))
    given = stages.run("reading the surface", last)
    side = options.hemisphere or side_of(options.surface, given)
    if options.t1 and "unknown" in str(arrays.field_numbers(given).get("CoordinateSpace", "unknown")):
        raise StageError(f"{options.surface} must say that it is in scanner RAS, so that the T1 can be read on it; "
                         "it does not say. Convert it to a format that does, or leave --t1 out.", 2)
    if options.cortex:
        cortex = authalic.vtkVertexDataReader()
        cortex.SetInputConnection(last.GetOutputPort())
        cortex.SetFileName(str(options.cortex))
        cortex.SetArrayName(CORTEX)
        stages.run("reading the cortex label", cortex)
        last = cortex
    return {side: (last, 0)}


def side_of(path, given):
    """lh or rh, by the name of the file (lh.white, hemi-L, x.L.surf.gii), else by where the surface is."""
    name = re.search(r"(?:^|[._-])(?:hemi-)?([lr])h?[._-]", path.name.lower())
    if name:
        return name.group(1) + "h"
    return "lh" if arrays.points(given)[:, 0].mean() < 0 else "rh"


def cut(sampled, side, options):
    """vtkCutToDisk for the cortex label if there is one, else for a plane near the midline."""
    opening = authalic.vtkCutToDisk()
    if options.cortex:
        opening.SetRegionArrayName(CORTEX)
        opening.KeepRegionOn()
        return opening
    sampled.Update()
    x = arrays.points(sampled.GetOutputDataObject(0))[:, 0]
    inward = 1 if side == "lh" else -1
    medial = np.max(inward * x) - MEDIAL_SHARE * np.ptp(x)
    opening.SetRegionModeToPlane()
    opening.SetPlaneOrigin(inward * medial, 0, 0)
    opening.SetPlaneNormal(inward, 0, 0)
    return opening
