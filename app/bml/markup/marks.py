"""The marks of the speech, and times told from them.

Every word has a mark where it begins. With `TimeForm.SYNC` all points of a behaviour are told from one mark, that of
the word in which its stroke (without one, its start) falls: wherever a realizer's speech puts the word, the phases
keep their lengths and their order, and the stroke its word. What comes before the first word is told from the start of
the speech.
"""

from bisect import bisect_right
from collections.abc import Callable
from functools import partial

from ...model import SyncPoints, Word
from .documents import Reference, Time, TimeForm

SPEECH = "speech1"
"""The id of the speech."""

Clock = Callable[[SyncPoints], dict[str, Time]]
"""Tells the points that are set, by name, in order."""


def clock(
    words: tuple[Word, ...], timing: TimeForm, mark: Callable[[int], str], *, speech_start_s: float = 0.0
) -> Clock:
    """How a document tells times; `mark` is the id of the mark before the word of a number."""
    if timing is TimeForm.ABSOLUTE:
        return _absolute
    starts = [(to_milli(speech_start_s), "start")]
    starts += [(to_milli(word.interval.start_s), mark(word.index)) for word in words if word.interval]
    return partial(_from_mark, starts)


def to_milli(number: float) -> float:
    """The number to three decimals; never -0.0."""
    return round(number, 3) + 0.0


def _absolute(sync: SyncPoints) -> dict[str, Time]:
    return {name: to_milli(time_s) for name, time_s in sync.in_order()}


def _from_mark(starts: list[tuple[float, str]], sync: SyncPoints) -> dict[str, Time]:
    anchor_s = to_milli(sync.start if sync.stroke is None else sync.stroke)
    mark_s, mark = starts[max(bisect_right(starts, anchor_s, key=lambda start: start[0]) - 1, 0)]
    return {name: Reference(SPEECH, mark, to_milli(to_milli(time_s) - mark_s)) for name, time_s in sync.in_order()}
