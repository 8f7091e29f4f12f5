"""Samples real volumes on real surfaces with Authalic, scipy and wb_command, and compares.

nibabel reads and orients independently of Authalic. Leaves with 77 (skipped) when nibabel, scipy or the data
are missing.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import nibabel
    import numpy as np
    from scipy.ndimage import map_coordinates
except ImportError as missing:
    print("nothing to compare with:", missing)
    sys.exit(77)

parser = argparse.ArgumentParser()
parser.add_argument("--dump", required=True)
parser.add_argument("--data", required=True)
OPTIONS, REST = parser.parse_known_args()
if not os.path.isdir(OPTIONS.data):
    print("real data not present:", OPTIONS.data)
    sys.exit(77)

AT_VERTEX, ALONG_NORMAL, BETWEEN = 0, 1, 2
REDUCERS = {0: np.nanmean, 1: np.nanmedian, 2: np.nanmax, 3: np.nanmin}
TRILINEAR, NEAREST = 0, 1


def data(path):
    return os.path.join(OPTIONS.data, path)


PET = data("volumes/spm12/PET.nii")
GREY = data("volumes/spm12/grey.nii")
T1 = data("volumes/mni/mni_icbm152_t1_tal_nlin_sym_09a_converted.nii.gz")
MIDTHICKNESS = data("cortex/conte69_gifti/conte69_32k_lh.gii")
WHITE, PIAL = data("cortex/fsaverage5_gifti/white_left.gii.gz"), data("cortex/fsaverage5_gifti/pial_left.gii.gz")
SUBJECT_PIAL, SUBJECT_T1 = data("cortex/subject1_fs/lh.pialsurface6"), data("cortex/subject1_fs/brain.mgz")


def gifti(path):
    if path.endswith(".gz"):
        import gzip
        image = nibabel.GiftiImage.from_bytes(gzip.open(path).read())
    else:
        image = nibabel.load(path)
    return image.darrays[0].data.astype(float), image.darrays[1].data


def samples_of(surface, volume, mode, reducer, interpolation, other=None):
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out")
        words = [OPTIONS.dump, "sample", surface, volume, out, mode, reducer, interpolation]
        words += [other] if other else []
        done = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise AssertionError(done.stderr)
        both = np.fromfile(out)
    return both[:both.size // 2], both[both.size // 2:]


def outward_normals(points, faces):
    """Weighted by angle, with the angles from arc cosines."""
    normals = np.zeros_like(points)
    a, b, c = (points[faces[:, k]] for k in range(3))
    face = np.cross(b - a, c - a)
    length = np.linalg.norm(face, axis=1, keepdims=True)
    face = np.divide(face, length, out=np.zeros_like(face), where=length > 0)
    for k, (here, left, right) in enumerate(((a, b, c), (b, c, a), (c, a, b))):
        p, q = left - here, right - here
        cosine = (p * q).sum(1) / np.maximum(np.linalg.norm(p, axis=1) * np.linalg.norm(q, axis=1), 1e-300)
        np.add.at(normals, faces[:, k], face * np.arccos(np.clip(cosine, -1, 1))[:, None])
    return normals / np.linalg.norm(normals, axis=1, keepdims=True)


def by_scipy(volume, points, interpolation):
    """points: vertices × samples × 3 in scanner RAS. NaN outside the field of view."""
    image = nibabel.load(volume)
    values = np.asarray(image.dataobj, dtype=np.float32).astype(float)
    voxel = nibabel.affines.apply_affine(np.linalg.inv(image.affine), points)
    sampled = map_coordinates(values.reshape(values.shape[:3]), np.moveaxis(voxel, -1, 0), order=1 - interpolation,
                              mode="constant", cval=np.nan)
    if interpolation == NEAREST:
        return sampled
    inside = ((voxel >= -1e-6) & (voxel <= np.array(values.shape[:3]) - 1 + 1e-6)).all(-1)
    return np.where(inside, sampled, np.nan)


def depths(points, faces):
    return points[:, None] - np.arange(11.0)[None, :, None] * outward_normals(points, faces)[:, None]


class Sampling(unittest.TestCase):
    def agree(self, ours, theirs, tolerance):
        np.testing.assert_array_equal(np.isnan(ours), np.isnan(theirs))
        self.assertLess(np.nanmax(np.abs(ours - theirs)), tolerance)

    def need(self, *paths):
        for path in paths:
            if not os.path.exists(path):
                self.skipTest("real data not present: " + path)

    def test_vertices_agree_with_scipy(self):
        self.need(MIDTHICKNESS, PET, GREY, T1)
        points, _ = gifti(MIDTHICKNESS)
        for volume in (PET, GREY, T1):
            for interpolation in (TRILINEAR, NEAREST):
                ours, coverage = samples_of(MIDTHICKNESS, volume, AT_VERTEX, 0, interpolation)
                self.agree(ours, by_scipy(volume, points, interpolation), 1e-5)
                np.testing.assert_array_equal(coverage, ~np.isnan(ours))

    def test_a_surface_in_tkras_agrees_with_scipy(self):
        self.need(SUBJECT_PIAL, SUBJECT_T1)
        points, _ = nibabel.freesurfer.read_geometry(SUBJECT_PIAL)
        image = nibabel.load(SUBJECT_T1)
        scanner = nibabel.affines.apply_affine(image.affine @ np.linalg.inv(image.header.get_vox2ras_tkr()), points)
        ours, _ = samples_of(SUBJECT_PIAL, SUBJECT_T1, AT_VERTEX, 0, TRILINEAR)
        self.agree(ours, by_scipy(SUBJECT_T1, scanner, TRILINEAR), 1e-5)
        found = [f"{x:.3g}" for x in np.percentile(ours, [1, 25, 50, 75, 99])]
        self.assertEqual(found, ["40.4", "49.4", "53.2", "56.8", "103"])

    def test_profiles_along_the_normal_agree_with_scipy(self):
        self.need(MIDTHICKNESS, PET)
        points, faces = gifti(MIDTHICKNESS)
        profile = by_scipy(PET, depths(points, faces), TRILINEAR)
        for reducer, function in REDUCERS.items():
            ours, coverage = samples_of(MIDTHICKNESS, PET, ALONG_NORMAL, reducer, TRILINEAR)
            self.agree(ours, function(profile, axis=1), 1e-5)
            np.testing.assert_allclose(coverage, np.isfinite(profile).mean(1), atol=1e-12)

    def test_profiles_between_surfaces_agree_with_scipy(self):
        self.need(WHITE, PIAL, T1)
        white, pial = gifti(WHITE)[0], gifti(PIAL)[0]
        fractions = np.arange(11)[None, :, None] * 0.1
        profile = by_scipy(T1, white[:, None] + fractions * (pial - white)[:, None], TRILINEAR)
        for reducer, function in REDUCERS.items():
            ours, _ = samples_of(WHITE, T1, BETWEEN, reducer, TRILINEAR, PIAL)
            self.agree(ours, function(profile, axis=1), 1e-5)

    @unittest.skipUnless(shutil.which("wb_command"), "wb_command is not installed")
    def test_vertices_agree_with_workbench(self):
        self.need(MIDTHICKNESS, PET, GREY)
        for volume in (PET, GREY):
            with tempfile.TemporaryDirectory() as folder:
                out = os.path.join(folder, "out.func.gii")
                subprocess.run(["wb_command", "-volume-to-surface-mapping", volume, MIDTHICKNESS, out, "-trilinear"],
                               check=True, capture_output=True)
                theirs = nibabel.load(out).darrays[0].data
            ours, _ = samples_of(MIDTHICKNESS, volume, AT_VERTEX, 0, TRILINEAR)
            self.assertLess(np.abs(ours - theirs).max(), 2e-6)

    @unittest.skipUnless(shutil.which("wb_command"), "wb_command is not installed")
    def test_weighted_statistics_agree_with_workbench(self):
        self.need(MIDTHICKNESS, PET)
        done = subprocess.run([OPTIONS.dump, "summary", MIDTHICKNESS, PET], check=True, capture_output=True, text=True)
        area, mean, sd, median = map(float, done.stdout.split())
        with tempfile.TemporaryDirectory() as folder:
            metric = os.path.join(folder, "out.func.gii")

            def workbench(*words):
                return subprocess.run(["wb_command", *words], check=True, capture_output=True, text=True).stdout

            def weighted(*words):
                return float(workbench("-metric-weighted-stats", metric, "-area-surface", MIDTHICKNESS, *words))

            workbench("-volume-to-surface-mapping", PET, MIDTHICKNESS, metric, "-trilinear")
            areas = os.path.join(folder, "areas.func.gii")
            workbench("-surface-vertex-areas", MIDTHICKNESS, areas)
            self.assertAlmostEqual(float(workbench("-metric-stats", areas, "-reduce", "SUM")) / area, 1, delta=1e-5)
            self.assertAlmostEqual(weighted("-mean"), mean, delta=2e-6)
            self.assertAlmostEqual(weighted("-stdev"), sd, delta=2e-6)
            self.assertAlmostEqual(weighted("-percentile", "50"), median, delta=2e-5)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *REST], verbosity=2)
