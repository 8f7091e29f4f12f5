#!/usr/bin/python3
"""authalic.flatten: arrays in and out, the numbers of the filters, every failure in words, progress and
interrupts."""
import inspect
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest
import warnings

import numpy as np

import authalic
from authalic import _classes, _maps

DATA = pathlib.Path(__file__).parents[2] / "data"


def bumpy_disk():
    surface = authalic.read_surface(DATA / "bumpy_disk.off")
    return surface.points, surface.faces


def surface_for(method):
    """A surface of the topology that a method takes."""
    topology = _maps.METHODS[method].surface
    if topology == "sphere":
        surface = authalic.read_surface(DATA / "folded_sphere.off")
        return surface.points, surface.faces
    if topology in ("torus", "flat-cones"):
        surface = authalic.read_surface(DATA / ("torus.off" if topology == "torus" else "double_torus.off"))
        return surface.points, surface.faces
    points, faces = bumpy_disk()
    if topology == "disk":
        return points, faces
    kept = np.linalg.norm(points[faces].mean(axis=1)[:, :2], axis=1) > np.ptp(points[:, 0]) / 6
    used, corners = np.unique(faces[kept], return_inverse=True)
    return points[used], corners.reshape(-1, 3)


def square_sheet(n=12):
    """A flat unit square of 2 n² triangles."""
    x, y = np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1), indexing="ij")
    at = np.arange((n + 1)**2).reshape(n + 1, n + 1)
    a, b, c, d = (s.ravel() for s in (at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]))
    return np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()]), np.concatenate(
        [np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def shares(image, faces):
    """Signed area of each face as a part of the whole."""
    a, b, c = (image[faces[:, k]] for k in range(3))
    areas = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    return areas / areas.sum()


class Results(unittest.TestCase):
    def test_every_method_gives_an_image_without_folds_and_the_surface_back(self):
        for method in authalic.methods():
            points, faces = surface_for(method)
            result = authalic.flatten(points, faces, method=method)
            self.assertEqual(len(result.image), len(result.points), method)
            ids = result.point_arrays.get("OriginalPointIds", np.arange(len(points)))  # where the map cuts the surface
            self.assertTrue(np.array_equal(result.points, points[ids]), method)
            self.assertTrue(np.array_equal(ids[result.faces], faces), method)
            self.assertTrue(result.converged, method)
            self.assertEqual(result.metrics["flipped_faces"], 0, method)
            self.assertIn(result.report["method"], method)

    def test_the_domain_sphere_makes_the_spherical_map_of_authalic(self):
        ball = authalic.read_surface(DATA / "folded_sphere.off")
        result = authalic.flatten(ball, domain="sphere", tolerance=0.03)
        self.assertTrue(np.array_equal(result.image,
                                       authalic.flatten(ball, method="authalic-sphere", tolerance=0.03).image))
        self.assertLess(np.abs(np.linalg.norm(result.image, axis=1) - 1).max(), 1e-12)
        self.assertLess(np.abs(result.point_arrays["VertexAreaDistortion"]).max(), 1e-9)

    def test_the_default_preserves_areas_where_the_harmonic_map_does_not(self):
        points, faces = bumpy_disk()
        corners = points[faces]
        native = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        native /= native.sum()
        off = {method: np.abs(shares(authalic.flatten(points, faces, method).image, faces) / native - 1)
               for method in ("authalic", "harmonic")}
        self.assertLess(off["authalic"].max(), 0.15)
        self.assertGreater(off["harmonic"].max(), 1.0)

    def test_has_the_bits_of_the_filter(self):
        points, faces = bumpy_disk()
        result = authalic.flatten(points, faces, domain="square", tolerance=1e-3)
        exact = authalic.vtkAuthalicMap()
        exact.SetInputData(authalic.Surface(points, faces).to_vtk())
        exact.SetDomainToSquare()
        exact.SetTolerance(1e-3)
        exact.Update()
        again = authalic.SurfaceMap.from_filter(exact)
        self.assertTrue(np.array_equal(result.image, again.image))
        self.assertEqual(result.metrics, again.metrics)
        self.assertTrue(np.array_equal(result.face_arrays["AreaDistortion"], again.face_arrays["AreaDistortion"]))

    def test_has_the_bits_of_the_command(self):
        command = pathlib.Path(os.environ.get("AUTHALIC_BINARY_DIR", ""), "bin/authalic")
        if not command.exists():
            self.skipTest(f"{command} is not there")
        with tempfile.TemporaryDirectory() as here:
            disk, image = str(DATA / "bumpy_disk.off"), f"{here}/map.vtp"
            subprocess.run([str(command), "map", "authalic", disk, "-o", image, "--quiet"], check=True)
            self.assertTrue(np.array_equal(authalic.read_surface(image).points[:, :2],
                                           authalic.flatten(authalic.read_surface(disk)).image))

    def test_options_left_out_have_the_defaults_of_the_filter(self):
        exact = authalic.vtkAuthalicMap()
        report = authalic.flatten(*bumpy_disk()).report["options"]
        self.assertEqual(report["tolerance"], exact.GetTolerance())
        self.assertEqual(report["max_iterations"], exact.GetMaximumIterations())
        self.assertEqual(report["domain"], "disk")

    def test_a_flat_square_stays_where_it_is(self):
        points, faces = square_sheet()
        image = authalic.flatten(points, faces, "harmonic", "square").image
        moved = [np.abs(turn(image) - points[:, :2]).max() for turn in
                 (lambda p: p, lambda p: np.column_stack([p[:, 1], 1 - p[:, 0]]), lambda p: 1 - p,
                  lambda p: np.column_stack([1 - p[:, 1], p[:, 0]]))]
        self.assertLess(min(moved), 1e-12)

    def test_every_domain(self):
        points, faces = bumpy_disk()
        rectangle = authalic.flatten(points, faces, "tutte", ("rectangle", 3.0)).image
        self.assertTrue(np.allclose([rectangle.min(axis=0), rectangle.max(axis=0)], [(0, 0), (3, 1)]))
        triangle = authalic.flatten(points, faces, "tutte", [(0, 0), (4, 0), (0, 5)]).image
        self.assertTrue(np.allclose(triangle.max(axis=0), (4, 5)))
        disk = authalic.flatten(points, faces, "tutte", "disk").image
        self.assertAlmostEqual(np.linalg.norm(disk, axis=1).max(), 1.0)

    def test_a_measure_per_face_and_per_vertex_enlarges_its_region(self):
        points, faces = bumpy_disk()
        inside = np.linalg.norm(points[:, :2] - points[:, :2].mean(axis=0), axis=1) < np.ptp(points[:, 0]) / 6
        for measure, chosen in ((np.where(inside, 4.0, 1.0), inside[faces].all(axis=1)),
                                (np.where(inside[faces].all(axis=1), 4.0, 1.0), inside[faces].all(axis=1))):
            plain, larger = (shares(authalic.flatten(points, faces, measure=m).image, faces)[chosen].sum()
                             for m in (None, measure))
            self.assertGreater(larger, 2.5 * plain)

    def test_starts_from_a_name_an_image_or_a_map(self):
        points, faces = bumpy_disk()
        start = authalic.flatten(points, faces, "mean-value")
        images = [
            authalic.flatten(points, faces, initial=initial).image
            for initial in ("mean-value", start, start.image)
        ]
        self.assertTrue(np.array_equal(images[0], images[1]) and np.array_equal(images[1], images[2]))
        self.assertFalse(np.array_equal(images[0], authalic.flatten(points, faces).image))

    def test_lie_flows_of_spheres_and_holes_take_a_measure_and_hole_areas(self):
        ball = authalic.read_surface(DATA / "folded_sphere.off")
        measure = np.where(ball.points[:, 0] > 0, 3.0, 1.0)
        for method in ("lie-flow", "lie-advection"):
            result = authalic.flatten(ball, domain="sphere", method=method, measure=measure)
            self.assertEqual((result.image.shape, result.metrics["flipped_faces"]), (ball.points.shape, 0), method)
            self.assertLess(result.metrics["area_distortion"], 2.05, method)
        tube = authalic.read_surface(DATA / "bent_tube.off")
        result = authalic.flatten(tube, method="lie-flow-holes", hole_areas=[150], on_not_converged="ignore")
        self.assertEqual(result.metrics["flipped_faces"], 0)
        self.assertLess(result.report["hole_residual"], 1e-9)

    def test_holes_get_the_areas_that_they_are_given(self):
        tube = authalic.read_surface(DATA / "bent_tube.off")
        result = authalic.flatten(tube, method="authalic-holes", hole_areas=[150], domain="annulus", tolerance=0.05)
        self.assertEqual((result.status, result.metrics["flipped_faces"]), ("converged", 0))
        self.assertLess(result.metrics["vertex_log_area_ratio_max_abs"], 1e-9)
        self.assertLess(result.report["hole_residual"], 1e-9)
        self.assertEqual(result.report["hole_areas"], [150])
        with self.assertRaisesRegex(authalic.InvalidArgument, "hole_areas"):
            authalic.flatten(tube, method="annulus", hole_areas=[150])
        free = authalic.flatten(tube, method="authalic-holes", domain="annulus", tolerance=0.05, free_radii=True)
        self.assertEqual((free.status, free.metrics["flipped_faces"]), ("converged", 0))
        self.assertNotEqual(free.report["hole_areas"], [150])
        self.assertLess(free.report["hole_residual"], 1e-9)
        with self.assertRaisesRegex(authalic.InvalidArgument, "free"):
            authalic.flatten(tube, method="authalic-holes", hole_areas=[150], free_radii=True)

    def test_transport_in_a_stereographic_plane_depends_on_the_pole(self):
        ball = authalic.read_surface(DATA / "folded_sphere.off")
        words = {"method": "transport", "domain": "sphere", "formulation": "stereographic"}
        one, other = (authalic.flatten(ball, pole=pole, **words) for pole in ((0, 0, 2), (0, 1, 0)))
        self.assertEqual((one.status, other.status), ("converged", "converged"))
        self.assertEqual((one.report["pole"], other.report["pole"]), ([0, 0, 1], [0, 1, 0]))
        self.assertGreater(np.abs(one.image - other.image).max(), 1e-3)
        self.assertNotIn("transport_cost", one.report)
        for pole in ((0, np.nan, 1), (0, 1), "north"):
            with self.assertRaises(authalic.InvalidArgument):
                authalic.flatten(ball, pole=pole, **words)
        with self.assertRaisesRegex(authalic.InvalidArgument, "stereographic"):
            authalic.flatten(ball, method="transport", domain="sphere", pole=(0, 0, 1))
        with self.assertRaisesRegex(authalic.InvalidArgument, "formulation must be one of"):
            authalic.flatten(ball, method="transport", domain="sphere", formulation="mercator")

    def test_transport_from_a_source_density_gives_cells_their_shares_of_it(self):
        surface = authalic.read_surface(DATA / "bumpy_disk.off")
        plane = authalic.flatten(surface)
        density = 1.5 + plane.image[:, 0]
        moved = authalic.flatten(surface, method="transport", source=plane, source_density=density)
        self.assertEqual(moved.status, "converged")
        self.assertAlmostEqual(moved.report["source_mass"], 1.5 * np.pi, 2)
        self.assertAlmostEqual(moved.point_arrays["CellMass"].sum(), moved.report["source_mass"], 12)
        named = plane.with_point_arrays({"rho": density})
        again = authalic.flatten(surface, method="transport", source=named, source_density="rho")
        bare = authalic.flatten(surface, method="transport", source=(plane.image, plane.faces), source_density=density)
        np.testing.assert_array_equal(again.image, moved.image)
        np.testing.assert_array_equal(bare.image, moved.image)
        words = {"method": "transport", "source": plane, "source_density": density}
        for error, text, change in (
                (authalic.InvalidArgument, "belong together", {"source": None}),
                (authalic.InvalidArgument, "belong together", {"source_density": None}),
                (authalic.InvalidArgument, "shape", {"source_density": density[:7]}),
                (authalic.InvalidArgument, "positive", {"source_density": density - 2}),
                (authalic.InvalidArgument, "uniform source", {"finish": "authalic"}),
                (authalic.InvalidArgument, "uniform source", {"balance": 0.5}),
                (authalic.InvalidArgument, "takes no source", {"method": "authalic"}),
                (authalic.SurfaceError, "covers the polygon", {"domain": "square"})):
            with self.assertRaisesRegex(error, text):
                authalic.flatten(surface, **{**words, **change})

    def test_transport_fills_holes_and_the_finish_makes_them_round(self):
        tube = authalic.read_surface(DATA / "bent_tube.off")
        bare = authalic.flatten(tube, method="transport-holes", hole_share=0.25)
        self.assertEqual(bare.status, "converged")
        self.assertLess(bare.report["transport_residual"], 1e-9)
        area = np.linalg.norm(np.cross(*(tube.points[tube.faces[:, k]] - tube.points[tube.faces[:, 0]]
                                         for k in (1, 2))), axis=1).sum() / 2
        self.assertAlmostEqual(bare.report["hole_areas"][0] / area, 1 / 3, 9)
        round_one = authalic.flatten(tube, method="transport", domain="holes", hole_share=0.25, finish="authalic")
        self.assertEqual((round_one.status, round_one.metrics["flipped_faces"]), ("converged", 0))
        self.assertLess(round_one.metrics["vertex_log_area_ratio_max_abs"], 1e-9)
        with self.assertRaisesRegex(authalic.InvalidArgument, "below 1"):
            authalic.flatten(tube, method="transport-holes", hole_share=1)

    def test_tubes_go_to_the_periodic_rectangle_cut_open(self):
        tube = authalic.read_surface(DATA / "bent_tube.off")
        for method in ("authalic-holes", "lie-flow-holes"):
            result = authalic.flatten(tube, method=method, domain="periodic-rectangle")
            self.assertEqual((result.status, result.metrics["flipped_faces"]), ("converged", 0), method)
            original = result.point_arrays["OriginalPointIds"]
            copies = result.image[len(tube.points):] - result.image[original[len(tube.points):]]
            self.assertEqual(len(copies), len(result.report["cut"]))
            np.testing.assert_allclose(np.abs(copies), [[1, 0]] * len(copies), atol=1e-12)
            area = result.report["height"] * result.report["circumference"]
            a, b, c = (tube.points[tube.faces[:, k]] for k in range(3))
            self.assertAlmostEqual(area / (np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2), 1, 9)

    def test_takes_whole_numbers_lists_single_precision_and_foreign_orders(self):
        points, faces = square_sheet(4)
        expected = authalic.flatten(points, faces, "mean-value").image
        for p, f in ((points.tolist(), faces.tolist()), (np.asfortranarray(points), np.asfortranarray(faces)),
                     (points, faces.astype(np.uint16)), (points[:, :2], faces), (points.astype(np.float32), faces)):
            self.assertTrue(np.array_equal(authalic.flatten(p, f, "mean-value").image, expected))

    def test_never_changes_or_shares_its_input(self):
        points, faces = bumpy_disk()
        kept = points.copy(), faces.copy()
        result = authalic.flatten(points, faces, measure=np.ones(len(points)))
        result.points[:] = 0
        result.faces[:] = 0
        result.image[:] = 0
        self.assertTrue(np.array_equal(points, kept[0]) and np.array_equal(faces, kept[1]))

    def test_passes_the_arrays_and_fields_of_a_surface(self):
        points, faces = bumpy_disk()
        surface = authalic.Surface(points, faces, {"Sulc": points[:, 2]}, {"Part": np.arange(len(faces))},
                                   {"Note": "kept"})
        result = authalic.flatten(surface, method="tutte")
        self.assertTrue(np.array_equal(result.point_arrays["Sulc"], points[:, 2]))
        self.assertTrue(np.array_equal(result.face_arrays["Part"], np.arange(len(faces))))
        self.assertEqual(result.fields["Note"], "kept")

    def test_the_same_bits_at_any_thread_count(self):
        one, two = (authalic.flatten(*bumpy_disk(), threads=threads).image for threads in (1, 2))
        self.assertTrue(np.array_equal(one, two))


class Failures(unittest.TestCase):
    def refuses(self, kind, *words, **options):
        arguments = dict(zip(("points", "faces"), square_sheet(4)))
        arguments.update(options)
        with self.assertRaises(kind) as caught:
            authalic.flatten(**arguments)
        sentence = str(caught.exception)
        for word in words:
            self.assertIn(word, sentence)
        self.assertNotIn("\n", sentence)
        self.assertNotIn("0x", sentence)

    def test_options_out_of_range_unknown_or_of_another_method(self):
        self.refuses(authalic.InvalidArgument, "lie-flow", method="no-method")
        self.refuses(authalic.InvalidArgument, "disk", domain="sphere", method="mean-value")
        self.refuses(authalic.SurfaceError, "sphere is required", domain="sphere", method="lie-flow")
        self.refuses(authalic.SurfaceError, "sphere is required", domain="sphere")
        self.refuses(authalic.InvalidArgument, "aspect", domain="rectangle")
        self.refuses(authalic.InvalidArgument, "aspect", domain=("rectangle",))
        self.refuses(authalic.InvalidArgument, domain=("rectangle", -1.0))
        self.refuses(authalic.InvalidArgument, "3", domain=[(0, 0), (1, 0)])
        self.refuses(authalic.InvalidArgument, "tolerance", tolerance=0)
        self.refuses(authalic.InvalidArgument, "tolerance", tolerance=float("nan"))
        self.refuses(authalic.InvalidArgument, "max_iterations", max_iterations=-1)
        self.refuses(authalic.InvalidArgument, "threads", threads=-1)
        self.refuses(authalic.InvalidArgument, "tutte", method="tutte", tolerance=0.1)
        self.refuses(authalic.InvalidArgument, "stepratio", stepratio=0.1)
        self.refuses(authalic.InvalidArgument, "step_ratio", step_ratio="much")
        self.refuses(authalic.InvalidArgument, "unfold", method="lie-flow", finish="later")
        self.refuses(authalic.InvalidArgument, "harmonic", initial="nowhere")
        self.refuses(authalic.InvalidArgument, "initial", initial=np.zeros((3, 2)))
        self.refuses(authalic.InvalidArgument, "initial", method="tutte", initial="harmonic")
        self.refuses(authalic.InvalidArgument, "callable", progress=3)
        self.refuses(authalic.InvalidArgument, "on_not_converged", on_not_converged="shrug")

    def test_arrays_of_another_shape_or_kind(self):
        points, faces = square_sheet(4)
        self.refuses(authalic.InvalidArgument, "points", points=points[:, :1])
        self.refuses(authalic.InvalidArgument, "points", points="surface")
        self.refuses(authalic.InvalidArgument, "points", points=[[None] * 3])
        self.refuses(authalic.InvalidArgument, "faces", faces=faces[:, :2])
        self.refuses(authalic.InvalidArgument, "faces", faces=faces.astype(float))
        self.refuses(authalic.InvalidArgument, "faces", faces=None)
        self.refuses(authalic.InvalidArgument, "twice", points=authalic.Surface(points, faces))
        self.refuses(authalic.SurfaceError, "face 0", "0 to 24", faces=faces + 2**33)
        self.refuses(authalic.SurfaceError, "from 0", faces=faces - 1)
        self.refuses(authalic.InvalidArgument, "measure", "25", measure=[1.0, 2.0])
        self.refuses(authalic.InvalidArgument, "measure", measure=np.ones((25, 2)))
        self.refuses(authalic.InvalidArgument, "Nowhere", measure="Nowhere")
        self.refuses(ValueError, measure=-np.ones(25))
        self.refuses(ValueError, measure=np.full(25, np.nan))

    def test_surfaces_that_are_no_disk_or_no_numbers(self):
        points, faces = square_sheet(4)
        torus = authalic.read_surface(DATA / "torus.off")
        self.refuses(authalic.SurfaceError, "disk", "genus 1", points=torus.points, faces=torus.faces)
        self.refuses(authalic.SurfaceError, "empty", points=np.zeros((0, 3)), faces=np.zeros((0, 3), int))
        broken = points.copy()
        broken[7, 1] = np.nan
        self.refuses(authalic.SurfaceError, "vertex 7", points=broken)
        self.refuses(authalic.SurfaceError, faces=np.concatenate([faces, faces[:1]]))

    def test_not_converged_is_a_warning_an_exception_with_the_result_or_nothing(self):
        few = dict(max_iterations=1, tolerance=1e-9)
        with self.assertWarns(authalic.NotConvergedWarning) as caught:
            result = authalic.flatten(*bumpy_disk(), **few)
        self.assertEqual(result.status, "not-converged")
        self.assertEqual(pathlib.Path(caught.filename).name, pathlib.Path(__file__).name)
        with self.assertRaises(authalic.NotConverged) as caught:
            authalic.flatten(*bumpy_disk(), on_not_converged="raise", **few)
        self.assertTrue(np.array_equal(caught.exception.result.image, result.image))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            authalic.flatten(*bumpy_disk(), on_not_converged="ignore", **few)

    def test_says_nothing_on_stdout_or_stderr(self):
        script = ("import authalic, numpy\nfor last in ([0, 1, 5], [0, 2, 1]):\n    try:\n"
                  "        authalic.flatten(numpy.eye(4, 3), [[0, 1, 2], last])\n"
                  "    except authalic.SurfaceError: print('refused')\n")
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
        self.assertEqual((done.stdout, done.stderr), ("refused\nrefused\n", ""))


class Stopping(unittest.TestCase):
    def test_progress_rises_to_one_with_the_name_of_the_stage(self):
        seen = []
        authalic.flatten(*bumpy_disk(), progress=lambda fraction, stage: seen.append((fraction, stage)))
        fractions = [fraction for fraction, _ in seen]
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(fractions[-1], 1.0)
        self.assertIn("Matching faces", {stage for _, stage in seen})

    def test_progress_that_returns_false_cancels(self):
        calls = []

        def stop(fraction, stage):
            calls.append(fraction)
            return False
        with self.assertRaises(authalic.Cancelled):
            authalic.flatten(*bumpy_disk(), progress=stop)
        self.assertEqual(len(calls), 1)
        authalic.flatten(*bumpy_disk(), progress=lambda fraction, stage: None)

    def test_what_progress_raises_comes_out(self):
        def fail(fraction, stage):
            raise KeyError("mine")
        with self.assertRaisesRegex(KeyError, "mine"):
            authalic.flatten(*bumpy_disk(), progress=fail)

    def test_no_filter_is_left_behind(self):
        made, gone, original = [], [], _classes.vtkAuthalicMap

        def make():
            made.append(1)
            algorithm = original()
            algorithm.AddObserver("DeleteEvent", lambda *_: gone.append(1))
            return algorithm
        try:
            _classes.vtkAuthalicMap = make
            authalic.flatten(*bumpy_disk(), progress=lambda *_: None)
            with self.assertRaises(authalic.SurfaceError):
                authalic.flatten(authalic.read_surface(DATA / "torus.off"))
        finally:
            _classes.vtkAuthalicMap = original
        self.assertGreater(len(made), 1)
        self.assertEqual(len(gone), len(made))

    def test_control_c_is_a_keyboard_interrupt_before_the_end(self):
        handler = signal.getsignal(signal.SIGINT)
        signal.signal(signal.SIGINT, signal.default_int_handler)
        seen = []

        def press(fraction, stage):
            seen.append(fraction)
            if len(seen) == 3:
                os.kill(os.getpid(), signal.SIGINT)
        try:
            with self.assertRaises(KeyboardInterrupt):
                authalic.flatten(*bumpy_disk(), tolerance=1e-9, progress=press)
            self.assertLess(seen[-1], 1.0)
            self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
        finally:
            signal.signal(signal.SIGINT, handler)


class MeasureControl(unittest.TestCase):
    def setUp(self):
        self.points, self.faces = bumpy_disk()
        self.east = self.points[:, 0] > 10

    def star_share(self, image, inside):
        return (shares(image, self.faces)[:, None] * inside[self.faces]).sum() / 3

    def test_a_region_gets_its_factor_however_it_is_named(self):
        surface = authalic.Surface(self.points, self.faces).with_point_arrays({"Side": self.east * 5})
        plain = authalic.flatten(surface)
        s = self.star_share(plain.image, self.east)
        for region in (self.east, "Side", ("Side", 5)):
            result = authalic.flatten(surface, roi=(region, 4), roi_blend=3)
            self.assertAlmostEqual(self.star_share(result.image, self.east), 4 * s / (4 * s + 1 - s), delta=1e-9)

    def test_several_regions_hold_together(self):
        regions = [(self.east, 4), (("sphere", -20, 0, -9, 8), 0.5), (("geodesic", 0, 0, 21, 8), 2)]
        result = authalic.flatten(self.points, self.faces, roi=regions)
        regions = result.report["regions"]
        self.assertEqual([r["factor"] for r in regions], [4, 0.5, 2])
        for region in regions:
            self.assertAlmostEqual(region["image_share"], region["target_share"], delta=1e-9)

    def test_a_measure_is_multiplied(self):
        measure = 1 + (self.points[:, 1] > 0)
        region = authalic.flatten(self.points, self.faces, measure=measure, roi=(self.east, 4)).report["regions"][0]
        before = authalic.flatten(self.points, self.faces, measure=measure, roi=(self.east, 1)).report["regions"][0]
        m = before["target_share"]
        self.assertAlmostEqual(region["image_share"], 4 * m / (4 * m + 1 - m), delta=1e-9)

    def test_the_balance_may_differ_from_vertex_to_vertex(self):
        one = authalic.flatten(self.points, self.faces, balance=0.5)
        same = authalic.flatten(self.points, self.faces, balance=np.full(len(self.points), 0.5))
        self.assertTrue(np.array_equal(one.image, same.image))
        local = authalic.flatten(self.points, self.faces, balance=self.east.astype(float))
        stiff = local.face_arrays["AngleDistortion"]
        inside = self.east[self.faces].all(axis=1)
        self.assertLess(np.mean(stiff[~inside]), np.mean(stiff[inside]))
        ball = authalic.read_surface(DATA / "folded_sphere.off")
        self.assertEqual(authalic.flatten(ball, domain="sphere", balance=0.5).status, "converged")

    def test_the_curve_of_balances_says_what_angles_cost(self):
        curve = authalic.balance_curve(self.points, self.faces, balances=[0, 0.5, 1])
        self.assertEqual((curve.status, curve.report["status"], len(curve.report["seconds"]["maps"])),
                         ("converged", "converged", 3))
        self.assertTrue((np.diff(curve.table["angle_distortion"]) > 0).all())
        self.assertTrue((np.diff(curve.table["area_distortion"]) < 0).all())
        half = authalic.flatten(self.points, self.faces, method="balanced")
        self.assertAlmostEqual(half.metrics["area_distortion"], curve.table["area_distortion"][1], delta=2e-3)
        for balances in ([], [1.5], "half"):
            with self.assertRaises(authalic.InvalidArgument):
                authalic.balance_curve(self.points, self.faces, balances=balances)

    def test_what_cannot_be_is_refused_in_words(self):
        def refuses(words, **options):
            with self.assertRaises(authalic.InvalidArgument) as caught:
                authalic.flatten(self.points, self.faces, **options)
            self.assertIn(words, str(caught.exception))

        refuses("(region, factor)", roi=[self.east])
        refuses("factor", roi=(self.east, 0))
        refuses("it is empty", roi=(self.east * 0, 2))
        refuses("it is everything", roi=(self.east * 0 + 1, 2))
        refuses("must have shape", roi=(self.east[:5], 2))
        refuses("must reach", roi=(("sphere", 0, 0, 500, 5), 2))
        refuses("table of region names", roi=(("Nothing", "V1"), 2))
        refuses("needs a region", roi_blend=2)
        refuses("balance", balance=1.5)
        refuses("vertex", balance=np.full(len(self.points), 2.0))
        refuses("no balance", balance=0.5, method="lscm")


class Documentation(unittest.TestCase):
    def test_signature_and_docstring_name_every_parameter(self):
        signature = inspect.signature(authalic.flatten)
        self.assertEqual(list(signature.parameters)[:8], ["points", "faces", "method", "domain", "measure", "initial",
                                                          "tolerance", "max_iterations"])
        for name in signature.parameters:
            self.assertIn(name, authalic.flatten.__doc__)
        for method in authalic.methods():
            self.assertIn(method, authalic.flatten.__doc__)

    def test_every_map_filter_of_the_package_has_a_method(self):
        filters = {method.filter for method in _maps.METHODS.values()}
        for name in (name for name in authalic.__all__ if name.startswith("vtk")):
            try:
                is_map = getattr(authalic, name)().IsA("vtkSurfaceMapAlgorithm")
            except (TypeError, NotImplementedError):  # abstract
                continue
            self.assertEqual(name in filters, bool(is_map), name)

    def test_every_line_of_the_table_of_methods_makes_a_filter(self):
        for name, method in _maps.METHODS.items():
            self.assertTrue(method.make().IsA("vtkSurfaceAlgorithm"), name)
            self.assertIsInstance(authalic.methods()[name], dict)


if __name__ == "__main__":
    unittest.main(verbosity=2)
