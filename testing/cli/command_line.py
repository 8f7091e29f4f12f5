"""What the tests of the command line share: a folder of their own, calls that succeed, calls that fail."""
import argparse
import os
import pathlib
import subprocess
import tempfile
import unittest

ARGUMENTS = argparse.Namespace()


def grid(path, n=24, height=0.3):
    """A bumpy sheet of n by n squares as OFF."""
    points = [(x / n, y / n, height * ((x * 7 + y * 3) % 5) / n) for y in range(n + 1) for x in range(n + 1)]
    faces = []
    for y in range(n):
        for x in range(n):
            a = y * (n + 1) + x
            faces += [(a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)]
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(repr(c) for c in p) for p in points] + [f"3 {f[0]} {f[1]} {f[2]}" for f in faces]
    path.write_text("\n".join(lines) + "\n")
    return path


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.here = pathlib.Path(self.folder.name)
        self.sheet = grid(self.here / "sheet.off")

    def tearDown(self):
        self.folder.cleanup()

    def run_verb(self, *words):
        return subprocess.run([ARGUMENTS.authalic, *map(str, words)], capture_output=True, text=True, cwd=self.here,
                              timeout=240)

    def fails(self, code, *words):
        before = set(self.here.iterdir())
        result = self.run_verb(*words)
        self.assertEqual(result.returncode, code, result.stderr)
        lines = [line for line in result.stderr.splitlines() if line]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith("authalic: "), lines[0])
        self.assertEqual(set(self.here.iterdir()), before, "something was left behind")
        return lines[0]

    def succeeds(self, *words):
        result = self.run_verb(*words)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout


def main(program):
    """Runs the tests of the calling program with the arguments of this folder's programs."""
    parser = argparse.ArgumentParser()
    for option in ("--authalic", "--fixtures", "--data"):
        parser.add_argument(option, required=True, type=os.path.abspath)
    _, rest = parser.parse_known_args(namespace=ARGUMENTS)
    unittest.main(module="__main__", argv=[program, *rest], verbosity=2)
