"""Semantic checks of parsed gestures (Gesture Engine §4.3): frame times, phases, strokes, duplicate names.

Frame times increase within 0 … 1, phases are in order, there is a stroke, and the first frame places the arm.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType

from ...errors import Mistake
from .gesture import ArmKey, FrameType, KeyCurve
from .statements import FrameTree, GestureFile, GestureTree, LocatedMistake, Statement, StatementValue, mistake_in

IN_ORDER: tuple[FrameType, ...] = tuple(FrameType)
"""The phases in order."""

REPEATED = frozenset({FrameType.PREPARATION, FrameType.STROKE, FrameType.HOLD, FrameType.RETRACTION})
"""Poses within a phase, which may occur any number of times. The other types are instants and occur once."""

_PARTS: Mapping[str, int] = MappingProxyType({"FINGER": 1, "JOINT": 1, "EXPRESSIVITY": 1, "TRACK": 2})
"""Statements that may occur several times, and how many of their first words are then different."""


@dataclass(frozen=True, slots=True)
class TimedFrame:
    """An interpreted frame; fields are None where the file is wrong. `type_at` is the position of its type."""

    tree: FrameTree
    time: float | None
    type: FrameType | None
    type_at: StatementValue
    leading: ArmKey
    other: ArmKey | None
    noise: bool
    curve: KeyCurve


def frame_mistakes(tree: GestureTree, frames: Sequence[TimedFrame]) -> Iterator[LocatedMistake]:
    """All mistakes in the frames of a gesture."""
    for frame in frames:
        readable = all(statement.readable for statement in frame.tree.statements)
        if readable and not any(statement.keyword.text == "FRAMETYPE" for statement in frame.tree.statements):
            yield LocatedMistake(frame.tree.start.keyword, "this frame has no FRAMETYPE")
    yield from _time_mistakes(frames)
    yield from _phase_mistakes(frames)
    if tree.all_readable() and all(frame.time is not None and frame.type is not None for frame in frames):
        yield from _stroke_mistakes(tree, frames)
        yield from _place_mistakes(frames)


def repeated_statements(statements: Iterable[Statement]) -> Iterator[LocatedMistake]:
    """The lines of a frame or header that repeat an earlier statement."""
    seen: dict[tuple[str, ...], StatementValue] = {}
    for statement in statements:
        keyword = statement.keyword
        part = [word.text for word in statement.words[: _PARTS.get(keyword.text, 0)]]
        key = ("OTHER" if statement.other else "", keyword.text, *part)
        if statement.readable and key in seen:
            what = " ".join(filter(None, key))
            yield LocatedMistake(keyword, f"duplicate {what}; the first is in line {seen[key].line}")
        seen.setdefault(key, keyword)


def duplicate_names(files: Sequence[GestureFile]) -> Iterator[Mistake]:
    """Gestures with the same name, in one file or several: a mistake at each but the first."""
    first: dict[str, tuple[GestureFile, StatementValue]] = {}
    for file in files:
        for name in (word for tree in file.gestures for word in _names(tree)):
            if name.text in first:
                there, earlier = first[name.text]
                told = f"a gesture called {name.text} is also at {there.path}:{earlier.line}; names must be unique"
                yield mistake_in(file, LocatedMistake(name, told))
            first.setdefault(name.text, (file, name))


def _names(tree: GestureTree) -> Iterator[StatementValue]:
    for statement in tree.header:
        if statement.keyword.text == "GESTUREINSTANCE" and statement.readable:
            yield statement.words[0]


def _time_mistakes(frames: Sequence[TimedFrame]) -> Iterator[LocatedMistake]:
    for before, after in pairwise(frame for frame in frames if frame.time is not None):
        assert before.time is not None
        assert after.time is not None
        if after.time <= before.time:
            told = f"frame times must increase; the frame before is at {before.time:g}"
            yield LocatedMistake(after.tree.start.numbers[0], told)


def _phase_mistakes(frames: Sequence[TimedFrame]) -> Iterator[LocatedMistake]:
    for before, after in pairwise(frame for frame in frames if frame.type is not None):
        assert before.type is not None
        assert after.type is not None
        if after.type is before.type and after.type not in REPEATED:
            yield LocatedMistake(after.type_at, f"a gesture has one {after.type}; the frame before is one already")
        elif IN_ORDER.index(after.type) < IN_ORDER.index(before.type):
            yield LocatedMistake(
                after.type_at, f"{after.type} cannot follow {before.type}; the order is {', '.join(IN_ORDER)}"
            )


def _stroke_mistakes(tree: GestureTree, frames: Sequence[TimedFrame]) -> Iterator[LocatedMistake]:
    """Only the stroke is mandatory. It must have a duration: from its start or the frame before it, to its end."""
    types = [frame.type for frame in frames]
    ends = [position for position, type_ in enumerate(types) if type_ in {FrameType.STROKE, FrameType.STROKE_END}]
    if not frames:
        yield LocatedMistake(tree.start, "this gesture has no frames; it needs at least a stroke")
    elif not ends:
        told = "this gesture has no stroke: a frame of type stroke_start and one of stroke_end, or stroke"
        yield LocatedMistake(tree.start, told)
    elif ends[-1] == 0:
        told = "the stroke is the first frame and takes no time; say where it comes from in a frame before it"
        yield LocatedMistake(frames[0].tree.start.keyword, told)


def _place_mistakes(frames: Sequence[TimedFrame]) -> Iterator[LocatedMistake]:
    """The first frame must place the arm; later ones may leave the place open."""
    for frame in frames[:1]:
        fixed = {name for name, _ in frame.leading.joints}
        if frame.leading.place is None and not {"UpperArm", "LowerArm"} <= fixed:
            told = "the first frame must say where the arm is: ARM, or JOINT for UpperArm and LowerArm"
            yield LocatedMistake(frame.tree.start.keyword, told)
