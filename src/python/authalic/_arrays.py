"""Between numpy and VTK's data objects. Everything is copied; nothing is shared with the caller."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ._errors import InvalidArgument, SurfaceError


def numbers(values, name, shape=None, dtype=float):
    """`values` as a contiguous array of numbers; `shape` may hold None for any length.

    Raises InvalidArgument when they are no numbers or have another shape."""
    try:
        array = np.ascontiguousarray(values)
        if array.dtype == object or array.dtype.kind not in "biuf":
            raise TypeError
        array = array.astype(_storable(array.dtype) if dtype is None else dtype, copy=False)
    except (TypeError, ValueError):
        raise InvalidArgument(f"{name} must be an array of numbers; it is {_kind(values)}.") from None
    if shape is not None and (array.ndim != len(shape) or any(w not in (None, h)
                                                              for w, h in zip(shape, array.shape))):
        raise InvalidArgument(f"{name} must have shape {_text(shape)}; it has {_text(array.shape)}.")
    return array


def _storable(dtype):
    """The type of number that VTK can keep: in this machine's byte order; half and long double become double."""
    return np.dtype(float) if dtype.kind == "f" and dtype.itemsize not in (4, 8) else dtype.newbyteorder("=")


def _kind(values):
    return f"of type {getattr(values, 'dtype', type(values).__name__)}"


def _text(shape):
    return "(" + ", ".join("n" if k is None else str(k) for k in shape) + ("," if len(shape) == 1 else "") + ")"


def coordinates(points, name="points"):
    """n×3 doubles; n×2 gets z = 0."""
    array = numbers(points, name)
    if array.ndim == 2 and array.shape[1] == 2:
        array = np.column_stack([array, np.zeros(len(array))])
    return numbers(array, name, (None, 3))


def corners(faces, vertex_count):
    """m×3 vertex indices. Raises SurfaceError when one is out of range."""
    array = numbers(faces, "faces", (None, 3), dtype=None)
    if array.dtype.kind not in "iu":
        raise InvalidArgument(f"faces must hold integers, vertex indices from 0; they are {array.dtype}.")
    bad = np.flatnonzero(((array < 0) | (array >= vertex_count)).any(axis=1))
    if len(bad):
        raise SurfaceError(f"Vertex indices from 0 to {vertex_count - 1} are required, but face {bad[0]} names "
                           f"{', '.join(map(str, array[bad[0]]))}; indices count from 0.")
    return array.astype(np.int64)


def polydata(points, faces):
    """A triangle mesh of n×3 points and m×3 vertex indices."""
    mesh, cells = vtkPolyData(), vtkCellArray()
    set_points(mesh, points)
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(faces, dtype=np.int64).ravel(), deep=1))
    mesh.SetPolys(cells)
    return mesh


def set_points(mesh, points):
    """Replaces the points."""
    array = vtkPoints()
    array.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=1))
    mesh.SetPoints(array)


def points_of(mesh):
    """n×3 doubles."""
    if mesh.GetNumberOfPoints() == 0:
        return np.zeros((0, 3))
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)


def faces_of(mesh):
    """m×3 vertex indices. Raises SurfaceError unless every polygon is a triangle."""
    polygons = mesh.GetPolys()
    ids = vtk_to_numpy(polygons.GetConnectivityArray()).astype(
        np.int64) if polygons.GetNumberOfCells() else np.zeros(0, int)
    if len(ids) != 3 * polygons.GetNumberOfCells() or polygons.IsHomogeneous() not in (0, 3):
        raise SurfaceError("The surface must consist of triangles; run vtkTriangleFilter first.")
    return ids.reshape(-1, 3)


def add_arrays(data, arrays, count, of):
    """Copies of numpy arrays as the point or cell arrays of `data`."""
    for name, values in arrays.items():
        array = numbers(values, f"array '{name}'", dtype=None)
        if array.ndim not in (1, 2) or len(array) != count:
            raise InvalidArgument(f"Array '{name}' must have one row for each of the {count} {of}; "
                                  f"its shape is {_text(array.shape)}.")
        out = numpy_to_vtk(array.astype(np.uint8) if array.dtype == bool else array, deep=1)
        out.SetName(name)
        data.AddArray(out)


def arrays_of(data):
    """{name: copy} of every array of numbers."""
    found = {}
    for k in range(data.GetNumberOfArrays()):
        array = data.GetArray(k)
        if array is not None and array.GetName():
            found[array.GetName()] = vtk_to_numpy(array).copy()
    return found


def add_fields(mesh, fields):
    """Text, numbers and arrays as field data."""
    for name, value in fields.items():
        texts = [value] if isinstance(value, str) else value
        if isinstance(texts, (list, tuple)) and texts and all(isinstance(t, str) for t in texts):
            array = vtkStringArray()
            for text in texts:
                array.InsertNextValue(text)
        else:
            array = numpy_to_vtk(np.atleast_1d(numbers(value, f"field '{name}'", dtype=None)), deep=1)
        array.SetName(name)
        mesh.GetFieldData().AddArray(array)


def fields_of(mesh):
    """Field data by name: text, one number, a list of texts, or an array."""
    data, found = mesh.GetFieldData(), {}
    for k in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(k)
        if isinstance(array, vtkStringArray):
            texts = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
            found[array.GetName()] = texts[0] if len(texts) == 1 else texts
        elif data.GetArray(array.GetName()) is not None:
            values = vtk_to_numpy(array).copy()
            found[array.GetName()] = values[0].item() if values.shape == (1,) else values
    return found
