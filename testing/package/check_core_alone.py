#!/usr/bin/python3
"""Configures the project with AUTHALIC_VTK=OFF, builds it, and asks of its installation what check_package.py asks.

    check_core_alone.py --build BUILD --source SOURCE --cxx COMPILER

VTK cannot be found during all of it, and no header is precompiled: sources include what they use. BUILD is not
touched; the second build tree is temporary.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build")
    parser.add_argument("--source", required=True)
    parser.add_argument("--cxx", required=True)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="authalic-core-") as folder:
        for words in (["cmake", "-S", options.source, "-B", folder, "-G", "Ninja", "-DAUTHALIC_VTK=OFF",
                       "-DBUILD_TESTING=OFF", "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_COMPILER={options.cxx}",
                       "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"],
                      ["cmake", "--build", folder],
                      [sys.executable, str(pathlib.Path(__file__).with_name("check_package.py")), "--build", folder,
                       "--source", options.source, "--cxx", options.cxx, "-v"]):
            if subprocess.run(words, check=False).returncode != 0:
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
