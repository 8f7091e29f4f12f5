#!/usr/bin/python3
"""Makes the fixtures of data/ and MANIFEST.tsv; running it again gives the same bytes.

    make_fixtures.py [DIRECTORY]
"""
import gzip
import hashlib
import pathlib
import struct
import sys

import numpy as np


def disk(rings):
    """Points and faces of a flat unit disk; ring r has 6 r vertices."""
    points, first = [(0.0, 0.0)], [0]
    for r in range(1, rings + 1):
        first.append(len(points))
        angle = 2 * np.pi * np.arange(6 * r) / (6 * r)
        points += list(zip(r / rings * np.cos(angle), r / rings * np.sin(angle)))
    faces = []
    for r in range(1, rings + 1):
        outer, inner = 6 * r, max(6 * (r - 1), 1)
        for side in range(6):
            for k in range(r):
                a, b = side * r + k, side * (r - 1) + k
                faces.append((first[r] + a, first[r] + (a + 1) % outer, first[r - 1] + b % inner))
                if k + 1 < r:
                    faces.append((first[r - 1] + b % inner, first[r] + (a + 1) % outer, first[r - 1] + (b + 1) % inner))
    return np.array(points), np.array(faces)


def sphere(levels):
    """Points and faces of the octahedron subdivided onto the unit sphere."""
    points = [np.array(p, float) for p in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(levels):
        middle, finer = {}, []

        def mid(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                m = points[a] + points[b]
                middle[key] = len(points)
                points.append(m / np.linalg.norm(m))
            return middle[key]

        for a, b, c in faces:
            x, y, z = mid(a, b), mid(b, c), mid(c, a)
            finer += [(a, x, z), (x, b, y), (z, y, c), (x, y, z)]
        faces = finer
    return np.array(points), np.array(faces)


def torus(rings, sides):
    u, v = np.meshgrid(2 * np.pi * np.arange(rings) / rings, 2 * np.pi * np.arange(sides) / sides, indexing="ij")
    r = 3 + np.cos(v)
    points = np.stack([r * np.cos(u), r * np.sin(u), np.sin(v)], -1).reshape(-1, 3)
    at = lambda i, j: (i % rings) * sides + j % sides
    faces = [f for i in range(rings) for j in range(sides)
             for f in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))]
    return points, np.array(faces)


def slab(holes, size):
    """mm; the smoothed surface of a slab with square holes in a row, of genus `holes`; `size` voxels to a hole."""
    solid = np.ones(((2 * holes + 1) * size, 3 * size, size), bool)
    for k in range(holes):
        solid[(2 * k + 1) * size:(2 * k + 2) * size, size:2 * size] = False
    inside = np.pad(solid, 1)
    number, faces = {}, []
    for voxel in np.argwhere(solid):
        for axis in range(3):
            for side in (0, 1):
                if inside[tuple(voxel + 1 + (2 * side - 1) * np.eye(3, dtype=int)[axis])]:
                    continue
                u, v = np.eye(3, dtype=int)[[(axis + 1) % 3, (axis + 2) % 3]]
                corner = voxel + side * np.eye(3, dtype=int)[axis]
                a, b, c, d = (number.setdefault(tuple(p), len(number))
                              for p in (corner, corner + u, corner + u + v, corner + v))
                faces += [(a, b, c), (a, c, d)] if side else [(a, c, b), (a, d, c)]
    points, faces = np.array(list(number), float), np.array(faces)
    for _ in range(6):
        total, count = np.zeros_like(points), np.zeros(len(points))
        for k in range(3):  # every edge once from each end
            np.add.at(total, faces[:, k], points[faces[:, (k + 1) % 3]])
            np.add.at(count, faces[:, k], 1)
        points = 0.5 * (points + total / count[:, None])
    return points, faces


def bent_tube(along, around):
    """mm; a quarter of a torus with swellings and no symmetry, open at both ends."""
    u, v = np.meshgrid(np.arange(along + 1) / along, 2 * np.pi * np.arange(around) / around, indexing="ij")
    r = 8 + 2 * np.sin(9 * u + 0.5) + np.cos(2 * v + 3 * u)
    bend = 0.5 * np.pi * u
    points = np.stack([(30 + r * np.cos(v)) * np.cos(bend), (30 + r * np.cos(v)) * np.sin(bend), r * np.sin(v)], -1)
    at = lambda i, j: i * around + j % around
    faces = [f for i in range(along) for j in range(around)
             for f in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))]
    return points.reshape(-1, 3), np.array(faces)


def bumpy_disk():
    """mm; a disk of radius 40 with bumps, no symmetry."""
    p, faces = disk(20)
    x, y = p.T
    z = 0.5 * (np.sin(3 * x + 1) * np.cos(4 * y) + 0.5 * np.exp(-8 * ((x - 0.3) ** 2 + y ** 2)))
    return 40 * np.column_stack([x, y, z]), faces


def folded_sphere():
    """mm; a closed surface of genus 0 with folds, like a small cortex."""
    p, faces = sphere(5)
    x, y, z = p.T
    radius = 30 * (1 + 0.12 * np.sin(7 * x + 2 * y) * np.cos(6 * y - z) + 0.08 * np.sin(9 * z + 3 * x))
    return radius[:, None] * p, faces


def shells():
    """mm; the two halves of a closed surface without symmetry, with one rim of 72 vertices in the plane z = 0."""
    p, faces = disk(12)
    x, y = p.T
    high = (1 - x**2 - y**2) * (1 + 0.4 * np.sin(4 * x + 1) * np.cos(3 * y))
    low = -0.7 * (1 - x**2 - y**2) * (1 + 0.3 * np.cos(3 * x - y))
    rim = np.isclose(x**2 + y**2, 1)
    return [(30 * np.column_stack([x, y, np.where(rim, 0.0, z)]), f) for z, f in ((high, faces), (low, faces[:, ::-1]))]


def phantom():
    """A two-hemisphere phantom at 2 mm: T1-like intensities, and labels 1 (left) and 2 (right) of the grey matter.

    White matter 110, grey matter 80, outside 0; folded like a cortex; the hemispheres touch in a small bridge.
    """
    shape, spacing = (72, 84, 64), 2.0
    affine = np.diag([spacing, spacing, spacing, 1.0])
    affine[:3, 3] = [-spacing * (n - 1) / 2 for n in shape]
    i, j, k = np.indices(shape)
    x, y, z = (affine[a, 3] + spacing * c for a, c in enumerate((i, j, k)))
    t1, labels = np.zeros(shape), np.zeros(shape, np.uint8)
    for side, label in ((-1, 1), (1, 2)):
        u, v, w = (x - side * 30) / 28, y / 62, z / 46
        radius = np.sqrt(u * u + v * v + w * w) + 1e-9
        folds = 0.06 * np.sin(0.16 * y + 0.05 * z) * np.cos(0.17 * z) + 0.04 * np.sin(0.2 * y + 0.1 * x)
        t1[(radius < 0.95 + folds) & (t1 < 80)] = 80
        labels[(radius < 0.95 + folds) & (side * x > 0)] = label
        t1[radius < 0.80 + folds] = 110
    bridge = (np.abs(x) < 16) & ((y / 14) ** 2 + (z / 6) ** 2 < 1)
    t1[bridge] = 110
    labels[t1 >= 110] = 0
    return np.round(t1).astype(np.uint8), labels, affine


def off_bytes(points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += ["{:.9g} {:.9g} {:.9g}".format(*p) for p in points]
    lines += ["3 {} {} {}".format(*f) for f in faces]
    return ("\n".join(lines) + "\n").encode()


def nifti_bytes(volume, affine):
    """A gzipped single-file NIfTI-1 of uint8 with sform = scanner."""
    header = bytearray(348)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *volume.shape, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 2, 8)
    struct.pack_into("<8f", header, 76, 1, affine[0, 0], affine[1, 1], affine[2, 2], 0, 0, 0, 0)
    struct.pack_into("<3f", header, 108, 352, 1, 0)
    struct.pack_into("<B", header, 123, 2)
    struct.pack_into("<2h", header, 252, 0, 1)
    for row in range(3):
        struct.pack_into("<4f", header, 280 + 16 * row, *affine[row])
    header[344:348] = b"n+1\0"
    return gzip.compress(bytes(header) + b"\0\0\0\0" + volume.tobytes(order="F"), 9, mtime=0)


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    t1, labels, affine = phantom()
    fixtures = {
        "bumpy_disk.off": (off_bytes(*bumpy_disk()), "mm", "topological disk, 1 boundary loop of 120 vertices"),
        "folded_sphere.off": (off_bytes(*folded_sphere()), "mm", "closed, genus 0"),
        "upper_shell.off": (off_bytes(*shells()[0]), "mm", "topological disk, meets lower_shell.off at its rim"),
        "lower_shell.off": (off_bytes(*shells()[1]), "mm", "topological disk, meets upper_shell.off at its rim"),
        "torus.off": (off_bytes(*torus(24, 12)), "mm", "closed, genus 1"),
        "double_torus.off": (off_bytes(*slab(2, 4)), "mm", "closed, genus 2"),
        "bent_tube.off": (off_bytes(*bent_tube(24, 24)), "mm", "annulus, 2 boundary loops of 24 vertices"),
        "phantom_t1.nii.gz": (nifti_bytes(t1, affine), "intensity", "two folded hemispheres, 2 mm: white 110, grey 80"),
        "phantom_labels.nii.gz": (nifti_bytes(labels, affine), "label", "grey matter of the phantom: 1 left, 2 right"),
    }
    rows = ["file\tsha256\tunits\tlicence\tdescription"]
    for name, (content, units, description) in fixtures.items():
        (folder / name).write_bytes(content)
        rows.append("\t".join([name, hashlib.sha256(content).hexdigest(), units, "BSD-3-Clause", description]))
    (folder / "MANIFEST.tsv").write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
