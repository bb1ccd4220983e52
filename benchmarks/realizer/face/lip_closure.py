"""Measures when the lips close for P, B, M, F and V.

Lips are closed for P, B and M, lower lip and upper teeth for F and V. The opening is a share of the jaw's range:
`jawOpen` less `mouthClose`, plus what raised, lowered or funnelled lips add.
"""

from dataclasses import dataclass

import numpy as np

from understudy.model import FloatArray, Interval, Viseme
from understudy.realizer.face.face_tables import INDEX

BILABIAL, LABIODENTAL = "PP", "FF"

SHUT = 0.01
"""An opening too small to see, as a share of the jaw's range."""

LIP_SHARE = 0.25
"""How far a fully raised, lowered or funnelled lip opens the mouth, as a share of the jaw's range."""


@dataclass(frozen=True, slots=True)
class Closure:
    """A viseme that requires a closed mouth, and the interval in which it is closed; None if it never is."""

    viseme: Viseme
    closed: Interval | None


def lip_opening(shapes: FloatArray, *, to_teeth: bool = False) -> FloatArray:
    """The opening (T,) between the lips; or `to_teeth`, between lower lip and upper teeth, which the upper lip does not
    affect."""
    jaw = shapes[:, INDEX["jawOpen"]] - shapes[:, INDEX["mouthClose"]]
    opening = jaw + LIP_SHARE * (_pair(shapes, "mouthLowerDown") + shapes[:, INDEX["mouthFunnel"]])
    return opening if to_teeth else opening + LIP_SHARE * _pair(shapes, "mouthUpperUp")


def lip_closures(visemes: tuple[Viseme, ...], shapes: FloatArray, times_s: FloatArray) -> tuple[Closure, ...]:
    """One for each bilabial and labiodental: the closed interval around the smallest opening within its phone."""
    openings = {BILABIAL: lip_opening(shapes), LABIODENTAL: lip_opening(shapes, to_teeth=True)}
    return tuple(
        Closure(viseme, _shut(openings[viseme.label], times_s, viseme.interval))
        for viseme in visemes
        if viseme.label in openings
    )


def _shut(opening: FloatArray, times_s: FloatArray, phone: Interval) -> Interval | None:
    first, behind = np.searchsorted(times_s, [phone.start_s, phone.end_s])
    first = min(int(first), len(times_s) - 1)
    least = first + int(np.argmin(opening[first : max(int(behind), first + 1)]))
    if opening[least] > SHUT:
        return None
    is_open = np.flatnonzero(opening > SHUT)
    next_open = int(np.searchsorted(is_open, least))
    start_s, end_s = float(times_s[0]), float(times_s[-1])
    if next_open > 0:
        start_s = _crossing(opening, times_s, int(is_open[next_open - 1]), int(is_open[next_open - 1]) + 1)
    if next_open < len(is_open):
        end_s = _crossing(opening, times_s, int(is_open[next_open]), int(is_open[next_open]) - 1)
    return Interval(start_s, end_s)


def _crossing(opening: FloatArray, times_s: FloatArray, outside: int, inside: int) -> float:
    """When the opening passes `SHUT` between two neighbouring frames."""
    share = (opening[outside] - SHUT) / (opening[outside] - opening[inside])
    return float(times_s[outside] + share * (times_s[inside] - times_s[outside]))


def _pair(shapes: FloatArray, name: str) -> FloatArray:
    return np.asarray(shapes[:, [INDEX[name + "Left"], INDEX[name + "Right"]]].mean(axis=1))
