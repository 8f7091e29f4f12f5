"""Where the plugin and ParaView's programs are; a test that needs them skips, and says why, where they are not."""
import os
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77
HERE = pathlib.Path(__file__).parent


class PluginBuild:
    def __init__(self, root):
        root = pathlib.Path(root)
        self.fixtures, self.pipelines = str(root / "data"), root / "pipelines/paraview"
        programs = root / "build/paraview-prefix/usr/bin"
        self.pvpython, self.pvbatch = programs / "pvpython", programs / "pvbatch"
        plugins = sorted((root / "build/paraview/lib").glob("paraview-*/plugins/Authalic/Authalic.so"))
        if not plugins or not self.pvpython.exists():
            reason = root / "build/paraview-unavailable"
            print(reason.read_text() if reason.exists() else "build/paraview is not built")
            sys.exit(SKIPPED)
        self.plugin = str(plugins[-1])

    def launcher(self, kind):
        """The command for pvpython, pvbatch or mpi (two processes of pvbatch)."""
        if kind != "mpi":
            return [str(self.pvpython if kind == "pvpython" else self.pvbatch)]
        if not shutil.which("mpirun"):
            print("mpirun is not installed")
            sys.exit(SKIPPED)
        return ["mpirun", "--oversubscribe", "-n", "2", str(self.pvbatch)]

    def run(self, kind, script, *arguments):
        """What a script of this folder printed, both streams; ends the test when it fails."""
        return run(self.launcher(kind) + [HERE / script, self.plugin, self.fixtures, *arguments])

    def draw(self, kind, script, *arguments):
        """The same for a script of pipelines/paraview, on a display."""
        sys.path.insert(0, str(self.pipelines.parent / "cortex"))
        from render import Display  # the X server of the main job
        with Display() as display:
            if not display.available:
                print("there is no display, and Xvfb is not installed")
                sys.exit(SKIPPED)
            return run(self.launcher(kind) + [self.pipelines / script, "--plugin", self.plugin, *arguments])


def run(command):
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_mpi_yield_when_idle="1")
    command = [str(part) for part in command]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=400,
                          env=environment)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout
