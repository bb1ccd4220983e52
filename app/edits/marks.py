"""Moves sync points as an author asked; the others follow and keep their order.

As in BML edited by hand (`understudy.bml.reading.moved_points`), strokes are never stretched: moving `stroke`,
`stroke_end`, `stroke_start` or `ready` moves the whole behaviour. `start` and `relax` move alone, which lengthens or
shortens the preparation or the hold, and `end` moves with `relax`. A behaviour without a stroke moves with `ready`.
Nothing begins before 0, no stroke ends after `end_s`. Times are seconds, whole milliseconds.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from ..model import SyncPoints, Word
from ..model.edits import MARKS, Edge, MarkPlace
from .words import find_word

_LEADING = ("stroke", "stroke_end", "stroke_start", "ready")
"""The first of these that was moved takes the others with it."""

_STROKE = ("stroke_start", "stroke", "stroke_end")
_TOLERANCE_S = 0.0015
"""Times are rounded to milliseconds, twice."""


@dataclass(frozen=True, slots=True)
class MovedPoints:
    """The sync points after the move, and those that could not be moved all the way, with the time asked for."""

    sync: SyncPoints
    refused: tuple[tuple[str, float], ...] = ()


def place_s(place: MarkPlace, words: Sequence[Word]) -> float | None:
    """The time of a place, on the clock of the words; None if its word is gone or not spoken."""
    index = find_word(place.at, words)
    interval = None if index is None else words[index].interval
    if interval is None:
        return None
    return (interval.start_s if place.edge is Edge.START else interval.end_s) + place.offset_s


def moved(sync: SyncPoints, wanted_s: Mapping[str, float], *, end_s: float, lasting: bool = False) -> MovedPoints:
    """The sync points with those named in `wanted_s` moved there; names the behaviour does not have are ignored.

    A `lasting` behaviour changes a state and is over once that is reached, so its last three points coincide.
    """
    points = dict(sync.in_order())
    wanted_s = {name: round(at_s, 3) for name, at_s in wanted_s.items() if name in points}
    if lasting and "end" in wanted_s:
        wanted_s["ready"] = wanted_s.pop("end")
    points = _with_leading(points, wanted_s)
    if "start" in wanted_s:
        points["start"] = wanted_s["start"]
    if "relax" in wanted_s and "end" in points:
        points["end"] += wanted_s["relax"] - points["relax"]
        points["relax"] = wanted_s["relax"]
    if "end" in wanted_s:
        points["end"] = wanted_s["end"]
    if lasting:
        points |= dict.fromkeys(("relax", "end"), points["ready"]) if "ready" in points else {}
    points = _in_order(_within(points, end_s))
    refused = tuple((name, at_s) for name, at_s in wanted_s.items() if abs(points[name] - at_s) > _TOLERANCE_S)
    return MovedPoints(replace(sync, **{name: round(at_s, 3) + 0.0 for name, at_s in points.items()}), refused)


def _with_leading(points: dict[str, float], wanted_s: Mapping[str, float]) -> dict[str, float]:
    leading = next((name for name in _LEADING if name in wanted_s), None)
    if leading is None:
        return points
    later_s = wanted_s[leading] - points[leading]
    return {name: at_s + later_s for name, at_s in points.items()}


def _within(points: dict[str, float], end_s: float) -> dict[str, float]:
    """The points shifted together so that the stroke, or else the ready point, lies within the line."""
    held = [points[name] for name in (*_STROKE, "ready") if name in points] or [points["start"]]
    later_s = max(0.0, -min(held)) or min(0.0, end_s - max(held))
    return {name: max(0.0, at_s + later_s) for name, at_s in points.items()}


def _in_order(points: dict[str, float]) -> dict[str, float]:
    """The points in their order; the stroke, or else the ready point, stays where it is."""
    fixed = [name for name in (*_STROKE, "ready") if name in points]
    names = [name for name in MARKS if name in points]
    first = min((names.index(name) for name in fixed), default=0)
    for place in range(first - 1, -1, -1):
        points[names[place]] = min(points[names[place]], points[names[place + 1]])
    for place in range(first + 1, len(names)):
        points[names[place]] = max(points[names[place]], points[names[place - 1]])
    return points
