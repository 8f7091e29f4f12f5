"""Reads every file of the real data and of nibabel's own test data with Authalic and with nibabel, and compares.

    walk_with_nibabel.py --dump PROGRAM --data FOLDER

Values and labels must be the same, coordinates too; what nibabel does not read as a volume or a surface, and kinds that
Authalic refuses (colours, complex numbers, headers without voxels), must end in one sentence and exit code 5. Leaves
with 77 (skipped) when nibabel is missing.
"""
import argparse
import collections
import gzip
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import warnings

try:
    import nibabel
    import numpy as np
except ImportError:
    print("nibabel is not installed; nothing to compare with")
    sys.exit(77)

VOLUMES = (".nii", ".mgz", ".mgh", ".hdr")
# Not read, and refused in words: types, and headers that hold no voxels.
REFUSED = {"ascii_flat_data.gii": "6402", "base64bin.gii": "6402",  # faces of a surface that is not in the file
           "example_rgb.nii.gz": "RGB", "nifti1.hdr": ".img", "nifti2.hdr": ".img", "analyze.hdr": "Analyze",
           "row_major.dconn.nii": "CIFTI"}


class Different(Exception):
    pass


class Walk:
    def __init__(self, dump):
        self.dump, self.counts, self.failures = dump, collections.Counter(), []
        self.folder = tempfile.mkdtemp()
        self.out = os.path.join(self.folder, "out")

    def run(self, action, path, *words):
        done = subprocess.run([self.dump, action, path, self.out, *map(str, words)], capture_output=True, text=True,
                              timeout=120, check=False)
        if done.returncode not in (0, 5) or (done.returncode == 5 and len(done.stderr.splitlines()) != 1):
            raise Different(f"exit {done.returncode}: {done.stderr}")
        return done.returncode == 0, done.stderr

    def must(self, action, path, *words):
        good, said = self.run(action, path, *words)
        if not good:
            raise Different(f"refused: {said}")

    def array(self, name, kind):
        return np.fromfile(f"{self.out}.{name}", kind)

    def plain(self, path):
        """nibabel wants the plain file of surfaces."""
        if path.suffix != ".gz":
            return path
        target = pathlib.Path(self.folder, path.name[:-3])
        with gzip.open(path) as source, open(target, "wb") as file:
            shutil.copyfileobj(source, file)
        return target

    @staticmethod
    def same(ours, theirs, what, tolerance=0):
        if ours.shape != theirs.shape:
            raise Different(f"{what}: shape {ours.shape} instead of {theirs.shape}")
        if not np.allclose(ours, theirs, rtol=tolerance, atol=tolerance, equal_nan=True):
            raise Different(f"{what} differ")

    def volume(self, path):
        image = nibabel.load(path)
        frames = int(np.prod(image.shape[3:], dtype=int))
        shape = (tuple(image.shape) + (1, 1, 1))[:3]
        data = np.asanyarray(image.dataobj).reshape(shape + (frames,), order="F")
        for frame in {0, frames - 1}:
            self.must("volume", path, frame)
            values = self.array("values", "<f4").reshape(shape, order="F")
            self.same(values, data[..., frame].astype("f4"), "values", 2e-7)  # scaling is done in double, then rounded
        lines = pathlib.Path(self.out + ".txt").read_text(encoding="utf-8").splitlines()
        if lines[6] == "scanner-ras":
            affine = np.array([line.split() for line in lines[1:5]], float)
            self.same(affine, image.affine, "affine", 2e-5)

    def gifti(self, path):
        plain = self.plain(path)
        if (path.parent / "external.dat").exists() and path.suffix == ".gz":
            shutil.copy(path.parent / "external.dat", self.folder)
        image = nibabel.load(plain, mmap=False)
        points, faces = (image.get_arrays_from_intent(name) for name in ("pointset", "triangle"))
        if points and faces:
            self.must("surface", path)
            self.same(self.array("points", "<f8"), points[0].data.ravel(order="C").astype(float), "points")
            self.same(self.array("faces", "<i4"), faces[0].data.ravel(order="C"), "faces")
            return "GIFTI surface"
        metric = next((a for a in image.darrays if np.squeeze(a.data).ndim == 1 and a.intent != 1002), None)
        if metric is not None:
            self.must("scalars", path)
            self.same(self.array("values", "<f4"), metric.data.ravel().astype("f4"), "values")
            return "GIFTI metric"
        label = next(a for a in image.darrays if a.intent == 1002)
        self.must("annot", path)
        self.same(self.array("labels", "<i4"), label.data.ravel(), "labels")
        return "GIFTI labels"

    def freesurfer(self, path):
        plain = self.plain(path)
        start = plain.read_bytes()[:3]
        if plain.suffix == ".label":
            self.must("label", path)
            self.same(self.array("vertices", "<i4"), nibabel.freesurfer.read_label(plain), "vertices")
            return "FreeSurfer label"
        if plain.suffix == ".annot":
            self.must("annot", path)
            labels, _, names = nibabel.freesurfer.read_annot(plain)
            rows = [line.split("\t") for line in pathlib.Path(self.out + ".txt").read_text().splitlines()]
            if [row[1] for row in rows] != [name.decode() for name in names]:
                raise Different("names of regions differ")
            ids = {int(row[0]): i for i, row in enumerate(rows)}
            self.same(np.array([ids.get(x, -1) for x in self.array("labels", "<i4")]), labels, "labels")
            return "FreeSurfer annotation"
        if start == b"\xff\xff\xfe":
            self.must("surface", path)
            points, faces = nibabel.freesurfer.read_geometry(plain)
            self.same(self.array("points", "<f8"), points.ravel().astype(float), "points")
            self.same(self.array("faces", "<i4"), faces.ravel(), "faces")
            return "FreeSurfer surface"
        self.must("scalars", path)
        self.same(self.array("values", "<f4"), nibabel.freesurfer.read_morph_data(plain), "values")
        return "FreeSurfer morphometry"

    def kind(self, path):
        """Compares one file; returns what it was."""
        name = path.name[:-3] if path.name.endswith(".gz") else path.name
        if path.name in REFUSED:
            good, said = self.run("surface" if path.suffix == ".gii" else "volume", path)
            if good or REFUSED[path.name] not in said:
                raise Different(f"not refused in the right words: {said}")
            return "refused"
        if name.endswith(".gii"):
            return self.gifti(path)
        if name.endswith(VOLUMES):
            self.volume(path)
            return "volume"
        is_freesurfer = name.endswith((".label", ".annot")) or self.plain(path).read_bytes()[:2] == b"\xff\xff"
        if is_freesurfer and not path.suffix == ".dcm":
            return self.freesurfer(path)
        for action in ("volume", "surface", "scalars", "annot", "label"):
            self.run(action, path)  # a sentence or a result, whatever it is
        return "another kind"

    def visit(self, path):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                self.counts[self.kind(path)] += 1
        except Exception as error:  # one file must not hide the others
            self.failures.append(f"{path}: {type(error).__name__}: {error}")


def files_of(folders):
    skipped = (".py", ".pyc", ".md", ".rst", ".txt", ".m", ".dat", ".bz2")
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.is_file() and path.suffix not in skipped and path.name != "LICENSE":
                yield path


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--dump", required=True)
    parser.add_argument("--data", required=True)
    options = parser.parse_args()
    package = pathlib.Path(nibabel.__file__).parent
    walk = Walk(options.dump)
    for path in files_of([options.data, *package.rglob("tests/data")]):
        walk.visit(path)
    shutil.rmtree(walk.folder)
    for kind, count in sorted(walk.counts.items()):
        print(f"{count:4d}  {kind}")
    print("\n".join(walk.failures))
    few = walk.counts["volume"] < 5
    return 1 if walk.failures or few else 0


if __name__ == "__main__":
    sys.exit(main())
