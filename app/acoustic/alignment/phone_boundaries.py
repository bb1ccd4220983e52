"""Converts between timed words with phones and a list of boundaries.

Times are seconds from the start of the audio. Adjacent phones share one boundary; a pause has two.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from ...model import FloatArray, Interval, Phone, Word

SHORTEST_PAUSE_S = 0.030
"""Phones closer than this share one boundary."""

SHORTEST_PHONE_S = 0.010


@dataclass(frozen=True, slots=True)
class Boundary:
    """The end of `left` and start of `right` (None: silence); `time_s` from the start of the audio."""

    time_s: float
    left: str | None
    right: str | None


def boundaries(words: Sequence[Word]) -> list[Boundary]:
    """All starts and ends of phones, in order; adjacent phones share one."""
    phones = [phone for word in words for phone in word.phones]
    found = [Boundary(phones[0].interval.start_s, None, phones[0].label)]
    for left, right in pairwise(phones):
        if are_adjacent(left, right):
            found.append(Boundary(right.interval.start_s, left.label, right.label))
        else:
            found.append(Boundary(left.interval.end_s, left.label, None))
            found.append(Boundary(right.interval.start_s, None, right.label))
    return [*found, Boundary(phones[-1].interval.end_s, phones[-1].label, None)]


def are_adjacent(left: Phone, right: Phone) -> bool:
    """Whether two phones share a boundary."""
    return right.interval.start_s - left.interval.end_s < SHORTEST_PAUSE_S


def spaced_times(times_s: FloatArray, duration_s: float) -> FloatArray:
    """The times moved to be at least `SHORTEST_PHONE_S` apart, if the audio is long enough, and within it; in
    milliseconds."""
    room_s = min(SHORTEST_PHONE_S, duration_s / len(times_s)) * np.arange(len(times_s))
    ascending = np.maximum.accumulate(np.maximum(times_s, 0.0) - room_s) + room_s
    latest_s = duration_s - room_s[::-1]
    ordered: FloatArray = np.minimum(ascending, latest_s).round(3)
    return ordered


def with_boundaries(words: tuple[Word, ...], times_s: FloatArray) -> tuple[Word, ...]:
    """The words with their phones between `times_s`, the new times of `boundaries(words)`."""
    remaining = iter([float(time_s) for time_s in times_s])
    previous: Phone | None = None
    start_s = end_s = next(remaining)
    made = []
    for word in words:
        phones = []
        for phone in word.phones:
            if previous is not None:
                start_s = end_s if are_adjacent(previous, phone) else next(remaining)
            previous, end_s = phone, next(remaining)
            phones.append(replace(phone, interval=Interval(start_s, end_s)))
        interval = Interval(phones[0].interval.start_s, phones[-1].interval.end_s)
        made.append(replace(word, interval=interval, phones=tuple(phones)))
    return tuple(made)
