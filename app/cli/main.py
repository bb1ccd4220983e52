"""The command `understudy`: reads its arguments, runs one command, and reports every foreseen mistake on one line.

Exit codes: 0 done, 2 wrong input, 130 interrupted. A command is the module of its name in `understudy.cli.commands`
with a function `run(arguments, log) -> int`; it is imported when it is called, so that `understudy --help` is quick.

Options that override settings (`--lexicon`, `--agitation-model`) are passed through the environment, so that the
processes that a command starts have them too.
"""

import argparse
import gc
import importlib
import os
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import cast

from ..authored_folders import VARIABLE as LEXICON
from ..authored_folders import layers_of
from ..errors import UnderstudyError
from .arguments.parser import make_parser
from .files import discard_the_rest, require_distinct, standard_output
from .log import Log

WRONG_INPUT = 2
INTERRUPTED = 130

SHARED = {
    **{name: ("hearing", name) for name in ("agitation", "align", "analyze", "pitch", "reference")},
    **{name: ("serving", name) for name in ("serve", "studio")},
    "say": ("perform", "run"),
    "script": ("perform", "script"),
}
"""The module and function of each command that shares a module with others."""

FEWEST_NEW_OBJECTS = 50_000
"""Garbage collection threshold. Loading makes many objects that all stay; with Python's own threshold of 700,
collections take a tenth of the time of a short line."""


def main(argv: Sequence[str] | None = None) -> int:
    """Runs the command that `argv` (default: the process's arguments) names; returns the exit code."""
    gc.set_threshold(FEWEST_NEW_OBJECTS)
    argv = sys.argv[1:] if argv is None else argv
    log = Log.for_arguments(argv)
    try:
        arguments = make_parser().parse_args(argv)
        require_distinct(arguments)
        run = _command(arguments.command)
        gc.enable()
        with set_by(arguments):
            code = run(arguments, log)
        with standard_output():
            sys.stdout.flush()
    except UnderstudyError as error:
        log.error(error)
        return WRONG_INPUT
    except BrokenPipeError:
        discard_the_rest()
        return 0
    except KeyboardInterrupt:
        return INTERRUPTED
    return code


def _command(name: str) -> Callable[[argparse.Namespace, Log], int]:
    """The function of a command, such as `agitation train` or `motion-model`: `run` in the module of that name, or a
    function in a module of several commands. Only that module is imported."""
    name = name.replace(" ", "_").replace("-", "_")
    module, function = SHARED.get(name, (name, "run"))
    home = importlib.import_module(f".commands.{module}", __package__)
    return cast(Callable[[argparse.Namespace, Log], int], getattr(home, function))


AGITATION_MODEL = "UNDERSTUDY_AGITATION_MODEL"


@contextmanager
def set_by(arguments: argparse.Namespace) -> Iterator[None]:
    """Sets the environment variables of `--lexicon` and `--agitation-model` within the block."""
    variables = dict(_told(arguments))
    before = {name: os.environ.get(name) for name in variables}
    os.environ.update(variables)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


def _told(arguments: argparse.Namespace) -> Iterator[tuple[str, str]]:
    given: Mapping[str, object] = vars(arguments)
    folders, model = given.get("lexicon"), given.get("agitation_model")
    if isinstance(folders, list):
        named = (*layers_of(os.environ.get(LEXICON)), *map(Path, folders))
        yield LEXICON, os.pathsep.join(str(each.absolute()) for each in named)
    if isinstance(model, str):
        yield AGITATION_MODEL, str(Path(model).absolute())
