"""Moves the other sync points along with those moved by hand in a file of ours.

The record has the durations of each behaviour's phases as scheduled (`understudy.bml.writing.blocks`). Points that no
longer agree with most of the others were moved. If that is a point up to the end of the stroke, the whole behaviour
moves by as much, because strokes are never stretched; if it is `relax`, which lengthens or shortens a hold, `end` moves
too; `end` moves alone. Points that were moved stay where they were put. Points at 0 that are written a moment later
(`FIRST_MOMENT_S`) were not moved.
"""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import accumulate

from ...model import Notice
from ..markup.documents import Element, Reference, Time
from ..markup.elements import OURS, ElementKind
from ..markup.mistakes import kind_of, typed_attributes
from ..markup.speech import FIRST_MOMENT_S
from ..markup.values import text_of

_FIRST_COUNTS = ("stroke", "strokeEnd", "strokeStart", "attackPeak", "ready", "start", "relax")
"""If several points were moved, the first of these determines how the others move."""
_BLOCKS = ("bml", "required")
_FEWEST = 3
"""With only two points it cannot be decided which was moved."""


@dataclass(frozen=True, slots=True)
class _Move:
    """A behaviour's points, of which `point` was moved by hand, `later_s` later than scheduled; `points` have new
    values as text, by name."""

    behavior: str
    point: str
    later_s: float
    points: Mapping[str, str]

    @property
    def notice(self) -> Notice:
        which = "later" if self.later_s > 0 else "earlier"
        message = f"{self.behavior}: its {self.point} is {abs(self.later_s):.3f} s {which} than scheduled"
        return Notice("bml_point_moved", f"{message}; what depends on it follows")


def with_following_points(root: Element, kind: ElementKind) -> tuple[Element, tuple[Notice, ...]]:
    """The file with the other points adjusted, and a notice for each behaviour of which one was moved."""
    moves = {move.behavior: move for move in _moves(root, kind, dict(_phases_s(root)))}
    notices = tuple(move.notice for move in moves.values())
    return _moved(root, moves) if moves else root, notices


def _moved(element: Element, moves: Mapping[str, _Move]) -> Element:
    content = tuple(part if isinstance(part, str) else _moved(part, moves) for part in element.content)
    move = moves.get(str(element.attributes.get("id")))
    return replace(element, content=content, attributes={**element.attributes, **(move.points if move else {})})


def _phases_s(element: Element) -> Iterator[tuple[str, tuple[float, ...]]]:
    """The durations of phases in the records of a file, by behaviour; what is not a number is reported elsewhere."""
    for part in element.children:
        if part.name == f"{{{OURS}}}behavior":
            lengths = str(part.attributes.get("phases", "")).split()
            if lengths and all(length.replace(".", "", 1).isdecimal() for length in lengths):
                yield str(part.attributes.get("ref")), tuple(map(float, lengths))
        else:
            yield from _phases_s(part)


def _moves(element: Element, kind: ElementKind, phases_s: Mapping[str, tuple[float, ...]]) -> Iterator[_Move]:
    for part in element.children:
        inside, name = kind_of(part, kind), str(part.attributes.get("id"))
        if inside and inside.name in _BLOCKS:
            yield from _moves(part, inside, phases_s)
        elif inside and name in phases_s:
            move = _move(name, _stated(part, inside), phases_s[name])
            if move:
                yield move


def _stated(element: Element, kind: ElementKind) -> dict[str, Time]:
    """The sync points given in the element, in order."""
    values = typed_attributes(element, kind)
    points = ((name, values.get(name)) for name in kind.syncs)
    return {name: time for name, time in points if isinstance(time, float | Reference)}


def _move(behavior: str, stated: Mapping[str, Time], phases_s: tuple[float, ...]) -> _Move | None:
    """The move of a behaviour all of whose points are given, relative to the same point; None if nothing moves."""
    anchors = {replace(time, offset_s=0.0) if isinstance(time, Reference) else None for time in stated.values()}
    if len(stated) != len(phases_s) + 1 or len(stated) < _FEWEST or len(anchors) != 1:
        return None
    times_s = {name: time.offset_s if isinstance(time, Reference) else float(time) for name, time in stated.items()}
    late_s = _late_s(times_s, phases_s, moment_s=0.0 if None in anchors else FIRST_MOMENT_S)
    point = next((name for name in _FIRST_COUNTS if late_s.get(name)), None)
    if point is None:
        return None
    (anchor,) = anchors
    follow = {"end"} if point == "relax" else late_s.keys()
    points = {
        name: _text(times_s[name] + late_s[point], anchor) for name in late_s if name in follow and not late_s[name]
    }
    return _Move(behavior, point, late_s[point], points)


def _late_s(times_s: Mapping[str, float], phases_s: tuple[float, ...], *, moment_s: float) -> dict[str, float]:
    """How much later than scheduled each point is, relative to most of them; first points that are `moment_s` later
    than others are not."""
    scheduled_s = accumulate(phases_s, initial=0.0)
    apart_s = {name: round(time_s - at_s, 3) for (name, time_s), at_s in zip(times_s.items(), scheduled_s, strict=True)}
    first_s = next(iter(apart_s.values()))
    written_s = round(first_s - moment_s, 3)
    if written_s in apart_s.values():
        apart_s = {name: written_s if each_s == first_s else each_s for name, each_s in apart_s.items()}
    usual_s = Counter(apart_s.values()).most_common(1)[0][0]
    return {name: round(each_s - usual_s, 3) for name, each_s in apart_s.items()}


def _text(time_s: float, anchor: Reference | None) -> str:
    """The time as text; times are not negative if they are absolute."""
    rounded_s = round(time_s, 3) + 0.0
    return text_of(max(0.0, rounded_s) if anchor is None else replace(anchor, offset_s=rounded_s))
