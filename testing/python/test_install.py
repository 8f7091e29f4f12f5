#!/usr/bin/python3
"""cmake --install gives a package that runs from its own prefix, wherever that is moved."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = """
import pathlib, sys
import numpy, authalic
assert pathlib.Path(authalic.__file__).is_relative_to(sys.argv[1]), authalic.__file__
square, fan = [(0, 0), (1, 0), (1, 1), (0, 1), (0.2, 0.3)], [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
result = authalic.flatten(square, fan, "tutte")
assert abs(result.image[4]).max() < 1e-12, result.image
libraries = [line.split()[-1] for line in open("/proc/self/maps") if "uthalic" in line]
assert libraries and all(path.startswith(sys.argv[1]) for path in libraries), libraries
print(authalic.__version__, len(authalic.__all__))
"""


class Install(unittest.TestCase):
    def test_runs_after_installation_and_after_moving(self):
        build = os.environ.get("AUTHALIC_BINARY_DIR")
        if not build:
            self.skipTest("AUTHALIC_BINARY_DIR does not say what to install")
        with tempfile.TemporaryDirectory() as here:
            here = str(pathlib.Path(here).resolve())
            subprocess.run(["cmake", "--install", build, "--prefix", f"{here}/first"],
                           check=True,
                           capture_output=True)
            os.rename(f"{here}/first", f"{here}/second")
            package = next(pathlib.Path(here, "second").glob("lib*/**/authalic/__init__.py")).parents[1]
            files = {path.name for path in (package / "authalic").iterdir()}
            self.assertLessEqual({"py.typed", "_classes.pyi", "__init__.py", "_maps.py"}, files)
            self.assertNotIn("__pycache__", files)
            done = subprocess.run([sys.executable, "-c", SCRIPT, f"{here}/second"], cwd=here, capture_output=True,
                                  text=True, check=False, env={"PYTHONPATH": str(package), "PATH": "/usr/bin:/bin"})
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr, "")
            self.assertRegex(done.stdout, r"^\d+\.\d+\.\d+ \d+\n$")


if __name__ == "__main__":
    unittest.main(verbosity=2)
