"""Where the strokes of a line fall, so that each idea has one.

The reading tells what a director would give for a gesture on the very word, and a stroke shows what is wanted within
`NEAR` words of it. Where two strokes are nearer to each other than that, what lies between them belongs to one of them:
a number that is named is counted once, on its word, and not before it and after it. So each stroke has a window of
words, up to `NEAR` to its left and right, windows do not overlap, and of the worth of a gesture there remains the share
that lies in its window.

Shapes: W words, L lexemes; a window is told by its reach to the left and right, 0 to `NEAR`.
"""

from bisect import bisect_right
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from ...model import SingleArray

STROKES_APART_S = 1.0
"""The least time from one stroke to the next: the hand has to come, show something and be seen."""

NEAR = 2
"""Words around a director's stroke within which a stroke still belongs to the same idea."""

PLACE = 0.3
"""The gain of a stroke where directors have any stroke, whatever its meaning, in addition to its worth."""

PRECISE = 0.15
"""The additional gain of a stroke on the very word, not only near it."""

UNPLACED = 0.1
"""What a gesture is worth on words of which the reading does not tell which: a rule may offer it on all of them."""

SHARE_POWER = 0.4
"""Of the share that lies in a window, this power remains of the worth: less is lost than lies outside, for a director
may want two gestures for one idea. Chosen on held-out lines, with the price (docs/measurements/choice.md)."""

NEVER = -1.0
_SLACK_S = 1e-6

Window = tuple[int, int]
"""How far a stroke's window reaches to the left and to the right."""

WHOLE = NEAR, NEAR
WINDOWS: tuple[Window, ...] = tuple(product(range(NEAR + 1), range(NEAR + 1)))


@dataclass(frozen=True, slots=True)
class Stroke:
    """A stroke on a word, and its window."""

    word: int
    window: Window = WHOLE


@dataclass(frozen=True, slots=True, eq=False)
class Worth:
    """What gestures are worth (W, L) with all their window, what they are worth on the very words by the reading (W,
    L), and how likely any stroke is there (W,)."""

    whole: SingleArray
    at_word: SingleArray
    stroke: SingleArray

    def share(self, window: Window) -> SingleArray:
        """The share of the worth (W, L) that remains in a window."""
        if window == WHOLE:
            return np.ones_like(self.at_word)
        within, whole = (windowed(self.at_word, each) for each in (window, WHOLE))
        return np.asarray(((within + UNPLACED) / (whole + UNPLACED)) ** SHARE_POWER, np.float32)

    def of(self, window: Window) -> SingleArray:
        """The gain of each gesture with its stroke on each word (W, L), and this window."""
        place = PLACE * windowed(self.stroke[:, None], (min(1, window[0]), min(1, window[1])))
        return np.asarray(self.whole * self.share(window) + PRECISE * self.at_word + place, np.float32)

    def gains(self, window: Window = WHOLE) -> SingleArray:
        """The most that any gesture gains with its stroke on each word (W,), and this window."""
        return np.asarray(self.of(window).max(axis=1, initial=0.0), np.float32)


def windowed(values: SingleArray, window: Window) -> SingleArray:
    """The sums of the values (W, N) over a window about each word."""
    left, right = window
    padded = np.zeros((len(values) + left + right, values.shape[1]), values.dtype)
    padded[left : left + len(values)] = values
    return np.asarray(sum(padded[shift : shift + len(values)] for shift in range(left + right + 1)), np.float32)


def strokes(worth: Worth, price: float, times_s: Sequence[float], *, still: Collection[int] = ()) -> list[Stroke]:
    """The strokes, in order, such that the sum of their gains less the price is greatest, by dynamic programming; none
    falls on a word of `still`. `times_s` are the times of the words, in order."""
    if not len(worth.stroke):
        return []
    gains = {window: worth.gains(window) - price for window in WINDOWS}
    for each in gains.values():
        each[list(still)] = NEVER
    return _Search(gains, times_s).best()


@dataclass(frozen=True, slots=True)
class _Ending:
    """The best strokes of a beginning of the line: their total, the last one, and the ending before it."""

    total: float = 0.0
    stroke: Stroke | None = None
    before: "_Ending | None" = None

    def strokes(self) -> Iterator[Stroke]:
        """The strokes, the last first; in a long recording there are thousands."""
        ending: _Ending | None = self
        while ending is not None and ending.stroke is not None:
            yield ending.stroke
            ending = ending.before


_NOTHING = _Ending()


@dataclass(frozen=True, slots=True)
class _Search:
    """The gains (W,) by window, less the price, and the times of the words."""

    gains: dict[Window, SingleArray]
    times_s: Sequence[float]

    def best(self) -> list[Stroke]:
        """The strokes with the greatest total, in order."""
        gains = {window: values.tolist() for window, values in self.gains.items()}
        endings: list[dict[int, _Ending]] = []
        far: list[_Ending] = [_NOTHING]
        for word, time_s in enumerate(self.times_s):
            last = bisect_right(self.times_s, time_s - STROKES_APART_S + _SLACK_S)
            begun = tuple(self._begun(word, last, endings, far))
            own: dict[int, _Ending] = {}
            for right in range(NEAR + 1):
                made = (
                    _Ending(before.total + gains[left, right][word], Stroke(word, (left, right)), before)
                    for left, before in begun
                )
                own[right] = max(made, key=lambda each: each.total)
            endings.append(own)
            far.append(max(far[-1], own[NEAR], key=lambda each: each.total))
        return list(far[-1].strokes())[::-1]

    def _begun(
        self, word: int, last: int, endings: Sequence[dict[int, _Ending]], far: Sequence[_Ending]
    ) -> Iterator[tuple[int, _Ending]]:
        """What may go before a stroke on a word, with the left reach of its window; `last` is the number of words that
        are early enough."""
        yield NEAR, far[min(last, max(0, word - 2 * NEAR))]
        for earlier in range(max(0, word - 2 * NEAR), last):
            between = word - earlier - 1
            for right in range(NEAR + 1):
                left = min(NEAR, between - right)
                if left >= 0:
                    yield left, endings[earlier][right]
