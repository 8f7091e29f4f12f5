"""What the functions of the package raise: one class per kind of failure, as in the C++ core."""


class Error(Exception):
    """Base of every failure that authalic reports: one sentence, what was required, found, where, what to do."""


class InvalidArgument(Error, ValueError):
    """An option is outside its range, unknown, or contradicts another one (exit code 2 of the command line)."""


class SurfaceError(Error, ValueError):
    """The surface has the wrong topology for the method, degenerate geometry, NaN coordinates, or arrays of another
    length: TopologyError and GeometryError of the C++ core (exit code 3)."""


class SolverError(Error, RuntimeError):
    """A matrix could not be factorised, or memory ran out (exit code 1)."""


class FormatError(Error, OSError):
    """A file is missing, unreadable, malformed, or cannot be written (exit code 5)."""


class Cancelled(Error):
    """The progress callable asked to stop (exit code 130)."""


class NotConverged(Error):
    """The tolerance was not reached (exit code 4); the best result is the attribute `result`."""

    def __init__(self, sentence, result=None):
        super().__init__(sentence)
        self.result = result


class AuthalicWarning(UserWarning):
    """A doubt about a result that is there, in words."""


class NotConvergedWarning(AuthalicWarning):
    """The tolerance was not reached; the result is the best iterate and says so in its `status`."""


BY_KIND = {1: SolverError, 2: InvalidArgument, 3: SurfaceError, 5: FormatError, 130: Cancelled}
