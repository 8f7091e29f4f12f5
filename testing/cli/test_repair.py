#!/usr/bin/python3
"""The verb repair: what it changes and says, what it leaves alone, what it refuses.

    test_repair.py --authalic PROGRAM --fixtures FOLDER --data FOLDER

Tests of meshes that are not in the repository skip where --data has none.
"""
import json
import math
import pathlib
import re

from command_line import ARGUMENTS, CommandLine, main

COLON = "colon/EdinGCA_3D_00020_CTC_inflated"


def read_off(path):
    words = iter(path.read_text().split()[1:])
    n, m, _ = (int(next(words)) for _ in range(3))
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(n)]
    return points, [tuple(int(next(words)) for _ in range(4))[1:] for _ in range(m)]


def write_off(path, points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"] + [" ".join(map(repr, p)) for p in points]
    path.write_text("\n".join(lines + ["3 %d %d %d" % tuple(f) for f in faces]) + "\n")
    return path


class Repair(CommandLine):
    def report(self, *words):
        """Of a repair that succeeds: its JSON and its lines on stderr."""
        result = self.run_verb("repair", *words, "--json", "r.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads((self.here / "r.json").read_text()), result.stderr.splitlines()

    def same_surface(self, one, other):
        """The same points in the same order, the same triangles in the same order, from whichever corner."""
        found = []
        for k, path in enumerate((one, other)):
            self.succeeds("convert", path, f"same{k}.off")
            points, faces = read_off(self.here / f"same{k}.off")
            found.append((points, [min(f, f[1:] + f[:1], f[2:] + f[:2]) for f in faces]))
        return found[0] == found[1]

    def damaged(self):
        """The sheet with one defect of each of several kinds, and how many the report must count."""
        points, faces = read_off(self.sheet)
        faces[200] = (faces[200][1], faces[200][0], faces[200][2])
        faces.append(faces[500])
        faces.append((7, 7, 9))
        points += [(0.0, 0.0, 9.0), (5.0, 5.0, 5.0), (5.1, 5.0, 5.0), (5.0, 5.1, 5.0)]
        faces.append((626, 627, 628))
        counts = {"flipped_faces": 1, "duplicate_faces": 1, "degenerate_faces": 1, "isolated_vertices": 1,
                  "stray_components": 1}
        return write_off(self.here / "damaged.off", points, faces), counts

    def test_a_clean_surface_stays_as_it_is_and_that_is_said(self):
        report, lines = self.report(self.sheet, "out.vtp")
        self.assertEqual((report["changed"], report["changes"], report["remaining"]), (0, {}, ""))
        self.assertEqual(lines, ["authalic: nothing to repair: points and triangles stay as they are, bit for bit"])
        self.assertTrue(self.same_surface(self.sheet, "out.vtp"))

    def test_every_change_is_counted_and_what_was_sound_is_left(self):
        path, counts = self.damaged()
        report, lines = self.report(path, "out.vtp")
        self.assertEqual({kind: entry["count"] for kind, entry in report["changes"].items()}, counts)
        self.assertEqual(report["changed"], len(lines))
        self.assertEqual(report["status"], "converged")
        stray = report["changes"]["stray_components"]["first"][0]
        self.assertAlmostEqual(stray["area_mm2"], 0.005, 9)
        self.assertAlmostEqual(math.dist(stray["place_mm"], (5.1 / 3 + 10 / 3, 5.1 / 3 + 10 / 3, 5)), 0, 9)
        self.assertTrue(self.same_surface(self.sheet, "out.vtp"))

    def test_a_dry_run_says_the_same_and_writes_no_surface(self):
        path, _ = self.damaged()
        wet, said = self.report(path, "out.vtp")
        (self.here / "r.json").unlink()
        before = set(self.here.iterdir())
        dry, would = self.report(path, "--dry-run")
        self.assertEqual(set(self.here.iterdir()) - before, {self.here / "r.json"})
        self.assertEqual({**dry, "dry_run": False}, wet)
        self.assertEqual([line.replace("would be: ", "") for line in would], said)
        self.assertTrue(all("would be: " in line for line in would))

    def test_a_second_repair_finds_nothing(self):
        path, _ = self.damaged()
        self.report(path, "once.vtp")
        report, _ = self.report("once.vtp", "twice.vtp")
        self.assertEqual(report["changed"], 0)
        self.assertTrue(self.same_surface("once.vtp", "twice.vtp"))

    def test_a_handle_is_listed_with_place_and_length_and_a_map_follows(self):
        torus = pathlib.Path(ARGUMENTS.fixtures) / "torus.off"
        report, lines = self.report(torus, "ball.vtp")
        handle, = report["changes"]["handles"]["first"]
        points = read_off(torus)[0]
        loop = [points[i] for i in handle["ids"]]
        length = sum(math.dist(loop[i], loop[i - 1]) for i in range(len(loop)))
        self.assertAlmostEqual(handle["length_mm"], length, 9)
        place = [sum(p[k] for p in loop) / len(loop) for k in range(3)]
        self.assertAlmostEqual(math.dist(handle["place_mm"], place), 0, 9)
        self.assertRegex(lines[0], r"^authalic: 1 handle cut and capped: [\d.]+ mm at \(.*\) mm$")
        self.assertEqual((report["topology"]["genus"], report["topology"]["euler_characteristic"]), (0, 2))
        self.succeeds("map", "sphere", "ball.vtp", "-o", "sphere.vtp")

    def test_options_say_what_is_a_defect(self):
        torus = pathlib.Path(ARGUMENTS.fixtures) / "torus.off"
        report, lines = self.report(torus, "t.vtp", "--largest-handle", "0")
        self.assertEqual((report["changed"], report["remaining"]), (0, "genus 1"))
        self.assertIn("genus 1", lines[0])
        path, _ = self.damaged()
        self.assertEqual(self.report(path, "d.vtp", "--stray-share", "0")[0]["remaining"], "2 components")
        points, faces = read_off(self.sheet)
        write_off(self.here / "hole.off", points, faces[:600] + faces[601:])
        self.assertEqual(self.report("hole.off", "h.vtp", "--largest-hole", "0")[0]["changed"], 0)
        closed = self.report("hole.off", "h.vtp", "--largest-hole", "0.3")[0]["changes"]
        self.assertEqual({kind: entry["count"] for kind, entry in closed.items()}, {"holes": 1})
        soup = [points[v] for face in faces for v in face]
        write_off(self.here / "soup.off", soup, [(3 * f, 3 * f + 1, 3 * f + 2) for f in range(len(faces))])
        self.assertEqual(self.report("soup.off", "s.vtp")[0]["topology"]["vertices"], len(points))
        self.assertIn("share no edge", self.fails(3, "repair", "soup.off", "s.vtp", "--keep-seams"))

    def test_wrong_use_is_2_and_files_that_cannot_be_5(self):
        self.assertIn("--dry-run", self.fails(2, "repair", self.sheet))
        for words in (("--largest-hole", "-1"), ("--largest-handle", "nan"), ("--stray-share", "1.5"),
                      ("--junction-tolerance", "0.2"), ("--junction-tolerance", "-1")):
            self.fails(2, "repair", self.sheet, "o.vtp", *words)
        self.fails(5, "repair", "missing.off", "o.vtp")
        for target in ("no/such/folder/x.vtp", "/dev/full"):
            self.fails(5, "repair", self.sheet, target)
            self.fails(5, "repair", self.sheet, "o.vtp", "--json", target)

    def test_what_cannot_be_repaired_is_3_with_the_reason(self):
        points, faces = read_off(self.sheet)
        write_off(self.here / "nan.off", [(math.nan, 0.0, 0.0)] + points[1:], faces)
        self.assertIn("vertex 0", self.fails(3, "repair", "nan.off", "o.vtp"))
        write_off(self.here / "flat.off", points[:4], [(0, 0, 1), (2, 3, 2)])
        self.assertIn("sound triangle", self.fails(3, "repair", "flat.off", "o.vtp"))
        band = [((2 + w * math.cos(math.pi * i / 24)) * math.cos(math.pi * i / 12),
                 (2 + w * math.cos(math.pi * i / 24)) * math.sin(math.pi * i / 12), w * math.sin(math.pi * i / 24))
                for i in range(24) for w in (-0.3, 0.3)]
        quads = [(2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 3) for i in range(23)] + [(46, 47, 1, 0)]
        write_off(self.here / "moebius.off", band, [f for a, b, c, d in quads for f in ((a, b, c), (b, d, c))])
        self.assertRegex(self.fails(3, "repair", "moebius.off", "o.vtp"), r"one-sided.*near \([-\d., ]+\) mm")

    def test_a_refusal_of_a_map_names_the_verb(self):
        path, _ = self.damaged()
        self.assertIn("authalic repair", self.fails(3, "map", "tutte", path, "-o", "m.vtp"))
        torus = pathlib.Path(ARGUMENTS.fixtures) / "torus.off"
        self.assertIn("authalic repair", self.fails(3, "map", "sphere", torus, "-o", "m.vtp"))

    def test_colon_segments_become_a_disk_an_annulus_and_a_poly_annulus_that_are_mapped(self):
        folder = pathlib.Path(ARGUMENTS.data) / COLON
        if not folder.is_dir():
            self.skipTest(f"{folder} is not there")
        accepted = "--allow-nonconverged"  # a closed tube this long does not reach the tolerance
        for name, loops, changes, method in (("A-DSJ", 1, {"handles": 3}, ("authalic", accepted)),
                                             ("SF+-HF-", 2, {"handles": 3},
                                              ("authalic", "--domain", "periodic-rectangle")),
                                             ("SF+-HF-", 2, {"handles": 3}, ("annulus",)),
                                             ("HF+-ICVc", 3, {"t_junctions": 1, "non_manifold_vertices": 1},
                                              ("circle-domain",))):
            report, _ = self.report(folder / f"large-intestine-{name}.vtk", "clean.vtp")
            self.assertEqual({k: e["count"] for k, e in report["changes"].items()}, changes)
            topology = report["topology"]
            self.assertEqual((topology["genus"], len(topology["boundary_loops"])), (0, loops))
            self.succeeds("map", *method, "clean.vtp", "-o", "m.vtp", "--report", "m.json")
            flat = json.loads((self.here / "m.json").read_text())
            self.assertEqual(flat["metrics"]["flipped_faces"], 0, name)

    def test_bad_meshes_are_repaired_or_refused_in_words(self):
        bad = pathlib.Path(ARGUMENTS.data) / "meshes" / "bad"
        if not bad.is_dir():
            self.skipTest(f"{bad} is not there")
        refused = {"moebius.obj": "one-sided", "soup.stl": "share no edge"}
        for path in sorted(bad.iterdir()):
            if path.name in refused:
                self.assertTrue(re.search(refused[path.name], self.fails(3, "repair", path, "o.vtp")), path)
                continue
            report, _ = self.report(path, "o.vtp")
            self.assertTrue(report["topology"]["oriented_manifold"], path)
            self.assertGreater(report["changed"], 0, path)
            self.assertEqual(self.report("o.vtp", "--dry-run")[0]["changed"], 0, path)


if __name__ == "__main__":
    main("test_repair.py")
