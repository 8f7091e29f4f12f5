#!/usr/bin/python3
"""The four roads to the conformal sphere side by side, in the form of Table 1 of nadeem2017: D_angle and seconds.

    spherical_roads.py COMMAND DATA [--repetitions N] [--judge PROGRAM]

COMMAND is the built `authalic`, DATA the folder of real test data. Seconds are the CPU time of the map and its
measurement (medians), without reading and writing. With --judge, PROGRAM SURFACE MAP must print JSON with the members
D_angle, angle_err_deg and flips of an independent evaluation; the script fails when they differ from the report.
"""
import argparse
import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

SURFACES = {"Max Planck": "meshes/closed_g0/decimated-max.obj", "bunny": "meshes/closed_g0/bunny.obj",
            "gargoyle": "meshes/closed_g0/gargoyle.obj", "David": "meshes/closed_g0/david.off",
            "brain": "meshes/closed_g0/sphere_brain.off",
            "fsaverage5, left pial": "cortex/fsaverage5_gifti/pial_left.gii.gz",
            "fsaverage6, left pial": "cortex/fsaverage6_fs/lh.pial",
            "fsaverage6, right pial": "cortex/fsaverage6_fs/rh.pial",
            "one subject, ico 6, left pial": "cortex/subject1_fs/lh.pialsurface6",
            "one subject, ico 6, right pial": "cortex/subject1_fs/rh.pialsurface6"}
ROADS = ("welding", "mean-curvature-flow", "harmonic", "stereographic")


def cpu_seconds(command):
    """User time of one run of a program that must succeed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(command)} ended with {done.returncode}: {done.stderr}")
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def judged(judge, surface, image, report):
    """Whether an independent program finds the numbers of the report."""
    found = json.loads(subprocess.run([sys.executable, judge, surface, image], capture_output=True, text=True,
                                      check=True).stdout)
    metrics = report["metrics"]
    return (found["flips"] == report["flips"]
            and abs(found["D_angle"] - metrics["angle_distortion"]) < 1e-6
            and abs(found["angle_err_deg"] - metrics["angle_error_mean_degrees"]) < 1e-2)


def row(options, surface, road, folder):
    """(faces, D_angle, degrees, flips, CPU seconds, whether the judge agrees) of one map."""
    image, report_file = str(folder / "map.vtp"), folder / "map.json"
    convert = [options.command, "convert", surface, str(folder / "copy.vtp"), "--quiet"]
    command = [options.command, "map", "sphere", surface, "-o", image, "--report", str(report_file), "--initial", road,
               "--quiet"]
    seconds = [cpu_seconds(command) - cpu_seconds(convert) for _ in range(options.repetitions)]
    report = json.loads(report_file.read_text())
    metrics = report["metrics"]
    agrees = options.judge is None or judged(options.judge, surface, image, report)
    return (report["topology"]["faces"], metrics["angle_distortion"], metrics["angle_error_mean_degrees"],
            report["flips"], statistics.median(seconds), agrees)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--judge")
    options = parser.parse_args()
    print("| surface | faces | " + " | ".join(f"{road}: D_angle, degrees, flips, CPU s" for road in ROADS) + " |")
    print("|---" * (len(ROADS) + 2) + "|")
    all_agree = True
    with tempfile.TemporaryDirectory() as name:
        for title, path in SURFACES.items():
            rows = [row(options, str(options.data / path), road, pathlib.Path(name)) for road in ROADS]
            cells = [f"{d:.5f}, {degrees:.3f}, {flips}, {seconds:.2f}" for _, d, degrees, flips, seconds, _ in rows]
            print(f"| {title} | {rows[0][0]:,} | " + " | ".join(cells) + " |", flush=True)
            all_agree = all_agree and all(agrees for *_, agrees in rows)
    if options.judge:
        print("The judge agrees." if all_agree else "The judge does not agree.")
    return 0 if all_agree else 1


if __name__ == "__main__":
    sys.exit(main())
