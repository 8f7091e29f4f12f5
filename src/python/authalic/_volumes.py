"""Volumes as arrays with their affine; sampling them on surfaces; surfaces out of them."""
import dataclasses
import os
from typing import Any, NamedTuple, Optional

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

from . import _arrays, _classes, _filters
from ._errors import InvalidArgument
from ._surfaces import Path, Progress, Surface, require_space, to_polydata, write_with


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class Volume:
    """Voxels and where they are.

    values  (i, j, k); NaN = no value
    affine  (4, 4): scanner RAS mm of the centre of voxel (i, j, k) = affine @ (i, j, k, 1)
    fields  CoordinateSpace, Frames, Warnings ...
    """
    values: np.ndarray
    affine: np.ndarray = dataclasses.field(default_factory=lambda: np.eye(4))
    fields: dict[str, Any] = dataclasses.field(default_factory=dict)

    @classmethod
    def from_vtk(cls, image: Any) -> "Volume":
        """Copies the scalars of a vtkImageData."""
        size = image.GetDimensions()
        values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(size, order="F").copy()
        affine = np.eye(4)
        for column in range(3):
            for row in range(3):
                affine[row, column] = image.GetDirectionMatrix().GetElement(row, column) * image.GetSpacing()[column]
        extent = image.GetExtent()
        affine[:3, 3] = np.array(image.GetOrigin()) + affine[:3, :3] @ extent[::2]
        return cls(values, affine, _arrays.fields_of(image))

    def to_vtk(self) -> Any:
        """A vtkImageData with origin, spacing and direction matrix such that its physical coordinates are scanner
        RAS."""
        values = _arrays.numbers(self.values, "values", (None, None, None), dtype=None)
        affine = _arrays.numbers(self.affine, "affine", (4, 4))
        spacing = np.linalg.norm(affine[:3, :3], axis=0)
        if not np.isfinite(affine).all() or not spacing.all():
            raise InvalidArgument("affine must be finite and have no column of zeros.")
        image = vtkImageData()
        image.SetDimensions(values.shape)
        image.SetOrigin(affine[:3, 3])
        image.SetSpacing(spacing)
        image.SetDirectionMatrix((affine[:3, :3] / spacing).ravel())
        voxels = values.astype(np.uint8) if values.dtype == bool else values
        scalars = numpy_to_vtk(voxels.ravel(order="F"), deep=1)
        scalars.SetName("Values")
        image.GetPointData().SetScalars(scalars)
        _arrays.add_fields(image, self.fields)
        return image

    def __repr__(self) -> str:
        return f"Volume({' x '.join(map(str, np.shape(self.values)))} voxels, {np.asarray(self.values).dtype})"


class Samples(NamedTuple):
    """values (n,), NaN = n/a; coverage (n,), the fraction of samples that were valid."""
    values: np.ndarray
    coverage: np.ndarray


def read_volume(path: Path, frame: int = 0, transform: str = "automatic") -> Volume:
    """Reads a NIfTI (.nii, .nii.gz, .hdr/.img) or MGH (.mgh, .mgz) volume.

    frame      of a file of more than three dimensions, from 0; fields["Frames"] counts them
    transform  of a NIfTI file: "sform", "qform", or "automatic": the sform if its code is above 0, else the qform;
               fields["TransformDisagreement"] is how many mm apart they put the farthest corner, where they differ

    Whole numbers stay int, else float with slope and intercept applied. fields["CoordinateSpace"] is
    "scanner-ras", or "unknown" when the file does not orient itself. Raises FormatError.
    """
    reader = _classes.vtkVolumeFileReader()
    reader.SetFileName(os.fspath(path))
    _filters.configure(reader, frame=frame, transform=transform)
    _filters.warn(_filters.run(reader)[1])
    return Volume.from_vtk(reader.GetOutput())


def write_volume(path: Path, volume: Any) -> list[str]:
    """Writes a volume as NIfTI-1 (.nii, .nii.gz) or MGH (.mgh, .mgz), whole or not at all.

    volume  Volume or vtkImageData, scanner RAS mm; one that says that its space is unknown is refused

    Values get the narrowest type that gives each back exactly (fields["StoredType"] when that does). Returns what the
    format had no room for, one sentence each. Raises FormatError, InvalidArgument.
    """
    return write_with(_classes.vtkVolumeFileWriter(), path, _image(volume))


def _image(volume: Any) -> Any:
    if isinstance(volume, (str, os.PathLike)):
        volume = _only_what_is_clear(read_volume(volume), os.fspath(volume))
    if hasattr(volume, "to_vtk"):
        return volume.to_vtk()
    if hasattr(volume, "GetDirectionMatrix"):
        return volume
    raise InvalidArgument("A volume is needed: a Volume, a vtkImageData, or the path of a file.")


def _only_what_is_clear(volume, path):
    apart = volume.fields.get("TransformDisagreement", 0.0)
    if apart > 0.5 * np.linalg.norm(volume.affine[:3, :3], axis=0).min():
        raise InvalidArgument(f"{path}: one place is required, but the sform and the qform put voxels up to {apart:g} "
                              "mm apart, over half a voxel; read it first with transform='sform' or transform='qform'.")
    if volume.fields.get("Frames", 1) > 1:
        raise InvalidArgument(f"{path}: a volume of one frame is required, but it has {volume.fields['Frames']}; "
                              "read it first with frame=...")
    return volume


def sample_volume(surface: Any,
                  volume: Any,
                  mode: str = "at-vertex",
                  *,
                  depths: Optional[tuple[float, float, float]] = None,
                  other: Any = None,
                  fractions: Optional[tuple[float, float, float]] = None,
                  reducer: Optional[str] = None,
                  interpolation: Optional[str] = None,
                  skip_zero: Optional[bool] = None,
                  threads: int = 0,
                  progress: Progress = None) -> Samples:
    """Reads a volume at, below, or between surfaces: one number per vertex.

    surface        Surface, SurfaceMap (its surface is sampled, not its image) or vtkPolyData; scanner RAS mm
    volume         Volume, vtkImageData, or the path of a file
    mode           "at-vertex", "along-normal" or "between-surfaces"
    depths         along-normal: (from, to, step) in mm, inward positive
    other          between-surfaces: the other surface, same vertices in the same order
    fractions      between-surfaces: (from, to, step), 0 = the surface, 1 = the other
    reducer        "mean", "median", "maximum", "minimum", "mode"
    interpolation  "trilinear" or "nearest"
    skip_zero      a sample of exactly 0 counts as n/a

    None = the default of vtkSampleVolumeOnSurface. A vertex without a valid sample is NaN, never 0. A surface or
    volume that says that its space is unknown is refused.
    Raises SurfaceError, InvalidArgument, FormatError, Cancelled.
    """
    sampler = _classes.vtkSampleVolumeOnSurface()
    _filters.configure(sampler, mode=mode, reducer=reducer, interpolation=interpolation, skip_zero=skip_zero,
                       threads=threads)
    for name, steps in (("depth", depths), ("fraction", fractions)):
        if steps is not None:
            first, last, step = _arrays.numbers(steps, name + "s", (3,)).tolist()
            _filters.configure(sampler, **{name + "_from": first, name + "_to": last, name + "_step": step})
    sampler.SetArrayName("Sample")
    _meet(sampler, surface, volume)
    if other is not None:
        sampler.SetInputData(2, to_polydata(other))
    _filters.warn(_filters.run(sampler, progress)[1])
    arrays = _arrays.arrays_of(sampler.GetOutput().GetPointData())
    return Samples(arrays["Sample"], arrays["SampleCoverage"])


def _meet(algorithm, surface, volume):
    mesh, image = to_polydata(surface), _image(volume)
    require_space(surface=mesh, volume=image)
    algorithm.SetInputData(0, mesh)
    algorithm.SetInputData(1, image)


def labels_on_surface(surface: Any, labels: Any, max_distance: Optional[float] = None) -> np.ndarray:
    """The nearest labelled voxel of each vertex, (n,) int; 0 where there is none within max_distance (mm).

    surface  Surface, SurfaceMap or vtkPolyData; labels  Volume, vtkImageData, or the path of a file; scanner RAS mm
    Raises SurfaceError, InvalidArgument, FormatError.
    """
    filter_ = _classes.vtkLabelsOnSurface()
    _filters.configure(filter_, max_distance=max_distance)
    _meet(filter_, surface, labels)
    _filters.warn(_filters.run(filter_)[1])
    return _arrays.arrays_of(filter_.GetOutput().GetPointData())["Label"]


def cortical_surfaces(t1: Any, labels: Any = None, *, progress: Progress = None, threads: int = 0,
                      **options: Any) -> dict[str, Surface]:
    """From a T1 volume to one closed genus-0 white surface per hemisphere: {"left": Surface, "right": Surface}.

    t1       Volume, vtkImageData, or the path of a file; skull-stripped unless labels are given
    labels   region labels on any grid, see label_convention
    options  of vtkCorticalSurface: label_convention ("aal", "free-surfer"), threshold, target_faces,
             smoothing_iterations ...

    point_arrays["MedialWall"] marks what cut_to_disk removes. Doubts (an implausible area) are AuthalicWarnings.
    Raises SurfaceError, InvalidArgument, FormatError, Cancelled.
    """
    extraction = _classes.vtkCorticalSurface()
    _filters.configure(extraction, threads=threads, **options)
    extraction.SetInputData(0, _image(t1))
    if labels is not None:
        extraction.SetInputData(1, _image(labels))
    _filters.warn(_filters.run(extraction, progress)[1])
    return {side: Surface.from_vtk(extraction.GetOutput(port)) for port, side in enumerate(("left", "right"))}
