#!/usr/bin/python3
"""Makes the Debian package of a build tree, reads it, unpacks it somewhere and runs what is in it from there.

    check_debian.py --build BUILD --source SOURCE [unittest arguments]

Leaves with 77 (skipped) where dpkg is not installed.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ARGUMENTS = None
FOLDER = None  # of this run, removed at the end
DEB = None
ROOT = None  # where the package is unpacked


def must(*words, environment=None):
    clean = {"PATH": "/usr/bin:/bin:/usr/sbin:/sbin", "LC_ALL": "C.UTF-8", **(environment or {})}
    process = subprocess.run(list(map(str, words)), env=clean, text=True, check=False, timeout=300,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if process.returncode != 0:
        raise AssertionError(" ".join(map(str, words)) + "\n" + process.stdout)
    return process.stdout


def setUpModule():
    global FOLDER, DEB, ROOT
    FOLDER = pathlib.Path(tempfile.mkdtemp(prefix="authalic-debian-"))
    words = must(shutil.which("cpack"), "--config", ARGUMENTS.build / "CPackConfig.cmake", "-B", FOLDER,
                 environment={"PATH": os.environ["PATH"]})
    if "Warning" in words:
        raise AssertionError(words)
    DEB, = FOLDER.glob("*.deb")
    ROOT = FOLDER / "root"
    must("dpkg", "-x", DEB, ROOT)


def tearDownModule():
    shutil.rmtree(FOLDER)


def version():
    return re.search(r"CPACK_PACKAGE_VERSION \"(.*)\"", (ARGUMENTS.build / "CPackConfig.cmake").read_text()).group(1)


class Debian(unittest.TestCase):
    def test_names_itself_its_version_and_what_it_needs(self):
        fields = dict(line.split(": ", 1) for line in must("dpkg-deb", "-f", DEB).splitlines() if ": " in line
                      and not line.startswith(" "))
        self.assertEqual((fields["Package"], fields["Version"]), ("authalic", version()))
        needs = fields["Depends"]
        for package in ("libc6", "libvtk9", "libnifti2", "python3-vtk9", "python3-numpy"):
            self.assertIn(package, needs)
        self.assertNotIn("-dev", needs)
        own_solver = "AUTHALIC_HAVE_CHOLMOD" not in (ARGUMENTS.build / "build.ninja").read_text()
        self.assertEqual("libcholmod" not in needs, own_solver)

    def test_keeps_to_usr_and_belongs_to_root(self):
        lines = must("dpkg-deb", "-c", DEB).splitlines()
        self.assertGreater(len(lines), 100)
        for line in lines:
            self.assertIn(" root/root ", line)
            self.assertRegex(line, r" \./(usr/\S*.*)?$")
        for wanted in ("usr/bin/authalic", "usr/lib/libAuthalicCore.so." + version(),
                       "usr/lib/cmake/Authalic/AuthalicConfig.cmake", "usr/include/authalic/vtkDiscreteLieFlow.h",
                       "usr/share/doc/authalic/copyright"):
            self.assertTrue((ROOT / wanted).exists(), wanted)

    def test_says_under_which_licences_it_comes(self):
        text = (ROOT / "usr/share/doc/authalic/copyright").read_text()
        for words in ("BSD-3-Clause", "GPL-3", "CHOLMOD", "medical device"):
            self.assertIn(words, text)
        own = " ".join((ARGUMENTS.source / "LICENSE").read_text().split("Redistribution", 1)[1].split())
        self.assertIn(own, " ".join(text.replace("\n .\n", "\n\n").split()))

    def test_finds_its_libraries_wherever_it_lies(self):
        programs = [ROOT / "usr/bin/authalic", *ROOT.glob("usr/lib/lib*.so"), *ROOT.rglob("authalic/*.so")]
        self.assertGreater(len(programs), 10)
        for program in programs:
            libraries = must("ldd", program)
            self.assertNotIn("not found", libraries, program)
            for name, place in re.findall(r"(lib(?:vtk)?Authalic\S+) => (\S+)", libraries):
                self.assertTrue(place.startswith(str(ROOT)), f"{program}: {name} is {place}")

    def test_the_command_runs_from_there(self):
        command = ROOT / "usr/bin/authalic"
        self.assertEqual(must(command, "--version").strip(), version())
        self.assertRegex(must(command, "info", ARGUMENTS.source / "data/torus.off"), r"genus +1\n")
        must(command, "map", "authalic", ARGUMENTS.source / "data/bumpy_disk.off", "-o", FOLDER / "map.vtp",
             "--report", FOLDER / "map.json")
        report = json.loads((FOLDER / "map.json").read_text())
        self.assertEqual((report["status"], report["metrics"]["flipped_faces"]), ("converged", 0))

    def test_python_imports_it_from_there(self):
        place, = ROOT.glob("usr/lib/python3*/dist-packages")
        told = must("/usr/bin/python3", "-c", "import authalic; print(authalic.__version__, authalic.__file__, "
                    "authalic.vtkDiscreteLieFlow().GetClassName())", environment={"PYTHONPATH": str(place)})
        self.assertEqual(told.split(), [version(), str(place / "authalic/__init__.py"), "vtkDiscreteLieFlow"])


def main():
    global ARGUMENTS
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    if not shutil.which("dpkg-deb") or not shutil.which("dpkg-shlibdeps"):
        print("skipped: dpkg-deb and dpkg-shlibdeps (dpkg-dev) are not installed")
        return 77
    unittest.main(argv=[sys.argv[0], *rest])
    return 0


if __name__ == "__main__":
    sys.exit(main())
