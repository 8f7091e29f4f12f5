#!/usr/bin/python3
"""The command line from outside: exit codes, one line per failure, nothing partial, same bytes at any thread count.

    test_cli.py --authalic PROGRAM --fixtures FOLDER --data FOLDER

Tests of meshes that are not in the repository skip where --data has none.
"""
import math
import pathlib
import signal
import subprocess
import time

from command_line import ARGUMENTS, CommandLine, grid, main


class Help(CommandLine):
    def test_every_verb_has_a_page_with_examples_and_exit_codes(self):
        for verb in ("info", "map", "weld", "cut", "extract", "sample", "elements", "density", "convert",
                     "repair"):
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
        self.fails(2, "map", "lie-flow", self.sheet, "-o", "m.vtp", "--keep-initial", "--domain", "sphere")

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
            if path == volume:
                self.assertIn("scanner-ras", self.succeeds("info", path))
            else:
                self.fails(5, "info", path)
            for words in (("map", "lie-flow", path, "-o", "m.vtp"), ("cut", path, "-o", "d.vtp"),
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
            if self.run_verb("info", path).returncode:
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
    main("test_cli.py")
