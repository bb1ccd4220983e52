"""Describes a line's delivery for a realizer: the phrases between its pauses, and the times of stress.

Phrases stand for intonation units, in which gestures flow into each other (Kipp, Neff et al. 2007, §3.3, take a
segmentation of the utterance): they end at a pause or the end of a sentence. Times are seconds of the words' intervals.
"""

from collections.abc import Iterator
from itertools import pairwise

from ...model import Interval, Word
from ..timing.anchoring import stressed_vowel_s

SHORTEST_PAUSE_S = 0.2

_SENTENCE_ENDS = (".", "!", "?", ";", ":")
_CLOSERS = "\"'”’)]"


def phrases(words: tuple[Word, ...]) -> tuple[Interval, ...]:
    """The intervals of speech; words without times are in none."""
    return tuple(_phrases([word for word in words if word.interval]))


def emphases_s(words: tuple[Word, ...]) -> tuple[float, ...]:
    """The times at which the stressed vowels of the emphasised words begin."""
    return tuple(sorted(stressed_vowel_s(word) for word in words if word.interval and word.is_emphasised))


def _phrases(timed: list[Word]) -> Iterator[Interval]:
    first = 0
    for place, (word, following) in enumerate(pairwise(timed), start=1):
        if word.interval and following.interval and _parted(word, following.interval.start_s - word.interval.end_s):
            yield _whole(timed[first:place])
            first = place
    if timed:
        yield _whole(timed[first:])


def _whole(words: list[Word]) -> Interval:
    intervals = [word.interval for word in words if word.interval]
    return Interval(intervals[0].start_s, intervals[-1].end_s)


def _parted(word: Word, pause_s: float) -> bool:
    return pause_s >= SHORTEST_PAUSE_S or word.text.rstrip(_CLOSERS).endswith(_SENTENCE_ENDS)
