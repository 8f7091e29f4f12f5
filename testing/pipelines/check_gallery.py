#!/usr/bin/python3
"""Every script of the gallery runs on the fixtures and on real data, and leaves what it promises.

    check_gallery.py DATA BUILD [unittest options]     DATA = the folder of real test data, BUILD = the build tree
"""
import base64
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import authalic

ROOT = pathlib.Path(__file__).resolve().parents[2]
GALLERY = ROOT / "pipelines/gallery"
DATA, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SUBJECT = DATA / "cortex/subject1_fs"


def pixels(path):
    """h×w×3 bytes, top row first."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]


def colours_at(picture, uv, v_is_up):
    """The pixel under each texture coordinate."""
    height, width, _ = picture.shape
    column = np.clip((uv[:, 0] * width).astype(int), 0, width - 1)
    row = np.clip((uv[:, 1] * height).astype(int), 0, height - 1)
    return picture[height - 1 - row if v_is_up else row, column]


class Script(unittest.TestCase):
    """Runs a script into a folder of its own: once on the fixtures, once on real data where there are some."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = pathlib.Path(folder.name)

    def run_script(self, name, *options):
        done = subprocess.run(
            [sys.executable, "-W", "ignore",
             str(GALLERY / name), "--out",
             str(self.out), *map(str, options)],
            capture_output=True,
            text=True,
            check=False,
            timeout=240)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def cortex(self):
        """Options for a real hemisphere: its surface and cortex label."""
        if not SUBJECT.is_dir():
            self.skipTest(f"{SUBJECT} is not there")
        return "--surface", SUBJECT / "lh.pialsurface5", "--region", SUBJECT / "lh.cortex5.label", "--keep"

    def has_picture(self, name, charts=0):
        """Panels of 420 pixels with something in them; the last ones are charts, which are mostly white."""
        picture = pixels(self.out / name)
        self.assertGreater(len(np.unique(picture.reshape(-1, 3), axis=0)), 100, name)
        covered = (picture != 255).any(axis=2)
        parts = np.array_split(covered, covered.shape[1] // 420, axis=1)
        for k, part in enumerate(parts):
            self.assertGreater(part.mean(), 0.1 if k < len(parts) - charts else 0.03, "an empty panel")


class FlattenHemisphere(Script):
    def holds(self, *options):
        self.assertIn("flipped faces: 0", self.run_script("flatten_hemisphere.py", *options))
        flat = authalic.read_surface(self.out / "map.vtp")
        self.assertAlmostEqual(np.linalg.norm(flat.points, axis=1).max(), 1.0, 9)
        self.assertLess(np.abs(flat.face_arrays["AreaDistortion"]).mean(), 0.05)
        report = json.loads((self.out / "map.json").read_text(encoding="utf-8"))
        self.assertEqual((report["status"], report["flips"]), ("converged", 0))
        self.has_picture("map.png")

    def test_on_fixtures(self):
        self.holds()

    def test_on_real_data(self):
        self.holds(*self.cortex())

    def test_on_real_data_with_an_annotation(self):
        annotation = DATA / "cortex/fsaverage5_gifti/test.annot"
        if not annotation.exists():
            self.skipTest(f"{annotation} is not there")
        surface = annotation.parent / "pial_left.gii.gz"
        names = authalic.read_vertex_data(annotation, authalic.read_surface(surface), "A").fields["ANames"]
        self.holds("--surface", surface, "--region", annotation, "--values", names[0])


    def test_on_fixtures_failures_are_one_sentence(self):
        disk = ROOT / "data/bumpy_disk.off"
        for options in (("--surface", "none.off"), ("--surface", disk, "--region", "none.label")):
            done = subprocess.run([sys.executable, str(GALLERY / "flatten_hemisphere.py"), "--out", str(self.out),
                                   *map(str, options)], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn("does not exist", done.stderr)


class Pet(Script):
    def holds(self, low, high, *options):
        self.assertIn(" 0 vertices without a value", self.run_script("pet_on_cortex.py", *options))
        header, *rows = (self.out / "pet.tsv").read_text(encoding="utf-8").splitlines()
        table = np.array([row.split("\t") for row in rows], dtype=float)
        means, areas = (table[:, header.split("\t").index(name)] for name in ("pet_mean", "area_mm2"))
        self.assertTrue(low < np.median(means) < high, np.median(means))
        self.assertLess(abs(areas / np.median(areas) - 1)[5:-5].mean(), 0.3)
        self.has_picture("pet.png")

    def test_on_fixtures(self):
        self.holds(100, 112)

    def test_on_real_data(self):
        volume, surface = DATA / "volumes/spm12/PET.nii", DATA / "cortex/conte69_gifti/conte69_32k_lh.gii"
        if not (volume.exists() and surface.exists()):
            self.skipTest(f"{volume} or {surface} is not there")
        self.holds(0.70, 0.80, "--surface", surface, "--space", "scanner-ras", "--volume", volume, "--depths", 0, 2)


class SpaceCheck(Script):
    def holds(self, least, *options):
        printed = self.run_script("space_check.py", *options)
        seen, inside, outside = map(float, re.search(
            r"([\d.]+)% of the vertices lie in the volume; 1.5 mm inside ([\d.]+), outside ([\d.]+)", printed).groups())
        self.assertGreater(seen, 99)
        self.has_picture("space.png")
        return inside / outside > least

    def test_on_fixtures(self):
        self.assertTrue(self.holds(1.2))

    def test_on_real_data(self):
        surface, volume = SUBJECT / "lh.pialsurface6", SUBJECT / "brain.mgz"
        if not volume.exists():
            self.skipTest(f"{volume} is not there")
        self.assertTrue(self.holds(1.5, "--surface", surface, "--volume", volume))
        flipped = self.out / "flipped.ply"  # in the wrong space the two sides are alike
        authalic.write_surface(flipped, authalic.read_surface(surface), space="lps")
        self.assertFalse(self.holds(1.5, "--surface", flipped, "--space", "scanner-ras", "--volume", volume))


class RegionOfInterest(Script):
    def holds(self, *options):
        before, after = re.search(r"([\d.]+)% area-preserving, ([\d.]+)% with",
                                  self.run_script("region_of_interest.py", *options)).groups()
        self.assertGreater(float(after), 2.5 * float(before))
        self.has_picture("region.png")

    def test_on_fixtures(self):
        self.holds()

    def test_on_real_data(self):
        self.holds(*self.cortex())


class CompareMethods(Script):
    def holds(self, *options):
        printed = self.run_script("compare_methods.py", *options)
        self.assertEqual(printed.splitlines()[:3],
                         (self.out / "methods.tsv").read_text(encoding="utf-8").splitlines())
        header, *rows = (line.split("\t") for line in printed.splitlines()[:3])
        found = {row[0]: dict(zip(header[2:], map(float, row[2:]))) for row in rows}
        self.assertLess(found["authalic"]["area_distortion"], found["mean-value"]["area_distortion"])
        self.assertGreater(found["authalic"]["angle_distortion"], found["mean-value"]["angle_distortion"])
        self.has_picture("methods.png")

    def test_on_fixtures(self):
        self.holds()

    def test_on_real_data(self):
        self.holds(*self.cortex())


class ConformalSphere(Script):
    def holds(self, most_degrees, *options):
        printed = self.run_script("conformal_sphere.py", *options)
        self.assertEqual(printed.splitlines()[:3],
                         (self.out / "roads.tsv").read_text(encoding="utf-8").splitlines())
        header, *rows = (line.split("\t") for line in printed.splitlines()[:3])
        for row in rows:
            found = dict(zip(header[2:], map(float, row[2:])))
            self.assertEqual((row[1], found["flipped_faces"]), ("converged", 0))
            self.assertLess(found["angle_error_mean_degrees"], most_degrees)
            self.assertLess(found["angle_error_p50_degrees"], found["angle_error_p95_degrees"])
        sphere = authalic.read_surface(self.out / "sphere.vtp")
        self.assertLess(np.abs(np.linalg.norm(sphere.points, axis=1) - 1).max(), 1e-12)
        self.assertEqual(sphere.face_arrays["BeltramiCoefficient"].shape, (len(sphere.faces), 2))
        self.has_picture("sphere.png", charts=2)

    def test_on_fixtures(self):
        self.holds(1.0)

    def test_on_real_data(self):
        self.holds(4.5, *self.cortex()[:2])


class Balance(Script):
    def holds(self, *options):
        self.run_script("balance.py", "--balances", 5, *options)
        header, *rows = (line.split("\t") for line in
                         (self.out / "curve.tsv").read_text(encoding="utf-8").splitlines())
        angles, areas, folds = (np.array([float(row[header.index(name)]) for row in rows])
                                for name in ("angle_distortion", "area_distortion", "flipped_faces"))
        self.assertTrue((np.diff(angles) > 0).all() and (np.diff(areas) < 0).all() and not folds.any())
        self.assertLess(areas[-1], 2.001)
        self.has_picture("balance.png", charts=1)

    def test_on_fixtures(self):
        self.holds()

    def test_on_real_data(self):
        self.holds(*self.cortex()[:2])


class FlowAgainstTransport(Script):
    def holds(self, *options):
        self.run_script("flow_against_transport.py", *options)
        header, *rows = (line.split("\t") for line in
                         (self.out / "flow.tsv").read_text(encoding="utf-8").splitlines())
        for row in rows:
            found = dict(zip(header, row))
            self.assertEqual((found["flow_status"], found["transport_status"]), ("converged", "converged"))
            self.assertLess(abs(float(found["difference_percent"])), 2)
            self.assertLess(float(found["beltrami_p50"]), 0.4)
        self.has_picture("flow.png", charts=1)

    def test_on_fixtures(self):
        self.holds()

    def test_on_real_data(self):
        lion = DATA / "meshes/open_disk/chinese_lion.off"
        if not lion.exists():
            self.skipTest(f"{lion} is not there")
        self.holds("--disk", lion, "--radius", 8.4261)


class PolarFactorisation(Script):
    def holds(self, *options):
        self.run_script("polar_factorisation.py", *options)
        header, *rows = (line.split("\t") for line in
                         (self.out / "polar.tsv").read_text(encoding="utf-8").splitlines())
        middles, finished = (dict(zip(header, row)) for row in rows)
        self.assertLess(float(middles["log_ratio_max"]), 1e-9)
        self.assertEqual(float(middles["composition_max"]), 0)
        self.assertLess(float(finished["log_ratio_max"]), 1e-9)
        self.assertLess(float(finished["area_distortion"]), 2.001)
        self.assertEqual(finished["flipped_faces"], "0")
        for found in (middles, finished):  # up to the size of cells
            self.assertLess(float(found["cost"]), 1.001 * float(found["cost_of_identity"]))
        self.has_picture("polar.png")

    def test_on_fixtures(self):
        self.holds()
        self.holds("--method", "tutte")

    def test_on_real_data(self):
        lion = DATA / "meshes/open_disk/chinese_lion.off"
        if not lion.exists():
            self.skipTest(f"{lion} is not there")
        self.holds("--disk", lion)


class Checkerboard(Script):
    def read_obj(self):
        """(vertices, texture coordinates per vertex, picture), by the format's own rules."""
        words = [line.split() for line in (self.out / "checkerboard.obj").read_text(encoding="utf-8").splitlines()]
        points, places = (np.array([w[1:] for w in words if w and w[0] == kind], dtype=float) for kind in ("v", "vt"))
        corners = np.array([corner.split("/")[:2] for w in words if w and w[0] == "f" for corner in w[1:]],
                           dtype=int) - 1
        uv = np.full((len(points), 2), np.nan)
        uv[corners[:, 0]] = places[corners[:, 1], :2]
        material, = (w[1] for w in words if w and w[0] == "mtllib")
        picture = re.search(r"map_Kd (\S+)", (self.out / material).read_text(encoding="utf-8")).group(1)
        self.assertEqual(pathlib.Path(picture).name, picture)
        return points, uv, pixels(self.out / picture)

    def read_gltf(self):
        file = json.loads((self.out / "checkerboard.gltf").read_text(encoding="utf-8"))
        raw = [base64.b64decode(buffer["uri"].split(",", 1)[1]) for buffer in file["buffers"]]

        def view(number):
            part = file["bufferViews"][number]
            return raw[part["buffer"]][part.get("byteOffset", 0):][:part["byteLength"]]

        def numbers(number, width):
            return np.frombuffer(view(file["accessors"][number]["bufferView"]), dtype="<f4").reshape(-1, width)

        attributes = file["meshes"][0]["primitives"][0]["attributes"]
        (self.out / "inside.png").write_bytes(view(file["images"][0]["bufferView"]))
        return numbers(attributes["POSITION"], 3), numbers(attributes["TEXCOORD_0"],
                                                           2), pixels(self.out / "inside.png")

    def holds(self, *options):
        self.run_script("checkerboard.py", *options)
        points, uv, picture = self.read_obj()
        self.assertTrue(((uv >= 0) & (uv <= 1)).all())
        other_points, other_uv, other_picture = self.read_gltf()
        self.assertTrue(np.allclose(points, other_points, atol=1e-4))
        seen, other = colours_at(picture, uv, True), colours_at(other_picture, other_uv, False)
        near_edge = (np.abs(uv * 24 - np.round(uv * 24)) < 1e-3).any(axis=1)
        self.assertTrue(np.array_equal(seen[~near_edge], other[~near_edge]))
        self.assertGreater(len(np.unique(seen, axis=0)), 50)
        self.has_picture("checkerboard.png")

    def test_on_fixtures(self):
        self.holds()

    def test_on_real_data(self):
        self.holds(*self.cortex())


class RepairSurface(Script):
    def holds(self, handles, loops, *options):
        self.assertIn(f"{handles} handle", self.run_script("repair_surface.py", *options))
        report = json.loads((self.out / "repair.json").read_text(encoding="utf-8"))
        self.assertEqual(report["changes"]["handles"]["count"], handles)
        found = authalic.topology(authalic.read_surface(self.out / "repaired.vtp"))
        self.assertEqual((found["genus"], found["oriented_manifold"], len(found["boundary_loops"])), (0, True, loops))
        self.has_picture("repair.png")

    def test_on_fixtures(self):
        self.holds(1, 0)

    def test_on_real_data(self):
        path = DATA / "colon/EdinGCA_3D_00020_CTC_inflated/large-intestine-SF+-HF-.vtk"
        if not path.exists():
            self.skipTest(f"{path} is not there")
        self.holds(3, 2, "--surface", path, "--scale", 0.808594, 0.808594, 0.7)


class Tutorial(unittest.TestCase):
    def test_on_fixtures_in_cells_and_as_a_whole(self):
        script = ROOT / "pipelines/tutorial.py"
        self.assertGreater(script.read_text(encoding="utf-8").count("\n# %%\n"), 6)
        done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, check=False, timeout=120)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("SurfaceError: A topological disk is required", done.stdout)


class Cxx(unittest.TestCase):
    def test_on_fixtures_builds_on_the_installed_package_and_has_the_bits_of_python(self):
        with tempfile.TemporaryDirectory() as here:
            prefix, tree, image = (f"{here}/{name}" for name in ("prefix", "tree", "map.vtp"))
            for command in (["cmake", "--install", str(BUILD), "--prefix", prefix],
                            ["cmake", "-S", str(GALLERY / "cpp"), "-B", tree, f"-DCMAKE_PREFIX_PATH={prefix}"],
                            ["cmake", "--build", tree]):
                done = subprocess.run(command, capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertNotIn("warning", done.stdout)
            surface, plane = ROOT / "data/folded_sphere.off", ["0", "0", "-20", "0", "0", "-1"]
            done = subprocess.run([f"{tree}/flatten", str(surface), image, *plane],
                                  capture_output=True,
                                  text=True,
                                  check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            disk = authalic.cut_to_disk(authalic.read_surface(surface), plane=((0, 0, -20), (0, 0, -1)))
            self.assertTrue(np.array_equal(authalic.read_surface(image).points[:, :2], authalic.flatten(disk).image))
            done = subprocess.run([f"{tree}/flatten", f"{here}/none.off", image, *plane],
                                  capture_output=True,
                                  text=True,
                                  check=False)
            self.assertEqual(done.returncode, 5)
            self.assertIn("does not exist", done.stderr)


class Listing(unittest.TestCase):
    def test_every_script_is_in_the_readme(self):
        text = (ROOT / "pipelines/README.md").read_text(encoding="utf-8")
        for path in [*GALLERY.glob("*.py"), *GALLERY.glob("cpp/*.cxx"), ROOT / "pipelines/tutorial.py"]:
            self.assertIn(path.name, text)


if __name__ == "__main__":
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    outcome = unittest.main(argv=[sys.argv[0], "-v", *sys.argv[3:]], exit=False).result
    skipped = outcome.skipped and len(outcome.skipped) == outcome.testsRun
    sys.exit(77 if skipped else not outcome.wasSuccessful())
