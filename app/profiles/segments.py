"""Segments of speech, within which gestures are joined to units (NGS §3.3): sequences of words without a long pause.

The paper segments utterances manually. Our segments are separated by pauses of at least `PAUSE_S`; sentences with a
shorter pause between them are one segment. Times are seconds.
"""

from collections.abc import Sequence
from itertools import pairwise

from ..model import Interval, Word

PAUSE_S = 0.6
LONGEST_PAUSE_S = 2.0
"""The part of a pause that counts as speech at most; the rest is silence without gestures."""


SHORTEST_RETRACTION_S, SHORTEST_PREPARATION_S, AFTER_STROKE_S = 0.4, 0.35, 0.1
"""The minimum durations of the movements to and from rest (`understudy.realizer.scheduling.rests`), and of the hold
after a stroke before them."""
SHORTEST_REST_S = AFTER_STROKE_S + SHORTEST_RETRACTION_S + SHORTEST_PREPARATION_S
"""Gestures with less time between them are one unit, since there is no time for a rest."""


def segments_of(words: Sequence[Word]) -> tuple[tuple[int, int], ...]:
    """The first and last word of each segment of the timed words."""
    timed = [word for word in words if word.interval is not None]
    breaks = [place for place, (word, following) in enumerate(pairwise(timed), start=1) if _parted(word, following)]
    starts, ends = [0, *breaks], [*breaks, len(timed)]
    return tuple((timed[start].index, timed[end - 1].index) for start, end in zip(starts, ends, strict=True) if timed)


def spoken_s(words: Sequence[Word], segments: Sequence[tuple[int, int]]) -> float:
    """The duration of speech in segments of words, including the counted parts of the pauses between them."""
    by_index = {word.index: word for word in words}
    spans = [(time_of(by_index[first]).start_s, time_of(by_index[last]).end_s) for first, last in segments]
    pauses_s = sum(min(LONGEST_PAUSE_S, other[0] - one[1]) for one, other in pairwise(spans))
    return sum(end_s - start_s for start_s, end_s in spans) + pauses_s


def time_of(word: Word) -> Interval:
    """The interval of a timed word."""
    assert word.interval is not None, "only timed words are asked"
    return word.interval


def _parted(word: Word, following: Word) -> bool:
    return time_of(following).start_s - time_of(word).end_s >= PAUSE_S
