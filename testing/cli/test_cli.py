#!/usr/bin/python3
"""The command line from outside: exit codes, one line per failure, nothing partial, same bytes at any thread count.

    test_cli.py --authalic PROGRAM --fixtures FOLDER --data FOLDER

Tests of meshes that are not in the repository skip where --data has none.
"""
import argparse
import json
import math
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

ARGUMENTS = None


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


class Help(CommandLine):
    def test_every_verb_has_a_page_with_examples_and_exit_codes(self):
        for verb in ("info", "map", "weld", "cut", "extract", "sample", "elements", "convert"):
            page = self.succeeds(verb, "--help")
            for section in ("SYNOPSIS", "DESCRIPTION", "ARGUMENTS", "OPTIONS", "EXAMPLES", "EXIT CODES"):
                self.assertIn(section, page, verb)

    def test_defaults_are_shown(self):
        self.assertRegex(self.succeeds("map", "--help"), r"--tolerance X\n(?: {8}.*\n)*? {8}.*\(default: [\d.e-]+\)")


class Usage(CommandLine):
    def test_wrong_use_is_2(self):
        self.fails(2)
        self.fails(2, "fold", "x")
        self.fails(2, "map", "tutte")
        self.assertIn("lie-flow", self.fails(2, "map", "mercator", self.sheet, "-o", "m.vtp"))
        self.fails(2, "map", "tutte", self.sheet, "-o", "m.vtp", "--domain", "sphere")
        self.fails(2, "map", "tutte", self.sheet, "-o", "m.vtp", "--domain", "rectangle:wide")
        self.fails(2, "map", "tutte", self.sheet, "-o", "m.vtp", "--tolerance", "1")
        self.fails(2, "map", "lie-flow", self.sheet, "-o", "m.vtp", "--step-ratio", "3")
        self.fails(2, "map", "lie-flow", self.sheet, "-o", "m.vtp", "--threads", "-2")

    def test_numbers_out_of_range_are_2_in_short_sentences(self):
        for option, values in (("--tolerance", ("0", "-1", "nan", "x")), ("--max-iterations", ("-1", "1.5", "many")),
                               ("--step-ratio", ("0", "nan")), ("--fixed-step", ("-1", "nan"))):
            for value in values:
                words = self.fails(2, "map", "lie-flow", self.sheet, "-o", "m.vtp", option, value)
                self.assertLess(len(words), 160, words)

    def test_options_of_a_sphere_that_do_not_fit_are_2(self):
        sphere = pathlib.Path(ARGUMENTS.fixtures) / "folded_sphere.off"
        for words in (("--domain", "disk"), ("--initial", "tutte"), ("--rotation", "landmarks"),
                      ("--landmarks", "3", "3"), ("--landmarks", "3"), ("--landmarks", "3", "9999999"),
                      ("--rotation", "none", "--landmarks", "3", "4"), ("--punctured-face", "9999999"),
                      ("--tolerance", "0"), ("--step-ratio", "0.5")):
            self.fails(2, "map", "sphere", sphere, "-o", "m.vtp", *words)
        self.assertIn("sphere", self.fails(2, "map", "welding", sphere, "-o", "m.vtp", "--initial", "harmonic"))

    def test_a_domain_that_is_none_is_2(self):
        for domain in ("foo", "rectangle", "rectangle:", "rectangle:0", "rectangle:-1", "rectangle:nan",
                       "rectangle:1e9", "polygon:", "disk:3", "torus"):
            self.fails(2, "map", "tutte", self.sheet, "-o", "m.vtp", "--domain", domain)
        for corners in ("0 0\n1 0\n", "0 0\n1 0\n2 0\n", "0 0\n1 1\n1 0\n0 1\n", "0 0\n1 0\nnan 1\n",
                        "0 0\n0 0\n1 1\n"):
            (self.here / "corners.txt").write_text(corners)
            self.fails(2, "map", "tutte", self.sheet, "-o", "m.vtp", "--domain", "polygon:corners.txt")

    def test_a_measure_that_is_no_positive_density_is_2(self):
        for first in ("0", "-1", "nan", "inf"):
            (self.here / "measure.txt").write_text(f"{first}\n" + "1\n" * 624)
            words = self.fails(2, "map", "lie-flow", self.sheet, "-o", "m.vtp", "--measure", "measure.txt")
            self.assertIn("vertex 0", words)

    def test_a_measure_of_another_surface_is_3_and_one_that_is_not_there_2_or_5(self):
        for count in (624, 626):
            (self.here / "measure.txt").write_text("1\n" * count)
            self.assertIn("625", self.fails(3, "map", "tutte", self.sheet, "-o", "m.vtp", "--measure", "measure.txt"))
        self.assertIn("array", self.fails(2, "map", "tutte", self.sheet, "-o", "m.vtp", "--measure", "Importance"))
        self.assertIn("array", self.fails(5, "map", "tutte", self.sheet, "-o", "m.vtp", "--measure", "importance.txt"))
        self.fails(5, "map", "tutte", self.sheet, "-o", "m.vtp", "--measure", self.sheet)

    def test_names_of_outputs_that_do_not_fit_are_2(self):
        self.assertIn(".vtp", self.fails(2, "map", "tutte", self.sheet, "-o", "m.png"))
        self.assertIn("another kind", self.fails(2, "convert", self.sheet, "m.nii.gz"))
        self.assertIn("of its own", self.fails(2, "map", "tutte", self.sheet, "-o", "m.vtp", "--report", "./m.vtp"))

    def test_ranges_of_cut_sample_and_extract_are_checked(self):
        volume = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        sample = ("sample", volume, self.sheet, "-o", "s.vtp", "--space", "scanner-ras")
        self.fails(2, "cut", self.sheet, "-o", "d.vtp", "--plane", *"000000")
        self.fails(2, "cut", self.sheet, "-o", "d.vtp", "--plane", "nan", *"00001")
        self.fails(3, "cut", self.sheet, "-o", "d.vtp", "--plane", "0", "0", "9", *"00", "-1")
        self.fails(2, "cut", self.sheet, "-o", "d.vtp", "--smoothing", "-1")
        self.fails(2, *sample, "--depths", "0", "10", "0")
        self.fails(2, *sample, "--depths", "0", "1e9", "1e-9")
        self.assertIn("--other", self.fails(2, *sample, "--mode", "between-surfaces"))
        self.fails(2, *sample, "--labels", "-1")
        for option, value in (("--smoothing", "5000"), ("--sealing", "nan"), ("--threshold", "nan"),
                              ("--threshold", "-5"), ("--threshold", "1e9"), ("--faces", "-1")):
            self.fails(2, "extract", volume, "-o", "surfaces", option, value)

    def test_a_region_that_is_not_there_is_2_or_5(self):
        self.assertIn("MedialWall", self.fails(2, "cut", self.sheet, "-o", "d.vtp"))
        self.fails(5, "cut", self.sheet, "-o", "d.vtp", "--region", "missing.label")

    def test_sampling_a_surface_of_unknown_space_is_2(self):
        volume = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        self.assertIn("--space", self.fails(2, "sample", volume, self.sheet, "-o", "s.vtp"))


class Files(CommandLine):
    def test_missing_folder_empty_and_truncated_files_are_5(self):
        empty = self.here / "empty.vtp"
        empty.write_bytes(b"")
        truncated = self.here / "cut.off"
        truncated.write_text(self.sheet.read_text()[:4000])
        junk = self.here / "junk.gii"
        junk.write_bytes(bytes(range(256)) * 20)
        for path in ("missing.off", self.here, empty, truncated, junk, "/dev/null"):
            self.fails(5, "info", path)
            self.fails(5, "map", "tutte", path, "-o", "m.vtp")
        self.fails(5, "extract", junk, "-o", "surfaces")
        self.fails(5, "extract", self.sheet, "-o", "surfaces")

    def test_every_output_is_checked_before_any_is_written(self):
        volume = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        self.succeeds("convert", self.sheet, "sheet.vtp", "--space", "scanner-ras")
        self.succeeds("map", "tutte", "sheet.vtp", "-o", "map.vtp")
        (self.here / "folder.vtp").mkdir()
        plane = ("--plane", "0.5", "0.5", "0", "1", "0", "0")
        for target in ("no/such/folder/x.vtp", "folder.vtp", "sheet.off/x.vtp", "/proc/x.vtp", "/dev/full"):
            for words in (("info", self.sheet, "--json"), ("convert", self.sheet), ("cut", self.sheet, *plane, "-o"),
                          ("cut", self.sheet, *plane, "-o", "d.vtp", "--json"),
                          ("map", "tutte", self.sheet, "-o", "m.vtp", "--report"), ("elements", "map.vtp", "-o"),
                          ("elements", "map.vtp", "-o", "e.tsv", "--json"), ("sample", volume, "map.vtp", "-o"),
                          ("sample", volume, "map.vtp", "-o", "s.vtp", "--json")):
                self.fails(5, *words, target)
        for target in ("no/such/folder/x.vtp", "folder.vtp"):
            self.fails(5, "map", "tutte", self.sheet, "-o", target)
            self.fails(5, "elements", "map.vtp", "-o", "e.tsv", "--grid", target)
        self.fails(5, "extract", volume, "-o", "sheet.off")
        self.fails(5, "extract", volume, "-o", "/proc/surfaces")
        self.fails(5, "extract", volume, "-o", "surfaces", "--json", "no/such/folder/x.json")

    def test_altered_vtp_files_are_5_without_a_word_of_the_library(self):
        self.succeeds("convert", self.sheet, "sheet.vtp")
        good = (self.here / "sheet.vtp").read_bytes()
        points = b'NumberOfPoints="'
        altered = [good[: len(good) // 2], good[:-30], good.replace(b"</VTKFile>", b""),
                   good.replace(points, points + b"-"), good.replace(points, points + b"9"),
                   good.replace(points, points + b"99999999999"),
                   good.replace(b'NumberOfPolys="', b'NumberOfPolys="9'), good.replace(b'type="Float', b'type="Foo', 1),
                   good.replace(b'type="PolyData"', b'type="ImageData"'),
                   good.replace(b'offset="0"', b'offset="99999999"'),
                   good.replace(b"vtkZLibDataCompressor", b"vtkLZ9DataCompressor")]
        altered += [good[: at] + b"\xff<>\x00" + good[at + 4 :] for at in range(900, len(good) - 40, len(good) // 7)]
        for data in altered:
            (self.here / "altered.vtp").write_bytes(data)
            self.fails(5, "info", "altered.vtp")

    def test_a_file_of_another_kind_is_5_for_every_verb(self):
        volume = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        picture, text = self.here / "picture.off", self.here / "words.nii"
        picture.write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(300))
        text.write_text("hello world\n")
        for path in (volume, picture, text):
            for words in (("info", path), ("map", "lie-flow", path, "-o", "m.vtp"), ("cut", path, "-o", "d.vtp"),
                          ("sample", volume, path, "-o", "s.vtp"), ("elements", path, "-o", "e.tsv"),
                          ("convert", path, "c.vtp")):
                self.fails(5, *words)
        for path in (self.sheet, picture, text):
            self.fails(5, "extract", path, "-o", "surfaces")
            self.fails(5, "extract", volume, "--labels", path, "-o", "surfaces")
            self.fails(5, "sample", path, self.sheet, "-o", "s.vtp", "--space", "scanner-ras")

    def test_damaged_volumes_are_5(self):
        whole = (pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz").read_bytes()
        for data in (b"", whole[:40], whole[: len(whole) // 2], whole[:-4], bytes(4000)):
            (self.here / "damaged.nii.gz").write_bytes(data)
            self.fails(5, "sample", "damaged.nii.gz", self.sheet, "-o", "s.vtp", "--space", "scanner-ras")
            self.fails(5, "extract", "damaged.nii.gz", "-o", "surfaces")

    def test_edge_volumes_are_read_or_refused_in_one_sentence(self):
        edge = pathlib.Path(ARGUMENTS.data) / "volumes" / "edge"
        if not edge.is_dir():
            self.skipTest(f"{edge} is not there")
        for path in sorted(edge.iterdir()):
            self.fails(5, "info", path)
            words = ("sample", path, self.sheet, "-o", "s.vtp", "--space", "scanner-ras")
            code = self.run_verb(*words, "-q").returncode
            self.assertIn(code, (0, 2, 5), path)
            (self.here / "s.vtp").unlink(missing_ok=True)
            if code:
                self.fails(code, *words)

    def test_numbers_that_are_none_are_5(self):
        (self.here / "corners.txt").write_text("0 0\n1 zero\n0 1\n")
        words = self.fails(5, "map", "tutte", self.sheet, "-o", "m.vtp", "--domain", "polygon:corners.txt")
        self.assertIn("zero", words)


class Surfaces(CommandLine):
    def test_not_a_number_is_3(self):
        broken = self.here / "nan.off"
        volume = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        for bad in ("nan", "inf"):
            broken.write_text(self.sheet.read_text().replace("0.0 0.0 0.0", f"{bad} 0.0 0.0", 1))
            for words in (("info", broken), ("map", "tutte", broken, "-o", "m.vtp"), ("cut", broken, "-o", "d.vtp"),
                          ("sample", volume, broken, "-o", "s.vtp"), ("elements", broken, "-o", "e.tsv"),
                          ("convert", broken, "c.vtp")):
                self.assertIn("vertex 0", self.fails(3, *words))

    def test_what_is_no_disk_is_3_for_every_method(self):
        around = lambda i: (math.cos(math.pi * i / 12), math.sin(math.pi * i / 12))
        annulus = [(r * around(i)[0], r * around(i)[1], 0) for i in range(24) for r in (1, 2)]
        quads = [(2 * i, 2 * i + 1, (2 * i + 2) % 48, (2 * i + 3) % 48) for i in range(24)]
        band = [((2 + w * math.cos(math.pi * i / 24)) * around(i)[0],
                 (2 + w * math.cos(math.pi * i / 24)) * around(i)[1],
                 w * math.sin(math.pi * i / 24)) for i in range(24) for w in (-0.3, 0.3)]
        shapes = {"annulus": (annulus, quads), "moebius": (band, quads[:-1] + [(46, 47, 1, 0)]),
                  "two": ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)] * 2, [(0, 1, 2, 3), (4, 5, 6, 7)])}
        for name, (points, squares) in shapes.items():
            faces = [face for a, b, c, d in squares for face in ((a, b, c), (b, d, c))]
            lines = [f"OFF\n{len(points)} {len(faces)} 0"] + [f"{x} {y} {z}" for x, y, z in points]
            (self.here / f"{name}.off").write_text("\n".join(lines + [f"3 {a} {b} {c}" for a, b, c in faces]) + "\n")
            self.succeeds("info", f"{name}.off")
            for method in ("tutte", "harmonic", "mean-value", "lie-flow", "authalic"):
                self.assertIn("disk is required", self.fails(3, "map", method, f"{name}.off", "-o", "m.vtp"))

    def test_what_is_no_sphere_is_3_with_where_and_what_would_help(self):
        torus = pathlib.Path(ARGUMENTS.fixtures) / "torus.off"
        for method in ("sphere", "welding"):
            self.assertIn("genus 1", self.fails(3, "map", method, torus, "-o", "m.vtp"))
            words = self.fails(3, "map", method, self.sheet, "-o", "m.vtp")
            self.assertRegex(words, r"sphere is required.*1 boundary loop.* near \(.*\) mm; close it")

    def test_a_closed_surface_is_3(self):
        torus = pathlib.Path(ARGUMENTS.fixtures) / "torus.off"
        self.assertIn("boundary loop", self.fails(3, "map", "lie-flow", torus, "-o", "m.vtp"))

    def test_bad_meshes_are_3_for_a_map_and_described_by_info(self):
        bad = pathlib.Path(ARGUMENTS.data) / "meshes" / "bad"
        if not bad.is_dir():
            self.skipTest(f"{bad} is not there")
        for path in sorted(bad.iterdir()):
            self.fails(3, "map", "harmonic", path, "-o", "m.vtp")
            self.assertIn("Euler number", self.succeeds("info", path))


class Results(CommandLine):
    def test_info_counts(self):
        out = self.succeeds("info", self.sheet, "--json", "i.json")
        self.assertIn("vertices           625", out)
        report = json.loads((self.here / "i.json").read_text())
        self.assertEqual(report["space"], "unknown")
        self.assertIn("625", json.dumps(report))

    def test_a_map_has_its_arrays_and_report(self):
        self.succeeds("map", "mean-value", self.sheet, "-o", "m.vtp", "--report", "r.json", "--domain", "square")
        text = (self.here / "m.vtp").read_bytes()
        for name in (b"OriginalPoints", b"AreaDistortion", b"AngleDistortion", b"Flipped"):
            self.assertIn(name, text)
        report = json.loads((self.here / "r.json").read_text())
        self.assertEqual(report["status"], "converged")
        for member in ("iterations", "residual_history", "seconds", "metrics", "flips", "topology", "options",
                       "version"):
            self.assertIn(member, report)

    def test_conformal_maps_keep_angles(self):
        fixtures = pathlib.Path(ARGUMENTS.fixtures)
        for name, method, *words in (("bumpy_disk.off", "riemann"), ("bumpy_disk.off", "riemann", "--road", "puncture"),
                                     ("bumpy_disk.off", "riemann", "--centre", "face:3"),
                                     ("bumpy_disk.off", "yamabe", "--metric", "circle-packing"),
                                     ("bumpy_disk.off", "lscm", "--pins", "spectral"), ("bent_tube.off", "annulus"),
                                     ("bent_tube.off", "annulus", "--domain", "rectangle"),
                                     ("bent_tube.off", "circle-domain", "--road", "koebe")):
            self.succeeds("map", method, fixtures / name, "-o", "c.vtp", "--report", "c.json", "-q", *words)
            report = json.loads((self.here / "c.json").read_text())
            self.assertEqual((report["method"], report["status"], report["metrics"]["flipped_faces"]),
                             (method, "converged", 0), words)
            self.assertLess(report["metrics"]["angle_distortion"], 2.05, (method, words))

    def test_options_of_conformal_maps_that_do_nothing_are_2(self):
        disk = pathlib.Path(ARGUMENTS.fixtures) / "bumpy_disk.off"
        for words in (("riemann", "--puncture", 3), ("riemann", "--packing-radii", "tangent"), ("annulus", "--refine"),
                      ("yamabe", "--road", "koebe"), ("yamabe", "--domain", "free"), ("riemann", "--centre", "middle"),
                      ("lscm", "--tolerance", 1e-3), ("lscm", "--domain", "disk"), ("slim", "--domain", "square"),
                      ("riemann", "--outer-vertex", 1), ("riemann", "--domain", "free")):
            self.fails(2, "map", words[0], disk, "-o", "m.vtp", *words[1:])
        self.assertIn("boundary loops", self.fails(3, "map", "annulus", disk, "-o", "m.vtp"))

    def test_closed_surfaces_have_domains_of_their_own(self):
        torus = pathlib.Path(ARGUMENTS.fixtures) / "torus.off"
        self.succeeds("map", "authalic", torus, "-o", "t.vtp", "--domain", "torus", "--report", "t.json", "-q",
                      "--tolerance", 0.1)
        report = json.loads((self.here / "t.json").read_text())
        self.assertEqual(report["status"], "converged")
        self.assertEqual(report["options"]["domain"], "torus")
        self.assertLess(report["metrics"]["vertex_log_area_ratio_max_abs"], 1e-9)
        self.assertLess(report["seam_error"], 1e-12)
        self.assertIn(b"OriginalPointIds", (self.here / "t.vtp").read_bytes())
        self.assertIn("genus 1", self.fails(3, "map", "authalic", torus, "-o", "s.vtp", "--domain", "sphere"))
        self.assertIn("torus", self.fails(3, "map", "authalic", self.sheet, "-o", "s.vtp", "--domain", "torus"))
        self.assertIn("--initial", self.fails(2, "map", "authalic", torus, "-o", "s.vtp", "--domain", "torus",
                                              "--initial", "t.vtp"))

    def test_the_authalic_map_is_exact_at_every_vertex_of_every_domain(self):
        sphere = pathlib.Path(ARGUMENTS.fixtures) / "folded_sphere.off"
        triangle = self.here / "triangle.txt"
        triangle.write_text("0 0\n4 0\n0 3\n")
        disk = pathlib.Path(ARGUMENTS.fixtures) / "bumpy_disk.off"
        for surface, domain in ((disk, "disk"), (disk, "square"), (disk, "rectangle:2"),
                                (disk, f"polygon:{triangle}"), (sphere, "sphere")):
            self.succeeds("map", "authalic", surface, "-o", "m.vtp", "--domain", domain, "--report", "r.json", "-q")
            report = json.loads((self.here / "r.json").read_text())
            self.assertEqual(report["status"], "converged", domain)
            self.assertEqual(report["metrics"]["flipped_faces"], 0, domain)
            self.assertLess(report["metrics"]["vertex_log_area_ratio_max_abs"], 1e-9, domain)
        self.fails(2, "map", "authalic", disk, "-o", "m.vtp", "--balance", 0.5, "--domain", "square")
        self.fails(2, "map", "authalic", disk, "-o", "m.vtp", "--balance", 2)
        for option in ("--tolerance", "--vertex-tolerance"):
            self.fails(2, "map", "authalic", disk, "-o", "m.vtp", option, 0)

    def test_holes_have_their_areas_and_vertices_theirs(self):
        tube = pathlib.Path(ARGUMENTS.fixtures) / "bent_tube.off"
        self.succeeds("map", "authalic", tube, "-o", "h.vtp", "--domain", "annulus", "--hole-areas", 150, "--tolerance",
                      0.05, "--report", "h.json")
        report = json.loads((self.here / "h.json").read_text())
        self.assertEqual((report["status"], report["hole_areas"]), ("converged", [150]))
        self.assertLess(max(report["vertex_residual"], report["hole_residual"]), 1e-9)
        self.assertIn("need --domain", self.fails(2, "map", "authalic", self.sheet, "-o", "h.vtp", "--hole-areas", 1))
        self.assertIn("each of the 1", self.fails(2, "map", "authalic", tube, "-o", "h.vtp", "--domain", "annulus",
                                                  "--hole-areas", 1, 2))

    def test_transport_gives_cells_and_its_finish_says_both_costs(self):
        disk = pathlib.Path(ARGUMENTS.fixtures) / "bumpy_disk.off"
        bare = self.run_verb("map", "transport", disk, "-o", "t.vtp", "--cells", "c.vtp", "--report", "t.json")
        if "CGAL" in bare.stderr:
            self.skipTest(bare.stderr)
        self.assertEqual(bare.returncode, 0, bare.stderr)
        self.assertTrue((self.here / "c.vtp").exists())
        report = json.loads((self.here / "t.json").read_text())
        self.assertLess(report["transport_residual"], 1e-9)
        self.assertEqual(report["empty_cells"], 0)
        self.assertEqual(report["flips"] > 0, "folded" in bare.stderr)
        finished = self.run_verb("map", "transport", disk, "-o", "f.vtp", "--finish", "authalic", "--report", "f.json")
        report = json.loads((self.here / "f.json").read_text())
        self.assertEqual((report["status"], report["flips"]), ("converged", 0))
        self.assertIn("before the finish", finished.stderr)
        self.assertGreater(report["finished_cost"], report["displacement_cost"])
        (self.here / "arrow.txt").write_text("0 0\n2 1\n0 2\n1 1\n")
        self.assertIn("convex", self.fails(2, "map", "transport", disk, "-o", "t.vtp", "--domain", "polygon:arrow.txt"))
        self.assertIn("--finish must be", self.fails(2, "map", "transport", disk, "-o", "t.vtp", "--finish", "match"))

    def test_transport_takes_closed_surfaces_to_the_sphere(self):
        ball = pathlib.Path(ARGUMENTS.fixtures) / "folded_sphere.off"
        self.succeeds("map", "transport", ball, "-o", "s.vtp", "--domain", "sphere", "--cells", "c.vtp", "--report",
                      "s.json")
        report = json.loads((self.here / "s.json").read_text())
        self.assertEqual((report["method"], report["status"], report["empty_cells"]), ("transport", "converged", 0))
        self.assertLess(report["transport_residual"], 1e-9)
        self.assertIn("is not for --domain sphere", self.fails(2, "map", "transport", ball, "-o", "n.vtp", "--domain",
                                                               "sphere", "--initial", "riemann"))

    def test_not_converged_is_4_with_the_best_map_unless_allowed(self):
        words = ["map", "lie-flow", self.sheet, "-o", "m.vtp", "--tolerance", "1e-15", "--max-iterations", "1",
                 "--quiet"]
        result = self.run_verb(*words)
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertTrue((self.here / "m.vtp").exists())
        self.succeeds(*words, "--allow-nonconverged")

    def test_maps_and_reports_are_the_same_in_two_runs_and_at_any_thread_count(self):
        fixtures = pathlib.Path(ARGUMENTS.fixtures)
        surfaces = {"bumpy_disk.off": ("tutte", "harmonic", "mean-value", "lie-flow", "lie-advection", "authalic",
                                       "transport", "riemann", "yamabe", "lscm", "slim"),
                    "bent_tube.off": ("annulus", "circle-domain"), "folded_sphere.off": ("sphere", "welding")}
        for disk, method in ((fixtures / name, method) for name, methods in surfaces.items() for method in methods):
            maps, reports = [], []
            for name, threads in (("a", 1), ("b", 1), ("c", 2)):
                self.succeeds("map", method, disk, "-o", f"{name}.vtp", "--report", f"{name}.json",
                              "--threads", threads)
                maps.append((self.here / f"{name}.vtp").read_bytes())
                reports.append(json.loads((self.here / f"{name}.json").read_text()))
                self.assertGreater(reports[-1].pop("seconds")["total"], 0, method)
            for other in (1, 2):
                self.assertTrue(maps[0] == maps[other], f"{method}: bytes of the map differ")
                self.assertEqual(reports[0], reports[other], method)

    def test_a_sphere_has_the_same_bytes_at_any_thread_count_and_every_road_leads_to_it(self):
        sphere = pathlib.Path(ARGUMENTS.fixtures) / "folded_sphere.off"
        for words in (("sphere",), ("welding",), ("sphere", "--initial", "mean-curvature-flow"),
                      ("sphere", "--initial", "stereographic", "--rotation", "principal-axes")):
            for threads in (1, 2):
                self.succeeds("map", *words, sphere, "-o", f"{threads}.vtp", "--report", "r.json", "--threads", threads)
            self.assertTrue((self.here / "1.vtp").read_bytes() == (self.here / "2.vtp").read_bytes(), words)
            report = json.loads((self.here / "r.json").read_text())
            self.assertEqual((report["method"], report["status"], report["flips"]), (words[0], "converged", 0))
            self.assertLess(report["centre_of_mass"], 1e-10)
            self.assertLess(report["metrics"]["angle_distortion"], 2.05)

    def test_two_halves_weld_to_a_sphere_and_others_do_not(self):
        halves = [pathlib.Path(ARGUMENTS.fixtures) / f"{side}_shell.off" for side in ("upper", "lower")]
        maps = ["upper.vtp", "lower.vtp"]
        for half, image in zip(halves, maps):
            self.succeeds("map", "mean-value", half, "-o", image)
        self.succeeds("weld", *maps, "-o", "sphere.vtp", "--report", "r.json")
        report = json.loads((self.here / "r.json").read_text())
        self.assertEqual((report["method"], report["flips"], report["topology"]["euler_characteristic"]),
                         ("conformal-welding", 0, 2))
        self.assertLess(report["boundary_mismatch"], 1e-10)
        self.succeeds("map", "tutte", self.sheet, "-o", "sheet.vtp")
        self.assertIn("same number", self.fails(3, "weld", maps[0], "sheet.vtp", "-o", "s.vtp"))
        self.assertIn("OriginalPoints", self.fails(2, "weld", *halves, "-o", "s.vtp"))
        self.assertIn("Seam", self.fails(2, "weld", *maps, "-o", "s.vtp", "--signature", "Seam"))
        self.assertIn("is required", self.fails(3, "weld", maps[0], maps[0], "-o", "s.vtp"))

    def test_a_sphere_that_did_not_converge_is_4(self):
        sphere = pathlib.Path(ARGUMENTS.fixtures) / "folded_sphere.off"
        words = ["map", "sphere", sphere, "-o", "m.vtp", "--max-iterations", "1", "--quiet"]
        self.assertEqual(self.run_verb(*words).returncode, 4)
        self.succeeds(*words, "--allow-nonconverged")

    def test_elements_are_the_same_in_two_runs_and_at_any_thread_count(self):
        for name, threads in (("a", 1), ("b", 2), ("c", 2)):
            self.succeeds("map", "lie-flow", self.sheet, "-o", f"{name}.vtp", "--threads", threads,
                          "--allow-nonconverged", "-q")
            self.succeeds("elements", f"{name}.vtp", "-o", f"{name}.tsv", "--threads", threads)
        self.assertEqual((self.here / "a.tsv").read_bytes(), (self.here / "b.tsv").read_bytes())
        self.assertEqual((self.here / "b.tsv").read_bytes(), (self.here / "c.tsv").read_bytes())
        self.assertEqual(sorted(p.name for p in self.here.glob("?.json")), ["a.json", "b.json", "c.json"])

    def test_cut_map_sample_elements_in_a_chain(self):
        volume = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        self.succeeds("cut", self.sheet, "-o", "d.vtp", "--plane", "0.5", "0.5", "0", "1", "0", "0", "--smoothing", "0")
        self.succeeds("map", "lie-flow", "d.vtp", "-o", "m.vtp", "--allow-nonconverged", "-q")
        self.succeeds("sample", volume, "m.vtp", "-o", "s.vtp", "--space", "scanner-ras", "--name", "T1")
        self.succeeds("elements", "s.vtp", "-o", "e.tsv", "--elements", "16", "--hemi", "L", "--json", "g.json")
        header, *rows = (self.here / "e.tsv").read_text().splitlines()
        self.assertIn("t1_mean", header.split("\t"))
        self.assertGreater(len(rows), 8)
        self.assertTrue((self.here / "e.json").exists())

    def test_convert_keeps_coordinates_to_the_bit_through_off(self):
        self.succeeds("convert", self.sheet, "s.vtp")
        self.succeeds("convert", "s.vtp", "t.off")
        numbers = lambda path: [float(word) for word in path.read_text().split()[4:]]
        self.assertEqual(numbers(self.sheet), numbers(self.here / "t.off"))


class Signals(CommandLine):
    def interrupted(self, surface, delay, which):
        words = [ARGUMENTS.authalic, "map", "lie-flow", str(surface), "-o", "m.vtp", "--report", "r.json",
                 "--tolerance", "1e-14"]
        before = set(self.here.iterdir())
        process = subprocess.Popen(words, cwd=self.here, stderr=subprocess.PIPE, text=True)
        time.sleep(delay)
        process.send_signal(which)
        begin = time.monotonic()
        said = process.communicate(timeout=120)[1]
        self.assertEqual(process.returncode, 130, said)
        self.assertEqual(len(said.splitlines()), 1, said)
        self.assertLess(time.monotonic() - begin, 5, "2 s on an idle machine")
        self.assertEqual(set(self.here.iterdir()), before)

    def test_an_interrupt_is_130_and_leaves_nothing(self):
        self.interrupted(grid(self.here / "big.off", 220), 1.0, signal.SIGINT)

    def test_a_scan_is_left_at_any_stage(self):
        scan = pathlib.Path(ARGUMENTS.data) / "meshes" / "open_disk" / "human_brain.off"
        if not scan.is_file():
            self.skipTest(f"{scan} is not there")
        for delay, which in ((0.6, signal.SIGINT), (1.5, signal.SIGTERM), (4.0, signal.SIGINT)):
            self.interrupted(scan, delay, which)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for option in ("--authalic", "--fixtures", "--data"):
        parser.add_argument(option, required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    ARGUMENTS.authalic = os.path.abspath(ARGUMENTS.authalic)
    ARGUMENTS.fixtures = os.path.abspath(ARGUMENTS.fixtures)
    ARGUMENTS.data = os.path.abspath(ARGUMENTS.data)
    unittest.main(argv=["test_cli.py", *rest], verbosity=2)
