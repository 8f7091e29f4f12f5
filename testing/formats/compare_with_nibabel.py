"""Reads files with Authalic and with nibabel, and what Authalic writes with nibabel and wb_command, and compares.

Every coordinate, value, label and affine must be the same. Leaves with 77 (skipped) when nibabel or the data are
missing.
"""

import argparse
import glob
import gzip
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import nibabel
    import numpy as np
except ImportError:
    print("nibabel is not installed; nothing to compare with")
    sys.exit(77)

parser = argparse.ArgumentParser()
parser.add_argument("--dump", required=True)
parser.add_argument("--data", required=True)
OPTIONS, REST = parser.parse_known_args()
if not os.path.isdir(OPTIONS.data):
    print("real data not present:", OPTIONS.data)
    sys.exit(77)


def data(path):
    return os.path.join(OPTIONS.data, path)


def run(*words):
    done = subprocess.run([OPTIONS.dump, *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{words}: exit {done.returncode}: {done.stderr}")


def unpacked(path, folder):
    """nibabel wants the plain file where Authalic undoes gzip by itself."""
    if not path.endswith(".gz"):
        return path
    plain = os.path.join(folder, os.path.basename(path)[:-3])
    with gzip.open(path) as source, open(plain, "wb") as target:
        shutil.copyfileobj(source, target)
    return plain


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.out = os.path.join(self.folder, "out")

    def tearDown(self):
        shutil.rmtree(self.folder)

    def array(self, name, kind):
        return np.fromfile(self.out + "." + name, kind)

    def facts(self):
        with open(self.out + ".txt", encoding="utf-8") as file:
            return file.read().splitlines()

    def surface(self, path):
        run("surface", path, self.out)
        return self.array("points", "<f8").reshape(-1, 3), self.array("faces", "<i4").reshape(-1, 3)


class Surfaces(Case):
    def test_freesurfer_surfaces(self):
        files = glob.glob(data("cortex/*_fs/*.pial")) + glob.glob(data("cortex/*_fs/*.white")) + glob.glob(
            data("cortex/subject1_fs/*pialsurface*"))
        self.assertGreater(len(files), 5)
        for path in files:
            points, faces = self.surface(path)
            expected = nibabel.freesurfer.read_geometry(path)
            np.testing.assert_array_equal(points, expected[0], path)
            np.testing.assert_array_equal(faces, expected[1], path)

    def test_gifti_surfaces(self):
        files = glob.glob(data("cortex/fsaverage5_gifti/[pwisf]*_left.gii.gz")) + glob.glob(
            data("cortex/conte69_gifti/conte69*.gii")) + glob.glob(data("cortex/gifti_encodings/*.gii"))
        compared = 0
        for path in files:
            image = nibabel.load(unpacked(path, self.folder), mmap=False)
            sets = image.get_arrays_from_intent("pointset"), image.get_arrays_from_intent("triangle")
            if not all(sets) or os.path.basename(path) in ("ascii_flat_data.gii", "base64bin.gii"):
                continue
            points, faces = self.surface(path)
            np.testing.assert_array_equal(points, sets[0][0].data.astype(float), path)
            np.testing.assert_array_equal(faces, sets[1][0].data.reshape(-1, 3), path)
            compared += 1
        self.assertGreaterEqual(compared, 15)

    def test_tkras_becomes_scanner_ras_by_the_full_formula(self):
        path = data("cortex/subject1_fs/lh.pialsurface4")
        self.surface(path)
        points, _, meta = nibabel.freesurfer.read_geometry(path, read_metadata=True)
        d = np.column_stack([meta["xras"], meta["yras"], meta["zras"]])
        p_inverse = np.array([[-1, 0, 0], [0, 0, -1], [0, 1, 0]], float)
        expected = points @ (d @ p_inverse).T + meta["cras"]
        np.testing.assert_allclose(self.array("scanner", "<f8").reshape(-1, 3), expected, atol=1e-9)

    def test_the_scanner_space_is_that_of_the_volume(self):
        self.surface(data("cortex/subject1_fs/lh.pialsurface6"))
        points = self.array("scanner", "<f8").reshape(-1, 3)
        image = nibabel.load(data("cortex/subject1_fs/brain.mgz"))
        from scipy.ndimage import map_coordinates

        voxels = nibabel.affines.apply_affine(np.linalg.inv(image.affine), points)
        values = map_coordinates(image.get_fdata(), voxels.T, order=1)
        np.testing.assert_allclose(np.percentile(values, [1, 25, 50, 75, 99]), [40.4, 49.4, 53.2, 56.8, 103], atol=0.5)


class Values(Case):
    def test_morphometry(self):
        for name in ["cortex/fsaverage3_fs/lh.thickness", "cortex/subject1_fs/lh.thickness",
                     "cortex/subject1_fs/lh.area.gz", "cortex/conte69_gifti/lh.conte69_32k_thickness"]:
            path = data(name)
            run("scalars", path, self.out)
            expected = nibabel.freesurfer.read_morph_data(unpacked(path, self.folder))
            np.testing.assert_array_equal(self.array("values", "<f4"), expected, path)

    def test_old_morphometry(self):
        path = os.path.join(self.folder, "lh.curv")
        numbers = np.array([-123, 0, 7, 32767, -32768], ">i2")
        with open(path, "wb") as file:
            file.write(bytes([0, 0, 5, 0, 0, 6]) + numbers.tobytes())
        run("scalars", path, self.out)
        expected = nibabel.freesurfer.read_morph_data(path)
        np.testing.assert_allclose(self.array("values", "<f4"), expected, rtol=1e-6)

    def test_gifti_metrics(self):
        files = glob.glob(data("cortex/fsaverage5_gifti/[acst][uhr]*_*.gii.gz")) + [
            data("cortex/conte69_gifti/lh.conte69_32k_thickness.gii"), data("cortex/gifti_encodings/rh.shape.curv.gii"),
            data("cortex/gifti_encodings/gzipbase64.gii"), data("cortex/gifti_encodings/task.func.gii")]
        compared = 0
        for path in files:
            image = nibabel.load(unpacked(path, self.folder), mmap=False)
            run("scalars", path, self.out)
            np.testing.assert_array_equal(self.array("values", "<f4"), image.darrays[0].data.ravel().astype("f4"), path)
            compared += 1
        self.assertGreaterEqual(compared, 8)

    def test_mgh_overlay(self):
        path = data("cortex/conte69_gifti/lh.conte69_32k_thickness.mgh")
        run("scalars", path, self.out)
        expected = nibabel.load(path).get_fdata(dtype="f4").ravel()
        np.testing.assert_array_equal(self.array("values", "<f4"), expected)

    def test_annotations(self):
        for name in ["cortex/subject1_fs/lh.aparc.annot.gz", "cortex/fsaverage5_gifti/test.annot"]:
            path = data(name)
            run("annot", path, self.out)
            rows = [line.split("\t") for line in self.facts()]
            labels, table, names = nibabel.freesurfer.read_annot(unpacked(path, self.folder))
            self.assertEqual([row[1] for row in rows], [n.decode() for n in names])
            np.testing.assert_array_equal([[int(x) for x in row[2:5]] for row in rows], table[:, :3])
            np.testing.assert_array_equal([255 - int(row[5]) for row in rows], table[:, 3])
            ids = {int(row[0]): i for i, row in enumerate(rows)}
            ours = np.array([ids.get(label, -1) for label in self.array("labels", "<i4")])
            np.testing.assert_array_equal(ours, labels, path)

    def test_gifti_labels(self):
        for name in ["rh.aparc.annot.gii", "label.gii"]:
            path = data("cortex/gifti_encodings/" + name)
            run("annot", path, self.out)
            image = nibabel.load(path)
            np.testing.assert_array_equal(self.array("labels", "<i4"), image.darrays[0].data)
            rows = [line.split("\t") for line in self.facts()]
            self.assertEqual({int(row[0]): row[1] for row in rows}, image.labeltable.get_labels_as_dict())

    def test_freesurfer_labels(self):
        for path in glob.glob(data("cortex/*_fs/*.label")):
            run("label", path, self.out)
            np.testing.assert_array_equal(self.array("vertices", "<i4"), nibabel.freesurfer.read_label(path), path)


class MoreFormats(Case):
    def path(self, name):
        return os.path.join(self.folder, name)

    @staticmethod
    def bytes(path):
        with open(path, "rb") as file:
            return file.read()

    def test_patches_take_their_faces_from_the_whole_surface(self):
        whole = data("cortex/fsaverage3_fs/lh.white")
        points, faces = nibabel.freesurfer.read_geometry(whole)
        kept = np.flatnonzero(points[:, 2] > 0)[::-1]
        border = np.arange(len(kept)) % 5 == 0
        record = np.zeros(len(kept), [("vertex", ">i4"), ("xyz", ">f4", 3)])
        record["vertex"] = np.where(border, -(kept + 1), kept + 1)
        record["xyz"] = points[kept]
        with open(self.path("lh.patch.3d"), "wb") as file:
            file.write(np.array([-1, len(kept)], ">i4").tobytes() + record.tobytes())
        run("patch", self.path("lh.patch.3d"), self.out, whole)
        np.testing.assert_array_equal(self.array("vertices", "<i4"), kept)
        np.testing.assert_array_equal(self.array("border", "<i4"), border)
        inside = faces[np.isin(faces, kept).all(axis=1)]
        np.testing.assert_array_equal(kept[self.array("faces", "<i4")].reshape(-1, 3), inside)
        np.testing.assert_array_equal(self.array("points", "<f8").reshape(-1, 3), points[kept].astype("f4"))

    def test_mz3(self):
        for name, layers in (("BrainMesh_ICBM152.lh.mz3", 0), ("cortex_5124.mz3", 0), ("16DoubleOverlay_5124x2.mz3", 2),
                             ("BrainMesh_ICBM152.lh.motor.mz3", 1)):
            raw = self.bytes(data("cortex/mz3/" + name))
            raw = gzip.decompress(raw) if raw[:2] == b"\x1f\x8b" else raw
            _, attributes = np.frombuffer(raw, "<u2", 2)
            m, n, skip = (int(x) for x in np.frombuffer(raw, "<u4", 3, 4))
            run("mz3", data("cortex/mz3/" + name), self.out)
            at = 16 + skip
            for bit, part, kind, count in ((1, "faces", "<i4", 3 * m), (2, "points", "<f4", 3 * n)):
                if attributes & bit:
                    ours = self.array(part, "<i4" if bit == 1 else "<f8")
                    np.testing.assert_array_equal(ours, np.frombuffer(raw, kind, count, at), name)
                    at += 4 * count
            at += 4 * n if attributes & 4 else 0
            values = np.frombuffer(raw[at:], "<f8" if attributes & 16 else "<f4")
            self.assertEqual(len(values), n * layers, name)
            np.testing.assert_array_equal(self.array("values", "<f4"), values.astype("f4"), name)

    def test_written_mz3_is_read_back(self):
        run("write-mz3", data("cortex/fsaverage3_fs/lh.pial"), self.path("s.mz3"))
        points, faces = self.surface(self.path("s.mz3"))
        expected = nibabel.freesurfer.read_geometry(data("cortex/fsaverage3_fs/lh.pial"))
        np.testing.assert_array_equal(points, expected[0].astype("f4"))
        np.testing.assert_array_equal(faces, expected[1])

    def test_w_files(self):
        values = np.array([1.5, np.nan, -2, 0], "f4")
        np.savetxt(self.path("v.txt"), values)
        run("write-paint", self.path("v.txt"), self.path("lh.w"))
        raw = self.bytes(self.path("lh.w"))
        self.assertEqual(raw[:5], bytes([0, 0, 0, 0, 3]))
        entries = [(int.from_bytes(raw[i:i + 3], "big"), float(np.frombuffer(raw, ">f4", 1, i + 3)[0]))
                   for i in range(5, len(raw), 7)]
        self.assertEqual(entries, [(0, 1.5), (2, -2), (3, 0)])
        run("sparse", self.path("lh.w"), self.out, 6)
        np.testing.assert_array_equal(self.array("values", "<f4"), [1.5, np.nan, -2, 0, np.nan, np.nan])

    def test_sparse_gifti(self):
        image = nibabel.gifti.GiftiImage()
        arrays = ([4, 1], "NIFTI_INTENT_NODE_INDEX", "int32"), ([7, 8], "NIFTI_INTENT_SHAPE", "float32")
        for numbers, intent, kind in arrays:
            image.add_gifti_data_array(nibabel.gifti.GiftiDataArray(
                np.array(numbers, kind), intent=intent, datatype="NIFTI_TYPE_" + kind.upper()))
        nibabel.save(image, self.path("s.func.gii"))
        run("sparse", self.path("s.func.gii"), self.out, 6)
        np.testing.assert_array_equal(self.array("values", "<f4"), [np.nan, 8, np.nan, np.nan, 7, np.nan])

    def test_written_annotations_are_read_by_nibabel(self):
        source = unpacked(data("cortex/subject1_fs/lh.aparc.annot.gz"), self.folder)
        run("write-annot", source, self.path("w.annot"))
        ours, expected = (nibabel.freesurfer.read_annot(p) for p in (self.path("w.annot"), source))
        np.testing.assert_array_equal(ours[0], expected[0])
        np.testing.assert_array_equal(ours[1], expected[1])
        self.assertEqual(ours[2], expected[2])

    def test_written_mgh_is_read_by_nibabel(self):
        for name in ("edge/SRA.nii.gz", "edge/anatomical.nii", "edge/resampled_anat_moved.nii"):
            for ending in ("v.mgz", "v.mgh"):
                run("write-volume", data("volumes/" + name), self.path(ending))
                ours, expected = nibabel.load(self.path(ending)), nibabel.load(data("volumes/" + name))
                np.testing.assert_allclose(ours.affine, expected.affine, atol=2e-4, err_msg=name)
                np.testing.assert_allclose(np.asanyarray(ours.dataobj), np.asanyarray(expected.dataobj), rtol=1e-6)

    def test_cifti(self):
        random = np.random.default_rng(1)
        left = nibabel.cifti2.BrainModelAxis.from_surface(np.sort(random.choice(642, 500, False)), 642, "CortexLeft")
        right = nibabel.cifti2.BrainModelAxis.from_surface(np.arange(3, 640), 642, "CortexRight")
        voxels = nibabel.cifti2.BrainModelAxis.from_mask(np.ones((2, 2, 2)), "ThalamusLeft", np.eye(4))
        models = left + right + voxels
        table = {0: ("???", (0, 0, 0, 0)), 1: ("one", (1, 0, 0, 1)), 2: ("two", (0, 0, 1, 1))}
        for axis, ending in ((nibabel.cifti2.ScalarAxis(["first", "second"]), "a.dscalar.nii"),
                             (nibabel.cifti2.LabelAxis(["first", "second"], [table, table]), "a.dlabel.nii")):
            labels = "dlabel" in ending
            shape = 2, len(models)
            values = (random.integers(0, 3, shape) if labels else random.normal(size=shape)).astype("f4")
            image = nibabel.Cifti2Image(values, (axis, models))
            image.nifti_header.set_intent("ConnDenseLabel" if labels else "ConnDenseScalar")
            nibabel.save(image, self.path(ending))
            for structure, part in (("CortexLeft", slice(0, 500)), ("CortexRight", slice(500, 500 + 637))):
                run("cifti", self.path(ending), self.out, structure)
                expected = np.full((2, 642), -1 if labels else np.nan, "f4")
                expected[:, models.vertex[part]] = values[:, part]
                np.testing.assert_array_equal(self.array("values", "<f4").reshape(2, 642), expected, ending)
            self.assertEqual([line for line in self.facts() if line[0] != "\t"], ["first", "second"])
            self.assertEqual("\t1\tone" in self.facts(), labels)

    def test_files_of_nibabels_own_tests(self):
        root = os.path.dirname(nibabel.__file__)
        compared = 0
        for path in sorted(glob.glob(root + "/gifti/tests/data/*.gii")):
            image = nibabel.load(path)
            sets = image.get_arrays_from_intent("pointset"), image.get_arrays_from_intent("triangle")
            if all(sets) and len(sets[1][0].data) > 0 and sets[1][0].data.max() < len(sets[0][0].data):
                points, faces = self.surface(path)
                np.testing.assert_array_equal(points, sets[0][0].data.astype(float), path)
                np.testing.assert_array_equal(faces, sets[1][0].data.reshape(-1, 3), path)
                compared += 1
        for name in ("anatomical.nii", "functional.nii", "example4d.nii.gz", "example_nifti2.nii.gz", "standard.nii.gz",
                     "reoriented_anat_moved.nii", "resampled_anat_moved.nii", "test.mgz"):
            image = nibabel.load(os.path.join(root, "tests", "data", name))
            run("volume", os.path.join(root, "tests", "data", name), self.out)
            values = np.asanyarray(image.dataobj)
            values = values.reshape(values.shape[:3] + (-1,), order="F")[..., 0]
            np.testing.assert_allclose(self.array("values", "<f4").reshape(values.shape, order="F"),
                                       values.astype("f8"), rtol=2e-7, err_msg=name)
            compared += 1
        self.assertGreaterEqual(compared, 10)

    def test_gifti_tool_and_nifti_tool_accept_what_is_written(self):
        if not shutil.which("gifti_tool") or not shutil.which("nifti_tool"):
            self.skipTest("gifti_tool and nifti_tool are not installed")
        run("write-gifti", data("cortex/fsaverage3_fs/lh.pial"), self.path("s.surf.gii"))
        run("write-shape", data("cortex/fsaverage3_fs/lh.thickness"), self.path("s.shape.gii"))
        run("write-volume", data("volumes/edge/anatomical.nii"), self.path("v.nii"))
        for words in (["gifti_tool", "-gifti_test", "-infile", self.path("s.surf.gii")],
                      ["gifti_tool", "-gifti_test", "-infile", self.path("s.shape.gii")],
                      ["nifti_tool", "-check_hdr", "-infiles", self.path("v.nii")],
                      ["nifti_tool", "-check_nim", "-infiles", self.path("v.nii")]):
            done = subprocess.run(words, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, f"{words}: {done.stdout}{done.stderr}")
            self.assertNotRegex(done.stdout + done.stderr, r"(?i)fail|invalid|not valid|bad ")


class Volumes(Case):
    def compare(self, path, image, frame=0):
        run("volume", path, self.out, frame)
        facts = self.facts()
        shape = [int(x) for x in facts[0].split()]
        self.assertEqual(shape[:3], list(image.shape[:3]) + [1] * (3 - len(image.shape)))
        self.assertEqual(shape[3], int(np.prod(image.shape[3:])))
        values = np.asanyarray(image.dataobj)
        values = values.reshape(values.shape[:3] + (-1,), order="F")[..., frame]
        ours = self.array("values", "<f4").reshape(shape[:3], order="F")
        np.testing.assert_allclose(ours, values.astype("f8"), rtol=2e-7, err_msg=path)
        return np.array([[float(x) for x in row.split()] for row in facts[1:5]]), facts

    def test_volumes(self):
        names = ["ASR.nii.gz", "LPS.nii.gz", "RAS.nii.gz", "SRA.nii.gz", "anatomical.nii", "big.nii.gz",
                 "little.nii.gz", "example4d.nii.gz", "example_nifti2.nii.gz", "functional.nii", "low_res.nii.gz",
                 "ras.hdr", "ras.img", "resampled_anat_moved.nii", "someones_anatomy.nii.gz", "test.mgz",
                 "with_extension.nii.gz"]
        files = [data("volumes/edge/" + n) for n in names] + glob.glob(data("volumes/ct/*.nii.gz")) + glob.glob(
            data("volumes/spm12/*.nii")) + glob.glob(data("volumes/mni/*t1*")) + glob.glob(data("cortex/*_fs/*.mgz"))
        self.assertGreater(len(files), 24)
        for path in files:
            image = nibabel.load(path)
            affine, facts = self.compare(path, image)
            np.testing.assert_allclose(affine, image.affine, atol=2e-5, err_msg=path)
            self.assertEqual(facts[6], "scanner-ras", path)

    def test_frames(self):
        for name in ["functional.nii", "example4d.nii.gz", "test.mgz"]:
            image = nibabel.load(data("volumes/edge/" + name))
            for frame in (1, image.shape[3] - 1):
                self.compare(data("volumes/edge/" + name), image, frame)

    def test_without_orientation_the_space_is_unknown(self):
        path = data("volumes/edge/minimal.nii.gz")
        affine, facts = self.compare(path, nibabel.load(path))
        self.assertEqual(facts[6], "unknown")
        np.testing.assert_allclose(np.diag(affine)[:3], nibabel.load(path).header.get_zooms()[:3], rtol=1e-6)

    def test_mgh_without_good_ras(self):
        image = nibabel.MGHImage(np.arange(60, dtype="f4").reshape(3, 4, 5), None)
        path = os.path.join(self.folder, "plain.mgh")
        nibabel.save(image, path)
        with open(path, "r+b") as file:
            file.seek(28)
            file.write(b"\0\0")
        affine, facts = self.compare(path, nibabel.load(path))
        # FreeSurfer's coronal default; nibabel 5.0 turns y and z the other way round.
        coronal = np.array([[-1, 0, 0], [0, 0, 1], [0, -1, 0]])
        np.testing.assert_allclose(affine[:3, :3], coronal)
        np.testing.assert_allclose(affine[:3, 3], -coronal @ [1.5, 2, 2.5])
        self.assertEqual(facts[6], "unknown")

    def test_random_oblique_headers(self):
        random = np.random.default_rng(7)
        for number in range(12):
            rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
            affine = np.eye(4)
            affine[:3, :3] = rotation * random.uniform(0.4, 3, 3)
            affine[:3, 3] = random.uniform(-99, 99, 3)
            values = random.integers(-99, 99, (4, 5, 6)).astype("i2")
            kind = [nibabel.Nifti1Image, nibabel.Nifti2Image, nibabel.Nifti1Pair][number % 3]
            image = kind(values, affine)
            image.header.set_xyzt_units("mm")
            if number % 2:
                image.set_qform(affine, 1)
                image.set_sform(None, 0)
            path = os.path.join(self.folder, f"v{number}" + (".hdr" if number % 3 == 2 else ".nii"))
            nibabel.save(image, path)
            ours, facts = self.compare(path, nibabel.load(path))
            np.testing.assert_allclose(ours, affine, atol=1e-4)
            self.assertIn("qform" if number % 2 else "sform", facts[7])

    def test_nan_stays_nan(self):
        values = np.array([[[1.5, np.nan, -2]]], "f4")
        path = os.path.join(self.folder, "nan.nii.gz")
        nibabel.save(nibabel.Nifti1Image(values, np.eye(4)), path)
        self.compare(path, nibabel.load(path))

    def test_written_volumes_are_read_back(self):
        for name in ["SRA.nii.gz", "anatomical.nii", "resampled_anat_moved.nii"]:
            path = os.path.join(self.folder, "w.nii.gz")
            source = nibabel.load(data("volumes/edge/" + name))
            run("write-volume", data("volumes/edge/" + name), path)
            written = nibabel.load(path)
            np.testing.assert_allclose(written.affine, source.affine, atol=2e-5)
            np.testing.assert_allclose(np.asanyarray(written.dataobj), np.asanyarray(source.dataobj), rtol=1e-6)
            if int(written.header["qform_code"]):
                np.testing.assert_allclose(written.get_qform(), source.affine, atol=1e-4)


class Writers(Case):
    def test_gifti_surface(self):
        path = os.path.join(self.folder, "lh.surf.gii")
        run("write-gifti", data("cortex/subject1_fs/lh.pialsurface5"), path)
        self.surface(data("cortex/subject1_fs/lh.pialsurface5"))
        points = self.array("scanner", "<f8").reshape(-1, 3).astype("f4")
        image = nibabel.load(path)
        np.testing.assert_array_equal(image.darrays[0].data, points)
        np.testing.assert_array_equal(image.darrays[1].data, self.array("faces", "<i4").reshape(-1, 3))
        self.assertEqual(image.darrays[0].coordsys.dataspace, 1)
        self.assertIn("VolGeomC_R", image.darrays[0].metadata)

    def test_freesurfer_surface(self):
        source = data("cortex/subject1_fs/lh.pialsurface4")
        path = os.path.join(self.folder, "lh.copy")
        run("write-freesurfer", source, path)
        points, faces, meta = nibabel.freesurfer.read_geometry(path, read_metadata=True)
        expected = nibabel.freesurfer.read_geometry(source, read_metadata=True)
        np.testing.assert_array_equal(points, expected[0])
        np.testing.assert_array_equal(faces, expected[1])
        for key in ["volume", "voxelsize", "xras", "yras", "zras", "cras"]:
            np.testing.assert_allclose(meta[key], expected[2][key], atol=1e-12)

    def test_labels_and_metrics(self):
        shape = os.path.join(self.folder, "t.shape.gii")
        run("write-shape", data("cortex/subject1_fs/lh.thickness"), shape)
        np.testing.assert_array_equal(nibabel.load(shape).darrays[0].data,
                                      nibabel.freesurfer.read_morph_data(data("cortex/subject1_fs/lh.thickness")))
        label = os.path.join(self.folder, "a.label.gii")
        run("write-label", data("cortex/subject1_fs/lh.aparc.annot.gz"), label)
        image = nibabel.load(label)
        _, _, names = nibabel.freesurfer.read_annot(unpacked(data("cortex/subject1_fs/lh.aparc.annot.gz"), self.folder))
        self.assertTrue({n.decode() for n in names} <= set(image.labeltable.get_labels_as_dict().values()))


@unittest.skipUnless(shutil.which("wb_command"), "wb_command is not installed")
class Workbench(Case):
    def information(self, path):
        done = subprocess.run(["wb_command", "-file-information", path], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_surface_metric_and_labels(self):
        surface = os.path.join(self.folder, "lh.surf.gii")
        run("write-gifti", data("cortex/fsaverage5_gifti/pial_left.gii.gz"), surface)
        words = self.information(surface)
        self.assertIn("CortexLeft", words)
        self.assertRegex(words, r"Number of Vertices:\s+10242")
        shape = os.path.join(self.folder, "t.shape.gii")
        run("write-shape", data("cortex/fsaverage5_gifti/thick_left.gii.gz"), shape)
        words = self.information(shape)
        self.assertIn("CortexLeft", words)
        label = os.path.join(self.folder, "a.label.gii")
        run("write-label", data("cortex/subject1_fs/lh.aparc.annot.gz"), label)
        self.assertIn("superiorfrontal", self.information(label))

    def test_coordinates(self):
        surface = os.path.join(self.folder, "lh.surf.gii")
        coordinates = os.path.join(self.folder, "xyz.func.gii")
        run("write-gifti", data("cortex/subject1_fs/lh.pialsurface4"), surface)
        subprocess.run(["wb_command", "-surface-coordinates-to-metric", surface, coordinates], check=True)
        theirs = np.column_stack([array.data for array in nibabel.load(coordinates).darrays])
        self.surface(data("cortex/subject1_fs/lh.pialsurface4"))
        np.testing.assert_array_equal(theirs, self.array("scanner", "<f8").reshape(-1, 3).astype("f4"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *REST])
