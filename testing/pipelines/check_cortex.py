#!/usr/bin/python3
"""Runs the main job on the 1 mm volume and examines everything that it leaves; then again on one thread: same bytes."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

try:
    import nibabel
except ImportError:
    nibabel = None

JOB = pathlib.Path(__file__).resolve().parents[2] / "pipelines/cortex/cortex.py"
TEMPLATES = pathlib.Path("/usr/share/mricron/templates")
SIDES = ("lh", "rh")
FIELDS = ("sulcal_depth", "t1", "t1_cortex", "t1_inward")
PICTURES = ("cortex", "flatmap", "checkerboard", "distortion", "histograms", "field")


def run(out, *more):
    return subprocess.run([sys.executable, str(JOB), "--fast", "--out", str(out), *more], capture_output=True,
                          text=True, timeout=900)


def table(path):
    """{column: [text]} of a TSV file."""
    rows = [line.split("\t") for line in path.read_text(encoding="utf-8").splitlines()]
    return dict(zip(rows[0], zip(*rows[1:])))


def numbers(column):
    return np.array([np.nan if text == "n/a" else float(text) for text in column])


def polydata(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


class FastJob(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.temporary.name) / "first"
        cls.again = pathlib.Path(cls.temporary.name) / "again"
        cls.result = run(cls.out)
        print(cls.result.stderr, file=sys.stderr)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_ends_with_the_path_of_the_page(self):
        self.assertEqual(self.result.returncode, 0)
        self.assertEqual(self.result.stdout.strip(), str(self.out / "index.html"))

    def test_shows_its_progress(self):
        self.assertRegex(self.result.stderr, r"\[ *1/\d+\]")
        self.assertRegex(self.result.stderr, r"peak memory [\d.]+ GiB")
        self.assertNotIn("Traceback", self.result.stderr)
        last = re.findall(r"\[ *(\d+)/(\d+)\]", self.result.stderr)[-1]
        self.assertEqual(last[0], last[1], "the number of stages is announced right")

    def test_leaves_every_file(self):
        names = ["white.surf.gii", "white.vtp", "flat.surf.gii", "map.vtp", "elements.tsv", "elements.json",
                 "elements_initial.tsv", "elements_initial.json", "regions.tsv", "regions.json", "elements.label.gii",
                 "regions.label.gii", "report.json", *(f"{name}.func.gii" for name in FIELDS)]
        for side in SIDES:
            for name in names:
                self.assertTrue((self.out / side / name).is_file(), f"{side}/{name}")
        self.assertEqual([], [str(p) for p in self.out.rglob("*.partial*")])

    def test_white_surface_is_a_sphere_and_the_map_does_not_flip(self):
        for side in SIDES:
            report = json.loads((self.out / side / "report.json").read_text())
            self.assertEqual(report["white"]["Genus"], 0)
            self.assertEqual(report["white"]["EulerCharacteristic"], 2)
            self.assertEqual(report["area_preserving"]["FlippedFaces"], 0)
            self.assertEqual(report["area_preserving"]["Status"], "converged")
            self.assertLess(report["area_preserving"]["TotalAreaDistortion"], 2 + 1e-4)
            self.assertLess(report["area_preserving"]["VertexMaxAbsLog"], 1e-9)
            self.assertGreater(report["initial"]["TotalAreaDistortion"],
                               report["area_preserving"]["TotalAreaDistortion"])

    def test_map_lies_in_the_unit_disk_and_keeps_its_vertices(self):
        for side in SIDES:
            map_, white = polydata(self.out / side / "map.vtp"), polydata(self.out / side / "white.vtp")
            points = vtk_to_numpy(map_.GetPoints().GetData())
            self.assertEqual(points.dtype, np.float64)
            self.assertLess(np.hypot(points[:, 0], points[:, 1]).max(), 1 + 1e-9)
            self.assertEqual(np.abs(points[:, 2]).max(), 0)
            data = map_.GetPointData()
            ids = vtk_to_numpy(data.GetArray("OriginalPointIds"))
            native = vtk_to_numpy(data.GetArray("OriginalPoints"))
            np.testing.assert_array_equal(native, vtk_to_numpy(white.GetPoints().GetData())[ids])
            for name in ("AreaDistortion", "AngleDistortion", "Flipped"):
                self.assertIsNotNone(map_.GetCellData().GetArray(name), name)

    def test_elements_have_equal_areas_that_add_up_to_the_cortex(self):
        for side in SIDES:
            kept = json.loads((self.out / side / "report.json").read_text())["cut"]["KeptArea"]
            deviation = {}
            for name in ("elements", "elements_initial"):
                columns = table(self.out / side / f"{name}.tsv")
                area, inside = numbers(columns["area_mm2"]), np.array(columns["interior"]) == "1"
                self.assertAlmostEqual(area.sum() / kept, 1, places=6)
                deviation[name] = np.abs(numbers(columns["area_ratio"])[inside] - 1).max()
            self.assertLess(deviation["elements"], 1e-3)
            self.assertGreater(deviation["elements_initial"], 0.2)

    def test_tables_have_their_columns_and_the_sidecars_describe_them(self):
        for side in SIDES:
            for name, key in (("elements", "element_id"), ("regions", "label_id")):
                columns = table(self.out / side / f"{name}.tsv")
                sidecar = json.loads((self.out / side / f"{name}.json").read_text())
                self.assertIn(key, columns)
                for field in FIELDS:
                    for statistic in ("n", "mean", "sd", "median", "min", "max", "coverage"):
                        self.assertIn(f"{field}_{statistic}", columns)
                self.assertEqual([], [column for column in columns if column not in sidecar])

    def test_statistics_are_within_the_range_of_the_field(self):
        for side in SIDES:
            columns = table(self.out / side / "elements.tsv")
            low, mean, high = (numbers(columns[f"t1_cortex_{k}"]) for k in ("min", "mean", "max"))
            self.assertTrue(((low <= mean) & (mean <= high)).all())
            self.assertTrue((low > 0).all() and (high < 256).all())

    def test_regions_are_named_and_lie_on_their_side(self):
        for side in SIDES:
            columns = table(self.out / side / "regions.tsv")
            names, area = np.array(columns["label_name"]), numbers(columns["area_mm2"])
            own = np.array([name.endswith(f"_{side[0].upper()}") for name in names])
            self.assertGreater(area[own].sum() / area.sum(), 0.98)
            self.assertIn(f"Precentral_{side[0].upper()}", names)

    @unittest.skipIf(nibabel is None, "nibabel is not installed")
    def test_nibabel_opens_every_gifti_file(self):
        for side in SIDES:
            white = nibabel.load(self.out / side / "white.surf.gii").agg_data()
            flat = nibabel.load(self.out / side / "flat.surf.gii").agg_data()
            self.assertEqual(white[0].shape, flat[0].shape)
            self.assertGreater(len(white[1]), len(flat[1]))
            self.assertEqual(np.abs(flat[0][:, 2]).max(), 0)
            for name in (*(f"{field}.func.gii" for field in FIELDS), "elements.label.gii", "regions.label.gii"):
                self.assertEqual(len(nibabel.load(self.out / side / name).agg_data()), len(white[0]), name)

    @unittest.skipIf(nibabel is None, "nibabel is not installed")
    def test_flat_surface_has_the_area_of_the_cortex_and_no_stray_vertices(self):
        for side in SIDES:
            points, faces = nibabel.load(self.out / side / "flat.surf.gii").agg_data()
            corner = points[faces].astype(float)
            area = 0.5 * np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])[:, 2]
            kept = json.loads((self.out / side / "report.json").read_text())["cut"]["KeptArea"]
            self.assertAlmostEqual(area.sum() / kept, 1, places=4)
            parked = np.setdiff1d(np.arange(len(points)), faces)
            radius = np.hypot(points[:, 0], points[:, 1])
            np.testing.assert_allclose(radius[parked], radius.max(), rtol=1e-5)

    def test_pictures_are_not_blank(self):
        for side in SIDES:
            for name in PICTURES:
                reader = vtkPNGReader()
                reader.SetFileName(str(self.out / side / f"{name}.png"))
                reader.Update()
                pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
                inked = (pixels != 255).any(axis=1).mean()
                self.assertTrue(0.03 < inked < 0.97, f"{side}/{name}: {inked}")
                self.assertGreater(len(np.unique(pixels, axis=0)), 50)

    def test_page_holds_everything_and_asks_the_network_for_nothing(self):
        page = (self.out / "index.html").read_text()
        self.assertEqual(page.count("data:image/png;base64,"), len(SIDES) * len(PICTURES))
        self.assertNotRegex(page, r"https?://")
        self.assertIn("Not a medical device", page)

    def test_second_run_on_one_thread_gives_the_same_bytes(self):
        second = run(self.again, "--no-pictures", "--threads", "1")
        self.assertEqual(second.returncode, 0, second.stderr)
        for side in SIDES:
            for path in sorted((self.out / side).iterdir()):
                twin = self.again / side / path.name
                if path.suffix == ".png":
                    continue
                if path.name == "report.json":
                    first, other = (json.loads(p.read_text()) for p in (path, twin))
                    first.pop("seconds"), other.pop("seconds")
                    self.assertEqual(first, other)
                else:
                    self.assertTrue(path.read_bytes() == twin.read_bytes(), f"{side}/{path.name} differs")


if __name__ == "__main__":
    if not (TEMPLATES / "ch2bet.nii.gz").is_file():
        print("mricron-data is not installed")
        sys.exit(77)
    unittest.main(verbosity=2)
