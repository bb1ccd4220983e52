"""Phrases that answer one another: "ask not what your country can do for you, ask what you can do for your country".

Two neighbouring phrases with most of their words in common are one idea in two parts. Where both name the same two
things in the other order, each thing has a side, and all four mentions are placed; where they differ in one place, what
differs is placed left and right if the reading finds a contrast there too: much that is said twice is no contrast but
insistence or a list.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from ...model import Parse, SingleArray, Token, Utterance
from .contrasts import LEAST_WORTH, LEFT, RIGHT, Ground, PlacedStroke
from .decoding import NEAR

PARALLEL = 3.0
"""The log-odds of a place in parallel phrases."""

LEAST_SHARED = 4
"""The fewest words that two parallel phrases have in common."""

LEAST_OVERLAP = 0.5
"""The least share of their words that is common to both."""

_ENDS = (",", ";", ":", ".", "!", "?", "—", "–")
_THINGS = frozenset({"NOUN", "PROPN", "PRON"})
_CONTENT = frozenset({"NOUN", "PROPN", "VERB", "ADJ", "ADV", "NUM"})


@dataclass(frozen=True, slots=True)
class _Phrase:
    """The tokens of one phrase between marks."""

    tokens: tuple[Token, ...]

    @property
    def lemmas(self) -> frozenset[str]:
        return frozenset(token.lemma.lower() for token in self.tokens if token.part_of_speech != "PUNCT")

    def things(self) -> dict[str, int]:
        """The word on which each thing is named last, by its lemma; not whose it is, and not what is asked for."""
        return {
            token.lemma.lower(): token.word
            for token in self.tokens
            if token.part_of_speech in _THINGS and "poss" not in token.dependency and not token.tag.startswith("W")
        }


def parallel_strokes(utterance: Utterance, ground: Ground, contrast: SingleArray) -> Iterator[PlacedStroke]:
    """The strokes of parallel phrases, each side where it belongs; none that would be too close in time. `contrast`
    (W,) is the worth of a contrast on each word."""
    taken: list[int] = []
    for one, other in pairwise(_phrases(utterance.parse, [word.text for word in utterance.words])):
        shared = one.lemmas & other.lemmas
        if len(shared) < LEAST_SHARED or len(shared) < LEAST_OVERLAP * len(one.lemmas | other.lemmas):
            continue
        for stroke in (*_crossed(one, other),) or (*_differing(one, other, contrast),):
            if stroke.word not in ground.still and all(ground.apart(stroke.word, word) for word in taken):
                taken.append(stroke.word)
                yield stroke


def _phrases(parse: Parse, texts: Sequence[str]) -> Iterator[_Phrase]:
    first = 0
    for word, text in enumerate(texts):
        if text.rstrip("\"'”’)").endswith(_ENDS) or word == len(texts) - 1:
            yield _Phrase(tuple(token for token in parse.tokens if first <= token.word <= word))
            first = word + 1


def _crossed(one: _Phrase, other: _Phrase) -> Iterator[PlacedStroke]:
    """Two things that both name, in the other order: four places."""
    before, after = one.things(), other.things()
    both = sorted((lemma for lemma in before if lemma in after), key=lambda lemma: before[lemma])
    for left, right in pairwise(both):
        if after[left] > after[right]:
            yield PlacedStroke(before[left], LEFT, before[right], PARALLEL)
            yield PlacedStroke(before[right], RIGHT, before[left], PARALLEL)
            yield PlacedStroke(after[right], RIGHT, after[left], PARALLEL)
            yield PlacedStroke(after[left], LEFT, after[right], PARALLEL)
            return


def _differing(one: _Phrase, other: _Phrase, contrast: SingleArray) -> Iterator[PlacedStroke]:
    """What the first has in the place of what the second has, if either is read as one side of a contrast."""
    left, right = _own(one, other), _own(other, one)
    if left is None or right is None:
        return
    if max(contrast[max(0, word - NEAR) : word + NEAR + 1].max() for word in (left, right)) >= LEAST_WORTH:
        yield PlacedStroke(left, LEFT, right, PARALLEL)
        yield PlacedStroke(right, RIGHT, left, PARALLEL)


def _own(phrase: _Phrase, other: _Phrase) -> int | None:
    """The last word with content that the other phrase does not have."""
    own = [
        token.word
        for token in phrase.tokens
        if token.part_of_speech in _CONTENT and token.lemma.lower() not in other.lemmas
    ]
    return own[-1] if own else None
