"""Finds the recordings in a folder and its subfolders, and matches them with lines: by the file that the line names,
else by a pattern of names, such as `{character}/{id}_t{take}.wav`, else by the line's id.

Names in braces are fields of the line, `*` matches anything but a folder. A pattern without a folder finds recordings
in any. One pass over the files indexes them, so that the cost does not grow with the number of lines. Names are
compared without case. Of several takes the one that the line names is used, else the last, the first, or each as a line
of its own.

For a name that fits nothing the one that was probably meant is suggested. Such names differ mostly in their numbers,
and the next number is never what was meant, so two names are near if their numbers are the same except for leading
zeros and their letters are similar.
"""

import os
import re
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path, PurePosixPath
from typing import Self

from ..errors import InputError, did_you_mean
from .audio import is_compressed
from .model import Recording, ScriptLine, Take

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
        message = f"{folder}: there is no such folder of recordings; give --audio the folder where they are"
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
                listed = ", ".join(f"{{{place}}}" for place in PLACES)
                message = f"pattern {text!r}: {match[0]!r} is not a place; places are {listed}{hint}"
                raise InputError("pattern_wrong", message, field="pattern")
            if name in places:
                made += f"(?P={name})"
            elif name is not None:
                places.append(name)
                made += rf"(?P<{name}>\d+)" if name in {"row", "take"} else f"(?P<{name}>[^/]+)"
            else:
                made += "[^/]*" if star else re.escape(plain)
        if not {"id", "row"} & set(places):
            message = f"pattern {text!r}: does not identify the line; put {{id}} where its id is"
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


Candidates = list[tuple[RecordingFile, int | None]]


class TakeChoice(StrEnum):
    """Which of several takes is performed."""

    LAST = "last"
    FIRST = "first"
    ALL = "all"


@dataclass(frozen=True, slots=True)
class UnmatchedLine:
    """A line without a recording, and the stem of the unused recording that may have been meant for it, or the
    recording that is there and cannot be read here."""

    line: ScriptLine
    near: str | None
    unreadable: Path | None = None


@dataclass(frozen=True, slots=True)
class JoinedLines:
    """The lines with their recordings; unmatched lines and recordings; and duplicates: recordings of the same take of a
    line, and lines with the same recording."""

    takes: tuple[Take, ...]
    missing: tuple[UnmatchedLine, ...] = ()
    unused: tuple[Path, ...] = ()
    rivals: tuple[tuple[ScriptLine, tuple[Path, ...]], ...] = ()
    shared: tuple[tuple[Path, tuple[ScriptLine, ...]], ...] = ()


def join_recordings(
    lines: Sequence[ScriptLine],
    files: Sequence[RecordingFile],
    pattern: RecordingPattern | None = None,
    choice: TakeChoice = TakeChoice.LAST,
    *,
    unreadable: Sequence[RecordingFile] = (),
) -> JoinedLines:
    """Matches the lines with the recordings; a line without any may have one that is `unreadable` here."""
    candidates_of = _finder(files, pattern)
    found = [(line, candidates_of(line)) for line in lines]
    chosen = [(line, _chosen(line, candidates, choice)) for line, candidates in found]
    takes = tuple(take for line, candidates in chosen for take in _takes(line, candidates))
    seen = {file.path for _line, candidates in found for file, _take in candidates}
    unused = tuple(file for file in files if file.path not in seen)
    near = NearNames(file.stem for file in unused)
    unreadable_of = _finder(unreadable, pattern)
    return JoinedLines(
        takes,
        tuple(
            UnmatchedLine(
                line, near.nearest(_wanted(line)), next((file.path for file, _take in unreadable_of(line)), None)
            )
            for line, candidates in chosen
            if not candidates
        ),
        tuple(file.path for file in unused),
        tuple(rival for line, candidates in found if (rival := _rivals(line, candidates))),
        _shared(takes),
    )


def join_one_recording(lines: Sequence[ScriptLine], recording: Path) -> JoinedLines:
    """Lines cut out of one recording by their times; lines without times are missing."""
    takes = [Take(line.id, line, Recording(recording, line.interval), line.take) for line in lines if line.interval]
    return JoinedLines(tuple(takes), tuple(UnmatchedLine(line, None) for line in lines if not line.interval))


def _finder(files: Sequence[RecordingFile], pattern: RecordingPattern | None) -> Callable[[ScriptLine], Candidates]:
    """A function that finds the recordings that may be a line's, in order of their names."""
    by_name: dict[str, Candidates] = defaultdict(list)
    for file in files:
        for name in {file.relative, file.path.name, file.relative.removesuffix(file.path.suffix), file.stem}:
            by_name[name.casefold()].append((file, file.take))
        if file.take is not None:
            for name in {file.line_stem, str(PurePosixPath(file.relative).with_name(file.line_stem))}:
                by_name[name.casefold()].append((file, file.take))
    by_key = pattern.by_key(files) if pattern else {}

    def candidates_of(line: ScriptLine) -> Candidates:
        if line.recording:
            return _named(line.recording, by_name)
        if pattern:
            return by_key.get(pattern.key(line), [])
        return by_name.get(line.id.casefold(), [])

    return candidates_of


def _named(recording: str, by_name: Mapping[str, Candidates]) -> Candidates:
    """The file that a sheet names, with or without folder and extension, which may differ from that of the files
    delivered."""
    path = PurePosixPath(recording.replace("\\", "/"))
    names = (str(path), str(path.with_suffix("")), path.name, path.stem) if path.name else ()
    return next((by_name[name.casefold()] for name in names if name.casefold() in by_name), [])


def _chosen(line: ScriptLine, candidates: Candidates, choice: TakeChoice) -> Candidates:
    """One recording for each wanted take."""
    by_take: dict[int, tuple[RecordingFile, int | None]] = {}
    for file, take in candidates:
        by_take.setdefault(take or 0, (file, take))
    if line.take is not None and len(candidates) > 1:
        return [by_take[line.take]] if line.take in by_take else []
    ordered = [by_take[number] for number in sorted(by_take)]
    return ordered if choice is TakeChoice.ALL else ordered[-1:] if choice is TakeChoice.LAST else ordered[:1]


def _takes(line: ScriptLine, candidates: Candidates) -> list[Take]:
    several = len(candidates) > 1
    return [
        Take(f"{line.id}_t{number or 0}" if several else line.id, line, Recording(file.path, line.interval), number)
        for file, number in candidates
    ]


def _rivals(line: ScriptLine, candidates: Candidates) -> tuple[ScriptLine, tuple[Path, ...]] | None:
    """The recordings of the first take that has more than one."""
    by_take: dict[int | None, list[Path]] = defaultdict(list)
    for file, take in candidates:
        by_take[take].append(file.path)
    several = [paths for paths in by_take.values() if len(paths) > 1]
    return (line, tuple(several[0])) if several else None


def _shared(takes: Sequence[Take]) -> tuple[tuple[Path, tuple[ScriptLine, ...]], ...]:
    by_path: dict[Path, list[ScriptLine]] = defaultdict(list)
    for take in takes:
        if take.recording.interval is None:
            by_path[take.recording.path].append(take.line)
    return tuple((path, tuple(lines)) for path, lines in by_path.items() if len(lines) > 1)


def _wanted(line: ScriptLine) -> str:
    return PurePosixPath(line.recording.replace("\\", "/")).stem or line.id


LEAST_LIKENESS = 0.6
"""The least Dice coefficient of the trigrams of two names that are near."""

_RUNS = re.compile(r"\d+|[^\W\d_]+")


class NearNames:
    """A set of names that is searched for near ones."""

    def __init__(self, names: Iterable[str]) -> None:
        self._by_numbers: dict[tuple[str, ...], list[tuple[str, Counter[str]]]] = defaultdict(list)
        for name in names:
            self._by_numbers[_numbers(name)].append((name, _trigrams(name)))

    def nearest(self, name: str) -> str | None:
        """The nearest name, or None."""
        own = _trigrams(name)
        likenesses = [(_likeness(own, theirs), other) for other, theirs in self._by_numbers[_numbers(name)]]
        best = max(likenesses, default=(0.0, ""))
        return best[1] if best[0] >= LEAST_LIKENESS else None


def _numbers(name: str) -> tuple[str, ...]:
    return tuple(run.lstrip("0") for run in _RUNS.findall(name) if run.isdecimal())


def _trigrams(name: str) -> Counter[str]:
    """The trigrams of the letters, padded at both ends; numbers are compared separately."""
    letters = "".join(run.casefold() for run in _RUNS.findall(name) if not run.isdecimal())
    marked = f"  {letters} "
    return Counter(marked[place : place + 3] for place in range(len(marked) - 2))


def _likeness(first: Counter[str], second: Counter[str]) -> float:
    return 2 * (first & second).total() / (first.total() + second.total())
