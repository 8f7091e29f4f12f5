"""Running VTK filters one by one: progress on stderr, seconds per stage, failures as one sentence."""
import re
import resource
import sys
import time

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING

NOT_CONVERGED = 4


class StageError(Exception):
    """A filter failed: what was required, what was found, where, what to do; and the exit code for it."""

    def __init__(self, sentence, code):
        super().__init__(sentence)
        self.code = code


class Stages:
    """The stages of a job. `seconds` collects the time of each by name, `warnings` what filters warned of."""

    def __init__(self, total, threads=0):
        self.total, self.number, self.threads = total, 0, threads
        self.seconds, self.warnings = {}, []
        self.begin = time.perf_counter()
        self.converged = True

    def run(self, name, filter_, port=0):
        """Updates a filter and returns the output of `port`."""
        chain = upstream(filter_)
        for member in chain:
            if hasattr(member, "SetThreads"):
                member.SetThreads(self.threads)
        messages = _Messages(chain)
        with self.stage(name) as stage:
            tag = filter_.AddObserver("ProgressEvent", lambda *_: stage.progress(filter_.GetProgress()))
            filter_.Update()
            filter_.RemoveObserver(tag)
        messages.close()
        self.warnings += [f"{name}: {text}" for text in messages.warnings]
        kinds = [member.GetErrorKind() for member in chain if hasattr(member, "GetErrorKind")]
        self.converged &= NOT_CONVERGED not in kinds
        failed = [kind for kind in kinds if kind not in (0, NOT_CONVERGED)]
        if failed or messages.errors:
            words = " ".join(messages.errors) or f"The stage '{name}' failed."
            raise StageError(words, failed[0] if failed else 1)
        return filter_.GetOutputDataObject(port)

    def stage(self, name):
        """A context that is timed and shown as a stage."""
        self.number += 1
        return _Stage(self, name)

    def summary(self):
        """Seconds and peak memory of the whole job, in words."""
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
        return f"{time.perf_counter() - self.begin:.1f} s, peak memory {peak:.2f} GiB"


class _Stage:
    def __init__(self, stages, name):
        self.stages, self.name, self.quarter = stages, name, 0
        self.label = f"[{stages.number:2d}/{stages.total}] {name}"

    def __enter__(self):
        self.begin = time.perf_counter()
        print(self.label, end=" ", file=sys.stderr, flush=True)
        return self

    def progress(self, fraction):
        """Shows how far the stage is: in place on a terminal, in quarters elsewhere."""
        if sys.stderr.isatty():
            print(f"\r{self.label} {100 * fraction:3.0f} %", end=" ", file=sys.stderr, flush=True)
        elif fraction < 1 and int(4 * fraction) > self.quarter:
            self.quarter = int(4 * fraction)
            print(f"{25 * self.quarter} %", end=" ", file=sys.stderr, flush=True)

    def __exit__(self, kind, *_):
        seconds = time.perf_counter() - self.begin
        self.stages.seconds[self.name] = round(seconds, 3)
        start = f"\r{self.label} 100 % " if sys.stderr.isatty() and kind is None else ""
        print(f"{start}{seconds:.1f} s" if kind is None else "failed", file=sys.stderr, flush=True)


def upstream(filter_):
    """The filter and every one that feeds it, sources first."""
    chain = []
    for port in range(filter_.GetNumberOfInputPorts()):
        for connection in range(filter_.GetNumberOfInputConnections(port)):
            source = filter_.GetInputAlgorithm(port, connection)
            chain += [member for member in upstream(source) if member not in chain]
    return [*chain, filter_]


class _Messages:
    """What filters and their executives say while they run, instead of VTK's own printing."""

    def __init__(self, filters):
        self.errors, self.warnings = [], []
        self.tags = []
        for filter_ in filters:
            self._listen(filter_, self.errors)
            self._listen(filter_.GetExecutive(), [])  # it only repeats that a filter failed

    def _listen(self, speaker, errors):
        for event, kept in (("ErrorEvent", errors), ("WarningEvent", self.warnings)):
            self.tags.append((speaker, speaker.AddObserver(event, self._listener(kept))))

    @staticmethod
    def _listener(kept):
        @calldata_type(VTK_STRING)
        def listen(_speaker, _event, text):
            kept.append(sentence(text))
        return listen

    def close(self):
        for speaker, tag in self.tags:
            speaker.RemoveObserver(tag)


def sentence(text):
    """What VTK's message says, without source file, line and address."""
    words = re.sub(r"^\s*(ERROR|Warning|Generic Warning): In [^\n]*\n", "", text)
    return re.sub(r"^\w+ \(0x[0-9a-f]+\): ", "", words).strip()
