"""The sync marks of the speech, and times relative to them.

Every word has a mark at its start. With `TimeForm.SYNC` all points of a behaviour refer to one mark, that of the word
in which its stroke (or else its start) falls: wherever a realizer's speech places the word, the phases keep their
durations, and the stroke its word. Points before the first word refer to the start of the speech. Nothing resolves
below `FIRST_MOMENT_S`: strict realizers drop a behaviour that begins before 0, as a sum of decimals may by a rounding
error (.35 + .25 − .6 is −5.6e-17).
"""

from bisect import bisect_right
from collections.abc import Callable
from functools import partial

from ...model import SyncPoints, Word
from ...model.formats.bml_form import TimeForm
from .documents import Reference, Time

SPEECH = "speech1"
"""The id of the speech behaviour."""

FIRST_MOMENT_S = 0.001
"""The earliest time that a point relative to a mark resolves to."""

TimeFormatter = Callable[[SyncPoints], dict[str, Time]]
"""Expresses the sync points that are set, by name, in order."""


def time_formatter(
    words: tuple[Word, ...], timing: TimeForm, mark: Callable[[int], str], *, speech_start_s: float = 0.0
) -> TimeFormatter:
    """The function that expresses times in a document; `mark` gives the id of the mark before the word with an
    index."""
    if timing is TimeForm.ABSOLUTE:
        return _absolute
    starts = [(to_milli(speech_start_s), "start")]
    starts += [(to_milli(word.interval.start_s), mark(word.index)) for word in words if word.interval]
    return partial(_from_mark, starts)


def to_milli(number: float) -> float:
    """The number rounded to three decimals; never -0.0."""
    return round(number, 3) + 0.0


def _absolute(sync: SyncPoints) -> dict[str, Time]:
    return {name: to_milli(time_s) for name, time_s in sync.in_order()}


def _from_mark(starts: list[tuple[float, str]], sync: SyncPoints) -> dict[str, Time]:
    anchor_s = to_milli(sync.start if sync.stroke is None else sync.stroke)
    mark_s, mark = starts[max(bisect_right(starts, anchor_s, key=lambda start: start[0]) - 1, 0)]
    points_s = {name: max(FIRST_MOMENT_S, to_milli(time_s)) for name, time_s in sync.in_order()}
    return {name: Reference(SPEECH, mark, to_milli(point_s - mark_s)) for name, point_s in points_s.items()}
