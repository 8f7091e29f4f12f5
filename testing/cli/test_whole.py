#!/usr/bin/python3
"""Outputs are there whole or not at all: full disks, read-only folders, kills in the middle of a write.

    test_whole.py --authalic PROGRAM --fixtures FOLDER --data FOLDER
"""
import json
import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import time
import unittest

from command_line import ARGUMENTS, grid, main
from format_files import Formats, curv


class Whole(Formats):
    """Outputs are there whole or not at all."""

    def outputs(self):
        volume = pathlib.Path(ARGUMENTS.fixtures) / "phantom_t1.nii.gz"
        big = grid(self.path("big.off"), 60)
        curv(self.path("lh.long"), [float(i % 2000) for i in range(3721)])
        for name in ("o.vtp", "o.vtk", "o.surf.gii", "o.ply", "o.obj", "o.off", "o.stl", "o.mz3", "lh.o"):
            yield big, name
        for name in ("o.shape.gii", "o.label.gii", "o.annot", "o.w", "o.mgh", "o.mgz", "o.txt", "o.curv"):
            yield "lh.long", name
        for name in ("o.nii", "o.nii.gz", "o.mgh", "o.mgz"):
            yield volume, name
        self.succeeds("convert", big, "all.vtp", "-q")
        self.path("every.label").write_text("#!ascii label\n3721\n" +
                                            "".join(f"{i} 0 0 0 0\n" for i in range(3721)))
        self.succeeds("convert", "all.vtp", "marked.vtp", "--data", "every.label", "-q")
        yield "marked.vtp", "o.label"
        self.path("all.patch.3d").write_bytes(struct.pack(">ii", -1, 3721) + b"".join(
            struct.pack(">i3f", i + 1, i % 61, i // 61, 0) for i in range(3721)))
        self.succeeds("convert", "all.patch.3d", "patch.vtp", "--whole", "all.vtp", "-q")
        yield "patch.vtp", "o.patch.3d"

    def test_a_full_disk_is_5_and_leaves_the_old_file(self):
        for source, name in self.outputs():
            self.path(name).write_bytes(b"old")
            before = set(self.here.iterdir())
            result = self.limited("convert", source, name, "-q", setup="trap '' XFSZ; ulimit -f 1;")
            self.assertEqual(result.returncode, 5, (name, result.stderr))
            self.assertIn("cannot be", result.stderr)
            self.assertEqual(self.bytes(name), b"old", name)
            self.assertEqual(set(self.here.iterdir()), before, name)
            self.path(name).unlink()

    @unittest.skipUnless(os.geteuid() == 0, "only root can mount a small disk")
    def test_a_disk_that_is_full_is_5_and_leaves_nothing(self):
        disk = self.path("disk")
        disk.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", disk], capture_output=True).returncode:
            self.skipTest("a file system cannot be mounted here")
        try:
            for source, name in self.outputs():
                result = self.run_verb("convert", source, disk / name, "-q")
                if result.returncode == 0:  # small enough
                    self.assertEqual(self.run_verb("info", disk / name).returncode in (0, 5), True)
                    (disk / name).unlink()
                    continue
                self.assertEqual(result.returncode, 5, (name, result.stderr))
                self.assertEqual(list(disk.iterdir()), [], name)
        finally:
            subprocess.run(["umount", disk], check=True)

    @unittest.skipIf(os.geteuid() == 0 and not shutil.which("setpriv"), "root may write anywhere")
    def test_a_folder_that_is_read_only_is_5(self):
        closed = self.path("closed")
        closed.mkdir()
        outputs = list(self.outputs())
        for path in (self.here, *self.here.iterdir()):
            path.chmod(0o755 if path.is_dir() else 0o644)
        closed.chmod(0o555)
        word = ["setpriv", "--reuid=65534", "--clear-groups"] if os.geteuid() == 0 else []
        for source, name in outputs:
            result = subprocess.run([*word, ARGUMENTS.authalic, "convert", source, "closed/" + name], cwd=self.here,
                                    capture_output=True, text=True)
            self.assertEqual(result.returncode, 5, (name, result.stderr))
            self.assertEqual(list(closed.iterdir()), [])

    def test_killed_in_the_middle_of_a_write_the_old_file_stays_and_what_is_left_breaks_no_later_run(self):
        for source, name in self.outputs():
            self.succeeds("convert", source, name, "-q")
            new = self.bytes(name)
            self.path(name).write_bytes(b"old")
            before = set(self.here.iterdir())
            killed = self.limited("convert", source, name, "-q", setup="ulimit -c 0 -f 1;")  # SIGXFSZ after 1 KB
            self.assertEqual(killed.returncode, -signal.SIGXFSZ, (name, killed.stderr))
            self.assertEqual(self.bytes(name), b"old", name)
            left = set(self.here.iterdir()) - before
            self.assertTrue(all(path.name.startswith("." + name) and path.suffix == ".tmp" for path in left), left)
            self.succeeds("convert", source, name, "-q")
            self.assertEqual(self.bytes(name), new, name)
            for path in (*left, self.path(name)):
                path.unlink()

    def test_killed_in_the_middle_the_old_file_is_there_or_the_new(self):
        big = grid(self.path("big.off"), 300)
        self.succeeds("convert", big, "whole.surf.gii")
        new = self.bytes("whole.surf.gii")
        seen = set()
        for attempt in range(12):
            self.path("o.surf.gii").write_bytes(b"old")
            process = subprocess.Popen([ARGUMENTS.authalic, "convert", big, "o.surf.gii"], cwd=self.here,
                                       stderr=subprocess.DEVNULL)
            time.sleep(0.04 * attempt)
            process.send_signal(signal.SIGKILL)
            process.wait()
            content = self.bytes("o.surf.gii")
            self.assertIn(content, (b"old", new))
            seen.add(content == new)
        self.assertIn(False, seen)


class EveryVerb(Formats):
    """The same of whatever a verb writes: surfaces, maps, tables, reports."""

    def commands(self):
        """Words of the command and its outputs; sources are made on the way."""
        fixtures = pathlib.Path(ARGUMENTS.fixtures)
        phantom, ball = fixtures / "phantom_t1.nii.gz", fixtures / "folded_sphere.off"
        yield ("info", self.sheet, "--json", "o.json"), ["o.json"]
        yield ("repair", fixtures / "torus.off", "o.vtp", "--json", "o.json"), ["o.vtp", "o.json"]
        yield ("map", "tutte", self.sheet, "-o", "o.vtp", "--report", "o.json"), ["o.vtp", "o.json"]
        self.succeeds("map", "tutte", self.sheet, "-o", "map.vtp", "-q")
        self.path("three.txt").write_text("".join(f"{i % 3}\n" for i in range(625)))
        yield ("map", "transport", self.sheet, "-o", "o.vtp", "--cells", "c.vtp"), ["o.vtp", "c.vtp"]
        yield ("cut", ball, "-o", "o.vtp", "--plane", "0", "0", "0", "0", "0", "1", "--json", "o.json"), \
            ["o.vtp", "o.json"]
        yield ("sample", phantom, self.sheet, "--space", "scanner-ras", "-o", "o.vtp", "--json", "o.json"), \
            ["o.vtp", "o.json"]
        yield ("sample", phantom, self.sheet, "--space", "scanner-ras", "-o", "o.func.gii"), ["o.func.gii"]
        yield ("elements", "map.vtp", "-o", "o.tsv", "--elements", "16", "--regions", "r.tsv", "--labels", "three.txt",
               "--json", "j.json", "--grid", "g.vtp"), ["o.tsv", "j.json", "r.tsv", "g.vtp"]
        yield ("density", self.sheet, "-o", "o.vtp", "--curvature-measure", "gaussian"), ["o.vtp"]
        yield ("balance", self.sheet, "-o", "o.tsv", "--values", "2", "--allow-nonconverged"), ["o.tsv", "o.json"]
        yield ("convert", phantom, "o.nii.gz"), ["o.nii.gz"]
        for half in ("upper", "lower"):
            self.succeeds("map", "mean-value", fixtures / f"{half}_shell.off", "-o", f"{half}.vtp", "-q")
        yield ("weld", "upper.vtp", "lower.vtp", "-o", "o.vtp", "--report", "o.json"), ["o.vtp", "o.json"]
        yield ("extract", phantom, "-o", ".", "--json", "o.json"), ["lh.white.vtp", "rh.white.vtp", "o.json"]

    def is_whole(self, name):
        if name.endswith(".json"):
            return bool(json.loads(self.path(name).read_text()))
        if name.endswith(".tsv"):
            rows = [line.count("\t") for line in self.path(name).read_text().splitlines()]
            return self.bytes(name).endswith(b"\n") and len(set(rows)) == 1
        return self.run_verb("info", name).returncode == 0

    def check(self, name, new):
        """The old file or a whole one, of the length of the new but for digits of times."""
        content = self.bytes(name)
        return content == b"old" or (self.is_whole(name) and abs(len(content) - new) < 100)

    def test_full_disks_and_kills_leave_the_old_file_or_a_whole_one_and_read_only_folders_nothing(self):
        tried, verbs = 0, set()
        for words, outputs in self.commands():
            verbs.add(words[0])
            self.succeeds(*words)
            new = {name: len(self.bytes(name)) for name in outputs}
            self.assertTrue(all(map(self.is_whole, outputs)), words)
            for setup, code in (("trap '' XFSZ; ulimit -f 0;", 5), ("trap '' XFSZ; ulimit -f 1;", 5),
                                ("ulimit -c 0 -f 0;", -signal.SIGXFSZ), ("ulimit -c 0 -f 1;", -signal.SIGXFSZ)):
                for name in outputs:
                    self.path(name).write_bytes(b"old")
                before = set(self.here.iterdir())
                result = self.limited(*words, setup=setup)
                fits = setup.endswith("1;") and max(new.values()) <= 1024
                self.assertEqual(result.returncode, 0 if fits else code, (words, setup, result.stderr))
                self.assertTrue(all(self.check(name, new[name]) for name in outputs), (words, setup))
                if code == 5:
                    self.assertEqual(set(self.here.iterdir()), before, words)
                tried += 1
            self.succeeds(*words)  # beside what the kills left
            self.assertTrue(all(self.is_whole(name) for name in outputs), words)
            for path in self.here.glob(".*.tmp"):
                path.unlink()
            self.read_only(words, outputs)
        self.assertGreater(tried, 40)
        listed = self.succeeds("--help").split("VERBS")[1].split("OPTIONS")[0]
        self.assertEqual(verbs, set(re.findall(r"^    (\w+): ", listed, re.MULTILINE)))

    def read_only(self, words, outputs):
        if os.geteuid() == 0 and not shutil.which("setpriv"):
            return
        closed = self.path("closed")
        closed.mkdir(exist_ok=True)
        for path in (self.here, *self.here.iterdir()):
            path.chmod(0o755 if path.is_dir() else 0o644)
        closed.chmod(0o555)
        user = ["setpriv", "--reuid=65534", "--clear-groups"] if os.geteuid() == 0 else []
        moved = ["closed/" + str(word) if word in (*outputs, ".") else str(word) for word in words]
        result = subprocess.run([*user, ARGUMENTS.authalic, *moved], cwd=self.here, capture_output=True, text=True)
        self.assertEqual(result.returncode, 5, (words, result.stderr))
        self.assertEqual(list(closed.iterdir()), [])


if __name__ == "__main__":
    main("test_whole.py")
