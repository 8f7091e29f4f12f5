#!/usr/bin/python3
"""authalic.repair: what it changes, what it leaves, what it refuses."""
import pathlib
import unittest
import warnings

import numpy as np

import authalic

DATA = pathlib.Path(__file__).parents[2] / "data"


def quiet(*surface, **options):
    """A repair that has no doubts."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return authalic.repair(*surface, **options)


def damaged(surface):
    """One face turned, one twice, one that names a vertex twice, one vertex that no face uses."""
    faces = surface.faces.copy()
    faces[100] = faces[100][[1, 0, 2]]
    faces = np.concatenate([faces, faces[7:8], [[3, 3, 5]]])
    return authalic.Surface(np.concatenate([surface.points, [[0, 0, 500]]]), faces,
                            {"Number": np.arange(len(surface.points) + 1)}, {"Number": np.arange(len(faces))})


class Repair(unittest.TestCase):
    def test_a_clean_surface_comes_back_bit_for_bit(self):
        for name in ("bumpy_disk.off", "bent_tube.off", "folded_sphere.off"):
            surface = authalic.read_surface(DATA / name)
            found = quiet(surface)
            self.assertEqual((found.changed, found.changes, found.summary, found.remaining), (0, {}, "", ""))
            self.assertEqual(found.points.tobytes(), surface.points.tobytes())
            self.assertTrue(np.array_equal(found.faces, surface.faces))

    def test_every_change_is_counted_and_the_rest_is_left(self):
        surface = authalic.read_surface(DATA / "bumpy_disk.off")
        found = quiet(damaged(surface))
        self.assertEqual({kind: entry["count"] for kind, entry in found.changes.items()},
                         {"isolated_vertices": 1, "degenerate_faces": 1, "duplicate_faces": 1, "flipped_faces": 1})
        self.assertEqual((found.changed, len(found.summary.splitlines())), (4, 4))
        self.assertEqual(found.points.tobytes(), surface.points.tobytes())
        same = np.array([sorted(np.roll(f, k).tolist() for k in range(3)) for f in found.faces])
        self.assertTrue(np.array_equal(same, [sorted(np.roll(f, k).tolist() for k in range(3)) for f in surface.faces]))
        self.assertEqual(found.changes["isolated_vertices"]["first"][0]["place_mm"], [0, 0, 500])
        for arrays, ids in ((found.point_arrays, "OriginalPointIds"), (found.face_arrays, "OriginalCellIds")):
            self.assertTrue(np.array_equal(arrays["Number"], arrays[ids]))

    def test_a_handle_has_a_place_and_a_length_and_options_leave_it(self):
        torus = authalic.read_surface(DATA / "torus.off")
        found = quiet(torus)
        handle, = found.changes["handles"]["first"]
        loop = torus.points[handle["ids"]]
        self.assertAlmostEqual(handle["length_mm"], np.linalg.norm(loop - np.roll(loop, 1, axis=0), axis=1).sum())
        self.assertLess(np.abs(loop.mean(axis=0) - handle["place_mm"]).max(), 1e-12)
        self.assertEqual(authalic.topology(found)["genus"], 0)
        with self.assertWarnsRegex(authalic.AuthalicWarning, "genus 1"):
            left = authalic.repair(torus, largest_handle=0.9 * handle["length_mm"])
        self.assertEqual((left.changed, left.remaining), (0, "genus 1"))

    def test_a_repaired_surface_is_one_for_every_function(self):
        surface = authalic.read_surface(DATA / "bumpy_disk.off")
        with self.assertRaisesRegex(authalic.SurfaceError, "authalic repair"):
            authalic.flatten(damaged(surface), method="harmonic")
        repaired = authalic.flatten(quiet(damaged(surface)), method="harmonic")
        clean = authalic.flatten(surface, method="harmonic")
        self.assertLess(np.abs(repaired.image - clean.image).max(), 1e-12)

    def test_holes_and_strays_go_up_to_a_size(self):
        surface = authalic.read_surface(DATA / "folded_sphere.off")
        holed = authalic.Surface(surface.points, surface.faces[1:])
        self.assertFalse(quiet(holed, largest_hole=0).changed)
        self.assertEqual(quiet(holed, largest_hole=1e3).report["topology"]["euler_characteristic"], 2)
        points = np.concatenate([surface.points, surface.points + [500, 0, 0]])
        pair = authalic.Surface(points, np.concatenate([surface.faces, surface.faces + len(surface.points)]))
        with self.assertWarnsRegex(authalic.AuthalicWarning, "2 components"):
            self.assertEqual(authalic.repair(pair).remaining, "2 components")

    def test_what_cannot_be_repaired_is_refused_with_the_reason(self):
        apart = np.arange(81).reshape(27, 3) ** 2 % 31
        with self.assertRaisesRegex(authalic.SurfaceError, "9 of 9 triangles share no edge"):
            authalic.repair(apart, np.arange(27).reshape(9, 3))
        surface = authalic.read_surface(DATA / "torus.off")
        for options in (dict(stray_share=2.0), dict(junction_tolerance=0.5), dict(largest_hole=np.inf),
                        dict(largest_holes=1.0), dict(sew_seams="some")):
            with self.assertRaises(authalic.InvalidArgument):
                authalic.repair(surface, **options)
        with self.assertRaises(authalic.Cancelled):
            authalic.repair(surface, progress=lambda *_: False)


if __name__ == "__main__":
    unittest.main(verbosity=2)
