"""Setting the options of a filter by their Python names, and running it with words, progress and interrupts."""
import re
import signal
import threading
import warnings

from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm, vtkTableAlgorithm

from ._errors import BY_KIND, AuthalicWarning, Cancelled, InvalidArgument, SolverError

NOT_CONVERGED = 4
_GENERAL = {"Threads"} | {name[3:] for base in (vtkPolyDataAlgorithm, vtkTableAlgorithm) for name in dir(base)}


def ivar(name):
    """max_iterations → MaximumIterations"""
    words = ["maximum" if word == "max" else word for word in name.split("_")]
    return "".join(word[:1].upper() + word[1:] for word in words)


def snake(name):
    """GridColumns → grid_columns"""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def option(name):
    """MaximumIterations → max_iterations"""
    return snake(name).replace("maximum", "max")


def _words(name):
    """MeanValue → mean-value"""
    return snake(name).replace("_", "-")


def choices(algorithm, name):
    """The words that an enumerated option takes; empty for other options."""
    start = f"Set{ivar(name)}To"
    return sorted(_words(m[len(start):]) for m in dir(algorithm) if m.startswith(start))


def options_of(algorithm):
    """{option: default} of everything that can be set; enumerated options as one of their words."""
    found = {}
    for name in dir(algorithm):
        if name.startswith("Set") and name[3:] not in _GENERAL and hasattr(algorithm, "Get" + name[3:]):
            value = getattr(algorithm, "Get" + name[3:])()
            found[option(name[3:])] = _word(algorithm, name[3:], value)
    return found


def _word(algorithm, name, value):
    for method in (m for m in dir(algorithm) if m.startswith(f"Set{name}To")):
        probe = algorithm.NewInstance()
        getattr(probe, method)()
        if getattr(probe, "Get" + name)() == value:
            return _words(method[len(name) + 5:])
    return value


def configure(algorithm, **options):
    """Sets every option that is not None. Raises InvalidArgument for an unknown option, word, type or range."""
    for name, value in options.items():
        if value is None:
            continue
        if not hasattr(algorithm, "Set" + ivar(name)):
            known = ", ".join(sorted(options_of(algorithm))) or "none"
            raise InvalidArgument(f"There is no option '{name}' of {algorithm.GetClassName()}; there are: {known}.")
        words = choices(algorithm, name) if isinstance(value, str) else []
        if words:
            _set_word(algorithm, name, value, words)
        else:
            _set_value(algorithm, name, value)


def _set_word(algorithm, name, value, words):
    plain = value.replace("-", "").replace("_", "").lower()
    for method in dir(algorithm):
        if method.lower() == f"set{ivar(name)}to{plain}".lower():
            return getattr(algorithm, method)()
    raise InvalidArgument(f"{name} must be one of {', '.join(words)}; it is '{value}'.")


def _set_value(algorithm, name, value):
    try:
        getattr(algorithm, "Set" + ivar(name))(value)
    except (TypeError, ValueError, OverflowError) as reason:
        raise InvalidArgument(f"{name} cannot be {value!r}: {reason}.") from None
    kept = getattr(algorithm, "Get" + ivar(name))()
    if isinstance(kept, (int, float)) and kept != value:
        raise InvalidArgument(
            f"{name} is outside its range: it is {value}, the nearest value that is allowed is {kept}.")


class _Watch:
    """Observes one execution: what was said, progress, and whether to stop."""

    def __init__(self, algorithm, progress):
        self.algorithm, self.progress = algorithm, progress
        self.errors, self.warnings, self.failure = [], [], None
        self.cancelled = self.interrupted = False
        self._handler, self._observers = None, []

    def __enter__(self):
        def said(into):
            def note(_object, _event, text):
                into.append(_sentence(text))
            note.CallDataType = "string0"
            return note

        executive = self.algorithm.GetExecutive()
        for who, event, what in ((self.algorithm, "ErrorEvent", said(self.errors)),
                                 (self.algorithm, "WarningEvent", said(self.warnings)),
                                 (executive, "ErrorEvent", said([])), (self.algorithm, "ProgressEvent", self._step)):
            self._observers.append((who, who.AddObserver(event, what)))
        if threading.current_thread() is threading.main_thread():
            if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
                self._handler = signal.signal(signal.SIGINT, self._interrupt)
        return self

    def __exit__(self, *_):
        if self._handler is not None:
            signal.signal(signal.SIGINT, self._handler)
        for who, tag in self._observers:
            who.RemoveObserver(tag)

    def _interrupt(self, *_):
        self.interrupted = True

    def _step(self, algorithm, _event):
        # No exception may leave an observer: VTK prints it, and ends the process on KeyboardInterrupt.
        try:
            if self.progress is not None and not (self.cancelled or self.failure or self.interrupted):
                self.cancelled = self.progress(algorithm.GetProgress(), algorithm.GetProgressText() or "") is False
        except BaseException as failure:  # pylint: disable=broad-except
            self.failure = failure
        if self.cancelled or self.failure or self.interrupted:
            algorithm.SetAbortExecute(1)


def _sentence(text):
    """The words of an error without file, line, class and address."""
    return re.sub(r"^\w+: In .*?, line \d+\n\w+ \((?:0x)?[0-9a-fA-F]+\): ", "", text, flags=re.S).strip()


def run(algorithm, progress=None, execute=None):
    """Updates the filter (or calls `execute`); returns (ErrorKind, what it warned of).

    Raises the exception that belongs to its ErrorKind with its sentence, what `progress` raised, KeyboardInterrupt
    after Ctrl-C, or Cancelled when `progress` returned False."""
    if progress is not None and not callable(progress):
        raise InvalidArgument("progress must be callable as progress(fraction, stage).")
    with _Watch(algorithm, progress) as watch:
        (execute or algorithm.Update)()
    if watch.failure is not None:
        raise watch.failure
    if watch.interrupted:
        raise KeyboardInterrupt
    kind = algorithm.GetErrorKind()
    if watch.cancelled:
        raise Cancelled("Cancelled on request of the progress callable; no result was produced.")
    if kind in BY_KIND:
        raise BY_KIND[kind](watch.errors[-1] if watch.errors else f"{algorithm.GetClassName()} failed.")
    if watch.errors:
        raise SolverError(watch.errors[-1])
    return kind, watch.warnings


def warn(sentences, category=AuthalicWarning, stacklevel=3):
    """Hands doubts of a filter to Python's warnings."""
    for sentence in sentences:
        warnings.warn(sentence, category, stacklevel=stacklevel)
