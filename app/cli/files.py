"""Files and standard streams for the commands: input is read up to a limit, output written completely or not at all,
and no command overwrites its input, or writes two results to one file. `-` is standard input or output.

Arguments that name files are of the types `InputFile` and `OutputName`, so that every command is checked alike. Two
names are the same file if their inode is the same or they resolve to the same path; `-` is whatever the standard stream
was redirected to. What is not a regular file (a terminal, /dev/null) may be named any number of times.
"""

import argparse
import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from stat import S_ISREG

from ..errors import InputError, TooLargeError, UndecodableError
from ..files import replace_file

STANDARD = "-"
LARGEST_CHARACTER_BYTES = 4


def read_bytes(name: str, *, limit: int, field: str) -> bytes:
    """The content of the file; raises InputError `file_unreadable`, TooLargeError `file_too_large`."""
    try:
        if name == STANDARD:
            content = sys.stdin.buffer.read(limit + 1)
        else:
            with Path(name).open("rb") as file:
                content = file.read(limit + 1)
    except (OSError, ValueError) as error:
        raise InputError("file_unreadable", f"{name}: cannot be read: {_reason(error)}", field=field) from None
    if len(content) > limit:
        raise TooLargeError("file_too_large", f"{name}: larger than the {limit} bytes allowed", field=field)
    return content


def read_text(name: str, *, max_characters: int, field: str) -> str:
    """The content as UTF-8; raises as `read_bytes` does, and UndecodableError `text_not_utf8`."""
    content = read_bytes(name, limit=max_characters * LARGEST_CHARACTER_BYTES, field=field)
    try:
        return content.decode()
    except UnicodeDecodeError as error:
        raise UndecodableError(
            "text_not_utf8", f"{name}: not UTF-8 at byte {error.start}; save the text as UTF-8", field=field
        ) from None


def require_writable(name: str, *, field: str) -> None:
    """Raises InputError `file_unwritable` when `write` would, so that no work is wasted."""
    if name == STANDARD:
        return
    target = Path(name).resolve()
    if target.is_dir():
        raise InputError("file_unwritable", f"{name}: is a folder; give the name of a file", field=field)
    if target.exists() and not os.access(target, os.W_OK):
        raise InputError("file_unwritable", f"{name}: is write-protected", field=field)
    if not os.access(target.parent, os.W_OK):
        raise InputError("file_unwritable", f"{name}: there is no folder {target.parent} to write to", field=field)


def write(name: str, content: bytes) -> None:
    """Writes a file whole (`replace_file`), or to standard output.

    Raises InputError `file_unwritable`.
    """
    if name == STANDARD:
        write_standard(content)
        return
    target = Path(name).resolve()
    try:
        if target.exists() and not target.is_file():
            target.write_bytes(content)  # a device such as /dev/null must stay what it is
        else:
            replace_file(target, content)
    except OSError as error:
        raise InputError("file_unwritable", f"{name}: cannot be written: {_reason(error)}") from None


def write_standard(content: bytes) -> None:
    """Writes to standard output and flushes it. Raises InputError `file_unwritable`, BrokenPipeError."""
    with standard_output():
        sys.stdout.buffer.write(content)
        sys.stdout.buffer.flush()


@contextmanager
def standard_output() -> Iterator[None]:
    """Raises InputError `file_unwritable` where standard output cannot be written in the block, such as to a disk that
    is full, and BrokenPipeError."""
    try:
        yield
    except BrokenPipeError:
        raise
    except OSError as error:
        discard_the_rest()
        raise InputError("file_unwritable", f"standard output: cannot be written: {_reason(error)}") from None


def discard_the_rest() -> None:
    """Discards buffered output that cannot be written, so that Python does not raise again when it ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _reason(error: OSError | ValueError) -> str:
    return error.strerror or str(error) if isinstance(error, OSError) else str(error)


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
