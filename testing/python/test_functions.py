#!/usr/bin/python3
"""The functions around flatten: files, topology, cutting, volumes, elements; closed forms and failures."""
import pathlib
import tempfile
import unittest
import warnings

import numpy as np

import authalic

DATA = pathlib.Path(__file__).parents[2] / "data"


def sphere(n=3):
    """Unit sphere: an octahedron with each face split n times into four."""
    points = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], dtype=float)
    faces = np.array([(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
    for _ in range(n):
        edges, inverse = np.unique(np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2),
                                   axis=0,
                                   return_inverse=True)
        middle = points[edges].sum(axis=1)
        ab, bc, ca = (len(points) + inverse.reshape(-1, 3)).T
        points = np.concatenate([points, middle / np.linalg.norm(middle, axis=1)[:, None]])
        a, b, c = faces.T
        faces = np.concatenate([np.column_stack(t) for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
    return points, faces


def linear_volume():
    """x + 2 y + 3 z in an oblique grid around the unit ball."""
    turn = np.linalg.qr(np.array([[2.0, 1, 0], [-1, 2, 0.5], [0.3, 0, 1]]))[0]
    affine = np.eye(4)
    affine[:3, :3] = turn * [0.1, 0.15, 0.2]
    affine[:3, 3] = -affine[:3, :3] @ [30, 20, 15]
    index = np.stack(np.meshgrid(*(np.arange(k) for k in (61, 41, 31)), indexing="ij"), axis=-1)
    return authalic.Volume((index @ affine[:3, :3].T + affine[:3, 3]) @ [1.0, 2, 3], affine)


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.here = pathlib.Path(self.folder.name)
        self.addCleanup(self.folder.cleanup)

    def test_surfaces_come_back_from_every_format(self):
        points, faces = sphere(2)
        for name, off in (("a.off", 0), ("a.ply", 0), ("a.obj", 0), ("a.vtp", 0), ("a.vtk", 0), ("a.gii", 1e-7),
                          ("lh.a", 1e-7)):
            authalic.write_surface(self.here / name, points, faces)
            back = authalic.read_surface(self.here / name)
            self.assertTrue(np.array_equal(back.faces, faces), name)
            self.assertLessEqual(np.abs(back.points - points).max(), off, name)

    def test_voxel_indices_become_scanner_ras_by_the_volume(self):
        volume, (indices, faces) = linear_volume(), sphere(2)
        indices = 8 * indices + [30, 20, 15]
        authalic.write_volume(self.here / "v.nii", volume)
        authalic.write_surface(self.here / "a.ply", indices, faces)
        placed = authalic.read_surface(self.here / "a.ply", space="voxel", volume=self.here / "v.nii")
        expected = indices @ volume.affine[:3, :3].T + volume.affine[:3, 3]
        self.assertLess(np.abs(placed.points - expected).max(), 1e-5)
        with self.assertRaisesRegex(authalic.FormatError, "volume"):
            authalic.read_surface(self.here / "a.ply", space="voxel")

    def test_volumes_come_back_and_say_what_they_lose(self):
        volume = linear_volume()
        whole = authalic.Volume(np.arange(24, dtype=np.int16).reshape(2, 3, 4), volume.affine)
        for name in ("v.nii", "v.nii.gz", "v.mgh", "v.mgz"):
            lost = [words for words in authalic.write_volume(self.here / name, volume) if "Values" in words]
            self.assertEqual(len(lost), 1 if ".mg" in name else 0, name)  # NIfTI keeps 64 bits
            back = authalic.read_volume(self.here / name)
            np.testing.assert_allclose(back.values, volume.values, rtol=1e-7, atol=1e-9)
            np.testing.assert_allclose(back.affine, volume.affine, atol=1e-6)
            self.assertFalse([words for words in authalic.write_volume(self.here / name, whole) if "Values" in words])
            again = authalic.read_volume(self.here / name)
            self.assertTrue(np.array_equal(again.values, whole.values))
            self.assertEqual(again.fields["StoredType"], "int16")
        lost = authalic.Volume(whole.values, whole.affine, {"CoordinateSpace": "unknown"})
        with self.assertRaisesRegex(authalic.InvalidArgument, "unknown"):
            authalic.write_volume(self.here / "v.nii", lost)

    def test_volumes_that_are_unclear_are_refused_with_the_argument_that_resolves_it(self):
        authalic.write_volume(self.here / "v.nii", authalic.Volume(np.ones((2, 3, 4), np.float32)))
        data = bytearray((self.here / "v.nii").read_bytes())
        data[280 + 12:280 + 16] = np.float32(9).tobytes()  # the sform's x
        (self.here / "v.nii").write_bytes(data)
        points, faces = sphere(1)
        surface = authalic.Surface(points, faces, {}, {}, {"CoordinateSpace": "scanner-ras"})
        with self.assertRaisesRegex(authalic.InvalidArgument, "transform="):
            authalic.sample_volume(surface, self.here / "v.nii")
        for transform, x in (("sform", 9), ("qform", 0)):
            volume = authalic.read_volume(self.here / "v.nii", transform=transform)
            self.assertEqual((volume.affine[0, 3], volume.fields["TransformDisagreement"]), (x, 9))
            authalic.sample_volume(surface, volume)
        with self.assertRaisesRegex(authalic.InvalidArgument, "transform"):
            authalic.read_volume(self.here / "v.nii", transform="both")

    def test_writers_return_what_is_lost_and_data_are_read_alone(self):
        points, faces = sphere(1)
        surface = authalic.Surface(points, faces, {"height": points[:, 2]}, {}, {"CoordinateSpace": "scanner-ras"})
        self.assertEqual(authalic.write_surface(self.here / "a.vtp", surface), [])
        self.assertEqual(authalic.write_surface(self.here / "a.off", surface)[0], "Arrays are not kept: height.")
        authalic.write_surface(self.here / "l.ply", surface, space="lps")
        back = authalic.read_surface(self.here / "l.ply")
        self.assertTrue(np.array_equal(back.points, points))
        turned = authalic.read_surface(self.here / "l.ply", space="scanner-ras")
        self.assertTrue(np.array_equal(turned.points, points * [-1, -1, 1]))
        authalic.write_vertex_data(self.here / "h.shape.gii", surface, "height")
        alone = authalic.read_vertex_data(self.here / "h.shape.gii")
        self.assertTrue(np.array_equal(alone.point_arrays["height"], points[:, 2].astype("f4")))
        self.assertEqual(len(alone.faces), 0)

    def test_patches_are_read_with_the_surface_they_were_cut_from(self):
        points, faces = sphere(2)
        authalic.write_surface(self.here / "lh.whole", points, faces)
        kept = np.flatnonzero(points[:, 2] > 0)
        new = -np.ones(len(points), int)
        new[kept] = np.arange(len(kept))
        inside = new[faces[(points[faces][:, :, 2] > 0).all(axis=1)]]
        patch = authalic.Surface(points[kept], inside, {"OriginalPointIds": kept})
        self.assertIn("Coordinates are rounded", authalic.write_surface(self.here / "lh.patch.3d", patch)[0])
        back = authalic.read_surface(self.here / "lh.patch.3d", whole=self.here / "lh.whole")
        self.assertTrue(np.array_equal(back.faces, inside))
        self.assertTrue(np.array_equal(back.point_arrays["OriginalPointIds"], kept))
        loop = np.bincount(np.sort(inside[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1) @ [1000, 1])
        ends = np.unique([divmod(edge, 1000) for edge in np.flatnonzero(loop == 1)])
        self.assertTrue(np.array_equal(np.flatnonzero(back.point_arrays["PatchBorder"]), ends))
        with self.assertRaisesRegex(authalic.InvalidArgument, "cut from"):
            authalic.read_surface(self.here / "lh.patch.3d")

    def test_a_map_keeps_everything_in_a_vtp_file(self):
        result = authalic.flatten(authalic.read_surface(DATA / "bumpy_disk.off"), method="harmonic")
        authalic.write_surface(self.here / "map.vtp", result)
        back = authalic.read_surface(self.here / "map.vtp")
        self.assertTrue(np.array_equal(back.points[:, :2], result.image))
        self.assertTrue(np.array_equal(back.point_arrays["OriginalPoints"], result.points))
        self.assertTrue(np.array_equal(back.face_arrays["AreaDistortion"], result.face_arrays["AreaDistortion"]))
        self.assertEqual(back.fields["Status"], "converged")

    def test_vertex_data_come_back(self):
        surface = authalic.Surface(*sphere(2)).with_point_arrays(
            {"depth": sphere(2)[0][:, 2], "other": sphere(2)[0][:, 1]})
        authalic.write_vertex_data(self.here / "depth.txt", surface, "depth")
        authalic.write_vertex_data(self.here / "lh.depth", surface, "depth")
        authalic.write_vertex_data(self.here / "both.func.gii", surface)
        for name in ("depth.txt", "lh.depth"):
            values = authalic.read_vertex_data(self.here / name, surface, name="again").point_arrays["again"]
            self.assertLess(np.abs(values - surface.point_arrays["depth"]).max(), 1e-6)
        both = authalic.read_vertex_data(self.here / "both.func.gii", authalic.Surface(*sphere(2)))
        self.assertEqual(sorted(both.point_arrays), ["depth", "other"])

    def test_the_space_can_be_asserted_and_is_told(self):
        authalic.write_surface(self.here / "a.off", *sphere(1))
        self.assertEqual(authalic.read_surface(self.here / "a.off").fields["CoordinateSpace"], "unknown")
        asserted = authalic.read_surface(self.here / "a.off", space="scanner-ras")
        self.assertEqual(asserted.fields["CoordinateSpace"], "scanner-ras")

    def test_volumes_have_their_affine(self):
        volume = authalic.read_volume(DATA / "phantom_t1.nii.gz")
        self.assertEqual(volume.values.ndim, 3)
        self.assertEqual(volume.fields["CoordinateSpace"], "scanner-ras")
        again = authalic.Volume.from_vtk(volume.to_vtk())
        self.assertTrue(np.array_equal(again.values, volume.values))
        self.assertLess(np.abs(again.affine - volume.affine).max(), 1e-12)

    def test_nifti_orientation_agrees_with_nibabel(self):
        try:
            import nibabel
        except ImportError:
            self.skipTest("nibabel is not installed")
        image, volume = nibabel.load(DATA / "phantom_t1.nii.gz"), authalic.read_volume(DATA / "phantom_t1.nii.gz")
        self.assertTrue(np.allclose(image.affine, volume.affine))
        self.assertTrue(np.array_equal(np.asarray(image.dataobj), volume.values))

    def test_bad_files_are_said_in_one_sentence(self):
        (self.here / "bad.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n", encoding="utf-8")
        for call, kind in (
            (lambda: authalic.read_surface(self.here / "none.off"),
             authalic.FormatError), (lambda: authalic.read_surface(self.here / "bad.off"), authalic.FormatError),
            (lambda: authalic.read_volume(self.here / "none.nii"), authalic.FormatError),
            (lambda: authalic.read_surface(self.here / "bad.off", space="moon"),
             authalic.InvalidArgument), (lambda: authalic.write_surface(self.here / "no/folder.off", *sphere(1)),
                                         authalic.FormatError),
            (lambda: authalic.write_vertex_data(self.here / "a.txt", authalic.Surface(*sphere(1)), "b"),
             authalic.InvalidArgument),
            (lambda: authalic.read_vertex_data(DATA / "torus.off", authalic.Surface(*sphere(1))), authalic.Error)):
            with self.assertRaises(kind) as caught:
                call()
            self.assertNotIn("\n", str(caught.exception))
            self.assertGreater(len(str(caught.exception)), 20)
        self.assertTrue(
            issubclass(authalic.FormatError, OSError) and issubclass(authalic.InvalidArgument, ValueError))


class Surfaces(unittest.TestCase):
    def test_topology_of_a_sphere_and_a_torus(self):
        report = authalic.topology(*sphere(4))
        self.assertEqual((report["euler_characteristic"], report["genus"], report["boundary_loops"]), (2, 0, []))
        errors = [abs(authalic.topology(*sphere(k))["area_mm2"] - 4 * np.pi) for k in (2, 3, 4)]
        self.assertTrue(all(3.5 < a / b < 4.5 for a, b in zip(errors, errors[1:])), errors)
        self.assertEqual(authalic.topology(authalic.read_surface(DATA / "torus.off"))["genus"], 1)

    def test_topology_finds_the_place_of_a_defect(self):
        points, faces = sphere(2)
        report = authalic.topology(points, np.concatenate([faces, faces[5:6]]))
        self.assertGreater(report["duplicate_faces"]["count"], 0)
        self.assertIn(len(faces), report["duplicate_faces"]["first"][0]["ids"])
        self.assertLess(
            np.abs(report["duplicate_faces"]["first"][0]["place_mm"] - points[faces[5]].mean(axis=0)).max(), 1e-9)

    def test_cutting_by_a_plane_flags_or_labels_gives_the_same_disk(self):
        points, faces = sphere(4)
        below = points[:, 2] < -0.5
        disks = [
            authalic.cut_to_disk(points, faces, **how)
            for how in (dict(plane=((0, 0, -0.5), (0, 0, -1))), dict(region=below),
                        dict(region=np.where(below, 7, 3), values=[7]), dict(region=~below, keep=True))
        ]
        for disk in disks:
            self.assertTrue(np.array_equal(disk.faces, disks[0].faces))
            self.assertTrue(np.array_equal(points[disk.point_arrays["OriginalPointIds"]], disk.points))
        report = authalic.topology(disks[0])
        self.assertEqual((report["euler_characteristic"], len(report["boundary_loops"])), (1, 1))
        kept, removed = disks[0].fields["KeptArea"], disks[0].fields["RemovedArea"]
        self.assertAlmostEqual(kept + removed, authalic.topology(points, faces)["area_mm2"])

    def test_regions_of_an_annotation_are_called_by_name(self):
        points, faces = sphere(4)
        surface = authalic.Surface(points, faces, {"parts": np.where(points[:, 2] < -0.5, 9, 4)},
                                   fields={"partsNames": ["rest", "wall"], "partsIds": np.array([4, 9])})
        by_name, by_number = (authalic.cut_to_disk(surface, region="parts", values=[v]) for v in ("wall", 9))
        self.assertTrue(np.array_equal(by_name.faces, by_number.faces))
        with self.assertRaisesRegex(authalic.InvalidArgument, "rest, wall"):
            authalic.cut_to_disk(surface, region="parts", values=["floor"])

    def test_cutting_needs_one_way_to_say_what(self):
        points, faces = sphere(1)
        for how, kind in ((dict(), authalic.InvalidArgument), (dict(
                region=[1], plane=((0, 0, 0), (0, 0, 1))), authalic.InvalidArgument), (dict(region=[1, 0]),
                                                                                       authalic.InvalidArgument),
                          (dict(region="Nowhere"), authalic.InvalidArgument), (dict(plane=((0, 0), (0, 0, 1))),
                                                                               authalic.InvalidArgument),
                          (dict(region=np.zeros(len(points))), authalic.Error), (dict(plane=((0, 0, 0), (0, 0, 1)),
                                                                                      smoothness=2),
                                                                                 authalic.InvalidArgument)):
            with self.assertRaises(kind):
                authalic.cut_to_disk(points, faces, **how)

    def test_distortion_of_the_map_of_flatten_and_of_any_other(self):
        surface = authalic.read_surface(DATA / "bumpy_disk.off")
        result = authalic.flatten(surface, method="mean-value")
        found = authalic.measure_distortion(result, surface)
        self.assertEqual(set(found.metrics), set(result.metrics))
        for name, value in result.metrics.items():
            self.assertAlmostEqual(found.metrics[name], value, 12, name)
        flat = np.column_stack([surface.points[:, :2], 0 * surface.points[:, 2]])
        folded = 3 * surface.points[:, :2]
        folded[int(np.argmin(np.linalg.norm(folded, axis=1)))] += 0.5 * np.ptp(folded[:, 0])
        self.assertGreater(authalic.measure_distortion(folded, flat, surface.faces).metrics["flipped_faces"], 0)
        same = authalic.measure_distortion(3 * surface.points[:, :2], flat, surface.faces)
        self.assertAlmostEqual(same.metrics["area_distortion"], 2.0)
        self.assertLess(np.abs(same.face_arrays["BeltramiCoefficient"]).max(), 1e-9)
        with self.assertRaises(authalic.InvalidArgument):
            authalic.measure_distortion(np.zeros((2, 2)), surface)
        with self.assertRaises(authalic.InvalidArgument):
            authalic.measure_distortion(result, surface, measure=[1.0])

    def test_distortion_of_a_sphere_and_its_statistics_are_numpys(self):
        surface = authalic.read_surface(DATA / "folded_sphere.off")
        result = authalic.flatten(surface, method="sphere", initial="welding")
        found = authalic.measure_distortion(100 * result.image, surface)
        self.assertEqual(set(found.metrics), set(result.metrics))
        for name, value in result.metrics.items():
            self.assertAlmostEqual(found.metrics[name], value, 9, name)
        beltrami = np.linalg.norm(found.face_arrays["BeltramiCoefficient"], axis=1)
        for name, value in (("mean", beltrami.mean()), ("sd", beltrami.std()), ("max", beltrami.max()),
                            ("p5", np.percentile(beltrami, 5)), ("p99", np.percentile(beltrami, 99))):
            self.assertAlmostEqual(found.metrics[f"beltrami_{name}"], value, 9, name)
        bins = found.histograms["BeltramiHistogram"]
        self.assertEqual(bins[:, 2].sum(), len(surface.faces))
        self.assertEqual(bins[0, 2], (beltrami < bins[0, 1]).sum())
        self.assertEqual(result.report["histograms"]["beltrami"]["counts"], bins[:-3, 2].tolist())

    def test_a_surface_goes_to_vtk_and_back(self):
        points, faces = sphere(1)
        whole = authalic.Surface(points, faces, {"a": np.arange(18), "v": points, "b": points[:, 0] > 0},
                                 {"f": np.ones(32)},
                                 {"Text": "words", "Number": 4.5, "Many": [1, 2, 3], "Texts": ["a", "b"]})
        back = authalic.Surface.from_vtk(whole.to_vtk())
        for name, values in {**whole.point_arrays, **whole.face_arrays}.items():
            self.assertTrue(np.array_equal({**back.point_arrays, **back.face_arrays}[name], values), name)
        self.assertEqual((back.fields["Text"], back.fields["Number"], back.fields["Texts"]),
                         ("words", 4.5, ["a", "b"]))
        self.assertTrue(np.array_equal(back.fields["Many"], [1, 2, 3]))
        with self.assertRaisesRegex(authalic.InvalidArgument, "18 vertices"):
            authalic.Surface(points, faces, {"a": np.arange(3)}).to_vtk()

    def test_numbers_of_any_byte_order_and_width_are_taken(self):
        points, faces = sphere(1)
        for kind in (">f8", "<f8", ">f4", "f2", "g", ">i4", "u2", "?", "i8"):
            values = np.arange(len(points)).astype(kind)
            back = authalic.Surface.from_vtk(authalic.Surface(points, faces, {"a": values}).to_vtk())
            self.assertTrue(np.array_equal(back.point_arrays["a"], values.astype(float)), kind)
        swapped = authalic.Surface(points.astype(">f8"), faces.astype(">i4")).to_vtk()
        self.assertTrue(np.array_equal(authalic.Surface.from_vtk(swapped).points, points))
        volume = authalic.Volume(np.arange(27).reshape(3, 3, 3).astype(">i2"))
        self.assertTrue(np.array_equal(authalic.Volume.from_vtk(volume.to_vtk()).values, volume.values))

    def test_polygons_of_a_foreign_polydata_are_refused(self):
        from vtkmodules.vtkFiltersSources import vtkPlaneSource
        quad = vtkPlaneSource()
        quad.Update()
        for call in (authalic.topology, authalic.flatten, authalic.Surface.from_vtk):
            with self.assertRaisesRegex(authalic.SurfaceError, "vtkTriangleFilter"):
                call(quad.GetOutput())


class Volumes(unittest.TestCase):
    def test_a_linear_field_is_read_exactly_at_and_between_surfaces(self):
        points, faces = sphere(3)
        volume, expected = linear_volume(), sphere(3)[0] @ [1, 2, 3]
        values, coverage = authalic.sample_volume(authalic.Surface(points, faces), volume)
        self.assertLess(np.abs(values - expected).max(), 1e-5)
        self.assertTrue((coverage == 1).all())
        middle = authalic.sample_volume(authalic.Surface(points, faces), volume, "between-surfaces",
                                        other=authalic.Surface(points / 2, faces), fractions=(0.5, 0.5, 1))
        self.assertLess(np.abs(middle.values - 0.75 * expected).max(), 1e-5)
        inward = authalic.sample_volume(authalic.Surface(points, faces), volume, "along-normal", depths=(0, 0.2, 0.1))
        self.assertLess(np.abs(inward.values - 0.9 * expected).max(), 0.01)

    def test_the_surface_of_a_map_is_sampled(self):
        cap = authalic.cut_to_disk(*sphere(3), plane=((0, 0, 0), (0, 0, -1)))
        values = authalic.sample_volume(authalic.flatten(cap, method="tutte"), linear_volume()).values
        self.assertLess(np.abs(values - cap.points @ [1, 2, 3]).max(), 1e-5)

    def test_an_unknown_space_is_refused_and_can_be_asserted(self):
        with self.assertRaisesRegex(authalic.InvalidArgument, "space"):
            authalic.sample_volume(authalic.read_surface(DATA / "bumpy_disk.off"), linear_volume())
        with self.assertRaisesRegex(authalic.InvalidArgument, "space"):
            authalic.labels_on_surface(authalic.read_surface(DATA / "bumpy_disk.off"), linear_volume())
        authalic.sample_volume(authalic.read_surface(DATA / "bumpy_disk.off", space="scanner-ras"), linear_volume())

    def test_outside_is_not_a_number_and_never_zero(self):
        points, faces = sphere(2)
        values, coverage = authalic.sample_volume(authalic.Surface(points + [50, 0, 0], faces), linear_volume())
        self.assertTrue(np.isnan(values).all() and (coverage == 0).all())

    def test_labels_reach_the_nearest_voxel(self):
        volume = linear_volume()
        corner = np.moveaxis(np.indices(volume.values.shape), 0, -1) @ volume.affine[:3, :3].T + volume.affine[:3, 3]
        labels = authalic.Volume((corner[..., 2] > 0) * 5, volume.affine)
        points, faces = sphere(3)
        found = authalic.labels_on_surface(authalic.Surface(points, faces), labels, max_distance=0.3)
        self.assertTrue((found[points[:, 2] > 0.1] == 5).all() and (found[points[:, 2] < -0.5] == 0).all())

    def test_options_and_volumes_are_checked(self):
        surface = authalic.Surface(*sphere(1))
        for how in (dict(mode="sideways"), dict(reducer="sum"), dict(mode="along-normal", depths=(0, 1, 0)),
                    dict(depths=3), dict(mode="between-surfaces")):
            with self.assertRaises(authalic.InvalidArgument):
                authalic.sample_volume(surface, linear_volume(), **how)
        for volume in (None, authalic.Volume(np.zeros(
            (2, 2))), authalic.Volume(np.zeros((2, 2, 2)), np.zeros((4, 4)))):
            with self.assertRaises(authalic.InvalidArgument):
                authalic.sample_volume(surface, volume)

    def test_the_phantom_has_two_hemispheres_with_a_medial_wall(self):
        with warnings.catch_warnings(record=True) as doubts:
            warnings.simplefilter("always")
            sides = authalic.cortical_surfaces(DATA / "phantom_t1.nii.gz", target_faces=6000)
        self.assertTrue(all(issubclass(doubt.category, authalic.AuthalicWarning) for doubt in doubts))
        self.assertLess(sides["left"].points[:, 0].mean(), sides["right"].points[:, 0].mean())
        for surface in sides.values():
            self.assertEqual(authalic.topology(surface)["euler_characteristic"], 2)
            self.assertEqual(
                len(authalic.topology(authalic.cut_to_disk(surface, region="MedialWall"))["boundary_loops"]), 1)


class Elements(unittest.TestCase):
    def setUp(self):
        self.surface = authalic.read_surface(DATA / "bumpy_disk.off")
        self.map = authalic.flatten(self.surface, domain="square")

    def test_areas_sum_to_the_surface_and_means_to_the_mean(self):
        found = authalic.elements(self.map,
                                  {"height": self.surface.points[:, 2], "one": np.ones(len(self.surface.points))},
                                  count=25,
                                  hemisphere="L")
        area = authalic.topology(self.surface)["area_mm2"]
        self.assertEqual(found.summary["elements"], 25)
        self.assertAlmostEqual(found.table["area_mm2"].sum() / area, 1.0, 9)
        self.assertTrue(np.allclose(found.table["one_mean"], 1.0) and (found.table["hemi"] == "L").all())
        corners = self.surface.points[self.surface.faces]
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        integral = (areas * corners[:, :, 2].mean(axis=1)).sum()
        self.assertAlmostEqual((found.table["height_mean"] * found.table["area_mm2"]).sum() / integral, 1.0, 6)
        self.assertEqual(set(found.face_ids), set(range(1, 26)))
        self.assertEqual(found.borders.shape[1:], (2, 3))

    def test_regions_have_their_names(self):
        labels = np.where(self.surface.points[:, 0] > 0, 2, 1)
        found = authalic.elements(self.map, {"x": self.surface.points[:, 0]},
                                  labels, {1: "left", 2: "right"},
                                  count=16)
        self.assertEqual(list(found.regions["label_name"]), ["left", "right"])
        self.assertLess(found.regions["x_mean"][0], found.regions["x_mean"][1])
        self.assertEqual(authalic.elements(self.map, count=4).regions, {})

    def test_failures_have_words(self):
        for kind, call in ((authalic.InvalidArgument, lambda: authalic.elements(self.map, {"x": [1, 2]})),
                           (authalic.InvalidArgument, lambda: authalic.elements(self.map, count=0)),
                           (authalic.InvalidArgument, lambda: authalic.elements(self.map, frame="round")),
                           (authalic.Error, lambda: authalic.elements(self.surface))):
            with self.assertRaises(kind):
                call()


class Documentation(unittest.TestCase):
    def test_every_function_and_class_says_what_it_takes_and_raises(self):
        for name in (name for name in authalic.__all__ if not name.startswith("vtk")):
            self.assertGreater(len(getattr(authalic, name).__doc__ or ""), 30, name)
            self.assertIn(name, authalic.__doc__)


if __name__ == "__main__":
    unittest.main(verbosity=2)
