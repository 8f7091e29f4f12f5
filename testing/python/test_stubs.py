#!/usr/bin/python3
"""Type stubs: valid Python, the names of the running package and no others; a type checker believes them."""
import ast
import importlib
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import authalic

FOLDER = pathlib.Path(authalic.__file__).parent
COMPILED = sorted(path.name.split(".")[0] for path in FOLDER.glob("vtkAuthalic*.so"))


def stub(name):
    return ast.parse((FOLDER / f"{name}.pyi").read_text(encoding="utf-8"))


def members(cls):
    """Names that the body of a class in a stub defines."""
    for node in cls.body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name
        elif isinstance(node, ast.AnnAssign):
            yield node.target.id


class Stubs(unittest.TestCase):
    def test_every_compiled_module_has_one_with_its_classes_and_their_members(self):
        self.assertGreaterEqual(len(COMPILED), 6)
        for name in COMPILED:
            module = importlib.import_module(f"authalic.{name}")
            classes = {node.name: node for node in stub(name).body if isinstance(node, ast.ClassDef)}
            self.assertEqual(set(classes), {key for key in vars(module) if key.startswith("vtk")}, name)
            for key, node in classes.items():
                real = {member for member in vars(getattr(module, key)) if not member.startswith("_")}
                self.assertEqual(set(members(node)), real, key)

    def test_every_overload_of_the_docstring_is_there(self):
        node = next(n for n in stub("vtkAuthalicFiltersSegmentation").body
                    if getattr(n, "name", "") == "vtkCutToDisk")
        found = [len(n.args.args) for n in node.body if getattr(n, "name", "") == "SetPlaneOrigin"]
        self.assertEqual(sorted(found), [2, 4])

    def test_the_package_shows_every_class(self):
        names = next(node.value for node in stub("_classes").body if isinstance(node, ast.Assign))
        self.assertEqual(ast.literal_eval(names),
                         [name for name in sorted(authalic.__all__) if name.startswith("vtk")])

    def test_the_package_is_marked_as_typed(self):
        self.assertTrue((FOLDER / "py.typed").exists())

    def test_every_name_of_the_package_is_there_once(self):
        self.assertEqual(len(authalic.__all__), len(set(authalic.__all__)))
        for name in authalic.__all__:
            self.assertTrue(hasattr(authalic, name), name)

    @unittest.skipUnless(shutil.which("mypy"), "mypy is not installed")
    def test_mypy_believes_the_package_and_finds_wrong_calls(self):
        right = ("import authalic, numpy\nresult = authalic.flatten(numpy.eye(3), [[0, 1, 2]], method='tutte')\n"
                 "flow = authalic.vtkDiscreteLieFlow()\nflow.SetTolerance(0.1)\n"
                 "number: float = flow.GetTolerance()\nimage: numpy.ndarray = result.image\n"
                 "authalic.Surface(numpy.eye(3), numpy.eye(3)).to_vtk()\n")
        wrong = "flow.SetTolerance('a')\nauthalic.flatten(faces=2)\nwords: str = flow.GetTolerance()\n"
        with tempfile.TemporaryDirectory() as here:
            for text, faults in ((right, 0), (right + wrong, 3)):
                pathlib.Path(here, "typed.py").write_text(text, encoding="utf-8")
                command = [shutil.which("mypy"), "--python-executable", sys.executable, "--ignore-missing-imports",
                           "--no-error-summary", "--cache-dir", f"{here}/cache", "typed.py"]
                done = subprocess.run(command, cwd=here, capture_output=True, text=True, check=False,
                                      env={"MYPYPATH": str(FOLDER.parent), "PATH": "/usr/bin:/bin"})
                self.assertEqual(len(done.stdout.splitlines()), faults, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
