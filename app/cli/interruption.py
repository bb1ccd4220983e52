"""The entry point of the process, and its end: Ctrl-C ends it without a traceback at any time, even while modules are
imported.

The first Ctrl-C raises KeyboardInterrupt, so that a command can clean up. An import of a C extension may turn that into
another error, and a destructor may swallow it; any uncaught error afterwards is taken as its consequence, and ends the
process as Ctrl-C does by default. A second Ctrl-C ends it at once.

A command that is done leaves at once, too: Python would take its models apart object by object, a sixth of the time of
a short line.
"""

import atexit
import gc
import os
import signal
import sys
from types import FrameType, TracebackType
from typing import NoReturn


def start() -> NoReturn:
    """Runs the command line of this process."""
    signal.signal(signal.SIGINT, _interrupt)
    sys.excepthook = _tell
    sys.unraisablehook = _tell_unraisable
    codes: list[int] = []
    atexit.register(_leave, codes)  # the first to be registered is the last to be called
    gc.disable()  # what is imported stays; `main` enables it again
    from .main import main

    codes.append(main())
    sys.exit(codes[0])


def _leave(codes: list[int]) -> None:
    """Ends the process after everything else that is done at its end, if a command has returned its exit code."""
    if codes:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(codes[0])


def _interrupt(_signal: int, _frame: FrameType | None) -> NoReturn:
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    raise KeyboardInterrupt


def _tell(kind: type[BaseException], error: BaseException, traceback: TracebackType | None) -> None:
    _end_if_interrupted()
    sys.__excepthook__(kind, error, traceback)


def _tell_unraisable(unraisable: "sys.UnraisableHookArgs") -> None:
    _end_if_interrupted()
    sys.__unraisablehook__(unraisable)


def _end_if_interrupted() -> None:
    if signal.getsignal(signal.SIGINT) is signal.SIG_DFL:
        os.kill(os.getpid(), signal.SIGINT)
