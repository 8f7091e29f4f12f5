#!/usr/bin/python3
"""What the command line makes of surfaces: maps, reports, tables.

    test_results.py --authalic PROGRAM --fixtures FOLDER --data FOLDER

Tests of meshes that are not in the repository skip where --data has none.
"""
import json
import math
import pathlib

from command_line import ARGUMENTS, CommandLine, main


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

    def test_surfaces_with_more_handles_become_flat_with_cones(self):
        fixtures = pathlib.Path(ARGUMENTS.fixtures)
        double = fixtures / "double_torus.off"
        self.succeeds("map", "authalic", double, "-o", "d.vtp", "--domain", "flat-cones", "--report", "d.json", "-q",
                      "--tolerance", 0.05)
        report = json.loads((self.here / "d.json").read_text())
        self.assertEqual(report["status"], "converged")
        self.assertEqual(report["options"]["domain"], "flat-cones")
        self.assertEqual(report["metrics"]["flipped_faces"], 0)
        self.assertLess(report["metrics"]["vertex_log_area_ratio_max_abs"], 1e-9)
        self.assertLess(report["seam_error"], 1e-9)
        self.assertLess(report["angle_error"], 1e-9)
        self.assertAlmostEqual(sum(2 * math.pi - cone["angle"] for cone in report["cones"]), -4 * math.pi)
        self.assertLess(max(seam["error"] for seam in report["seams"]), 1e-9)
        for name in (b"OriginalPointIds", b"ConeAngle", b"SeamPairs", b"SeamMotions"):
            self.assertIn(name, (self.here / "d.vtp").read_bytes())
        for fewer, genus, other in (("torus", 1, "torus"), ("folded_sphere", 0, "sphere")):
            words = self.fails(3, "map", "authalic", fixtures / f"{fewer}.off", "-o", "s.vtp", "--domain", "flat-cones")
            self.assertIn(f"genus {genus}", words)
            self.assertIn(f"for a {other}", words)
        self.assertIn("genus 2", self.fails(3, "map", "authalic", double, "-o", "s.vtp", "--domain", "torus"))
        self.assertIn("--initial", self.fails(2, "map", "authalic", double, "-o", "s.vtp", "--domain", "flat-cones",
                                              "--initial", "d.vtp"))

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

    def test_regions_of_interest_get_their_share_to_rounding(self):
        disk = pathlib.Path(ARGUMENTS.fixtures) / "bumpy_disk.off"
        points = [tuple(map(float, line.split())) for line in disk.read_text().splitlines()[2:1263]]
        label = ["#!ascii label", ""] + [f"{v} {p[0]} {p[1]} {p[2]} 0" for v, p in enumerate(points) if p[0] > 10]
        label[1] = str(len(label) - 2)
        (self.here / "east.label").write_text("\n".join(label) + "\n")
        (self.here / "rank.txt").write_text("\n".join(str(int(p[0] < -12)) for p in points) + "\n")
        said = self.run_verb("map", "authalic", disk, "-o", "m.vtp", "--report", "r.json", "--roi", "east.label=4",
                             "--roi", "rank.txt:1=0.25", "--roi", "sphere:0,0,21.7,9=16", "--roi-blend", 3,
                             "--tolerance", 0.1)
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertEqual(len([line for line in said.stderr.splitlines() if line.startswith("region ")]), 3)
        report = json.loads((self.here / "r.json").read_text())
        regions = report["regions"]
        self.assertEqual([r["name"] for r in regions], ["east.label", "rank.txt:1", "sphere:0,0,21.7,9"])
        self.assertEqual([r["factor"] for r in regions], [4, 0.25, 16])
        whole = 1 + sum((r["factor"] - 1) * r["source_share"] for r in regions)
        for r in regions:
            self.assertAlmostEqual(r["target_share"], r["factor"] * r["source_share"] / whole, delta=1e-11)
            self.assertAlmostEqual(r["image_share"], r["target_share"], delta=1e-9)
        self.assertEqual((report["status"], report["flips"]), ("converged", 0))
        self.succeeds("density", disk, "-o", "d.vtp", "-q", "--roi", "geodesic:0,0,21.7,9=4")
        self.succeeds("map", "authalic", "d.vtp", "-o", "n.vtp", "-q", "--measure", "RegionDensity", "--report",
                      "n.json")
        (region,) = json.loads((self.here / "n.json").read_text())["regions"]
        self.assertAlmostEqual(region["image_share"], region["target_share"], delta=1e-9)

    def test_regions_of_a_file_reach_a_surface_that_was_cut(self):
        sphere = pathlib.Path(ARGUMENTS.fixtures) / "folded_sphere.off"
        lines = sphere.read_text().splitlines()
        points = [tuple(map(float, line.split())) for line in lines[2:2 + int(lines[1].split()[0])]]
        (self.here / "side.txt").write_text("\n".join(str(int(p[0] > 12)) for p in points) + "\n")
        label = ["#!ascii label", ""] + [f"{v} 0 0 0 0" for v, p in enumerate(points) if p[0] > 12]
        label[1] = str(len(label) - 2)
        (self.here / "side.label").write_text("\n".join(label) + "\n")
        self.succeeds("cut", sphere, "-o", "cut.vtp", "--plane", 0, 0, -10, 0, 0, -1)
        shares = []
        for region in ("side.txt:1", "side.label"):
            self.succeeds("map", "authalic", "cut.vtp", "-o", "m.vtp", "-q", "--roi", f"{region}=4", "--report",
                          "r.json")
            (entry,) = json.loads((self.here / "r.json").read_text())["regions"]
            self.assertAlmostEqual(entry["image_share"], entry["target_share"], delta=1e-9)
            shares.append(entry["source_share"])
        self.assertEqual(*shares)
        self.assertGreater(shares[0], 0.2)

    def test_regions_that_cannot_be_are_refused_in_a_sentence(self):
        disk = pathlib.Path(ARGUMENTS.fixtures) / "bumpy_disk.off"
        (self.here / "flags.txt").write_text("1\n" * 1261)
        for region, words in (("flags.txt", "REGION=FACTOR"), ("flags.txt:1=", "factor above 0"),
                              ("flags.txt:1=0", "factor above 0"), ("flags.txt:1=-4", "factor above 0"),
                              ("flags.txt:1=nan", "factor above 0"), ("flags.txt:1=4", "it is everything"),
                              ("flags.txt:2=4", "it is empty"), ("flags.txt:V1=4", "table of region names"),
                              ("Nothing:1=4", "neither"), ("sphere:0,0,0=4", "four numbers"),
                              ("sphere:0,0,0,x=4", "four numbers"), ("sphere:0,0,900,5=4", "must reach"),
                              ("geodesic:0,0,21.7,900=4", "it is everything")):
            self.assertIn(words, self.fails(2, "map", "authalic", disk, "-o", "m.vtp", "--roi", region), region)
        self.assertIn("--roi", self.fails(2, "map", "authalic", disk, "-o", "m.vtp", "--roi-blend", 3))
        self.fails(2, "map", "authalic", disk, "-o", "m.vtp", "--roi", "sphere:0,0,21.7,9=4", "--roi-blend", -1)
        self.fails(2, "map", "authalic", disk, "-o", "m.vtp", "--curvature-weight", 0.5)
        self.fails(2, "map", "authalic", disk, "-o", "m.vtp", "--curvature-measure", "gaussian", "--curvature-weight",
                   1)
        self.fails(2, "density", disk, "-o", "m.vtp")
        self.fails(5, "map", "authalic", disk, "-o", "m.vtp", "--roi", "missing.label=4")

    def test_the_balance_is_a_number_or_a_weight_per_vertex_on_disk_and_sphere(self):
        fixtures = pathlib.Path(ARGUMENTS.fixtures)
        for name, count, domain in (("bumpy_disk.off", 1261, "disk"), ("folded_sphere.off", 4098, "sphere")):
            (self.here / "t.txt").write_text("\n".join(str(v % 2) for v in range(count)) + "\n")
            for balance in (0.5, "t.txt"):
                self.succeeds("map", "authalic", fixtures / name, "-o", "m.vtp", "--domain", domain, "--balance",
                              balance, "--report", "r.json", "-q")
                report = json.loads((self.here / "r.json").read_text())
                self.assertEqual((report["status"], report["flips"]), ("converged", 0), (name, balance))
                self.assertLess(report["vertex_residual"], 1e-9)
        self.assertIn("neither", self.fails(2, "map", "authalic", fixtures / name, "-o", "m.vtp", "--balance", "T",
                                            "--domain", "sphere"))
        (self.here / "t.txt").write_text("2\n" * count)
        self.assertIn("vertex 0", self.fails(2, "map", "authalic", fixtures / name, "-o", "m.vtp", "--balance", "t.txt",
                                             "--domain", "sphere"))

    def test_balanced_maps_lie_between_conformal_and_area_preserving(self):
        fixtures = pathlib.Path(ARGUMENTS.fixtures)
        for name, count, domain in (("bumpy_disk.off", 1261, "disk"), ("folded_sphere.off", 4098, "sphere")):
            surface, areas = fixtures / name, []
            (self.here / "t.txt").write_text("0.5\n" * count)
            for balance in ([], ["--balance", "t.txt"], ["--balance", 1]):
                self.succeeds("map", "balanced", surface, "-o", "m.vtp", "--domain", domain, *balance, "--report",
                              "r.json", "-q")
                report = json.loads((self.here / "r.json").read_text())
                self.assertEqual((report["status"], report["flips"]), ("converged", 0), (name, balance))
                areas.append(report["metrics"]["area_distortion"])
            self.assertEqual(areas[0], areas[1])
            self.assertLess(areas[2], min(2.001, areas[0]))
            self.assertIn("from 0", self.fails(2, "map", "balanced", surface, "-o", "m.vtp", "--domain", domain,
                                               "--balance", 2))
            self.succeeds("balance", surface, "-o", "c.tsv", "--at", 0.5, 1, "-q")
            header, *rows = (line.split("\t") for line in (self.here / "c.tsv").read_text().splitlines())
            self.assertEqual([float(row[0]) for row in rows], [0.5, 1])
            self.assertAlmostEqual(float(rows[0][header.index("area_distortion")]), areas[0], delta=2e-3)
            about = json.loads((self.here / "c.json").read_text())
            self.assertEqual(about["Curve"]["status"], "converged")
            self.assertTrue(set(header) <= set(about))
        self.fails(2, "balance", surface, "-o", "c.tsv", "--at", 1.5)
        self.fails(2, "balance", surface, "-o", "c.tsv", "--values", 1)
        self.fails(3, "balance", fixtures / "torus.off", "-o", "c.tsv")
        self.fails(2, "map", "balanced", fixtures / "bumpy_disk.off", "-o", "m.vtp", "--domain", "square")

    def test_curvature_may_be_the_measure(self):
        disk = pathlib.Path(ARGUMENTS.fixtures) / "bumpy_disk.off"
        (self.here / "k.txt").write_text("\n".join(str(v % 5) for v in range(1261)) + "\n")
        for curvature in ("gaussian", "k.txt"):
            self.succeeds("map", "authalic", disk, "-o", "m.vtp", "--curvature-measure", curvature, "--report",
                          "r.json", "-q", "--roi", "sphere:0,0,21.7,9=4")
            report = json.loads((self.here / "r.json").read_text())
            self.assertEqual(report["options"]["measure"], "RegionDensity")
            self.assertLess(report["metrics"]["vertex_log_area_ratio_max_abs"], 1e-9)

    def test_holes_have_their_areas_and_vertices_theirs(self):
        tube = pathlib.Path(ARGUMENTS.fixtures) / "bent_tube.off"
        self.succeeds("map", "authalic", tube, "-o", "h.vtp", "--domain", "annulus", "--hole-areas", 150, "--tolerance",
                      0.05, "--report", "h.json")
        report = json.loads((self.here / "h.json").read_text())
        self.assertEqual((report["status"], report["hole_areas"]), ("converged", [150]))
        self.assertLess(max(report["vertex_residual"], report["hole_residual"]), 1e-9)
        self.succeeds("map", "authalic", tube, "-o", "h.vtp", "--domain", "periodic-rectangle", "--report", "h.json")
        report = json.loads((self.here / "h.json").read_text())
        self.assertEqual((report["status"], report["flips"], report["pockets"]), ("converged", 0, 0))
        self.assertLess(report["vertex_residual"], 1e-9)
        self.assertIn("need --domain", self.fails(2, "map", "authalic", tube, "-o", "h.vtp", "--domain",
                                                  "periodic-rectangle", "--hole-areas", 150))
        self.assertIn("boundary loops", self.fails(3, "map", "authalic", self.sheet, "-o", "h.vtp", "--domain",
                                                   "periodic-rectangle"))
        self.assertIn("need --domain", self.fails(2, "map", "authalic", self.sheet, "-o", "h.vtp", "--hole-areas", 1))
        for domain in ("disk", "periodic-rectangle"):
            self.assertIn("need --domain", self.fails(2, "map", "authalic", tube, "-o", "h.vtp", "--domain", domain,
                                                      "--free-radii"))
        self.assertIn("free", self.fails(2, "map", "authalic", tube, "-o", "h.vtp", "--domain", "annulus",
                                         "--free-radii", "--hole-areas", 150))
        self.succeeds("map", "authalic", tube, "-o", "h.vtp", "--domain", "annulus", "--free-radii", "--tolerance",
                      0.05, "--report", "free.json")
        free = json.loads((self.here / "free.json").read_text())
        self.assertTrue(free["options"]["free_radii"] and not free["options"]["hold_centres"])
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

    def test_transport_takes_a_source_density(self):
        disk, ball = (pathlib.Path(ARGUMENTS.fixtures) / name for name in ("bumpy_disk.off", "folded_sphere.off"))
        self.succeeds("map", "transport", disk, "-o", "t.vtp", "--max-iterations", 0, "--allow-nonconverged")
        words = ("map", "transport", disk, "-o", "s.vtp", "--source", "t.vtp", "--source-density", "CellArea")
        self.succeeds(*words, "--report", "s.json")
        report = json.loads((self.here / "s.json").read_text())
        self.assertEqual((report["status"], report["options"]["source_density"]), ("converged", "CellArea"))
        self.assertLess(report["transport_residual"], 1e-9)
        self.assertGreater(report["source_mass"], 0)
        self.assertIn("belong together", self.fails(2, *words[:-2]))
        self.assertIn("belong together", self.fails(2, *words[:5], *words[7:]))
        self.assertIn("needs an array named", self.fails(2, *words[:-1], "rho"))
        self.assertIn("uniform source", self.fails(2, *words, "--finish", "authalic"))
        self.assertIn("source is uniform", self.fails(2, *words, "--domain", "sphere"))
        self.assertIn("covers the polygon", self.fails(3, *words, "--domain", "square"))
        self.assertIn("Source mesh: ", self.fails(3, *words[:6], ball, *words[7:]))

    def test_transport_starts_where_it_is_told(self):
        disk, tube = (pathlib.Path(ARGUMENTS.fixtures) / name for name in ("bumpy_disk.off", "bent_tube.off"))
        words = ("map", "transport", disk, "-o", "t.vtp", "--report", "t.json")
        for start, levels in ((None, 1), ("automatic", 1), ("voronoi", 1), ("coarse-to-fine", 2)):
            self.succeeds(*words, *(("--start", start) if start else ()))
            report = json.loads((self.here / "t.json").read_text())
            self.assertEqual((report["status"], report["options"]["start"]), ("converged", start or "automatic"))
            self.assertEqual(len(report["levels"]), levels)
            self.assertEqual(report["levels"][-1]["iterations"], report["iterations"])
        self.assertLess(report["levels"][0]["sites"], report["levels"][1]["sites"])
        self.succeeds("map", "transport", tube, "-o", "h.vtp", "--domain", "circle-domain", "--start", "coarse-to-fine",
                      "--report", "h.json")
        report = json.loads((self.here / "h.json").read_text())
        self.assertEqual((report["status"], report["options"]["start"]), ("converged", "coarse-to-fine"))
        self.assertEqual(report["levels"][-1]["iterations"], report["iterations"])
        self.assertIn("must be", self.fails(2, *words, "--start", "tutte"))
        self.assertIn("is not for --domain sphere", self.fails(2, *words, "--domain", "sphere", "--start", "voronoi"))

    def test_transport_takes_closed_surfaces_to_the_sphere(self):
        ball = pathlib.Path(ARGUMENTS.fixtures) / "folded_sphere.off"
        self.succeeds("map", "transport", ball, "-o", "s.vtp", "--domain", "sphere", "--cells", "c.vtp", "--report",
                      "s.json")
        report = json.loads((self.here / "s.json").read_text())
        self.assertEqual((report["method"], report["status"], report["empty_cells"]), ("transport", "converged", 0))
        self.assertLess(report["transport_residual"], 1e-9)
        self.assertIn("is not for --domain sphere", self.fails(2, "map", "transport", ball, "-o", "n.vtp", "--domain",
                                                               "sphere", "--initial", "riemann"))

    def test_transport_in_a_stereographic_plane_tells_its_pole(self):
        ball, disk = (pathlib.Path(ARGUMENTS.fixtures) / name for name in ("folded_sphere.off", "bumpy_disk.off"))
        words = ("map", "transport", "-o", "s.vtp", "--domain", "sphere", "--report", "s.json", ball)
        self.succeeds(*words[:-1], "--formulation", "stereographic", "--pole", 0, 0, -4, ball)
        report = json.loads((self.here / "s.json").read_text())
        self.assertEqual((report["status"], report["pole"]), ("converged", [0, 0, -1]))
        self.assertEqual(report["options"]["formulation"], "stereographic")
        self.assertNotIn("transport_cost", report)
        self.assertIn("needs --formulation", self.fails(2, *words, "--pole", 0, 0, 1))
        self.assertIn("is no direction", self.fails(2, *words, "--formulation", "stereographic", "--pole", 0, 0, 0))
        self.assertIn("finite pole", self.fails(2, *words, "--formulation", "stereographic", "--pole", 0, "nan", 1))
        self.assertIn("must be", self.fails(2, *words, "--formulation", "mercator"))
        self.assertIn("need --domain sphere", self.fails(2, "map", "transport", disk, "-o", "d.vtp", "--formulation",
                                                         "stereographic"))

    def test_transport_fills_holes_with_masses_of_their_own(self):
        tube = pathlib.Path(ARGUMENTS.fixtures) / "bent_tube.off"
        words = ("map", "transport", tube, "-o", "h.vtp", "--domain", "circle-domain")
        self.succeeds(*words, "--cells", "c.vtp", "--report", "h.json", "--hole-share", 0.2)
        report = json.loads((self.here / "h.json").read_text())
        self.assertEqual((report["method"], report["status"], report["empty_cells"]), ("transport", "converged", 0))
        self.assertEqual((report["options"]["domain"], report["options"]["hole_share"]), ("circle-domain", 0.2))
        self.assertLess(report["transport_residual"], 1e-9)
        self.assertTrue((self.here / "c.vtp").exists())
        self.succeeds(*words, "--report", "f.json", "--hole-areas", 650, "--finish", "authalic")
        report = json.loads((self.here / "f.json").read_text())
        self.assertEqual((report["status"], report["flips"], report["hole_areas"]), ("converged", 0, [650]))
        self.assertLess(report["hole_residual"], 1e-12)
        for code, options, said in ((2, ("--hole-share", 1), "below 1"), (2, ("--hole-areas", 1, 2), "each of the 1"),
                                    (2, ("--initial", "riemann"), "leave it out"), (2, ("--balance", 0.5), "balance")):
            self.assertIn(said, self.fails(code, *words, *options))
        self.assertIn("need --domain", self.fails(2, "map", "transport", tube, "-o", "h.vtp", "--hole-share", 0.2))
        disk = pathlib.Path(ARGUMENTS.fixtures) / "folded_sphere.off"
        self.assertIn("boundary", self.fails(3, "map", "transport", disk, "-o", "h.vtp", "--domain", "circle-domain"))

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
                                       "transport", "stretch", "stretch-energy",
                                       "riemann", "yamabe", "lscm", "slim"),
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

    def test_lie_flows_reach_their_domains_and_refuse_options_of_others(self):
        fixtures = pathlib.Path(ARGUMENTS.fixtures)
        (self.here / "l.txt").write_text("0 0\n2 0\n2 1\n1 1\n1 2\n0 2\n")
        for method, name, domain in (("lie-flow", "folded_sphere.off", "sphere"),
                                     ("lie-flow", "bent_tube.off", "circle-domain"),
                                     ("lie-flow", "bent_tube.off", "annulus"),
                                     ("lie-flow", "bent_tube.off", "periodic-rectangle"),
                                     ("lie-flow", "bumpy_disk.off", "polygon:l.txt"),
                                     ("lie-advection", "folded_sphere.off", "sphere"),
                                     ("lie-advection", "bumpy_disk.off", "rectangle:2")):
            maps = []
            for threads in (1, 2):
                self.succeeds("map", method, fixtures / name, "-o", "m.vtp", "--report", "r.json", "--domain", domain,
                              "--threads", threads, "--allow-nonconverged")
                maps.append((self.here / "m.vtp").read_bytes())
            report = json.loads((self.here / "r.json").read_text())
            self.assertEqual((report["method"], report["flips"]), (method, 0), domain)
            self.assertLess(report["metrics"]["area_distortion"], 2.1, domain)
            self.assertEqual(*maps)
        ball, disk = fixtures / "folded_sphere.off", fixtures / "bumpy_disk.off"
        self.assertIn("--hole-areas", self.fails(2, "map", "lie-flow", ball, "-o", "n.vtp", "--domain", "sphere",
                                                 "--hole-areas", "5"))
        self.assertIn("--initial tutte", self.fails(2, "map", "lie-flow", ball, "-o", "n.vtp", "--domain", "sphere",
                                                    "--initial", "tutte"))
        self.fails(2, "map", "lie-advection", disk, "-o", "n.vtp", "--hole-areas", "5")
        self.fails(3, "map", "lie-flow", disk, "-o", "n.vtp", "--domain", "sphere")
        self.fails(3, "map", "lie-advection", disk, "-o", "n.vtp", "--domain", "sphere")

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


if __name__ == "__main__":
    main("test_results.py")
