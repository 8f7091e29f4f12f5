#!/usr/bin/python3
"""The main job on a given surface, twice: everything is there, areas are equal, two runs give the same bytes.

    check_surface.py DATA     DATA = the folder of real test data
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

JOB = pathlib.Path(__file__).resolve().parents[2] / "pipelines/cortex/cortex.py"
DATA = pathlib.Path(sys.argv.pop()) / "cortex/fsaverage3_fs"
FILES = ("white.surf.gii", "white.vtp", "flat.surf.gii", "map.vtp", "elements.tsv", "elements.json",
         "elements_initial.tsv", "elements_initial.json", "elements.label.gii", "sulcal_depth.func.gii")


class GivenSurface(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.outs = [pathlib.Path(cls.temporary.name) / name for name in ("one", "two")]
        cls.results = [subprocess.run(
            [sys.executable, str(JOB), "--surface", str(DATA / "lh.white"), "--cortex", str(DATA / "lh.cortex.label"),
             "--elements", "60", "--no-pictures", "--threads", threads, "--out", str(out)],
            capture_output=True, text=True, timeout=100) for out, threads in zip(cls.outs, "12")]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_ends_well_with_the_path_of_the_page(self):
        for out, result in zip(self.outs, self.results):
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(result.stdout.strip(), str(out / "index.html"))

    def test_areas_are_preserved_without_flips(self):
        report = json.loads((self.outs[0] / "lh/report.json").read_text())
        self.assertEqual(report["white"]["Genus"], 0)
        self.assertEqual(report["area_preserving"]["FlippedFaces"], 0)
        self.assertLess(report["area_preserving"]["TotalAreaDistortion"], 2.05)
        self.assertLess(report["area_preserving"]["InteriorMaximumDeviation"], 0.02)
        self.assertGreater(report["initial"]["InteriorMaximumDeviation"], 0.2)

    def test_one_thread_and_two_give_the_same_bytes(self):
        for name in FILES:
            first, second = ((out / "lh" / name).read_bytes() for out in self.outs)
            self.assertTrue(first == second, name)
        first, second = (json.loads((out / "lh/report.json").read_text()) for out in self.outs)
        del first["seconds"], second["seconds"]
        self.assertEqual(first, second)


if __name__ == "__main__":
    if not DATA.is_dir():
        print(f"{DATA} is not there")
        sys.exit(77)
    unittest.main(verbosity=2)
