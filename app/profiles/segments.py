"""Segments of speech, in which gestures join to units (NGS §3.3): stretches of words without a long pause.

The paper segments by hand, into utterances. A pause of `PAUSE_S` parts ours: sentences that follow each other sooner
are one utterance. Times are seconds.
"""

from collections.abc import Sequence
from itertools import pairwise

from ..model import Interval, Word

PAUSE_S = 0.6
LONGEST_PAUSE_S = 2.0
"""What of a pause counts as speech; the rest is silence in which nobody gestures."""


SHORTEST_RETRACTION_S, SHORTEST_PREPARATION_S, AFTER_STROKE_S = 0.4, 0.35, 0.1
"""The least time in which hands go to rest and come from there (`understudy.realizer.scheduling.rests`), and how long a
stroke is held before."""
SHORTEST_REST_S = AFTER_STROKE_S + SHORTEST_RETRACTION_S + SHORTEST_PREPARATION_S
"""Gestures that are nearer are one unit, for there is no time to rest."""


def segments_of(words: Sequence[Word]) -> tuple[tuple[int, int], ...]:
    """The first and last word of each segment, of words that have times."""
    timed = [word for word in words if word.interval is not None]
    breaks = [place for place, (word, following) in enumerate(pairwise(timed), start=1) if _parted(word, following)]
    starts, ends = [0, *breaks], [*breaks, len(timed)]
    return tuple((timed[start].index, timed[end - 1].index) for start, end in zip(starts, ends, strict=True) if timed)


def spoken_s(words: Sequence[Word], segments: Sequence[tuple[int, int]]) -> float:
    """How long is spoken in segments of words, with the pauses between them, so far as these count."""
    by_index = {word.index: word for word in words}
    spans = [(time_of(by_index[first]).start_s, time_of(by_index[last]).end_s) for first, last in segments]
    pauses_s = sum(min(LONGEST_PAUSE_S, other[0] - one[1]) for one, other in pairwise(spans))
    return sum(end_s - start_s for start_s, end_s in spans) + pauses_s


def time_of(word: Word) -> Interval:
    """The interval of a word that has one."""
    assert word.interval is not None, "only timed words are asked"
    return word.interval


def _parted(word: Word, following: Word) -> bool:
    return time_of(following).start_s - time_of(word).end_s >= PAUSE_S
