"""Gives the two sides of a contrast a stroke each, one to the left and one to the right; both are shown or neither
(paper §3.4).

Rules find the places (functions of class `locus`, left and right by order of mention). Where the plan would show one
side of such a pair as a contrast, the other side is shown too, each with a stroke of its own to its own side. Strokes
that are too close to either are dropped.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from typing import TypeAlias

from ...model import Function, SingleArray
from .decoding import NEAR, STROKES_APART_S

Locus: TypeAlias = tuple[int, int, str]
"""First word, last word, and side of what is assigned a place in gesture space."""

LOCUS, LEFT, RIGHT = "locus", "left", "right"
CONTRAST = "contrast_sides"
LEAST_WORTH = 0.17
"""The least worth of a contrast at one of the sides with which both are shown."""


@dataclass(frozen=True, slots=True)
class PlacedStroke:
    """A stroke on `word` that shows one side of a contrast, `side`; its counterpart lies on word `other`. `log_odds` is
    its own, of parallel phrases; None for those of the reading."""

    word: int
    side: str
    other: int
    log_odds: float | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """Where strokes can fall: the `times_s` of the words, the most that any gesture would gain on each (W,), and the
    words that are to be `still`."""

    times_s: Sequence[float]
    gain: SingleArray
    still: Sequence[int] = ()

    def apart(self, one: int, other: int) -> bool:
        """Whether strokes on these words are far enough apart."""
        return abs(self.times_s[one] - self.times_s[other]) >= STROKES_APART_S


def placed_strokes(functions: Iterable[Function], worth: SingleArray, ground: Ground) -> Iterator[PlacedStroke]:
    """The strokes of each pair of places that is worth showing.

    `worth` (W,) is that of a contrast. Pairs whose strokes would be too close in time are left to a single gesture that
    shows both places.
    """
    loci = sorted(
        {(each.first, each.last, each.subtype) for each in functions if each.class_name == LOCUS and each.kept}
    )
    sides = [locus for locus in loci if locus[2] in (LEFT, RIGHT)]
    free_from = 0
    for one, other in pairwise(sides):
        if one[2] == other[2] or one[0] < free_from:
            continue
        words = _strokes_of(one, other, ground)
        if words is not None and max(worth[word] for word in words) >= LEAST_WORTH:
            yield PlacedStroke(words[0], one[2], words[1])
            yield PlacedStroke(words[1], other[2], words[0])
            free_from = other[0] + 1


def with_placed(taken: Iterable[int], placed: Iterable[PlacedStroke], ground: Ground) -> list[int]:
    """The strokes of a line in order: the placed ones, and those of `taken` that are not too close to them."""
    words = {each.word for each in placed}
    return sorted(words | {each for each in taken if all(ground.apart(each, word) for word in words)})


def _strokes_of(one: Locus, other: Locus, ground: Ground) -> tuple[int, int] | None:
    """The words of the two sides, far enough apart, on which strokes gain most: within the mentions, or within `NEAR`
    words after them."""
    firsts = range(one[0], min(one[1] + NEAR, other[0] - 1) + 1)
    seconds = range(other[0], min(other[1] + NEAR, len(ground.gain) - 1) + 1)
    pairs = [pair for pair in product(firsts, seconds) if ground.apart(*pair) and not {*pair} & {*ground.still}]
    return max(pairs, key=lambda pair: float(ground.gain[pair[0]] + ground.gain[pair[1]]), default=None)
