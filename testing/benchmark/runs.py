"""Runs of the command for tables of the documentation: reports, CPU seconds, memory, and the judge's view."""
import json
import os
import pathlib
import subprocess
import sys

DISKS = {"chinese_lion": "meshes/open_disk/chinese_lion.off", "human_face": "meshes/open_disk/human_face.off",
         "camelhead": "meshes/open_disk/camelhead.off", "human_brain": "meshes/open_disk/human_brain.off"}
OK, NOT_CONVERGED = 0, 4
AGREEMENT = {"D_area": ("area_distortion", 1e-6), "face_sd": ("face_area_ratio_sd", 1e-6),
             "face_mean_abs_log": ("face_log_area_ratio_mean_abs", 1e-6),
             "angle_err_deg": ("angle_error_mean_degrees", 1e-2)}


def timed(command):
    """(exit code, user seconds, peak kB, stderr) of one run of a program.

    A process counts the memory of the one that forked it: a small one of its own has to do that.
    """
    done = subprocess.run([sys.executable, __file__, *command], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def watch(command):
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        words = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime, usage.ru_maxrss, words


class Run:
    """One map: its report, what it took, and where it is."""

    def __init__(self, command, surface, words, folder):
        self.surface, self.image = str(surface), str(pathlib.Path(folder) / "map.vtp")
        report = pathlib.Path(folder) / "map.json"
        code, self.seconds, self.kilobytes, said = timed(
            [command, "map", *words, self.surface, "-o", self.image, "--report", str(report), "--quiet"])
        if code not in (OK, NOT_CONVERGED):
            sys.exit(f"{' '.join(words)} on {surface} ended with {code}: {said}")
        self.report = json.loads(report.read_text())
        self.metrics = self.report["metrics"]

    def judged(self, judge):
        """Whether an independent program finds the numbers of the report."""
        found = json.loads(subprocess.run([sys.executable, judge, self.surface, self.image], capture_output=True,
                                          text=True, check=True).stdout)
        bad = [f"{name} {found[name]} against {self.metrics[ours]}" for name, (ours, most) in AGREEMENT.items()
               if abs(found[name] - self.metrics[ours]) > most * max(1, abs(found[name]))]
        if found["flips"] != self.report["flips"]:
            bad.append(f"flips {found['flips']} against {self.report['flips']}")
        if bad:
            print("The judge does not agree:", "; ".join(bad), file=sys.stderr)
        return not bad


def row(*cells):
    """A line of a Markdown table."""
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def head(*titles):
    """The first two lines of a Markdown table."""
    return row(*titles) + "\n" + "|---" * len(titles) + "|"


if __name__ == "__main__":
    print(json.dumps(watch(sys.argv[1:])))
