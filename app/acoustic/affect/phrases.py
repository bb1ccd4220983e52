"""The phrases of a line: the words between pauses, each of which may sound different.

Short phrases join the next: what is heard in less than half a second says little about a feeling.
"""

from collections.abc import Iterator
from itertools import pairwise

from ...model import Interval, Word

SHORTEST_PAUSE_S = 0.25
SHORTEST_PHRASE_S = 0.6


def phrases_of(words: tuple[Word, ...]) -> tuple[tuple[int, int], ...]:
    """First and last word of each phrase, in order; none if no word has a time. A word that is not spoken belongs to
    the phrase before it."""
    starts = list(_starts(words))
    return tuple(zip(starts, [*(start - 1 for start in starts[1:]), len(words) - 1], strict=True)) if starts else ()


def phrase_interval(words: tuple[Word, ...], first: int, last: int) -> Interval:
    """From the start of its first word to the end of its last; at least one of them has a time."""
    timed = [word.interval for word in words[first : last + 1] if word.interval]
    return Interval(timed[0].start_s, timed[-1].end_s)


def _starts(words: tuple[Word, ...]) -> Iterator[int]:
    """The first word of each phrase; the first phrase has the words before it too."""
    timed = [(word.index, word.interval) for word in words if word.interval]
    if not timed:
        return
    yield 0
    begun_s, end_s = timed[0][1].start_s, timed[-1][1].end_s
    for (_, before), (index, after) in pairwise(timed):
        long_enough = before.end_s - begun_s >= SHORTEST_PHRASE_S and end_s - after.start_s >= SHORTEST_PHRASE_S
        if after.start_s - before.end_s >= SHORTEST_PAUSE_S and long_enough:
            begun_s = after.start_s
            yield index
