"""Cuts a long line into passages, which the rules read one by one: many rules compare words with words, so what they do
with a whole line would grow with the square of its length, or worse.

A passage is as many whole sentences as have `LONGEST_PASSAGE` words together; a line that has no more is one passage.
So nothing changes for a line of a minute. In a longer one rules do not see from one passage into the next: a noun that
was last named a minute ago is new again.
"""

from bisect import bisect_right
from collections.abc import Iterable, Sequence

from .chaining.chainer import Fact
from .chaining.facts import LONGEST_SENTENCE

LONGEST_PASSAGE = LONGEST_SENTENCE
"""Words: a minute of speech; no sentence is longer."""

_OF_THE_LINE = "utterance"
"""What is said of the line is known in every passage, like all that has no place."""


def passage_starts(facts: Iterable[Fact]) -> list[int]:
    """The boundaries at which the passages begin whose sentences are among `facts`; the first is 0."""
    sentences = sorted(fact.arguments for fact in facts if fact.predicate == "sentence")
    starts = [0]
    for begin, end in sentences:
        assert isinstance(begin, int)
        assert isinstance(end, int)
        if end - starts[-1] > LONGEST_PASSAGE:
            starts.append(begin)
    return starts


def by_passage(starts: Sequence[int], facts: Iterable[Fact]) -> list[list[Fact]]:
    """The facts of each passage: those that begin in it, what is at its end, and all that have no place. Whole numbers
    among the arguments are places: boundaries between words."""
    parts: list[list[Fact]] = [[] for _ in starts]
    for fact in facts:
        places = {place for place in fact.arguments if isinstance(place, int)}
        if not places or fact.predicate == _OF_THE_LINE:
            for part in parts:
                part.append(fact)
            continue
        begin = min(places)
        number = max(bisect_right(starts, begin) - 1, 0)
        parts[number].append(fact)
        if len(places) == 1 and number and starts[number] == begin:
            parts[number - 1].append(fact)
    return parts
