"""Files that the tests of `convert` and `info` start from, as FreeSurfer would write them."""
import struct
import subprocess

from command_line import ARGUMENTS, CommandLine

# An oblique volume: the axes are a rotation by no right angle.
OBLIQUE = ("valid = 1  # volume info valid\nfilename = ../mri/orig.mgz\nvolume = 64 72 80\n"
           "voxelsize = 1.5 1 0.75\nxras   = -0.8 0.6 0\nyras   = 0 0 -1\nzras   = 0.6 0.8 0\ncras   = 3.5 -20.25 7\n")
D_P_INVERSE = ((0.8, 0.6, 0.0), (-0.6, 0.8, 0.0), (0.0, 0.0, 1.0))  # D P^-1 of these axes, by hand


def white(path, n=9, geometry=OBLIQUE):
    """A FreeSurfer triangle file of a bumpy sheet, as FreeSurfer writes it."""
    points = [(float(x) - 4, float(y) - 4, 0.25 * ((3 * x + 5 * y) % 7)) for y in range(n) for x in range(n)]
    faces = []
    for y in range(n - 1):
        for x in range(n - 1):
            a = y * n + x
            faces += [(a, a + 1, a + n + 1), (a, a + n + 1, a + n)]
    data = b"\xff\xff\xfecreated by Authalic\n\n" + struct.pack(">ii", len(points), len(faces))
    data += b"".join(struct.pack(">3f", *p) for p in points) + b"".join(struct.pack(">3i", *f) for f in faces)
    if geometry:
        data += struct.pack(">iii", 2, 0, 20) + geometry.encode()
    path.write_bytes(data)
    return points, faces


def curv(path, values, faces=0):
    path.write_bytes(b"\xff\xff\xff" + struct.pack(">iii", len(values), faces, 1) +
                     struct.pack(f">{len(values)}f", *values))


class Formats(CommandLine):
    def setUp(self):
        super().setUp()
        self.points, self.faces = white(self.here / "lh.white")
        self.values = [0.1 * i - 2 for i in range(81)]
        curv(self.here / "lh.thickness", self.values, len(self.faces))

    def path(self, name):
        return self.here / name

    def bytes(self, name):
        return self.path(name).read_bytes()

    def converts(self, *words):
        """Returns what stderr says."""
        result = self.run_verb("convert", *words)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stderr

    def limited(self, *words, setup):
        """Runs the command after `setup`, a line of the shell."""
        return subprocess.run(["bash", "-c", setup + ' exec "$0" "$@"', ARGUMENTS.authalic, *map(str, words)],
                              capture_output=True, text=True, cwd=self.here)

    def there_and_back(self, source, middle, back, *, there=(), home=()):
        said = self.converts(source, middle, *there) + self.converts(middle, back, *home)
        self.assertEqual(self.bytes(back), self.bytes(source), f"{source} -> {middle} -> {back}")
        return said

    def lines_of(self, path, *words):
        return dict(line.split(None, 1) for line in self.succeeds("info", path, *words).splitlines() if " " in line)

    def annot(self, name):
        regions = [(0, "unknown", 25, 5, 25, 255), (3, "front & centre", 200, 10, 30, 255), (7, "back", 1, 2, 3, 90)]
        labels = [regions[i % 3] if i % 11 else None for i in range(81)]
        data = struct.pack(">i", 81)
        for i, region in enumerate(labels):
            data += struct.pack(">ii", i, region[2] + (region[3] << 8) + (region[4] << 16) if region else 0)
        data += struct.pack(">iii", 1, -2, 8) + struct.pack(">i", 9) + b"authalic\0" + struct.pack(">i", 3)
        for number, words, *color, opacity in regions:
            text = words.encode() + b"\0"
            data += struct.pack(">ii", number, len(text)) + text + struct.pack(">4i", *color, 255 - opacity)
        self.path(name).write_bytes(data)

    def nifti(self, name, sform_code, qform_code, shift):
        header = bytearray(352)
        struct.pack_into("<i", header, 0, 348)
        struct.pack_into("<8h", header, 40, 3, 2, 3, 4, 1, 1, 1, 1)
        struct.pack_into("<hh", header, 70, 4, 16)
        struct.pack_into("<4f", header, 76, 1, 2, 2, 2)
        struct.pack_into("<f", header, 108, 352)
        header[123] = 2
        struct.pack_into("<hh6f", header, 252, qform_code, sform_code, 0, 0, 0, 5 + shift, 6, 7)
        struct.pack_into("<12f", header, 280, 2, 0, 0, 5, 0, 2, 0, 6, 0, 0, 2, 7)
        header[344:348] = b"n+1\0"
        self.path(name).write_bytes(bytes(header) + struct.pack("<24h", *range(24)))
