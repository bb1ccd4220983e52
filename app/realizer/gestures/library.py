"""The gesture library: all definitions in a folder, available as clips by category, level of agitation and hand, of one
hand or both, with times in seconds.

The folder holds `*.gesture` files, also in subfolders, and optionally `aliases.yaml`: lexemes of other BML dialects, by
the category of ours that shows them.

The seven markers of a clip (paper §3.8, Table 3) come from the frames. Missing ones are derived: without `ready` there
is no pre-stroke hold; without `stroke` the emphasis is at `EMPHASIS` of the stroke; without `relax` the post-stroke
hold lasts until the last `hold` frame, or there is none.
"""

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType

import numpy as np

from ...errors import AuthoringError, InputError, Mistake, did_you_mean
from ...model import Hand, Level
from ...model.figure import GestureManner
from ...yaml_files import Entry, Source
from .checking import duplicate_names
from .definitions import definition
from .gesture import ArmKey, Clip, ClipKey, Definition, Expressivity, Frame, FrameType, Markers
from .gesture_space import sector_m
from .statements import GestureFile, LocatedMistake, mistake_in

EMPHASIS = 0.61
"""Where speakers put the emphasis within a stroke, as a share of its duration (docs/references.md)."""

LEAST_TURNS = 2
"""Frames inside the stroke of a wave, at which the hand turns back; a stroke that goes one way in an arc has one."""

LEADING = Hand.RIGHT
"""The leading hand of a two-handed gesture, whose keys come first in its file."""


def clip(definition: Definition, level: Level, hand: Hand, category: str) -> Clip:
    """The gesture as made by `hand`. One-handed definitions are mirrored for the left or for both hands; of two-handed
    ones, a single hand plays the leading hand's part. Raises KeyError for a level that the definition does not suit."""
    expressivity = _in_manner(definition.levels[level], definition.manner)
    scale_s = definition.duration_s / expressivity.tempo
    markers = relative_markers(definition.frames)
    in_seconds = Markers(*(scale_s * getattr(markers, name) for name in Markers.__slots__))
    return Clip(
        name=definition.name,
        category=category,
        level=level,
        hand=hand,
        markers=in_seconds,
        keys=tuple(_key(frame, hand, scale_s) for frame in definition.frames),
        expressivity=expressivity,
        stroke_speed_m_s=_stroke_speed_m_s(definition.frames, markers, expressivity, scale_s),
        aimed=definition.aimed,
        tracks=definition.tracks,
        manner=definition.manner,
        waves=definition.waves and _turns(definition.frames, markers) >= LEAST_TURNS,
        at_the_body=definition.at_the_body,
    )


def _turns(frames: Sequence[Frame], markers: Markers) -> int:
    return sum(markers.stroke_start < frame.time < markers.stroke_end for frame in frames)


def _in_manner(expressivity: Expressivity, manner: GestureManner) -> Expressivity:
    return replace(
        expressivity, amplitude=expressivity.amplitude * manner.space, tempo=expressivity.tempo * manner.pace
    )


def relative_markers(frames: Sequence[Frame]) -> Markers:
    """The markers as fractions 0 … 1 of the gesture; `frames` must have passed the checks."""
    at: dict[FrameType, float] = {frame.type: frame.time for frame in frames}
    strokes = [frame.time for frame in frames if frame.type is FrameType.STROKE]
    stroke_end = at.get(FrameType.STROKE_END, strokes[-1] if strokes else 1.0)
    stroke_start = at.get(FrameType.STROKE_START, _before_the_stroke(frames))
    emphasis = stroke_start + EMPHASIS * (stroke_end - stroke_start)
    last = frames[-1].time
    return Markers(
        start=0.0,
        ready=at.get(FrameType.READY, stroke_start),
        stroke_start=stroke_start,
        stroke=min(strokes, key=lambda time: abs(time - emphasis), default=emphasis),
        stroke_end=stroke_end,
        relax=at.get(FrameType.RELAX, at.get(FrameType.HOLD, stroke_end)),
        end=at.get(FrameType.END, last),
    )


def _before_the_stroke(frames: Sequence[Frame]) -> float:
    """The start of the stroke when no frame marks it: the last frame before the stroke's poses."""
    poses = {FrameType.STROKE, FrameType.STROKE_END}
    first = next(position for position, frame in enumerate(frames) if frame.type in poses)
    return frames[max(first - 1, 0)].time


def _key(frame: Frame, hand: Hand, scale_s: float) -> ClipKey:
    """Keys are relative to their own arm, so the mirror image is the same key on the other side."""
    arms: dict[Hand, ArmKey] = {LEADING: frame.leading, Hand.LEFT: frame.other or frame.leading}
    if hand is not Hand.BOTH:
        arms = {hand: frame.leading}
    return ClipKey(
        frame.time * scale_s, frame.type, arms.get(Hand.LEFT), arms.get(Hand.RIGHT), frame.noise, frame.curve
    )


def _stroke_speed_m_s(frames: Sequence[Frame], markers: Markers, expressivity: Expressivity, scale_s: float) -> float:
    """The mean speed of the leading hand along straight lines between its places. A frame without a place is
    interpolated between its neighbours."""
    placed = [(frame.time, frame.leading.place) for frame in frames if frame.leading.place is not None]
    if not placed:
        return 0.0
    known = np.array([sector_m(place, expressivity.amplitude) for _, place in placed if place is not None])
    inner = [time for time, _ in placed if markers.stroke_start < time < markers.stroke_end]
    times = [markers.stroke_start, *inner, markers.stroke_end]
    way = np.stack([np.interp(times, [time for time, _ in placed], known[:, axis]) for axis in range(3)], axis=-1)
    length_m = sum(float(np.linalg.norm(after - before)) for before, after in pairwise(way))
    return length_m / ((markers.stroke_end - markers.stroke_start) * scale_s)


SUFFIX = ".gesture"

LAST_RESORT = "BEAT"
"""Gesture Engine §5: requests that no prototype matches are shown by a generic beat."""


@dataclass(frozen=True, slots=True, eq=False)
class Library:
    """Gesture definitions in the order of their files and by category, and aliases of categories."""

    definitions: tuple[Definition, ...]
    by_category: Mapping[str, tuple[Definition, ...]]
    aliases: Mapping[str, str]

    @classmethod
    def load(cls, folder: Path) -> "Library":
        """Read all files in `folder`. Raises AuthoringError with all mistakes in all of them."""
        definitions = read_definitions(gesture_files([folder]))
        library = cls.of(definitions)
        path = folder / ALIASES
        return cls.of(definitions, read_aliases(path, library.categories)) if path.is_file() else library

    @classmethod
    def of(cls, definitions: Iterable[Definition], aliases: Mapping[str, str] = MappingProxyType({})) -> "Library":
        """A library of these definitions."""
        listed = tuple(definitions)
        found: dict[str, list[Definition]] = defaultdict(list)
        for one in listed:
            for category in one.categories:
                found[category].append(one)
        by_category = {category: tuple(found[category]) for category in sorted(found)}
        return cls(listed, MappingProxyType(by_category), MappingProxyType(dict(aliases)))

    def in_manner(self, manner: GestureManner) -> "Library":
        """The gestures of a character: these, made in its manner.

        The paper has two sets of 29 recordings, by a woman and by a man (§3.8). What differs between them is how much
        space a gesture takes, how fast it is, and how elbow and wrist are held: here each character has its own.
        """
        return Library.of((replace(one, manner=manner) for one in self.definitions), self.aliases)

    def with_waves(self, categories: Collection[str]) -> "Library":
        """The same gestures, of which those of these categories wave."""
        waving = {one.name for category in categories for one in self.by_category.get(category, ())}
        return Library.of((replace(one, waves=one.name in waving) for one in self.definitions), self.aliases)

    @property
    def categories(self) -> tuple[str, ...]:
        """The categories that have a gesture, sorted."""
        return tuple(self.by_category)

    def clips(self, category: str, level: Level, hand: Hand) -> tuple[Clip, ...]:
        """All clips for `category` at `level` with `hand`, in the order of the files; possibly none.

        Definitions for as many hands as requested take precedence. If there are none, both hands make a one-handed
        gesture as mirror images, or one hand makes the leading hand's part of a two-handed one. A definition for the
        left or the right hand is for that hand only.
        """
        return _clips(self, category, level, hand)

    def definition(self, name: str) -> Definition:
        """The definition of this name. Raises InputError `unknown_name`."""
        named = {one.name: one for one in self.definitions}
        if name not in named:
            hint = did_you_mean(name, named, most=3, otherwise="; see gestures list")
            raise InputError("unknown_name", f"no gesture is called {name!r}{hint}", field="name")
        return named[name]

    def category_of(self, lexeme: str) -> str | None:
        """The category of `lexeme` of any BML dialect: the same name, ignoring case and separators, or the one it is an
        alias of. None for a lexeme that nothing in the library shows."""
        spelt = re.sub(r"[^A-Z0-9]+", "_", lexeme.upper()).strip("_")
        named = (lexeme, spelt, self.aliases.get(spelt))
        return next((category for category in named if category in self.by_category), None)

    def nearest(self, lexeme: str) -> str | None:
        """The category of `lexeme`, or else a beat. None if the library has no beat either."""
        return self.category_of(lexeme) or (LAST_RESORT if LAST_RESORT in self.by_category else None)


@lru_cache(maxsize=4096)
def _clips(library: Library, category: str, level: Level, hand: Hand) -> tuple[Clip, ...]:
    """`Library.clips`. Cached, since every line asks for clips that others have asked for."""
    fit = [one for one in library.by_category.get(category, ()) if level in one.levels]
    either, both = [one for one in fit if one.hand is None], [one for one in fit if one.hand is Hand.BOTH]
    same = both if hand is Hand.BOTH else [one for one in fit if one.hand in {None, hand}]
    otherwise = either if hand is Hand.BOTH else both
    return tuple(clip(one, level, hand, category) for one in same or otherwise)


def gesture_files(paths: Iterable[Path]) -> tuple[Path, ...]:
    """The gesture files among these paths and in these folders, sorted by name within a folder."""
    inside = (sorted(path.rglob(f"*{SUFFIX}")) if path.is_dir() else [path] for path in paths)
    return tuple(file for files in inside for file in files if file.suffix == SUFFIX)


def read_definitions(paths: Sequence[Path]) -> tuple[Definition, ...]:
    """The definitions in these files. Raises AuthoringError with all mistakes, by file and line."""
    from .language import read_gestures  # brings lark, which gestures that are kept do without

    return _definitions([read_gestures(path) for path in paths])


def parse_definitions(text: str, path: Path) -> tuple[Definition, ...]:
    """As `read_definitions`, for a text in memory; `path` is for messages."""
    from .language import parse_gestures

    return _definitions([parse_gestures(text, path)])


def _definitions(parsed: Sequence[tuple[GestureFile, Sequence[Mistake]]]) -> tuple[Definition, ...]:
    """The definitions in parsed files, each with the mistakes of its syntax."""
    definitions: list[Definition] = []
    files: list[GestureFile] = []
    mistakes: list[Mistake] = []
    for file, found in parsed:
        wrong: list[LocatedMistake] = []
        read = [definition(tree, file.path, wrong) for tree in file.gestures]
        definitions += [one for one in read if one is not None]
        mistakes += [*found, *(mistake_in(file, one) for one in wrong)]
        files.append(file)
    mistakes += duplicate_names(files)
    if mistakes:
        order = {file.path: number for number, file in enumerate(files)}
        raise AuthoringError(tuple(sorted(mistakes, key=lambda one: (order[one.path], one.line, one.column))))
    return tuple(definitions)


ALIASES = "aliases.yaml"

_LEXEME = re.compile(r"[A-Z][A-Z0-9]*(_[A-Z0-9]+)*")


class Aliases(Entry):
    """The file format: for each category, its aliases."""

    aliases: Mapping[str, tuple[str, ...]]


def read_aliases(path: Path, categories: Collection[str]) -> Mapping[str, str]:
    """Our category by foreign lexeme. Raises AuthoringError with all mistakes, such as categories without gestures."""
    source = Source(path)
    listed = source.validated(Aliases).aliases
    mistakes = [source.mistake(where, told) for where, told in _mistakes(listed, categories)]
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    return {lexeme: category for category, lexemes in listed.items() for lexeme in lexemes}


def _mistakes(
    listed: Mapping[str, tuple[str, ...]], categories: Collection[str]
) -> Iterator[tuple[tuple[str | int, ...], str]]:
    seen: dict[str, str] = {}
    for category, lexemes in listed.items():
        if category not in categories:
            yield ("aliases", category), f"no gesture shows {category}{did_you_mean(category, categories)}"
        for position, lexeme in enumerate(lexemes):
            where = ("aliases", category, position)
            if not _LEXEME.fullmatch(lexeme):
                yield where, f"{lexeme!r}: lexemes are written in capitals, words joined by one underscore"
            elif lexeme in categories:
                yield where, f"{lexeme} has gestures of its own"
            elif lexeme in seen:
                yield where, f"{lexeme} is listed under {seen[lexeme]} already"
            seen.setdefault(lexeme, category)
