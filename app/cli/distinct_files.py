"""Prevents commands from overwriting their input, or writing two results to one file.

Arguments that name files are of the types `InputFile` and `OutputName`, so that every command is checked alike. Two
names are the same file if their inode is the same or they resolve to the same path; `-` is whatever the standard stream
was redirected to. What is not a regular file (a terminal, /dev/null) may be named any number of times.
"""

import argparse
import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from stat import S_ISREG

from ..errors import InputError
from .files import STANDARD


class InputFile(str):
    """The name of a file that is read; `-` is standard input."""

    __slots__ = ()


class OutputName(str):
    """The name of a file that is written; `-` is standard output."""

    __slots__ = ()


Identity = tuple[int, int] | Path | str
"""Device and inode; the resolved path if the file does not exist yet; `STANDARD` for standard output that is not a
file."""


def require_distinct(arguments: argparse.Namespace, beside: Iterable[OutputName] = ()) -> None:
    """Raises InputError `files_same` where an output is also an input, or another output; `beside` are outputs whose
    names are derived from those in `arguments`."""
    named = [*_named(arguments), *(("output", name) for name in beside)]
    taken: dict[Identity, tuple[str, str]] = {
        identity: (field, name)
        for field, name in named
        if isinstance(name, InputFile) and (identity := _identity(name)) is not None
    }
    for field, name in named:
        if not isinstance(name, OutputName):
            continue
        identity = _identity(name)
        if identity in taken:
            raise InputError("files_same", _message(name, *taken[identity]), field=field)
        if identity is not None:
            taken[identity] = (field, name)


def _named(arguments: argparse.Namespace) -> Iterator[tuple[str, str]]:
    for field, value in vars(arguments).items():
        for name in value if isinstance(value, list) else [value]:
            if isinstance(name, InputFile | OutputName):
                yield field, name


def _message(name: str, field: str, other: str) -> str:
    shown = "standard output" if name == STANDARD else name
    return f"{shown}: is the same file as {other} ({field}); give one of them another name, nothing was written"


def _identity(name: str) -> Identity | None:
    """None for what is not a regular file."""
    is_output = isinstance(name, OutputName)
    try:
        found = os.fstat(int(is_output)) if name == STANDARD else Path(name).stat()
    except FileNotFoundError:
        return Path(name).resolve()
    except (OSError, ValueError):
        return None  # reported when it is opened
    if S_ISREG(found.st_mode):
        return found.st_dev, found.st_ino
    return STANDARD if is_output and name == STANDARD else None
