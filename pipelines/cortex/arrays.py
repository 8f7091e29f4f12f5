"""Between VTK data objects and numpy: plumbing, no numerics of its own."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData


def points(surface):
    """n×3 coordinates."""
    return vtk_to_numpy(surface.GetPoints().GetData())


def faces(surface):
    """m×3 vertex indices of a triangle mesh."""
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def point_array(surface, name):
    """The point array of that name, or None."""
    array = surface.GetPointData().GetArray(name)
    return None if array is None else vtk_to_numpy(array)


def cell_array(surface, name):
    """The cell array of that name, or None."""
    array = surface.GetCellData().GetArray(name)
    return None if array is None else vtk_to_numpy(array)


def add_point_array(surface, name, values):
    """Adds a copy of `values` as the point array `name`; replaces one of that name."""
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    surface.GetPointData().AddArray(array)
    return array


def field_numbers(surface):
    """Field data as a dictionary: one number, a list of numbers, or a string per array."""
    data, out = surface.GetFieldData(), {}
    for k in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(k)
        values = [_plain(array.GetVariantValue(i)) for i in range(array.GetNumberOfValues())]
        out[array.GetName()] = values[0] if len(values) == 1 else values
    return out


def _plain(variant):
    if variant.IsString():
        return variant.ToString()
    return variant.ToDouble() if variant.IsFloat() or variant.IsDouble() else variant.ToInt()


def with_points(surface, coordinates):
    """The same triangles and arrays at other coordinates; arrays are shared, not copied."""
    out = vtkPolyData()
    out.ShallowCopy(surface)
    moved = vtkPoints()
    moved.SetData(numpy_to_vtk(np.ascontiguousarray(coordinates, dtype=float), deep=1))
    out.SetPoints(moved)
    return out


def native(map_):
    """A map put back where it came from: its triangles at OriginalPoints (mm)."""
    return with_points(map_, point_array(map_, "OriginalPoints"))


def triangles(coordinates, corners):
    """A triangle mesh of n×3 points and m×3 vertex indices."""
    mesh = with_points(vtkPolyData(), coordinates)
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(corners, dtype=np.int64).ravel(), deep=1))
    mesh.SetPolys(cells)
    return mesh


def segments(coordinates):
    """Lines between points 2k and 2k + 1."""
    lines = with_points(vtkPolyData(), coordinates)
    cells = vtkCellArray()
    cells.SetData(2, numpy_to_vtkIdTypeArray(np.arange(len(coordinates), dtype=np.int64), deep=1))
    lines.SetLines(cells)
    return lines


def copy_of(surface):
    """The same data under another object: arrays may be added without touching the first."""
    out = surface.NewInstance()
    out.ShallowCopy(surface)
    return out


def image_of(grey, tint=(1.0, 1.0, 1.0)):
    """h×w grey levels in [0, 1], bottom row first, as an RGB image."""
    image = vtkImageData()
    image.SetDimensions(grey.shape[1], grey.shape[0], 1)
    rgb = np.rint(grey.reshape(-1, 1) * np.array(tint) * 255).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(rgb, deep=1))
    return image


def face_areas(surface):
    """Area of each triangle."""
    corners = points(surface)[faces(surface)]
    return np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2


def add_cell_array(surface, name, values):
    """Adds a copy of `values` as the cell array `name`; replaces one of that name."""
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    surface.GetCellData().AddArray(array)


def mean_gradient(uv, values):
    """Unit vector along which `values` grow in the least-squares plane over the map."""
    centred = uv - uv.mean(axis=0)
    slope = np.linalg.lstsq(centred, values - values.mean(), rcond=None)[0]
    return slope / np.linalg.norm(slope)


def millimetres_per_unit(map_):
    """Length of a map unit if areas are preserved: the root of native over image area."""
    return (face_areas(native(map_)).sum() / face_areas(map_).sum())**0.5


def corners(surface):
    """Vertex indices of quadrilaterals, m×4."""
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 4)
