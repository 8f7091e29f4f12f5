#!/usr/bin/python3
"""The manners of a VTK filter, asked of every class of the package: a class without a line in the table below
fails."""
import dataclasses
import gc
import json
import pathlib
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import (vtkImageAlgorithm, vtkPolyDataAlgorithm, vtkTableAlgorithm,
                                                vtkTrivialProducer)
from vtkmodules.vtkIOCore import vtkWriter

import authalic

DATA = pathlib.Path(__file__).parents[2] / "data"
HERE = tempfile.TemporaryDirectory()
GENERAL = {
    name
    for base in (vtkPolyDataAlgorithm, vtkTableAlgorithm, vtkImageAlgorithm, vtkWriter) for name in dir(base)
}


def disk():
    surface = authalic.read_surface(DATA / "bumpy_disk.off")
    return with_arrays(surface).to_vtk()


def tube():
    return with_arrays(authalic.read_surface(DATA / "bent_tube.off")).to_vtk()


def ball():
    surface = authalic.read_surface(DATA / "folded_sphere.off")
    return with_arrays(surface, {"MedialWall": (surface.points[:, 2] < -20).astype(np.uint8)}).to_vtk()


def ring():
    return with_arrays(authalic.read_surface(DATA / "torus.off")).to_vtk()


def broken_ring():
    """The torus with a face twice and a hole."""
    surface = authalic.read_surface(DATA / "torus.off")
    faces = np.concatenate([surface.faces[1:], surface.faces[5:6]])
    return with_arrays(authalic.Surface(surface.points, faces)).to_vtk()


def soup():
    """Triangles that do not meet."""
    points = np.arange(9 * 9).reshape(27, 3) ** 2 % 31
    return authalic.Surface(points, np.arange(27).reshape(9, 3)).to_vtk()


def two_rings():
    return with_arrays(authalic.read_surface(DATA / "double_torus.off")).to_vtk()


def with_arrays(surface, more=None):
    n, m = len(surface.points), len(surface.faces)
    return dataclasses.replace(surface, point_arrays={"Kept": np.arange(n) * 0.5, **(more or {})},
                               face_arrays={"KeptCells": np.arange(m)}, fields={"KeptField": "words"})


def the_map():
    result = authalic.flatten(authalic.Surface.from_vtk(disk()), method="mean-value")
    return result.with_point_arrays(
        {"Sampled": result.points[:, 2], "SampledCoverage": np.ones(len(result.points))}).to_vtk()


def shell(side):
    return lambda: authalic.flatten(authalic.read_surface(DATA / f"{side}_shell.off"), method="harmonic").to_vtk()


def grid():
    elements = authalic.vtkElementGrid()
    elements.SetInputData(the_map())
    elements.SetNumberOfElements(16)
    elements.Update()
    return elements.GetOutput()


def volume():
    return authalic.Volume(np.arange(20**3).reshape(20, 20, 20) % 7 + 1.0,
                           np.diag([8.0, 8, 8, 1]) + np.outer([1, 1, 1, 0], [0, 0, 0, -76])).to_vtk()


def t1():
    return authalic.read_volume(DATA / "phantom_t1.nii.gz").to_vtk()


def file_named(name):
    path = pathlib.Path(HERE.name, name)
    if not path.exists():
        path.write_text("\n".join(map(str, np.arange(1261) * 0.5)) + "\n", encoding="utf-8")
    return str(path)


@dataclasses.dataclass
class Case:
    """How a class is used, and misused."""
    inputs: tuple = ()  # what makes the data of each port
    settings: dict = dataclasses.field(default_factory=dict)
    wrong: tuple = (0, vtkPolyData)  # (port, what makes data that must be refused)
    adders: dict = dataclasses.field(default_factory=dict)  # arguments of every Add… method
    keeps_vertices: bool = True  # whether arrays of input 0 are on output 0 as they are
    stops: bool = True  # whether it looks at the abort flag at least once
    writer: bool = False


CORNER = {"AddPolygonCorner": (1.0, 2.0)}
CASES = {
    "vtkBarycentricMap": Case((disk,), wrong=(0, ball), adders=CORNER),
    "vtkDiscreteLieFlow": Case((disk,), wrong=(0, ball), adders=CORNER),
    "vtkLieAdvection": Case((disk,), {"NumberOfSteps": 5}, wrong=(0, ball), adders=CORNER),
    "vtkStretchEnergyMap": Case((disk,), wrong=(0, ball), adders=CORNER),
    "vtkStretchMinimisation": Case((disk,), wrong=(0, ball), adders=CORNER),
    "vtkSphericalLieFlow": Case((ball,), wrong=(0, disk)),
    "vtkCircleDomainLieFlow": Case((tube,), wrong=(0, ball), adders={"AddHoleArea": (150.0,)}),
    "vtkSphericalLieAdvection": Case((ball,), {"NumberOfSteps": 5}, wrong=(0, disk)),
    "vtkOptimalTransportMap": Case((disk,), wrong=(0, ball), adders=CORNER),
    "vtkSphericalTransportMap": Case((ball,), wrong=(0, disk)),
    "vtkBalanceCurve": Case((disk,), {"NumberOfBalances": 2}, wrong=(0, tube), keeps_vertices=False,
                            adders={"AddBalance": (0.5,)}),
    "vtkAuthalicMap": Case((disk,), wrong=(0, ball), adders=CORNER),
    "vtkSphericalAuthalicMap": Case((ball,), wrong=(0, disk)),
    "vtkToroidalAuthalicMap": Case((ring,), wrong=(0, ball), keeps_vertices=False),
    "vtkFlatConeAuthalicMap": Case((two_rings,), wrong=(0, ring), keeps_vertices=False),
    "vtkRiemannMap": Case((disk,), wrong=(0, ball)),
    "vtkYamabeMap": Case((disk,), wrong=(0, ball)),
    "vtkLeastSquaresConformalMap": Case((disk,), wrong=(0, ball)),
    "vtkSymmetricDirichletMap": Case((disk,), wrong=(0, ball)),
    "vtkAnnulusMap": Case((tube,), wrong=(0, ball)),
    "vtkCircleDomainMap": Case((tube,), wrong=(0, ball)),
    "vtkSphericalConformalMap": Case((ball,), wrong=(0, disk)),
    "vtkConformalWelding": Case((shell("upper"), shell("lower")), wrong=(0, disk), keeps_vertices=False),
    "vtkCircleDomainAuthalicMap": Case((tube,), {"Domain": 1, "Tolerance": 0.05}, wrong=(0, ball),
                                       adders={"AddHoleArea": (150.0,)}),
    "vtkPolyAnnulusTransportMap": Case((tube,), wrong=(0, ball), adders={"AddHoleArea": (150.0,)}),
    "vtkMapDistortion": Case((the_map,), stops=False),
    "vtkSurfaceTopologyReport": Case((ball,), stops=False),
    "vtkRegionDensity": Case((disk,), {"RegionMode": 1, "Radius": 25.0, "Blend": 5.0}, stops=False,
                             adders={"AddRegionValue": (3.5,), "AddRegionName": ("one",)}),
    "vtkCurvatureDensity": Case((ball,), stops=False),
    "vtkSurfaceRepair": Case((broken_ring,), wrong=(0, soup), keeps_vertices=False),
    "vtkCutToDisk": Case((ball,), adders={"AddRegionValue": (3,)}, keeps_vertices=False),
    "vtkSampleVolumeOnSurface": Case((disk, volume), wrong=(1, vtkImageData)),
    "vtkLabelsOnSurface": Case((disk, volume), wrong=(1, vtkImageData)),
    "vtkElementGrid": Case((the_map,), wrong=(0, disk)),
    "vtkElementStatistics": Case((grid,), wrong=(0, the_map), keeps_vertices=False,
                                 adders={"AddFieldArray": ("Kept",), "AddRegion": (1, "one")}),
    "vtkCorticalSurface": Case((t1,), {"TargetFaces": 3000}, wrong=(0, vtkImageData), keeps_vertices=False),
    "vtkSurfaceFileReader": Case((), {"FileName": str(DATA / "torus.off")}, wrong=None, stops=False,
                                 keeps_vertices=False),
    "vtkVolumeFileReader": Case((), {"FileName": str(DATA / "phantom_t1.nii.gz")}, wrong=None, stops=False,
                                keeps_vertices=False),
    "vtkVertexDataReader": Case((disk,), {"FileName": file_named("height.txt")}, wrong=(0, ball), stops=False),
    "vtkSurfaceFileWriter": Case((disk,), {"FileName": str(pathlib.Path(HERE.name, "out.vtp"))}, stops=False,
                                 keeps_vertices=False, writer=True),
    "vtkVolumeFileWriter": Case((volume,), {"FileName": str(pathlib.Path(HERE.name, "out.nii"))},
                                wrong=(0, vtkImageData), stops=False, keeps_vertices=False, writer=True),
    "vtkVertexDataWriter": Case((disk,), {"FileName": str(pathlib.Path(HERE.name, "out.txt"))}, stops=False,
                                keeps_vertices=False, adders={"AddArrayName": ("Kept",)}, writer=True),
}


def concrete_classes():
    for name in authalic.__all__:
        if name.startswith("vtk"):
            try:
                getattr(authalic, name)()
            except (TypeError, NotImplementedError):
                continue
            yield name


def made(name):
    """(filter, its inputs), ready to run."""
    case, algorithm = CASES[name], getattr(authalic, name)()
    inputs = [make() for make in case.inputs]
    for port, data in enumerate(inputs):
        algorithm.SetInputDataObject(port, data)
    for key, value in case.settings.items():
        getattr(algorithm, "Set" + key)(value)
    algorithm.AddObserver("WarningEvent", lambda *_: None)  # kept from the console
    return algorithm, inputs


def update(algorithm):
    algorithm.Write() if algorithm.IsA("vtkWriter") else algorithm.Update()


def outputs(algorithm):
    return [] if algorithm.IsA("vtkWriter") else [algorithm.GetOutputDataObject(k)
                                                   for k in range(algorithm.GetNumberOfOutputPorts())]


def contents(data):
    """Everything in a data object, in full."""
    found = {}
    attributes = [("field", data.GetFieldData())]
    if data.IsA("vtkDataSet"):
        attributes += [("point", data.GetPointData()), ("cell", data.GetCellData())]
    if data.IsA("vtkTable"):
        attributes.append(("row", data.GetRowData()))
    if data.IsA("vtkPolyData") and data.GetNumberOfPoints():
        found["points"] = vtk_to_numpy(data.GetPoints().GetData()).tobytes()
        for kind in ("Polys", "Lines"):
            cells = getattr(data, "Get" + kind)()
            if cells.GetNumberOfCells():
                found[kind] = vtk_to_numpy(cells.GetConnectivityArray()).tobytes()
    if data.IsA("vtkImageData"):
        found["grid"] = data.GetDimensions(), data.GetOrigin(), data.GetSpacing()
    for kind, arrays in attributes:
        for k in range(arrays.GetNumberOfArrays()):
            array = arrays.GetAbstractArray(k)
            values = (vtk_to_numpy(array).tobytes() if array.IsA("vtkDataArray") else
                      tuple(array.GetValue(i) for i in range(array.GetNumberOfValues())))
            found[kind, array.GetName()] = array.GetDataTypeAsString(), array.GetNumberOfComponents(), values
    return found


def result(algorithm):
    return [contents(output) for output in outputs(algorithm)]


def is_empty(data):
    rows = data.GetNumberOfRows() if data.IsA("vtkTable") else data.GetNumberOfPoints()
    return rows == 0 and (not data.IsA("vtkPolyData") or data.GetNumberOfCells() == 0)


def own(algorithm, start):
    """Names of methods of our classes that start so, without that start."""
    return [name[len(start):] for name in dir(algorithm) if name.startswith(start) and name not in GENERAL]


def properties(algorithm):
    """Everything that can be set and read back."""
    return [name for name in own(algorithm, "Set") if hasattr(algorithm, "Get" + name)]


def another(algorithm, name, value):
    """A valid value of a property other than `value`."""
    if isinstance(value, tuple):
        return tuple(x + 1 for x in value)
    if value is None or isinstance(value, str):
        return (value or "") + "x"
    if isinstance(value, bool):
        return not value
    if hasattr(algorithm, f"Get{name}MaxValue"):
        low, high = getattr(algorithm, f"Get{name}MinValue")(), getattr(algorithm, f"Get{name}MaxValue")()
        return low if value != low else min(high, type(value)(value + 1))
    return value + 1


class Heard:
    """Events of an algorithm, kept from the console."""

    def __init__(self, algorithm):
        self.starts = self.errors = 0
        algorithm.AddObserver("StartEvent", self.start)
        algorithm.AddObserver("ErrorEvent", self.error)
        algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)

    def start(self, *_):
        self.starts += 1

    def error(self, *_):
        self.errors += 1


def each(wanted=lambda case: True):
    """A decorator: the test once for every line of the table that is wanted, as (self, name, case)."""
    def decorate(test):
        def run(self):
            for name, case in CASES.items():
                if wanted(case):
                    with self.subTest(name):
                        test(self, name, case)
        run.__name__ = test.__name__
        return run
    return decorate


def is_filter(case):
    return not case.writer


def is_map(case):
    """Whether its class is a map of a surface."""
    name = next(name for name, other in CASES.items() if other is case)
    return getattr(authalic, name)().IsA("vtkSurfaceMapAlgorithm")


def has_inputs(case):
    return bool(case.inputs) and not case.writer


class Manners(unittest.TestCase):
    def test_every_class_is_in_the_table(self):
        self.assertEqual(set(concrete_classes()), set(CASES))

    @each(lambda case: case.keeps_vertices)
    def test_arrays_and_fields_pass_through(self, name, case):
        algorithm, inputs = made(name)
        update(algorithm)
        before, after = contents(inputs[0]), contents(outputs(algorithm)[0])
        for key in (("point", "Kept"), ("cell", "KeptCells"), ("field", "KeptField")):
            self.assertEqual(before[key], after.get(key), key)

    @each(lambda case: case.inputs)
    def test_inputs_are_never_modified(self, name, case):
        algorithm, inputs = made(name)
        before = [(contents(data), data.GetMTime()) for data in inputs]
        update(algorithm)
        self.assertEqual([(contents(data), data.GetMTime()) for data in inputs], before)

    @each(is_filter)
    def test_runs_again_when_something_changed_and_only_then(self, name, case):
        algorithm, inputs = made(name)
        heard = Heard(algorithm)
        update(algorithm)
        first = result(algorithm)
        update(algorithm)
        self.assertEqual(heard.starts, 1)
        algorithm.Modified()
        update(algorithm)
        self.assertEqual(heard.starts, 2)
        for k, data in enumerate(inputs):
            data.Modified()
            update(algorithm)
            self.assertEqual(heard.starts, 3 + k)
        self.assertEqual(result(algorithm), first)

    @each(has_inputs)
    def test_follows_a_filter_before_it(self, name, case):
        algorithm, inputs = made(name)
        before = vtkTrivialProducer()
        before.SetOutput(inputs[0])
        algorithm.SetInputConnection(0, before.GetOutputPort())
        heard = Heard(algorithm)
        update(algorithm)
        update(algorithm)
        self.assertEqual(heard.starts, 1)
        inputs[0].Modified()
        update(algorithm)
        self.assertEqual(heard.starts, 2)

    @each()
    def test_a_property_that_changes_is_seen_and_printed(self, name, case):
        for key in properties(getattr(authalic, name)()):
            algorithm = getattr(authalic, name)()
            value = getattr(algorithm, "Get" + key)()
            with self.subTest(f"{name}.{key}"):
                printed, time = str(algorithm), algorithm.GetMTime()
                getattr(algorithm, "Set" + key)(value)
                self.assertEqual(algorithm.GetMTime(), time)
                other = another(algorithm, key, value)
                getattr(algorithm, "Set" + key)(other)
                self.assertEqual(getattr(algorithm, "Get" + key)(), other)
                self.assertGreater(algorithm.GetMTime(), time)
                unlike = [line for line in str(algorithm).splitlines() if line not in printed.splitlines()]
                self.assertTrue([line for line in unlike if "Modified Time" not in line and "(0x" not in line],
                                f"PrintSelf does not show {key}")

    @each()
    def test_lists_grow_are_seen_printed_and_cleared(self, name, case):
        algorithm = getattr(authalic, name)()
        self.assertEqual({"Add" + key for key in own(algorithm, "Add")}, set(case.adders))
        for key, arguments in case.adders.items():
            printed, time = str(algorithm), algorithm.GetMTime()
            getattr(algorithm, key)(*arguments)
            self.assertGreater(algorithm.GetMTime(), time)
            self.assertNotEqual([line for line in str(algorithm).splitlines() if "Modified" not in line],
                                [line for line in printed.splitlines() if "Modified" not in line], key)
            time = algorithm.GetMTime()
            getattr(algorithm, f"Clear{key[3:]}s")()
            self.assertGreater(algorithm.GetMTime(), time)

    @each()
    def test_words_of_an_enumeration_set_its_values(self, name, case):
        algorithm = getattr(authalic, name)()
        for key in (key for key in properties(algorithm) if own(algorithm, f"Set{key}To")):
            values = set()
            for word in own(algorithm, f"Set{key}To"):
                getattr(algorithm, f"Set{key}To{word}")()
                values.add(getattr(algorithm, "Get" + key)())
            self.assertEqual(values, set(range(getattr(algorithm, f"Get{key}MaxValue")() + 1)), key)

    @each(lambda case: case.wrong is not None)
    def test_an_error_empties_the_output_sets_the_kind_and_is_overcome(self, name, case):
        algorithm, inputs = made(name)
        heard = Heard(algorithm)
        expected = None
        if not algorithm.IsA("vtkWriter"):
            update(algorithm)
            expected = result(algorithm)
        port, make = case.wrong
        algorithm.SetInputDataObject(port, make())
        update(algorithm)
        self.assertGreater(heard.errors, 0)
        self.assertIn(algorithm.GetErrorKind(), (2, 3, 5))
        self.assertTrue(all(map(is_empty, outputs(algorithm))))
        if hasattr(algorithm, "GetReport"):
            self.assertEqual(algorithm.GetReport(), "")
        algorithm.SetInputDataObject(port, inputs[port])
        update(algorithm)
        self.assertEqual(algorithm.GetErrorKind(), 0)
        if expected is not None:
            self.assertEqual(result(algorithm), expected)

    @each(lambda case: "FileName" in case.settings)
    def test_a_missing_file_is_an_error_and_is_overcome(self, name, case):
        algorithm, inputs = made(name)
        heard = Heard(algorithm)
        algorithm.SetFileName(str(pathlib.Path(HERE.name, "no", "such.off")))
        update(algorithm)
        self.assertEqual((algorithm.GetErrorKind(), heard.errors > 0), (5, True))
        self.assertTrue(all(map(is_empty, outputs(algorithm))))
        algorithm.SetFileName(None)
        update(algorithm)
        self.assertEqual(algorithm.GetErrorKind(), 2)
        algorithm.SetFileName(case.settings["FileName"])
        if name == "vtkVertexDataWriter":
            algorithm.AddArrayName("Kept")
        update(algorithm)
        self.assertEqual(algorithm.GetErrorKind(), 0)

    @each(is_filter)
    def test_abort_is_honoured_and_leaves_a_clean_state(self, name, case):
        algorithm, inputs = made(name)
        expected = made(name)[0]
        update(expected)
        heard = Heard(algorithm)
        tag = algorithm.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
        update(algorithm)
        self.assertEqual(heard.errors, 0)
        self.assertEqual(algorithm.GetErrorKind(), 130 if case.stops else 0)
        algorithm.RemoveObserver(tag)
        algorithm.Modified()
        update(algorithm)
        self.assertEqual(algorithm.GetErrorKind(), expected.GetErrorKind())
        self.assertEqual(result(algorithm), result(expected))

    @each(is_map)
    def test_a_map_can_be_texture_coordinates_of_its_surface(self, name, case):
        algorithm, inputs = made(name)
        update(algorithm)
        image = authalic.SurfaceMap.from_filter(algorithm).image
        before, report = contents(outputs(algorithm)[0]), json.loads(algorithm.GetReport())
        algorithm.SetOutputModeToTextureCoordinates()
        update(algorithm)
        textured = outputs(algorithm)[0]
        after = contents(textured)
        if case.keeps_vertices:
            self.assertEqual(after["points"], contents(inputs[0])["points"])
        self.assertEqual(set(before) - set(after), {("point", "OriginalPoints")})
        self.assertEqual(set(after) - set(before), {("point", "TCoords")})
        self.assertEqual({key: after[key] for key in set(before) & set(after) - {"points"}},
                         {key: before[key] for key in set(before) & set(after) - {"points"}})
        places = textured.GetPointData().GetTCoords()
        self.assertEqual((places.GetName(), places.GetDataTypeAsString()), ("TCoords", "float"))
        scaled = (image - image.min(axis=0)) / (image.max(axis=0) - image.min(axis=0)).max()
        self.assertLess(np.abs(vtk_to_numpy(places) - scaled).max(), 1e-6)
        again = json.loads(algorithm.GetReport())
        self.assertEqual({**again, "seconds": 0}, {**report, "seconds": 0})
        with self.assertRaises(authalic.InvalidArgument):
            authalic.SurfaceMap.from_filter(algorithm)

    @each(is_map)
    def test_a_map_comes_with_the_statistics_of_every_map(self, name, case):
        algorithm, _ = made(name)
        update(algorithm)
        cells, report = outputs(algorithm)[0].GetCellData(), json.loads(algorithm.GetReport())
        moduli = np.linalg.norm(vtk_to_numpy(cells.GetArray("BeltramiCoefficient")), axis=1)
        self.assertAlmostEqual(report["metrics"]["beltrami_mean"], np.nanmean(np.minimum(moduli, 1 / moduli)), 9)
        self.assertAlmostEqual(report["metrics"]["beltrami_p50"], np.nanmedian(np.minimum(moduli, 1 / moduli)), 9)
        corners, counted = 3 * cells.GetNumberOfTuples(), report["histograms"]["angle_error_degrees"]
        self.assertEqual(sum(counted["counts"]) + sum(counted[k] for k in ("below", "above", "undefined")), corners)
        self.assertEqual(len(report["histograms"]), 5)

    @each()
    def test_two_of_a_kind_share_nothing(self, name, case):
        (one, _), (two, _) = made(name), made(name)
        update(two)
        before = result(two)
        for key in properties(one):
            value = getattr(one, "Get" + key)()
            getattr(one, "Set" + key)(another(one, key, value))
        two.Modified()
        update(two)
        self.assertEqual(result(two), before)

    @each()
    def test_nothing_is_left_when_filter_and_output_are_gone(self, name, case):
        algorithm, inputs = made(name)
        update(algorithm)
        gone = []
        for data in [algorithm, *outputs(algorithm)]:
            data.AddObserver("DeleteEvent", lambda *_: gone.append(1))
        expected = len(outputs(algorithm)) + 1
        counts = [data.GetReferenceCount() for data in inputs]
        data = None
        del algorithm
        gc.collect()
        self.assertEqual(len(gone), expected)
        for data, count in zip(inputs, counts):
            self.assertLess(data.GetReferenceCount(), count)
            self.assertEqual(data.GetReferenceCount(), 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
