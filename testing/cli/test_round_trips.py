#!/usr/bin/python3
"""From every format into every other and back to numbers; and what other programs make of everything that is written.

    test_round_trips.py --authalic PROGRAM --fixtures FOLDER --data FOLDER
"""
import pathlib
import shutil
import subprocess
import unittest

from command_line import ARGUMENTS, main
from format_files import Formats

try:
    import nibabel
    import numpy as np
except ImportError:
    nibabel = None


@unittest.skipUnless(nibabel, "nibabel is not installed")
class Pairs(Formats):
    def off(self, path):
        words = iter(self.path(path).read_text().split()[1:])
        n, m, _ = (int(next(words)) for _ in range(3))
        points = np.array([[float(next(words)) for _ in range(3)] for _ in range(n)])
        return points, np.array([[int(next(words)) for _ in range(4)][1:] for _ in range(m)])

    def corners(self, path):
        """The coordinates of the corners of each triangle, from its least corner on, triangles in an order of their
        own: what is left where a format keeps no order."""
        points, faces = self.off(path)
        found = []
        for a, b, c in points[faces].tolist():
            least = min((a, b, c))
            found.append(next(turn for turn in ((a, b, c), (b, c, a), (c, a, b)) if turn[0] == least))
        return np.array(sorted(found, key=lambda t: np.round(t, 3).tolist()))

    def test_a_surface_goes_from_every_format_into_every_other(self):
        self.succeeds("convert", "lh.white", "original.off", "-q")
        points, faces = self.off("original.off")
        corners = self.corners("original.off")
        names = ("lh.a", "a.surf.gii", "a.vtp", "a.vtk", "a.ply", "a.obj", "a.off", "a.stl", "a.mz3")
        for first in names:
            self.succeeds("convert", "lh.white", first, "-q")
            for second in names:
                middle = second.replace("a", "b", 1) if second != "lh.a" else "lh.b"
                self.succeeds("convert", first, middle, "-q")
                self.succeeds("convert", middle, "end.off", "-q")
                if "a.stl" in (first, second):
                    np.testing.assert_allclose(self.corners("end.off"), corners, atol=1e-5, err_msg=f"{first} {second}")
                    continue
                ours = self.off("end.off")
                np.testing.assert_allclose(ours[0], points, atol=1e-5, err_msg=f"{first} {second}")
                np.testing.assert_array_equal(ours[1], faces, f"{first} {second}")

    def test_numbers_go_from_every_format_into_every_other_bit_for_bit(self):
        names = ("n.func.gii", "n.shape.gii", "n.mgh", "n.mgz", "n.txt", "lh.thickness2", "n.curv")
        for first in names:
            self.succeeds("convert", "lh.thickness", first, "-q")
            for second in names:
                middle = second.replace("n", "m", 1)
                self.succeeds("convert", first, middle, "-q")
                self.succeeds("convert", "lh.white", "end.curv", "--data", middle, "-q")
                self.assertEqual(self.bytes("end.curv"), self.bytes("lh.thickness"), f"{first} {second}")

    def test_regions_go_between_annotations_and_gifti(self):
        self.annot("lh.parts.annot")
        self.succeeds("convert", "lh.parts.annot", "a.label.gii", "-q")
        for first, second in (("lh.parts.annot", "b.label.gii"), ("a.label.gii", "b.annot"),
                              ("a.label.gii", "c.label.gii")):
            self.succeeds("convert", first, second, "-q")
        ids = (0, 3, 7)  # nibabel gives these as labels
        (ours, _, names), (theirs, _, old) = (nibabel.freesurfer.read_annot(self.path(name))
                                              for name in ("b.annot", "lh.parts.annot"))
        self.assertEqual(names, old)
        for label, before in zip(ours, theirs):
            self.assertEqual(label, before if before in ids else 0)
        self.assertEqual(self.bytes("a.label.gii"), self.bytes("c.label.gii"))

    def test_voxels_go_from_every_format_into_every_other(self):
        source = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        original = nibabel.load(source)
        names = ("a.nii", "a.nii.gz", "a.mgh", "a.mgz")
        for first in names:
            self.succeeds("convert", source, first, "-q")
            for second in names:
                middle = second.replace("a", "b", 1)
                self.succeeds("convert", first, middle, "-q")
                ours = nibabel.load(self.path(middle))
                np.testing.assert_array_equal(np.asanyarray(ours.dataobj), np.asanyarray(original.dataobj))
                np.testing.assert_allclose(ours.affine, original.affine, atol=1e-5)
                self.assertEqual(ours.get_data_dtype().newbyteorder("="), original.get_data_dtype().newbyteorder("="))


@unittest.skipUnless(nibabel, "nibabel is not installed")
class Accepted(Formats):
    """Every file that the command writes, before nibabel, wb_command, gifti_tool and nifti_tool."""

    def setUp(self):
        super().setUp()
        phantom = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        self.annot("lh.parts.annot")
        self.succeeds("convert", "lh.white", "rich.vtp", "-q", "--data", "lh.thickness", "lh.parts.annot")
        self.succeeds("map", "tutte", "lh.white", "-o", "map.vtp", "-q")
        for words in (("rich.vtp", "s.surf.gii"), ("map.vtp", "flat.surf.gii"), ("rich.vtp", "lh.s"),
                      ("rich.vtp", "d.func.gii", "--array", "thickness"),
                      ("rich.vtp", "d.shape.gii", "--array", "thickness"),
                      ("rich.vtp", "d.label.gii", "--array", "parts"), ("rich.vtp", "lh.d.annot", "--array", "parts"),
                      ("rich.vtp", "d.mgh", "--array", "thickness"), ("rich.vtp", "d.mgz", "--array", "thickness"),
                      ("rich.vtp", "d.curv", "--array", "thickness"), (phantom, "v.nii"), (phantom, "v.nii.gz"),
                      (phantom, "v.mgh"), (phantom, "v.mgz")):
            self.succeeds("convert", *words, "-q")
        self.volumes = ["v.nii", "v.nii.gz"]
        for kind in ("u1", "i2", "u2", "i4", "f4", "f8"):
            voxels = np.arange(2 * 3 * 4 * 2).reshape(2, 3, 4, 2).astype(kind)
            image = nibabel.Nifti1Image(voxels, np.diag([2, 2, 2, 1]))
            image.header.set_xyzt_units("mm", "sec")
            image.header.extensions.append(nibabel.nifti1.Nifti1Extension("comment", b"words"))
            image.header.set_slope_inter(*((0.5, 1) if kind[0] != "f" else (1, 0)))
            nibabel.save(image, self.path("k.nii"))
            self.succeeds("convert", "k.nii", f"k_{kind}.nii", "-q")
            self.succeeds("convert", "k.nii", f"k_{kind}.mgz", "-q")
            self.volumes.append(f"k_{kind}.nii")

    def accepts(self, *words):
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True, cwd=self.here)
        self.assertEqual(done.returncode, 0, f"{words}: {done.stdout} {done.stderr}")
        return done.stdout + done.stderr

    def test_nibabel_reads_everything_of_its_kinds(self):
        read = 0
        for path in sorted(self.here.iterdir()):
            if path.name.endswith((".gii", ".nii", ".nii.gz", ".mgh", ".mgz")):
                image = nibabel.load(path)
                self.assertTrue(image.darrays if path.suffix == ".gii" else np.asanyarray(image.dataobj).size)
                read += 1
        self.assertGreaterEqual(read, 24)
        self.assertEqual(len(nibabel.freesurfer.read_geometry(self.path("lh.s"))[0]), 81)
        np.testing.assert_array_equal(nibabel.freesurfer.read_morph_data(self.path("d.curv")), np.float32(self.values))
        self.assertEqual(len(nibabel.freesurfer.read_annot(self.path("lh.d.annot"))[2]), 3)

    @unittest.skipUnless(shutil.which("wb_command"), "wb_command is not installed")
    def test_workbench_describes_every_gifti_and_nifti_file(self):
        for name in (*sorted(path.name for path in self.here.glob("*.gii")), *self.volumes):
            said = self.accepts("wb_command", "-file-information", name)
            self.assertIn("Name", said)
            self.assertNotRegex(said, "(?i)error|warning")

    @unittest.skipUnless(shutil.which("gifti_tool") and shutil.which("nifti_tool"), "gifti_tool, nifti_tool")
    def test_the_tools_of_the_standards_accept_every_gifti_and_nifti_file(self):
        for path in self.here.glob("*.gii"):
            self.accepts("gifti_tool", "-gifti_test", "-infile", path.name)
        for name in self.volumes:
            for check in ("-check_hdr", "-check_nim"):
                said = self.accepts("nifti_tool", check, "-infiles", name)
                self.assertIn("GOOD", said, name)


if __name__ == "__main__":
    main("test_round_trips.py")
