#!/usr/bin/python3
"""`convert` and `info` on every format: round trips bit for bit, what is lost said.

    test_formats.py --authalic PROGRAM --fixtures FOLDER --data FOLDER

Files are made here; what nibabel and wb_command make of ours is compared where they are installed.
"""
import base64
import gzip
import os
import pathlib
import shutil
import struct
import subprocess
import time
import unittest

from command_line import ARGUMENTS, main
from format_files import D_P_INVERSE, Formats, curv, white

try:
    import nibabel
    import numpy as np
except ImportError:
    nibabel = None
needs_nibabel = unittest.skipUnless(nibabel, "nibabel is not installed")


class Surfaces(Formats):
    def test_freesurfer_survives_every_format_that_keeps_the_geometry(self):
        self.assertEqual(self.converts("lh.white", "copy.white"), "")
        geometry = self.bytes("lh.white").index(struct.pack(">iii", 2, 0, 20))
        self.assertEqual(self.bytes("copy.white")[:geometry], self.bytes("lh.white")[:geometry])
        for middle in ("s.vtp", "s.vtk"):
            self.assertEqual(self.there_and_back("copy.white", middle, "back.white"), "", middle)

    def test_gifti_keeps_space_geometry_and_coordinates_to_32_bits(self):
        said = self.converts("lh.white", "s.surf.gii")
        self.assertRegex(said, r"^authalic: lost in s.surf.gii: Coordinates are rounded to 32 bits, by up to "
                         r"\S+ mm\.\n$")
        self.there_and_back("s.surf.gii", "s.vtp", "again.surf.gii")
        self.assertIn("SCANNER_ANAT", self.lines_of("again.surf.gii")["space"])

    def test_ply_obj_off_and_vtp_give_back_the_same_doubles(self):
        self.succeeds("convert", "lh.white", "s.ply", "-q")
        for middle in ("s.obj", "s.vtp", "s.vtk"):
            self.there_and_back("s.ply", middle, "back.ply")
        said = self.there_and_back("s.ply", "s.off", "back.ply", home=("--space", "scanner-ras"))
        self.assertIn("does not say that its coordinates are scanner-ras", said)

    def test_mz3_gives_back_points_and_overlays(self):
        white(self.path("plain.white"), geometry="")
        self.converts("plain.white", "s.mz3", "--data", "lh.thickness")
        self.converts("s.mz3", "back.white")
        self.assertEqual(self.bytes("back.white"), self.bytes("plain.white") + struct.pack(">ii", 2, 0))
        self.converts("plain.white", "back.thickness", "--data", "s.mz3")
        self.assertEqual(self.bytes("back.thickness"), self.bytes("lh.thickness"))

    def test_stl_says_that_it_loses_the_order(self):
        said = self.converts("lh.white", "s.stl")
        for words in ("order of the vertices", "volume geometry"):
            self.assertIn(words, said)
        self.assertIn("81", self.lines_of("s.stl")["vertices"])

    def test_every_loss_is_one_sentence_on_stderr_and_quiet_is_quiet(self):
        self.converts("lh.white", "a.vtp", "--data", "lh.thickness")
        result = self.run_verb("convert", "a.vtp", "a.off")
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 3, lines)
        for line, words in zip(lines, ("Arrays are not kept: thickness", "scanner-ras", "volume geometry")):
            self.assertTrue(line.startswith("authalic: lost in a.off: ") and line.endswith("."), line)
            self.assertIn(words, line)
        self.assertEqual((result.stdout, self.run_verb("convert", "a.vtp", "a.off", "-q").stderr), ("", ""))

    def test_patches_give_back_vertices_border_and_points(self):
        kept = [i for i, p in enumerate(self.points) if p[0] < 2]
        border = {i for i in kept if not (-4 < self.points[i][0] < 1 and -4 < self.points[i][1] < 4)}
        for name, flat in (("lh.patch.3d", False), ("lh.patch.flat", True)):
            data = struct.pack(">ii", -1, len(kept))
            for i in kept:
                x, y, z = self.points[i]
                data += struct.pack(">i3f", -(i + 1) if i in border else i + 1, x, y, 0 if flat else z)
            self.path(name).write_bytes(data)
            self.assertIn("was cut from", self.fails(2, "convert", name, "p.vtp"))
            self.assertIn(str(len(border)), self.succeeds("info", name))
            said = self.there_and_back(name, "p.vtp", "back" + name, there=("--whole", "lh.white"))
            self.assertEqual(said, "")
            expected = "unknown" if flat else "scanner-ras"
            self.assertTrue(self.lines_of(name, "--whole", "lh.white")["space"].startswith(expected), name)
        self.assertIn("OriginalPointIds", self.fails(2, "convert", "lh.white", "w.patch.3d"))

    def test_compressed_names_are_refused(self):
        for name in ("s.surf.gii.gz", "lh.curv.gz", "a.annot.gz"):
            self.assertIn(".gz", self.fails(2, "convert", "lh.white", name, "--data", "lh.thickness"))


class Spaces(Formats):
    def first_point(self, name):
        self.succeeds("convert", name, "first.obj", "-q")
        line = next(line for line in self.path("first.obj").read_text().splitlines() if line.startswith("v "))
        return [float(x) for x in line.split()[1:]]

    def test_tkras_of_an_oblique_volume_is_placed_by_the_full_formula(self):
        p = self.points[0]
        expected = [sum(m * x for m, x in zip(row, p)) + c for row, c in zip(D_P_INVERSE, (3.5, -20.25, 7))]
        for name in ("lh.white", "s.surf.gii", "s.vtp", "s.ply"):
            if name != "lh.white":
                self.succeeds("convert", "lh.white", name, "-q")
            for ours, theirs in zip(self.first_point(name), expected):
                self.assertAlmostEqual(ours, theirs, delta=1e-5, msg=name)
        only_centre = [x + c for x, c in zip(p, (3.5, -20.25, 7))]
        self.assertGreater(max(abs(a - b) for a, b in zip(only_centre, expected)), 1)

    def test_voxels_and_tkras_are_those_of_the_volume_that_is_named(self):
        turn = ((0.0, -1.2, 0.0, 5.0), (0.8, 0.0, 0.3, -7.0), (0.1, 0.0, 1.5, 2.0))  # voxel to world, sheared
        self.nifti("v.nii", 1, 0, 0)
        header = bytearray(self.bytes("v.nii"))
        struct.pack_into("<12f", header, 280, *(x for row in turn for x in row))
        self.path("v.nii").write_bytes(header)
        dimensions = struct.unpack_from("<3h", header, 42)
        white(self.path("bare.white"), geometry="")
        self.succeeds("convert", "bare.white", "placed.obj", "--space", "voxel", "--volume", "v.nii", "-q")
        self.assertIn("asserted by the user as voxel",
                      self.lines_of("bare.white", "--space", "voxel", "--volume", "v.nii")["space"])
        for ours, voxel in zip(self.obj_points("placed.obj"), self.points):
            for x, row in zip(ours, turn):
                self.assertAlmostEqual(x, sum(a * b for a, b in zip(row, voxel)) + row[3], places=4)
        self.succeeds("convert", "v.nii", "v.mgz", "-q")
        for name in ("v.nii", "v.mgz"):  # tkRAS has its origin in the middle of the volume
            self.succeeds("convert", "bare.white", "o.obj", "--space", "tkras", "--volume", name, "-q")
            middle = [sum(a * n / 2 for a, n in zip(row, dimensions)) + row[3] for row in turn]
            size = sum(row[1]**2 for row in turn)**0.5
            x, y, z = self.points[40]
            self.assertEqual((x, y), (0, 0))
            expected = [m - row[1] / size * z for m, row in zip(middle, turn)]  # D P^-1: z of tkRAS goes along -yras
            for x, y in zip(self.obj_points("o.obj")[40], expected):
                self.assertAlmostEqual(x, y, places=4)
        self.assertIn("--volume", self.fails(5, "convert", "bare.white", "o.vtp", "--space", "voxel"))
        self.nifti("lost.nii", 0, 0, 0)
        self.nifti("apart.nii", 4, 1, 3)
        for name, words in (("lost.nii", "--space scanner-ras"), ("apart.nii", "--transform"),
                            ("gone.nii", "gone.nii")):
            self.assertIn(words, self.fails(5, "info", "bare.white", "--space", "voxel", "--volume", name))

    def obj_points(self, name):
        lines = self.path(name).read_text().splitlines()
        return [tuple(map(float, line.split()[1:4])) for line in lines if line.startswith("v ")]

    def test_lps_turns_x_and_y_and_is_stated(self):
        ras = self.first_point("lh.white")
        for name in ("l.ply", "l.obj", "l.stl", "l.vtk", "l.vtp"):
            self.succeeds("convert", "lh.white", name, "--lps", "-q")
            self.assertTrue(self.lines_of(name)["space"].startswith("scanner-ras"), name)
            self.assertAlmostEqual(self.first_point(name)[0], ras[0], places=5)
        numbers = [line for line in self.path("l.obj").read_text().splitlines() if line.startswith("v ")][0].split()
        self.assertAlmostEqual(float(numbers[1]), -ras[0])
        self.assertAlmostEqual(float(numbers[2]), -ras[1])
        self.assertAlmostEqual(float(numbers[3]), ras[2])
        self.assertIn("space of its own", self.fails(2, "convert", "lh.white", "l.surf.gii", "--lps"))
        self.assertIn("unknown", self.fails(2, "convert", self.sheet, "l.ply", "--lps"))

    def test_info_says_which_space_and_why(self):
        white(self.path("bare.white"), geometry="")
        self.succeeds("convert", "lh.white", "s.surf.gii", "-q")
        self.succeeds("convert", "lh.white", "s.ply", "-q")
        for name, space, why in (("lh.white", "scanner-ras", "volume geometry"), ("bare.white", "unknown", "without"),
                                 ("s.surf.gii", "scanner-ras", "SCANNER_ANAT"), ("s.ply", "scanner-ras", "SPACE=RAS"),
                                 (self.sheet, "unknown", "")):
            line = self.lines_of(name)["space"]
            self.assertTrue(line.startswith(space) and why in line, line)

    def test_info_reports_sform_and_qform_that_disagree(self):
        for name, shift, warned in (("agree.nii", 0, False), ("differ.nii", 3, True)):
            self.nifti(name, 4, 1, shift)
            words = self.succeeds("info", name)
            self.assertEqual("disagree by up to 3.0" in words, warned, words)
            self.assertIn("scanner-ras (NIfTI sform, code 4 (MNI 152))", words)

    def test_a_volume_of_unknown_space_is_refused_with_the_option_that_resolves_it(self):
        self.nifti("lost.nii", 0, 0, 0)
        self.assertIn("unknown", self.lines_of("lost.nii")["space"])
        self.assertIn("--space scanner-ras", self.fails(2, "convert", "lost.nii", "v.mgz"))
        self.succeeds("convert", "lost.nii", "v.mgz", "--space", "scanner-ras")
        self.assertIn("scanner-ras", self.lines_of("v.mgz")["space"])


class Data(Formats):
    def test_numbers_survive_every_format_of_numbers(self):
        for middle in ("t.shape.gii", "t.func.gii", "t.mgh", "t.mgz", "t.txt"):
            self.converts("lh.thickness", middle)
            self.converts("lh.white", "back.thickness", "--data", middle)
            self.assertEqual(self.bytes("back.thickness"), self.bytes("lh.thickness"), middle)

    def test_nan_survives_lists_of_vertices(self):
        values = [float("nan") if i % 3 else i / 7 for i in range(81)]
        curv(self.path("lh.sparse"), values, len(self.faces))
        self.converts("lh.sparse", "lh.w")
        self.assertIn("give the surface", self.fails(5, "convert", "lh.w", "x.shape.gii"))
        self.converts("lh.white", "back.curv", "--data", "lh.w")
        self.assertEqual(self.bytes("back.curv"), self.bytes("lh.sparse"))

    def test_annotations_survive_as_arrays_and_say_what_gifti_merges(self):
        self.annot("lh.parts.annot")
        self.converts("lh.white", "s.vtp", "--data", "lh.parts.annot")
        self.converts("s.vtp", "back.parts.annot", "--array", "parts")
        self.assertEqual(self.bytes("back.parts.annot"), self.bytes("lh.parts.annot"))
        said = self.converts("lh.parts.annot", "parts.label.gii")
        self.assertIn("8 vertices without region (-1) become label 0", said)
        self.there_and_back("parts.label.gii", "p.annot", "parts2.label.gii")
        self.assertIn("front & centre", self.succeeds("info", "p.annot"))
        self.assertIn("Names and colours", self.converts("lh.parts.annot", "parts.curv"))

    def test_labels_survive_with_values(self):
        rows = [f"{i}  {p[0]:g}  {p[1]:g}  {p[2]:g} {i / 8:g}" for i, p in enumerate(self.points) if i % 4 == 0]
        self.path("lh.some.label").write_text(
            "\n".join(["#!ascii label  , from subject vox2ras=TkReg", str(len(rows)), *rows]) + "\n")
        self.converts("lh.white", "s.vtp", "--data", "lh.some.label")
        self.converts("s.vtp", "back.label", "--array", "some", "-q")
        back, source = (self.path(name).read_text().splitlines() for name in ("back.label", "lh.some.label"))
        self.assertEqual(back[:2], source[:2])
        for ours, theirs in zip(back[2:], source[2:]):
            for a, b in zip(ours.split(), theirs.split()):
                self.assertAlmostEqual(float(a), float(b), places=5)
        self.assertIn("21", self.succeeds("info", "lh.some.label"))
        self.assertIn("set of vertices", self.fails(2, "convert", "lh.thickness", "no.label"))

    def test_tables_are_made_up_only_with_words_and_never_for_fractions(self):
        curv(self.path("lh.numbers"), [float(i % 5) for i in range(81)])
        for name in ("n.annot", "n.label.gii"):
            self.assertIn("made up", self.converts("lh.numbers", name))
        self.assertIn("regions of n", self.succeeds("info", "n.annot"))
        self.assertIn("whole numbers", self.fails(2, "convert", "lh.thickness", "t.annot"))

    def test_data_alone_are_no_surface_and_say_what_to_do(self):
        self.assertIn("--data", self.fails(2, "convert", "lh.thickness", "s.vtp"))
        self.assertIn("read only", self.fails(2, "convert", "lh.thickness", "s.dscalar.nii"))

    def test_sparse_gifti_becomes_dense_on_its_surface(self):
        array = ('<DataArray Intent="NIFTI_INTENT_{}" DataType="NIFTI_TYPE_{}" ArrayIndexingOrder="RowMajorOrder" '
                 'Dimensionality="1" Dim0="2" Encoding="ASCII" Endian="LittleEndian"><Data>{}</Data></DataArray>')
        self.path("s.func.gii").write_text('<?xml version="1.0"?><GIFTI Version="1.0" NumberOfDataArrays="2">' +
                                           array.format("NODE_INDEX", "INT32", "4 1") +
                                           array.format("SHAPE", "FLOAT32", "7 8") + "</GIFTI>")
        self.assertIn("2", self.lines_of("s.func.gii")["vertices"])
        self.fails(5, "convert", "s.func.gii", "d.txt")
        self.succeeds("convert", "lh.white", "d.txt", "--data", "s.func.gii", "-q")
        lines = self.path("d.txt").read_text().split()
        self.assertEqual((lines[1], lines[4], lines.count("n/a")), ("8", "7", 79))

    @needs_nibabel
    def test_cifti_gives_each_surface_its_values(self):
        axes = nibabel.cifti2.BrainModelAxis
        left = axes.from_surface(np.arange(1, 81), 81, "CortexLeft")
        right = axes.from_surface(np.arange(70), 81, "CortexRight")
        models = left + right + axes.from_mask(np.ones((2, 1, 1)), "ThalamusLeft", np.eye(4))
        values = np.arange(2 * len(models), dtype="f4").reshape(2, -1)
        nibabel.save(nibabel.Cifti2Image(values, (nibabel.cifti2.ScalarAxis(["a", "b"]), models)),
                     self.path("x.dscalar.nii"))
        self.assertIn("80 of 81 vertices", self.succeeds("info", "x.dscalar.nii"))
        self.assertIn("CortexRight", self.fails(5, "convert", "x.dscalar.nii", "x.func.gii"))
        said = self.converts("x.dscalar.nii", "x.func.gii", "--structure", "CortexLeft")
        self.assertIn("CortexRight, 2 voxels", said)
        image = nibabel.load(self.path("x.func.gii"))
        for row, array in zip(values, image.darrays):
            np.testing.assert_array_equal(array.data, np.concatenate([[np.nan], row[:80]]).astype("f4"))
        self.assertEqual(image.meta["AnatomicalStructurePrimary"], "CortexLeft")


class Volumes(Formats):
    def test_voxels_and_affine_survive_nifti_and_mgh(self):
        source = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        self.succeeds("convert", source, "a.nii", "-q")
        for middle in ("b.nii.gz", "b.mgh", "b.mgz"):
            self.succeeds("convert", "a.nii", middle, "-q")
            self.succeeds("convert", middle, "c.nii", "-q")
            self.assertEqual(self.bytes("c.nii"), self.bytes("a.nii"), middle)

    @needs_nibabel
    def test_nibabel_reads_the_same_volume(self):
        rotation, _ = np.linalg.qr(np.array([[1, 0.2, 0.1], [-0.3, 1, 0.2], [0.1, -0.2, 1]]))
        affine = np.eye(4)
        affine[:3, :3], affine[:3, 3] = rotation * [1.25, 0.5, 2], (7, -60.5, 33)
        for kind in ("u1", "i2", "f4"):
            voxels = (np.arange(4 * 5 * 6).reshape(4, 5, 6) % 200).astype(kind)
            image = nibabel.Nifti1Image(voxels, affine)
            image.header.set_xyzt_units("mm")
            nibabel.save(image, self.path("o.nii.gz"))
            for name in ("p.nii", "p.nii.gz", "p.mgh", "p.mgz"):
                self.succeeds("convert", "o.nii.gz", name, "-q")
                ours = nibabel.load(self.path(name))
                np.testing.assert_array_equal(np.asanyarray(ours.dataobj), voxels)
                np.testing.assert_allclose(ours.affine, affine, atol=2e-5)

    @needs_nibabel
    def test_every_type_and_scaling_comes_back_bit_for_bit_through_nifti(self):
        random = np.random.default_rng(7)
        for kind in ("u1", "i1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"):
            info = np.iinfo(kind) if kind[0] != "f" else None
            voxels = random.integers(info.min, info.max, (3, 4, 5), kind, True) if info else \
                random.normal(size=(3, 4, 5)).astype(kind)
            for slope, inter in ((1, 0), (0.25, -3), (1 / 255, 7.5)) if info and info.bits <= 32 else ((1, 0),):
                image = nibabel.Nifti1Image(voxels, np.diag([2, 3, 4, 1]), dtype=kind)
                image.header.set_xyzt_units("mm", "sec")
                image.header.set_slope_inter(slope, inter)
                nibabel.save(image, self.path("k.nii"))
                for name in ("l.nii", "l.nii.gz"):
                    self.assertEqual(self.converts("k.nii", name), "", (kind, slope))
                    ours = nibabel.load(self.path(name))
                    self.assertEqual(ours.get_data_dtype(), np.dtype(kind), (kind, slope))
                    np.testing.assert_array_equal(ours.dataobj.get_unscaled(), voxels)
                    self.assertEqual((ours.dataobj.slope, ours.dataobj.inter), (np.float32(slope), np.float32(inter)))
                said = self.converts("k.nii", "l.mgz")
                theirs, back = (nibabel.load(self.path(name)).get_fdata() for name in ("k.nii", "l.mgz"))
                self.assertEqual("Values are rounded" in said, not np.array_equal(theirs, back), (kind, slope, said))

    @needs_nibabel
    def test_every_frame_its_time_and_the_notes_of_the_header_are_kept(self):
        voxels = np.arange(2 * 3 * 4 * 3, dtype="i2").reshape(2, 3, 4, 3)
        image = nibabel.Nifti1Image(voxels, np.diag([1, 2, 3, 1]), None)
        image.header["descrip"], image.header["cal_max"] = b"mine", 9
        image.header.extensions.append(nibabel.nifti1.Nifti1Extension("comment", b"a word or two"))
        image.header.set_xyzt_units("mm", "msec")
        image.header["pixdim"][4] = 1500
        nibabel.save(image, self.path("t.nii"))
        for source, name in (("t.nii", "u.nii.gz"), ("u.nii.gz", "w.nii")):
            self.assertEqual(self.converts(source, name), "")
            ours = nibabel.load(self.path(name))
            np.testing.assert_array_equal(np.asanyarray(ours.dataobj), voxels)
            for field in ("descrip", "cal_max", "xyzt_units", "pixdim", "dim"):
                np.testing.assert_array_equal(ours.header[field], image.header[field], field)
            self.assertEqual(ours.header.extensions[0].get_content().rstrip(b"\0"), b"a word or two")
        self.assertIn("description, display range, extensions", self.converts("t.nii", "f.mgz"))
        ours = nibabel.load(self.path("f.mgz"))
        np.testing.assert_array_equal(np.asanyarray(ours.dataobj), voxels)
        self.assertEqual(ours.header["tr"], 1500)
        self.converts("f.mgz", "g.nii")
        self.assertEqual(nibabel.load(self.path("g.nii")).header.get_zooms()[3], 1.5)
        self.assertIn("2 other frames", self.converts("t.nii", "f.mgz", "--frame", "2"))
        np.testing.assert_array_equal(nibabel.load(self.path("f.mgz")).get_fdata(), voxels[..., 2])
        self.fails(5, "convert", "t.nii", "f.mgz", "--frame", "3")
        self.assertIn("--frame 0 to 2", self.fails(2, "sample", "t.nii", "lh.white", "-o", "s.vtp"))
        self.succeeds("sample", "t.nii", "lh.white", "-o", "s.vtp", "--frame", "1")

    def test_tags_and_scan_parameters_of_mgh_are_kept_in_mgh_and_said_lost_elsewhere(self):
        self.nifti("n.nii", 1, 0, 0)
        self.succeeds("convert", "n.nii", "a.mgh", "-q")
        notes = struct.pack(">5f", 2300, 0.5, 2.9, 900, 256) + struct.pack(">iq", 3, 12) + b"mri_convert\0"
        whole = self.bytes("a.mgh")[:284 + 48] + notes
        self.path("a.mgh").write_bytes(whole)
        for name in ("b.mgz", "b.mgh"):
            self.assertEqual(self.converts("a.mgh", name), "")
        self.assertEqual(self.bytes("b.mgh"), whole)
        self.assertEqual(gzip.decompress(self.bytes("b.mgz")), whole)
        self.assertIn("scan parameters, tags", self.converts("a.mgh", "c.nii"))
        self.assertAlmostEqual(struct.unpack_from("<f", self.bytes("c.nii"), 76 + 16)[0], 2.3, places=6)

    def test_transforms_that_disagree_are_refused_with_the_option_that_resolves_it(self):
        self.nifti("d.nii", 4, 1, 3)
        self.nifti("near.nii", 4, 1, 0.5)
        words = self.fails(2, "convert", "d.nii", "o.nii")
        self.assertIn("--transform sform or --transform qform", words)
        self.assertIn("3 mm", words)
        for verb in (("sample", "d.nii", "lh.white", "-o", "o.vtp"), ("extract", "d.nii", "-o", "folder")):
            self.assertIn("--transform", self.fails(2, *verb))
        for choice, origin, code, other in (("sform", 5, 4, "qform"), ("qform", 8, 1, "sform")):
            said = self.converts("d.nii", "o.nii", "--transform", choice)
            self.assertIn(f"The {other}, which puts voxels up to 3 mm elsewhere, is not kept", said)
            line = self.lines_of("o.nii")
            self.assertIn(f"sform, code {code}", line["space"])
            self.assertIn(f"NIfTI {choice}, code {code}", self.lines_of("d.nii", "--transform", choice)["space"])
            self.assertEqual(struct.unpack_from("<f", self.bytes("o.nii"), 292)[0], origin)
        self.assertIn("qform", self.converts("near.nii", "o.nii"))  # within half a voxel: said
        self.nifti("only.nii", 4, 0, 0)
        self.assertIn("qform", self.fails(5, "convert", "only.nii", "o2.nii", "--transform", "qform"))
        self.succeeds("convert", "only.nii", "o.mgh", "-q")
        self.assertIn("sform and qform", self.fails(5, "info", "o.mgh", "--transform", "qform"))
        self.fails(2, "convert", "lh.white", "o2.vtp", "--transform", "qform")

    def test_kinds_that_do_not_become_each_other_are_refused(self):
        volume = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        self.fails(5, "convert", volume, "s.vtp")
        self.fails(2, "convert", "lh.white", "v.nii")
        self.fails(2, "convert", volume, "v.nii", "--data", "lh.thickness")
        self.fails(2, "convert", "lh.white", "s.vtp", "--frame", "1")


@needs_nibabel
class Oracles(Formats):
    def setUp(self):
        super().setUp()
        self.succeeds("convert", "lh.white", "s.surf.gii", "-q")

    def test_nibabel_reads_what_convert_writes(self):
        points, faces, meta = nibabel.freesurfer.read_geometry(self.path("lh.white"), read_metadata=True)
        self.succeeds("convert", "s.surf.gii", "back.white", "-q")
        ours = nibabel.freesurfer.read_geometry(self.path("back.white"), read_metadata=True)
        np.testing.assert_allclose(ours[0], points, atol=1e-5)
        np.testing.assert_array_equal(ours[1], faces)
        np.testing.assert_allclose(ours[2]["cras"], meta["cras"])
        gifti = nibabel.load(self.path("s.surf.gii"))
        np.testing.assert_allclose(gifti.darrays[0].data, points @ np.array(D_P_INVERSE).T + meta["cras"], atol=1e-5)
        for name in ("t.shape.gii", "t.mgz"):
            self.succeeds("convert", "lh.thickness", name, "-q")
        np.testing.assert_array_equal(nibabel.load(self.path("t.shape.gii")).darrays[0].data, np.float32(self.values))
        np.testing.assert_array_equal(nibabel.load(self.path("t.mgz")).get_fdata().ravel(), np.float32(self.values))

    @unittest.skipUnless(shutil.which("wb_command"), "wb_command is not installed")
    def test_workbench_accepts_them_and_agrees_on_area_distortion(self):
        self.succeeds("map", "mean-value", "s.surf.gii", "-o", "m.vtp", "-q")
        self.succeeds("convert", "m.vtp", "m.surf.gii", "-q")
        for name in ("s.surf.gii", "m.surf.gii"):
            done = subprocess.run(["wb_command", "-file-information", self.path(name)], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
        subprocess.run(["wb_command", "-surface-distortion", self.path("s.surf.gii"), self.path("m.surf.gii"),
                        self.path("d.func.gii")], check=True, capture_output=True)
        theirs = nibabel.load(self.path("d.func.gii")).darrays[0].data
        before, after = (nibabel.load(self.path(name)).darrays[0].data.astype(float)
                         for name in ("s.surf.gii", "m.surf.gii"))
        faces = np.array(self.faces)

        def one_third_stars(points):
            a, b, c = points[faces].swapaxes(0, 1)
            area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
            return np.bincount(faces.ravel(), np.repeat(area / 3, 3)), area.sum()

        (old, old_sum), (new, new_sum) = one_third_stars(before), one_third_stars(after)
        np.testing.assert_allclose(theirs, np.log2(new / old), atol=1e-4)
        self.succeeds("convert", "m.vtp", "a.func.gii", "--array", "VertexAreaDistortion", "-q")
        ours = nibabel.load(self.path("a.func.gii")).darrays[0].data
        np.testing.assert_allclose(ours, theirs - np.log2(new_sum / old_sum), atol=1e-4)


class Hostile(Formats):
    def test_a_kilobyte_that_claims_a_cube_of_32767_is_refused_without_the_memory(self):
        mgh = struct.pack(">6i", 1, 32767, 32767, 32767, 1, 3).ljust(1024, b"\0")
        nifti = bytearray(1024)
        struct.pack_into("<i", nifti, 0, 348)
        struct.pack_into("<8h", nifti, 40, 3, 32767, 32767, 32767, 1, 1, 1, 1)
        struct.pack_into("<hh", nifti, 70, 16, 32)
        struct.pack_into("<4f", nifti, 76, 1, 1, 1, 1)
        struct.pack_into("<f", nifti, 108, 352)
        nifti[344:348] = b"n+1\0"
        surface = b"\xff\xff\xfex\n\n" + struct.pack(">ii", 2**29, 2**29)
        for name, data in (("c.mgh", mgh), ("c.nii", bytes(nifti)), ("c.nii.gz", gzip.compress(bytes(nifti))),
                           ("c.mgz", gzip.compress(mgh)), ("lh.c", surface.ljust(1024, b"\0"))):
            self.path(name).write_bytes(data)
            begin = time.monotonic()
            # Libraries alone take address space; 140 TB, or even 12 GB, would not fit.
            result = self.limited("info", name, setup="ulimit -v 2000000;")
            self.assertEqual(result.returncode, 5, (name, result.stderr))
            self.assertEqual(len(result.stderr.splitlines()), 1)
            self.assertLess(time.monotonic() - begin, 5, "0.1 s on an idle machine")


    def test_a_vtp_whose_arrays_claim_gigabytes_is_refused_without_the_memory(self):
        self.succeeds("convert", "lh.white", "s.vtp", "-q")
        whole = self.bytes("s.vtp")
        data = whole.index(b"_", whole.index(b"<AppendedData")) + 1
        offsets = [int(part.split(b'"')[1]) for part in whole[:data].split(b" offset=")[1:]]
        claims = ((2**31, 32768, 0), (2**20, 2**31, 1), (2**32 - 1,) * 3, (1, 32768, 8, 2**32 - 4))
        refused = 0
        for offset in offsets:
            for claim in claims:
                at, words = data + offset, base64.b64encode(struct.pack(f"<{len(claim)}I", *claim)).rstrip(b"=")
                self.path("c.vtp").write_bytes(whole[:at] + words + whole[at + len(words):])
                result = self.limited("info", "c.vtp", setup="ulimit -v 2000000;")
                self.assertIn(result.returncode, (0, 5), (offset, claim, result.stderr))  # 0: an array of no cells
                self.assertEqual(len(result.stderr.splitlines()), 1 if result.returncode else 0, result.stderr)
                refused += result.returncode == 5
        self.assertGreaterEqual(refused, 4 * len(claims))  # points, offsets, corners, a text

    def test_names_of_any_kind_are_read_and_written_and_what_is_no_file_is_refused_in_words(self):
        for name in ("with blank.vtp", "größe ☃.surf.gii", "no-ending", "-dash.vtp", "a\nb.ply", "two..dots.off",
                     "UP.VTP", "x" * 200 + ".obj"):
            path = "./" + name if name.startswith("-") else name
            self.succeeds("convert", "lh.white", path, "-q")
            self.assertIn("81", self.lines_of(path)["vertices"], name)
        self.path("folder.vtp").mkdir()
        self.path("empty.vtp").write_bytes(b"")
        self.path("loop.vtp").symlink_to("loop.vtp")
        self.path("gone.vtp").symlink_to("nowhere.vtp")
        os.mkfifo(self.path("fifo.vtp"))
        for name in ("folder.vtp", "empty.vtp", "loop.vtp", "gone.vtp", "fifo.vtp", "missing.vtp", "lh.white/x.vtp",
                     "x" * 300 + ".vtp", "/dev/null", "/dev/zero", "/proc/self/mem"):
            for words in (("info", name), ("convert", name, "o.vtp"), ("repair", name, "o.vtp"),
                          ("map", "tutte", name, "-o", "o.vtp"), ("convert", "lh.white", "o.vtp", "--data", name)):
                self.fails(5, *words)
        for name in ("folder.vtp", "loop.vtp", "fifo.vtp", "lh.white/x.vtp", "x" * 300 + ".vtp", "/dev/null"):
            self.fails(5, "convert", "lh.white", name)
        self.succeeds("convert", "lh.white", "gone.vtp", "-q")  # through the link
        self.assertTrue(self.path("gone.vtp").is_symlink() and self.path("nowhere.vtp").is_file())

    def test_coordinates_that_are_no_numbers_and_surfaces_without_faces_are_refused_by_every_reader(self):
        for value in (float("nan"), float("inf")):
            data = bytearray(self.bytes("lh.white"))
            struct.pack_into(">f", data, data.index(b"\n\n") + 10 + 12 * 7, value)
            self.path("lh.bad").write_bytes(bytes(data))
            for words in (("info", "lh.bad"), ("repair", "lh.bad", "o.vtp"), ("map", "tutte", "lh.bad", "-o", "o.vtp"),
                          *(("convert", "lh.bad", name) for name in ("o.surf.gii", "o.ply", "o.stl", "o.mz3", "lh.o"))):
                self.assertIn("vertex 7", self.fails(3, *words))
        self.path("none.off").write_text("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n")
        for words in (("repair", "none.off", "o.vtp"), ("map", "tutte", "none.off", "-o", "o.vtp")):
            self.assertRegex(self.fails(3, *words), "face|triangle")

    def test_mz3_is_repaired_and_its_dry_run_writes_nothing(self):
        white(self.path("plain.white"), geometry="")
        self.converts("plain.white", "s.mz3", "--data", "lh.thickness")
        result = self.run_verb("repair", "s.mz3", "--dry-run")
        self.assertEqual((result.returncode, "nothing to repair" in result.stderr), (0, True), result.stderr)
        data = bytearray(gzip.decompress(self.bytes("s.mz3")))
        faces = 16 + 12 * 5
        data[faces:faces + 8] = data[faces + 4:faces + 8] + data[faces:faces + 4]  # turned
        self.path("t.mz3").write_bytes(bytes(data))
        before = set(self.here.iterdir())
        result = self.run_verb("repair", "t.mz3", "--dry-run")
        self.assertIn("would be: 1 face turned round", result.stderr)
        self.assertEqual(set(self.here.iterdir()), before)
        self.succeeds("repair", "t.mz3", "r.mz3")
        self.assertIn("nothing to repair", self.run_verb("repair", "r.mz3", "--dry-run").stderr)


if __name__ == "__main__":
    main("test_formats.py")
