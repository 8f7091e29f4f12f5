#!/usr/bin/python3
"""The examples of the documentation run, and every public name is in it."""
import contextlib
import io
import os
import pathlib
import re
import unittest

import authalic

ROOT = pathlib.Path(__file__).resolve().parents[2]


def examples(page):
    """The Python blocks of a page, as one script."""
    return "\n".join(re.findall(r"^```python\n(.*?)^```", (ROOT / page).read_text(encoding="utf-8"), flags=re.M | re.S))


class Documentation(unittest.TestCase):
    def setUp(self):
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(ROOT)

    def test_the_examples_run(self):
        for page in ("docs/python.md", "README.md"):
            script = examples(page)
            self.assertIn("authalic.flatten", script)
            with contextlib.redirect_stdout(io.StringIO()):
                exec(compile(script, page, "exec"), {})  # pylint: disable=exec-used

    def test_the_reference_names_everything(self):
        text = (ROOT / "docs/python.md").read_text(encoding="utf-8")
        for name in authalic.__all__:
            abstract = name.startswith("vtk") and name.endswith("Algorithm")
            self.assertTrue(abstract or f"`{name}" in text, name)

    def test_pictures_and_links_of_the_pages_are_there(self):
        for page in ("docs/python.md", "docs/gallery.md", "pipelines/README.md"):
            for target in re.findall(r"\]\(([^)#:]+)\)", (ROOT / page).read_text(encoding="utf-8")):
                self.assertTrue(((ROOT / page).parent / target).exists(), f"{page}: {target}")


if __name__ == "__main__":
    unittest.main(verbosity=2)
