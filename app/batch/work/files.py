"""Writes outputs completely or not at all: first to a folder of unfinished files, then renamed.

That folder is inside the output folder, so that renaming is atomic and a killed process leaves nothing elsewhere.
"""

import errno
import shutil
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from uuid import uuid4

from ...errors import InputError
from ...files import replace_file
from .jobs import OutputFile

UNFINISHED = ".unfinished"

_FULL = frozenset({errno.ENOSPC, errno.EDQUOT})


def write_whole(folder: Path, relative: str, content: bytes) -> None:
    """Writes `content` under `folder`, creating folders as needed; raises OSError."""
    unfinished = folder / UNFINISHED / uuid4().hex
    unfinished.parent.mkdir(parents=True, exist_ok=True)
    target = folder / relative
    target.parent.mkdir(parents=True, exist_ok=True)
    replace_file(target, content, unfinished=unfinished)


def write_files(folder: Path, files: Iterable[OutputFile]) -> tuple[OutputFile, ...]:
    """Writes every file that has content; returns all files without their content."""
    written = []
    for file in files:
        if file.content is not None:
            write_whole(folder, file.path, file.content)
        written.append(replace(file, content=None))
    return tuple(written)


def unwritable(error: OSError, folder: Path) -> InputError:
    """What a file that could not be written means to people: `disk_full` or `file_unwritable`."""
    if error.errno in _FULL:
        message = f"{folder}: the disk is full; free some space and run the same command again: nothing done is lost"
        return InputError("disk_full", message, field="out")
    return InputError("file_unwritable", f"{folder}: cannot be written to: {error}", field="out")


def clear_unfinished(folder: Path) -> None:
    """Removes what a killed process left; no other process may be writing there."""
    shutil.rmtree(folder / UNFINISHED, ignore_errors=True)
