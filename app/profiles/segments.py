"""Segments of speech, in which gestures join to units (NGS §3.3): stretches of words without a long pause.

The paper segments by hand, into utterances. A pause of `PAUSE_S` parts ours: sentences that follow each other sooner
are one utterance. Times are seconds.
"""

from collections.abc import Sequence
from itertools import pairwise

from ..model import Interval, Word

PAUSE_S = 0.6


def segments_of(words: Sequence[Word]) -> tuple[tuple[int, int], ...]:
    """The first and last word of each segment, of words that have times."""
    timed = [word for word in words if word.interval is not None]
    breaks = [place for place, (word, following) in enumerate(pairwise(timed), start=1) if _parted(word, following)]
    starts, ends = [0, *breaks], [*breaks, len(timed)]
    return tuple((timed[start].index, timed[end - 1].index) for start, end in zip(starts, ends, strict=True) if timed)


def time_of(word: Word) -> Interval:
    """The interval of a word that has one."""
    assert word.interval is not None, "only timed words are asked"
    return word.interval


def _parted(word: Word, following: Word) -> bool:
    return time_of(following).start_s - time_of(word).end_s >= PAUSE_S
