"""Divides a long line into passages, to which rules are applied one by one: many rules compare words with words, so the
cost for a whole line would grow with the square of its length, or worse.

A passage is as many whole sentences as have at most `LONGEST_PASSAGE` words together, so a line of up to a minute is
one passage and unaffected. In longer lines, rules do not see from one passage into the next: a noun last mentioned a
minute ago counts as new.
"""

from bisect import bisect_right
from collections.abc import Iterable, Sequence

from ..model import Fact
from .chaining.facts import LONGEST_SENTENCE

LONGEST_PASSAGE = LONGEST_SENTENCE
"""Words, about a minute of speech; no sentence is longer."""

_OF_THE_LINE = "utterance"
"""The predicate for the whole line, which is included in every passage, as are facts without a position."""


def passage_starts(facts: Iterable[Fact]) -> list[int]:
    """The boundaries at which the passages begin, given the sentences among `facts`; the first is 0."""
    sentences = sorted(fact.arguments for fact in facts if fact.predicate == "sentence")
    starts = [0]
    for begin, end in sentences:
        assert isinstance(begin, int)
        assert isinstance(end, int)
        if end - starts[-1] > LONGEST_PASSAGE:
            starts.append(begin)
    return starts


def by_passage(starts: Sequence[int], facts: Iterable[Fact]) -> list[list[Fact]]:
    """The facts of each passage: those that begin in it, those at its end, and all without a position. Whole numbers
    among the arguments are positions: boundaries between words."""
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
