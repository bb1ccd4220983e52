"""Finds the recordings in a folder and its subfolders."""

import os
import re
from dataclasses import dataclass
from pathlib import Path

from ...errors import InputError
from ..compressed import is_compressed

SUFFIXES = frozenset({".wav", ".wave", ".flac", ".ogg", ".oga", ".opus"})
"""What we read ourselves."""

_TAKE = re.compile(
    r"(?P<stem>.+?)(?:[ _.-]+(?:take|tk|t)[ _.-]*(?P<told>\d{1,3})| ?\((?P<copy>\d{1,3})\))", re.IGNORECASE
)


@dataclass(frozen=True, slots=True)
class RecordingFile:
    """A recording: its path, the path relative to the folder with forward slashes, and the two parts of its stem: the
    name of the line, and the number of the take if it ends in one (`scene1_07_t2`, `scene1_07 take 2`, `scene1_07
    (2)`)."""

    path: Path
    relative: str
    line_stem: str
    take: int | None

    @property
    def stem(self) -> str:
        return self.path.stem

    @classmethod
    def of(cls, path: Path, folder: Path) -> "RecordingFile":
        match = _TAKE.fullmatch(path.stem)
        line_stem = match["stem"] if match else path.stem
        take = int(match["told"] or match["copy"]) if match else None
        return cls(path, path.relative_to(folder).as_posix(), line_stem, take)


def find_recordings(folder: Path, *, without: Path) -> tuple[RecordingFile, ...]:
    """The recordings under `folder`, sorted by name, except hidden ones, those under `without` (our output folder) and
    what is no regular file, such as a pipe; compressed ones only where no other has their name.

    Raises InputError `file_unreadable`.
    """
    if not folder.is_dir():
        message = f"{folder}: no folder of recordings; give --audio the folder where they are"
        raise InputError("file_unreadable", message, field="audio")
    found, written = [], without.resolve()
    for parent, folders, files in os.walk(folder):
        folders[:] = sorted(
            name for name in folders if not name.startswith(".") and Path(parent, name).resolve() != written
        )
        names = [Path(parent, name) for name in files if not name.startswith(".")]
        paths = [path for path in names if path.suffix.lower() in SUFFIXES]
        plain = {path.stem.casefold() for path in paths}
        paths += [path for path in names if is_compressed(path) and path.stem.casefold() not in plain]
        found += [RecordingFile.of(path, folder) for path in paths if path.is_file()]
    return tuple(sorted(found, key=lambda each: each.relative))
