"""Describes a line's delivery for a realizer: the phrases between its pauses, and the times of stress.

Phrases stand for intonation units, in which gestures flow into each other (Kipp, Neff et al. 2007, §3.3, take a
segmentation of the utterance): they end at a pause or the end of a sentence. Times are seconds of the words' intervals.

Where a text says which words are its rheme, gestures repeat their strokes on the emphases of the rheme (Gesture Engine
§5.1).
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from ...model import Behavior, Channel, Function, Interval, Word
from ..timing.anchoring import stressed_vowel_s

SHORTEST_PAUSE_S = 0.2

SHORTEST_STROKE_S = 0.35
"""Between the ends of two strokes (`realizer/scheduling/repetition.py`)."""

_SENTENCE_ENDS = (".", "!", "?", ";", ":")
_CLOSERS = "\"'”’)]"


def phrases(words: tuple[Word, ...]) -> tuple[Interval, ...]:
    """The intervals of speech; words without times are in none."""
    return tuple(_phrases([word for word in words if word.interval]))


def emphases_s(words: tuple[Word, ...]) -> tuple[float, ...]:
    """The times at which the stressed vowels of the emphasised words begin."""
    return tuple(sorted(stressed_vowel_s(word) for word in words if word.interval and word.is_emphasised))


def expanded_in_rhemes(
    behaviors: Iterable[Behavior], words: tuple[Word, ...], functions: Sequence[Function]
) -> tuple[Behavior, ...]:
    """The behaviours, where those gestures whose stroke is in a rheme ask for further strokes on all of its later
    emphases: "If multiple intonational emphases are present within a rheme clause for which an appropriate gesture has
    been found […], that gesture's stroke will be repeated" (Gesture Engine §5.1)."""
    rhemes = [range(each.first, each.last + 1) for each in functions if each.given and _is_rheme(each)]
    if not rhemes:
        return tuple(behaviors)
    return tuple(_expanded(each, words, rhemes) for each in behaviors)


def _is_rheme(function: Function) -> bool:
    return (function.class_name, function.subtype) == ("information", "rheme")


def _expanded(behavior: Behavior, words: tuple[Word, ...], rhemes: Sequence[range]) -> Behavior:
    stroke_end_s = behavior.sync.stroke_end
    if behavior.kind is not Channel.GESTURE or stroke_end_s is None or behavior.after_strokes_s is not None:
        return behavior
    rheme = next((each for each in rhemes if behavior.first in each or behavior.last in each), None)
    if rheme is None:
        return behavior
    later = (time_s - stroke_end_s for time_s in emphases_s(tuple(word for word in words if word.index in rheme)))
    after_s = tuple(round(each, 3) for each in later if each >= SHORTEST_STROKE_S)
    return replace(behavior, after_strokes_s=after_s) if after_s else behavior


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
