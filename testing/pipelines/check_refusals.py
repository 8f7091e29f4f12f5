#!/usr/bin/python3
"""The main job on input that it must refuse: one sentence on stderr, the right exit code, nothing left behind."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

JOB = pathlib.Path(__file__).resolve().parents[2] / "pipelines/cortex/cortex.py"


class Refusals(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)

    def refuse(self, code, *arguments):
        """Runs the job; returns what it says."""
        out = self.folder / "out"
        result = subprocess.run([sys.executable, str(JOB), "--out", str(out), *map(str, arguments)],
                                capture_output=True, text=True, timeout=100)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertFalse(out.exists() and any(p.is_file() for p in out.rglob("*")), "nothing is left behind")
        return result.stderr

    def test_missing_file_is_named(self):
        self.assertIn("nowhere.nii", self.refuse(2, "--t1", self.folder / "nowhere.nii"))

    def test_folder_is_not_a_volume(self):
        self.assertIn("not a file", self.refuse(2, "--t1", self.folder))

    def test_unknown_option_is_named(self):
        self.assertIn("--tee-one", self.refuse(2, "--tee-one"))

    def test_number_of_elements_must_be_positive(self):
        self.assertIn("whole number", self.refuse(2, "--elements", "0"))

    def test_text_is_not_a_volume(self):
        path = self.folder / "text.nii"
        path.write_text("This is not an image.\n" * 100)
        self.assertIn("text.nii", self.refuse(5, "--t1", path))

    def test_empty_file_is_not_a_volume(self):
        path = self.folder / "empty.nii.gz"
        path.write_bytes(b"")
        self.assertIn("empty.nii.gz", self.refuse(5, "--t1", path))

    def test_text_is_not_a_surface(self):
        path = self.folder / "text.surf.gii"
        path.write_text("This is not a surface.\n")
        self.assertIn("text.surf.gii", self.refuse(5, "--surface", path))


if __name__ == "__main__":
    unittest.main(verbosity=2)
