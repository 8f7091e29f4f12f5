#!/usr/bin/python3
"""Areas of maps of scans against `wb_command -surface-distortion`, on the coordinates that both programs read.

GIFTI holds coordinates of 32 bits: both files of a map are written first, and then read by each side, so that what is
compared is the measure and not the rounding. Leaves with 77 (skipped) when wb_command, nibabel or the data are missing.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import authalic

try:
    import nibabel
except ImportError:
    nibabel = None
MESHES = pathlib.Path(os.environ.get("AUTHALIC_SHARED_DATA", "nowhere")) / "meshes/open_disk"
if not (nibabel and shutil.which("wb_command") and MESHES.is_dir()):
    print("wb_command, nibabel or the real data are missing; nothing to compare with")
    sys.exit(77)
NEEDLE = 100  # faces so many times as long as high


def squares(points, faces, kind):
    """Squared lengths of the three edges of every face."""
    a, b, c = points.astype(kind)[faces].swapaxes(0, 1)
    return [((p - q)**2).sum(axis=1, dtype=kind).astype(float) for p, q in ((a, b), (b, c), (c, a))]


def areas_of_workbench(points, faces):
    """MathFunctions::triangleArea of Workbench 1.5: squared lengths in 32 bits, the rest in 64."""
    ab, bc, ca = squares(points, faces, np.float32)
    return 0.25 * np.sqrt(np.abs(4 * ab * ca - (ab - bc + ca)**2))


def areas(points, faces):
    a, b, c = points[faces].swapaxes(0, 1)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def stars(faces, values):
    return np.bincount(faces.ravel(), np.repeat(values / 3, 3))


def longest_needle(points, faces):
    """At every vertex, of its faces, the largest ratio of the longest edge to the height on it."""
    ratio = np.max(squares(points, faces, float), axis=0) / (2 * areas(points, faces))
    worst = np.zeros(len(points))
    np.maximum.at(worst, faces.ravel(), np.repeat(ratio, 3))
    return worst


class Workbench(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.here = pathlib.Path(folder.name)

    def through_gifti(self, name, points, faces):
        authalic.write_surface(self.here / name, points, faces)
        back = authalic.read_surface(self.here / name)
        np.testing.assert_array_equal(back.points.astype(np.float32), nibabel.load(self.here / name).darrays[0].data)
        return back

    def both(self, mesh):
        """The surface and the map as their files have them, our log2 area ratios and those of Workbench."""
        surface = authalic.read_surface(MESHES / mesh, space="scanner-ras")
        image = authalic.flatten(surface, method="mean-value").image
        image = np.column_stack([image, np.zeros(len(image))])
        before = self.through_gifti("s.surf.gii", surface.points, surface.faces)
        after = self.through_gifti("m.surf.gii", image, surface.faces)
        subprocess.run(["wb_command", "-surface-distortion", self.here / "s.surf.gii", self.here / "m.surf.gii",
                        self.here / "d.func.gii"], check=True, capture_output=True)
        theirs = nibabel.load(self.here / "d.func.gii").darrays[0].data.astype(float)
        growth = areas(after.points, after.faces).sum() / areas(before.points, before.faces).sum()
        ours = authalic.measure_distortion(after.points, before).point_arrays["VertexAreaDistortion"] + np.log2(growth)
        return before, after, ours, theirs

    def test_log2_area_ratios_agree_at_every_vertex_of_scans(self):
        for mesh in ("human_brain.off", "chinese_lion.off", "human_face.off"):
            _, _, ours, theirs = self.both(mesh)
            self.assertGreater(np.ptp(theirs), 2, mesh)
            np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-5, err_msg=mesh)  # 3e-6 measured

    def test_where_they_do_not_agree_workbench_rounds_the_edges_of_needles_to_32_bits(self):
        before, after, ours, theirs = self.both("camelhead.off")
        faces = before.faces
        plump = np.maximum(*(longest_needle(s.points, faces) for s in (before, after))) < NEEDLE
        self.assertGreater(plump.mean(), 0.99)
        np.testing.assert_allclose(ours[plump], theirs[plump], rtol=0, atol=1e-4)  # 1.8e-5 measured
        self.assertGreater(np.abs(ours - theirs).max(), 1e-4)
        rounded = [stars(faces, areas_of_workbench(s.points, faces)) for s in (after, before)]
        np.testing.assert_allclose(np.log2(rounded[0] / rounded[1]), theirs, rtol=0, atol=1e-5)  # 9e-7 measured


if __name__ == "__main__":
    unittest.main()
