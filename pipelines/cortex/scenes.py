"""Lateral and medial views of a hemisphere, coloured by place, checkerboard or distortion."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkMapper, vtkPolyDataMapper, vtkTextActor, vtkTexture

import arrays
import colours
from render import OVERSAMPLING, View


def surface_actor(surface, rgb=None, lit=True):
    """Triangles in one neutral colour, or with n×3 colour bytes per vertex."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(_with_normals(surface) if lit else surface)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colours.NEUTRAL)
    actor.GetProperty().SetAmbient(0.25 if lit else 1.0)
    actor.GetProperty().SetDiffuse(0.80 if lit else 0.0)
    if rgb is not None:
        _colour_vertices(mapper, rgb)
    return actor


def _colour_vertices(mapper, rgb):
    coloured = arrays.copy_of(mapper.GetInput())
    array = numpy_to_vtk(rgb, deep=1)
    array.SetName("Colours")
    coloured.GetPointData().SetScalars(array)
    mapper.SetInputData(coloured)
    mapper.ScalarVisibilityOn()
    mapper.SetColorModeToDirectScalars()


def _with_normals(surface):
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def cell_actor(surface, array, table, lit=True):
    """Triangles coloured by a cell array through a lookup table."""
    return _array_actor(surface, array, table, lit, vtkMapper.SetScalarModeToUseCellFieldData)


def point_actor(surface, array, table, lit=True):
    """Triangles coloured by a point array through a lookup table."""
    return _array_actor(surface, array, table, lit, vtkMapper.SetScalarModeToUsePointFieldData)


def _array_actor(surface, array, table, lit, set_mode):
    actor = surface_actor(surface, lit=lit)
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    set_mode(mapper)
    mapper.SelectColorArray(array)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    return actor


def checker_actor(map_, squares=24):
    """The cortex with a checkerboard of `squares`² equal squares across the map, pixel by pixel."""
    surface = arrays.native(map_)
    uv = arrays.points(map_)[:, :2]
    place = (uv - uv.min(axis=0)) / (uv.max(axis=0) - uv.min(axis=0)).max() * squares / 2
    surface.GetPointData().SetTCoords(numpy_to_vtk(np.ascontiguousarray(place), deep=1))
    actor = surface_actor(surface)
    actor.GetProperty().SetColor(1, 1, 1)
    actor.SetTexture(_checker_texture())
    return actor


def _checker_texture():
    texture = vtkTexture()
    texture.SetInputData(arrays.image_of(np.array([[0.93, 0.22], [0.22, 0.93]]), (0.98, 0.98, 1.0)))
    texture.RepeatOn()
    texture.InterpolateOff()
    return texture


def behind(actor):
    """Draws an actor a little deeper, so that what lies on the same surface wins."""
    mapper = actor.GetMapper()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 8)
    return actor


def line_actor(lines, width=1.4, colour=colours.INK):
    """Lines, drawn a little in front of the surface they lie on."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(lines)
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-1, -4)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetLineWidth(width * OVERSAMPLING)
    actor.GetProperty().LightingOff()
    return actor


def views(surface, hemisphere):
    """Lateral and medial views that see the whole surface."""
    low, high = arrays.points(surface).min(axis=0), arrays.points(surface).max(axis=0)
    extent = ((high[1] - low[1]) * 1.04, (high[2] - low[2]) * 1.20)
    outward = (1, 0, 0) if hemisphere == "lh" else (-1, 0, 0)
    inward = tuple(-x for x in outward)
    centre = (low + high) / 2
    return View(centre, outward, (0, 0, 1), extent), View(centre, inward, (0, 0, 1), extent)


def caption(text, x=0.5, y=0.012, size=20, bold=False, centred=True):
    """Words at a place of the panel, in fractions of it."""
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(x, y)
    style = actor.GetTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(size)
    style.SetColor(*colours.INK)
    style.SetBold(bold)
    if centred:
        style.SetJustificationToCentered()
    return actor


def colour_bar(table, position, size):
    """A horizontal colour bar at a place of the panel, in fractions of it."""
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.3g")
    bar.SetPosition(*position)
    bar.SetWidth(size[0])
    bar.SetHeight(size[1])
    bar.SetMaximumNumberOfColors(256)
    bar.UnconstrainedFontSizeOn()
    style = bar.GetLabelTextProperty()
    style.SetColor(*colours.INK)
    style.SetFontSize(18)
    style.BoldOff()
    style.ItalicOff()
    style.ShadowOff()
    return bar
