#!/usr/bin/python3
"""The C++ package from outside: installed, moved to another place, found, compiled against, run.

    check_package.py --build BUILD --source SOURCE [--cxx COMPILER] [unittest arguments]

BUILD is a finished build tree. Every test works in a temporary folder on an installation that is not where it was
installed to.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

ARGUMENTS = None
FOLDER = None  # of this run, removed at the end
MOVED = None  # the installation, moved
HERE = pathlib.Path(__file__).resolve().parent
WARNINGS = ["-Wall", "-Wextra", "-Wshadow", "-Werror", "-Winvalid-pch"]


def run(*words, cwd=None, environment=None):
    """The finished process; stdout and stderr in one text."""
    clean = {k: v for k, v in os.environ.items() if k not in ("LD_LIBRARY_PATH", "PYTHONPATH", "CMAKE_PREFIX_PATH")}
    clean.update(environment or {})
    return subprocess.run(list(map(str, words)), cwd=cwd, env=clean, text=True, check=False, timeout=900,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def must(*words, **keywords):
    process = run(*words, **keywords)
    if process.returncode != 0:
        raise AssertionError(" ".join(map(str, words)) + "\n" + process.stdout)
    return process.stdout


def setUpModule():
    global FOLDER, MOVED
    FOLDER = pathlib.Path(tempfile.mkdtemp(prefix="authalic-package-"))
    must("cmake", "--install", ARGUMENTS.build, "--prefix", FOLDER / "first")
    MOVED = FOLDER / "second" / "place"
    MOVED.parent.mkdir()
    (FOLDER / "first").rename(MOVED)


def tearDownModule():
    shutil.rmtree(FOLDER)


def installed(pattern):
    return sorted(MOVED.rglob(pattern))


def has_vtk():
    return bool(installed("AuthalicModules-targets.cmake"))


def configure(source, build, *options):
    return run("cmake", "-S", source, "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={MOVED}",
               "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_COMPILER={ARGUMENTS.cxx}",
               "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wshadow -Werror", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *options)


def configured(name, *options):
    """The build folder of testing/package/NAME, configured to use the installation."""
    build = FOLDER / name
    if not (build / "build.ninja").exists():
        process = configure(HERE / name, build, *options)
        if process.returncode != 0:
            raise AssertionError(process.stdout)
    return build


def consumer(name, *options):
    """The same, built."""
    build = configured(name, *options)
    must("cmake", "--build", build)
    return build


def find_package(words, *options, languages="CXX"):
    """Configures a project that says only find_package(Authalic WORDS); what CMake says, and whether it went well."""
    source = pathlib.Path(tempfile.mkdtemp(dir=FOLDER))
    (source / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.22)\nproject(Probe {languages})\nfind_package(Authalic {words})\n"
        'message("found ${Authalic_FOUND} ${Authalic_VERSION} vtk ${VTK_FOUND} targets ${IMPORTED}")\n'
        "get_property(all DIRECTORY PROPERTY IMPORTED_TARGETS)\nmessage(\"imported ${all}\")\n")
    process = configure(source, source / "build", *options)
    return process.returncode == 0, " ".join(process.stdout.split())


class Consumers(unittest.TestCase):
    def test_core_alone_needs_no_vtk(self):
        build = consumer("core", "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON")
        self.assertRegex(must(build / "flatten"), r"^converged, residual 0\.01\d+, 0 folded faces\n$")
        libraries = must("ldd", build / "flatten")
        self.assertIn(str(MOVED), libraries)
        self.assertNotIn("vtk", libraries)
        self.assertNotIn("not found", libraries)

    def test_core_from_a_full_installation_leaves_vtk_alone(self):
        fine, words = find_package("REQUIRED COMPONENTS Core", "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON")
        self.assertTrue(fine, words)
        self.assertIn("imported Eigen3::Eigen;Authalic::Core", words)
        self.assertNotRegex(words, "VTK::|Authalic::(Formats|Reports|Filters|IO)")

    def test_formats_and_reports_bring_core(self):
        fine, words = find_package("REQUIRED COMPONENTS Reports Formats", "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON")
        self.assertTrue(fine, words)
        for target in ("Core", "Formats", "Reports"):
            self.assertIn(f"Authalic::{target}", words)
        self.assertNotIn("VTK::", words)

    def test_filters_map_a_file(self):
        if not has_vtk():
            self.skipTest("this build has no VTK modules")
        build = consumer("vtk")
        report = json.loads(must(build / "flatten_file", ARGUMENTS.source / "data/bumpy_disk.off", FOLDER / "map.vtp"))
        self.assertEqual(report["status"], "converged")
        self.assertEqual(report["version"], re.search(r"PACKAGE_VERSION \"(.*)\"", next(iter(installed(
            "AuthalicConfigVersion.cmake"))).read_text()).group(1))
        self.assertGreater((FOLDER / "map.vtp").stat().st_size, 1000)
        self.assertIn(str(MOVED), must("ldd", build / "flatten_file"))

    def test_all_of_vtk_by_one_name_and_without_components(self):
        if not has_vtk():
            self.skipTest("this build has no VTK modules")
        modules = [header.name[len("vtkAuthalic"):-len("Module.h")] for header in installed("vtkAuthalic*Module.h")]
        self.assertGreater(len(modules), 5)
        for components in ("COMPONENTS VTK", ""):
            fine, words = find_package("REQUIRED " + components, languages="C CXX")
            self.assertTrue(fine, words)
            for module in modules:
                self.assertIn(f"Authalic::{module}", words)


class Refusals(unittest.TestCase):
    def test_a_component_that_does_not_exist(self):
        fine, words = find_package("REQUIRED COMPONENTS Core Wavelets")
        self.assertFalse(fine)
        self.assertIn("Component Wavelets is required, but this installation has only Core, Formats, Reports", words)
        fine, words = find_package("COMPONENTS Core OPTIONAL_COMPONENTS Wavelets")
        self.assertTrue(fine, words)
        self.assertIn("found TRUE", words.replace("found 1", "found TRUE"))

    def test_vtk_modules_where_there_are_none(self):
        if has_vtk():
            self.skipTest("this build has VTK modules")
        for component in ("VTK", "FiltersParameterization"):
            fine, words = find_package(f"REQUIRED COMPONENTS {component}")
            self.assertFalse(fine)
            self.assertIn(f"Component {component} is required", words)
            self.assertIn("(it was built with AUTHALIC_VTK=OFF)", words)

    def test_another_version_of_vtk(self):
        if not has_vtk():
            self.skipTest("this build has no VTK modules")
        other = FOLDER / "other-vtk"
        other.mkdir()
        (other / "VTKConfig.cmake").write_text("set(VTK_FOUND TRUE)\n")
        (other / "VTKConfigVersion.cmake").write_text(
            'set(PACKAGE_VERSION "9.99.0")\nif(PACKAGE_FIND_VERSION_RANGE)\n  if(PACKAGE_VERSION VERSION_LESS '
            "PACKAGE_FIND_VERSION_MAX)\n    set(PACKAGE_VERSION_COMPATIBLE TRUE)\n  endif()\nelse()\n"
            "  set(PACKAGE_VERSION_COMPATIBLE TRUE)\nendif()\n")
        usual = re.search(r"^VTK_DIR:\w+=(.*)$", (ARGUMENTS.build / "CMakeCache.txt").read_text(), flags=re.M).group(1)
        hidden = f"{usual};{usual.removeprefix('/usr')}"  # /lib is /usr/lib
        fine, words = find_package("REQUIRED COMPONENTS VTK", f"-DVTK_DIR={other}", f"-DCMAKE_IGNORE_PATH={hidden}",
                                   languages="C CXX")
        self.assertFalse(fine, words)
        self.assertIn("9.99.0", words)

    def test_versions_that_are_not_compatible(self):
        config = installed("AuthalicConfigVersion.cmake")[0].read_text()
        major, minor, _ = map(int, re.search(r"PACKAGE_VERSION \"(\d+)\.(\d+)\.(\d+)", config).groups())
        for wanted, is_fine in ((f"{major}.{minor}", True), (f"{major}.{minor}.0", True), (f"{major + 1}.0", False),
                                (f"{major}.{minor + 1}", False), (f"{major}.{minor}.999", False)):
            fine, words = find_package(f"{wanted} REQUIRED COMPONENTS Core")
            self.assertEqual(fine, is_fine, wanted + words)


class Installation(unittest.TestCase):
    def test_knows_neither_where_it_was_built_nor_where_it_was_first(self):
        files = [p for p in installed("*") if p.suffix in (".cmake", ".h", ".py", ".pyi")]
        self.assertGreater(len(files), 60)
        for path in files:
            for place in (ARGUMENTS.build, ARGUMENTS.source, FOLDER / "first"):
                self.assertNotIn(str(place), path.read_text(), path)

    def test_libraries_have_the_version_of_their_interface_and_no_foreign_search_path(self):
        config = installed("AuthalicConfigVersion.cmake")[0].read_text()
        major, minor, patch = re.search(r"PACKAGE_VERSION \"(\d+)\.(\d+)\.(\d+)", config).groups()
        interface = f"{major}.{minor}" if major == "0" else major
        libraries = [p for p in installed("lib*.so.*") if not p.is_symlink()]
        self.assertGreaterEqual(len(libraries), 3)
        for library in libraries:
            self.assertTrue(library.name.endswith(f".so.{major}.{minor}.{patch}"), library)
            dynamic = must("readelf", "-d", library)
            name = library.name.split(".so.")[0]
            self.assertIn(f"soname: [{name}.so.{interface}]", dynamic)
            for path in re.findall(r"R(?:UN)?PATH.*\[(.*)\]", dynamic):
                for place in path.split(":"):
                    self.assertTrue(place.startswith("$ORIGIN"), f"{library.name}: {path}")

    def test_has_no_private_header(self):
        headers = installed("*.h")
        names = {str(h.relative_to(MOVED / "include/authalic")) for h in headers}
        self.assertIn("Core/authalic/AuthalicMap.h", names)
        self.assertIn("Core/base/VersionMacros.h", names)
        self.assertNotIn("Core/numerics/SparseBackend.h", names)
        for header in headers:
            self.assertNotRegex(header.read_text()[:600], "Private to [A-Za-z]+/", header)

    def test_the_examples_of_the_documentation_are_those_that_are_compiled_here(self):
        page = (ARGUMENTS.source / "docs/cpp.md").read_text()
        for example in ("core/CMakeLists.txt", "core/flatten.cxx", "vtk/CMakeLists.txt", "vtk/flatten_file.cxx"):
            self.assertIn("\n" + (HERE / example).read_text() + "```", page, example)


class Headers(unittest.TestCase):
    @staticmethod
    def flags(build):
        """Include paths and definitions with which a consumer was compiled."""
        command = json.loads((build / "compile_commands.json").read_text())[0]["command"]
        words, kept = shlex.split(command), []
        for at, word in enumerate(words):
            if word.startswith(("-I", "-D", "-std=")):
                kept.append(word)
            elif word == "-isystem":
                kept += [word, words[at + 1]]
        return kept

    def includes(self, header):
        """What the header includes, itself or through others of ours."""
        lines = set(re.findall(r'#include ["<]([^">]+)[">]', header.read_text()))
        ours = [MOVED / "include/authalic" / line for line in lines]
        return lines.union(*(self.includes(path) for path in ours if path.exists()))

    def precompiled(self, flags):
        """What most of our headers include anyway, parsed once: {name: file to include first}."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=FOLDER))
        files = {"Eigen/Core": folder / "eigen.h", "vtkPolyDataAlgorithm.h": folder / "vtk.h"}
        for name, file in files.items():
            file.write_text(f"#include <{name}>\n")
            run(ARGUMENTS.cxx, *WARNINGS, *flags, "-x", "c++-header", file, "-o", f"{file}.gch")
        return {name: file for name, file in files.items() if pathlib.Path(f"{file}.gch").exists()}

    def compile_alone(self, headers, flags):
        precompiled = self.precompiled(flags)

        def complaint(header):
            includes = self.includes(header)
            first = [word for name, file in precompiled.items() if name in includes for word in ("-include", file)][:2]
            process = run(ARGUMENTS.cxx, "-fsyntax-only", "-x", "c++", *WARNINGS, *flags, *first, "-include", header,
                          os.devnull)
            return process.stdout if process.returncode else ""

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            complaints = [text for text in pool.map(complaint, headers) if text]
        self.assertEqual(complaints, [], "\n".join(complaints))

    def test_of_the_libraries_compile_alone_without_vtk(self):
        flags = self.flags(configured("core", "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON"))
        headers = [h for h in installed("*.h") if h.relative_to(MOVED / "include/authalic").parts[0] in
                   ("Core", "Formats", "Reports")]
        self.assertGreater(len(headers), 40)
        self.compile_alone(headers, flags)

    def test_of_the_filters_compile_alone(self):
        if not has_vtk():
            self.skipTest("this build has no VTK modules")
        flags = self.flags(configured("vtk"))
        headers = [h for h in (MOVED / "include/authalic").glob("*.h")]
        classes = [h for h in headers if h.name.startswith("vtk")]
        self.assertGreater(len(classes), 15)
        self.compile_alone(classes, flags)
        helpers = [h for h in headers if h not in classes]
        self.compile_alone(helpers, flags + self.flags(configured("core")))


def main():
    global ARGUMENTS

    def folder(text):
        return pathlib.Path(text).resolve(strict=True)

    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=folder, required=True)
    parser.add_argument("--source", type=folder, required=True)
    parser.add_argument("--cxx", default="c++")
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()
