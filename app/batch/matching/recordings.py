"""Finds the recordings in a folder and its subfolders, all of them or those of a line by a pattern of their names, such
as `{character}/{id}_t{take}.wav`.

Names in braces are fields of the line, `*` matches anything but a folder. A pattern without a folder finds recordings
in any. One pass over the files indexes them, so that the cost does not grow with the number of lines.
"""

import os
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from ...errors import InputError, did_you_mean
from ..compressed import is_compressed
from ..model import ScriptLine

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
    special files such as pipes; compressed ones only where no other has their name.

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


PLACES = ("id", "character", "scene", "row", "take")
_PART = re.compile(r"\{(\w*)\}|(\*)|([^{}*]+)|(.)", re.DOTALL)


@dataclass(frozen=True, slots=True)
class RecordingPattern:
    """A compiled pattern; `places` are the fields in its braces that must agree with the line."""

    expression: re.Pattern[str]
    places: tuple[str, ...]
    has_folder: bool

    @classmethod
    def of(cls, text: str) -> Self:
        """Raises InputError `pattern_wrong`."""
        made, places = "", []
        for match in _PART.finditer(text):
            name, star, plain, stray = match.groups()
            if stray is not None or (name is not None and name not in PLACES):
                hint = did_you_mean(name or "", PLACES)
                told = ", ".join(f"{{{place}}}" for place in PLACES)
                message = f"pattern {text!r}: {match[0]!r} is no place; places are {told}{hint}"
                raise InputError("pattern_wrong", message, field="pattern")
            if name in places:
                made += f"(?P={name})"
            elif name is not None:
                places.append(name)
                made += rf"(?P<{name}>\d+)" if name in {"row", "take"} else f"(?P<{name}>[^/]+)"
            else:
                made += "[^/]*" if star else re.escape(plain)
        if not {"id", "row"} & set(places):
            message = f"pattern {text!r}: says nothing of the line; put {{id}} where its id stands"
            raise InputError("pattern_wrong", message, field="pattern")
        return cls(re.compile(made, re.IGNORECASE), tuple(name for name in places if name != "take"), "/" in text)

    def by_key(self, files: Iterable[RecordingFile]) -> dict[tuple[str, ...], list[tuple[RecordingFile, int | None]]]:
        """The matching files with their takes, by the values of `places`."""
        found: dict[tuple[str, ...], list[tuple[RecordingFile, int | None]]] = {}
        for file in files:
            match = self.expression.fullmatch(file.relative if self.has_folder else file.path.name)
            if match:
                take = int(match["take"]) if "take" in match.re.groupindex else None
                found.setdefault(tuple(_plain(match[name]) for name in self.places), []).append((file, take))
        return found

    def key(self, line: ScriptLine) -> tuple[str, ...]:
        """The values of `places` in a line."""
        return tuple(_plain(str(getattr(line, name))) for name in self.places)


def _plain(value: str) -> str:
    """In lower case, and numbers without leading zeros."""
    return value.lstrip("0") or "0" if value.isdecimal() else value.casefold()
