"""Parallel phrases: "ask not what your country can do for you, ask what you can do for your country".

Two neighbouring phrases with most of their words in common are one idea in two parts. Where both name the same two
things in the other order, each thing has a side, and all four mentions are placed; where they differ in one place, what
differs is placed left and right if the reading finds a contrast there too: much that is said twice is no contrast but
insistence or a list.

Gives the two sides of a contrast a stroke each, one to the left and one to the right; both are shown or neither (paper
§3.4).

Rules find the places (functions of class `locus`, left and right by order of mention). Where the plan would show one
side of such a pair as a contrast, the other side is shown too, each with a stroke of its own to its own side. Strokes
that are too close to either are dropped.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from typing import TypeAlias

from ...model import Function, Parse, SingleArray, Token, Utterance
from .strokes import NEAR, STROKES_APART_S

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
        """The last mention of each thing, by its lemma. Possessors and question words are left out."""
        return {
            token.lemma.lower(): token.word
            for token in self.tokens
            if token.part_of_speech in _THINGS and "poss" not in token.dependency and not token.tag.startswith("W")
        }


@dataclass(frozen=True, slots=True)
class PlacedStroke:
    """A stroke on `word` that shows one side of a contrast, `side`; its counterpart lies on word `other`. `log_odds` is
    its own, of parallel phrases; None for those of the reading."""

    word: int
    side: str
    other: int
    log_odds: float | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """Where strokes can fall: the `times_s` of the words, the highest gain of any gesture on each (W,), and the words
    that must stay `still`."""

    times_s: Sequence[float]
    gain: SingleArray
    still: Sequence[int] = ()

    def apart(self, one: int, other: int) -> bool:
        """Whether strokes on these words are far enough apart."""
        return abs(self.times_s[one] - self.times_s[other]) >= STROKES_APART_S


def parallel_strokes(utterance: Utterance, ground: Ground, contrast: SingleArray) -> Iterator[PlacedStroke]:
    """The strokes of parallel phrases, each on its side, without those that would be too close in time. `contrast` (W,)
    is the worth of a contrast on each word."""
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
    """Two things that both phrases name, in opposite order: four places."""
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
    """The words in which the two phrases differ, if either is read as one side of a contrast."""
    left, right = _own(one, other), _own(other, one)
    if left is None or right is None:
        return
    if max(contrast[max(0, word - NEAR) : word + NEAR + 1].max() for word in (left, right)) >= LEAST_WORTH:
        yield PlacedStroke(left, LEFT, right, PARALLEL)
        yield PlacedStroke(right, RIGHT, left, PARALLEL)


def _own(phrase: _Phrase, other: _Phrase) -> int | None:
    """The last content word that the other phrase lacks."""
    own = [
        token.word
        for token in phrase.tokens
        if token.part_of_speech in _CONTENT and token.lemma.lower() not in other.lemmas
    ]
    return own[-1] if own else None


Locus: TypeAlias = tuple[int, int, str]
"""First word, last word, and side of what is assigned a place in gesture space."""

LOCUS, LEFT, RIGHT = "locus", "left", "right"
CONTRAST = "contrast_sides"

LEAST_WORTH = 0.17
"""Both sides are shown if a contrast is worth at least this on one of them."""


def placed_strokes(functions: Iterable[Function], worth: SingleArray, ground: Ground) -> Iterator[PlacedStroke]:
    """The strokes of each pair of places that is worth showing.

    `worth` (W,) is that of a contrast. Pairs whose strokes would be too close in time are left to a single gesture that
    shows both places.
    """
    loci = sorted(
        {(each.first, each.last, each.subtype) for each in functions if each.class_name == LOCUS and each.kept}
    )
    sides = [locus for locus in loci if locus[2] in (LEFT, RIGHT)]
    free_from = 0
    for one, other in pairwise(sides):
        if one[2] == other[2] or one[0] < free_from:
            continue
        words = _strokes_of(one, other, ground)
        if words is not None and max(worth[word] for word in words) >= LEAST_WORTH:
            yield PlacedStroke(words[0], one[2], words[1])
            yield PlacedStroke(words[1], other[2], words[0])
            free_from = other[0] + 1


def with_placed(taken: Iterable[int], placed: Iterable[PlacedStroke], ground: Ground) -> list[int]:
    """The strokes of a line in order: the placed ones, and those of `taken` that are not too close to them."""
    words = {each.word for each in placed}
    return sorted(words | {each for each in taken if all(ground.apart(each, word) for word in words)})


def _strokes_of(one: Locus, other: Locus, ground: Ground) -> tuple[int, int] | None:
    """The words of the two sides, far enough apart, on which strokes gain most: within the mentions, or within `NEAR`
    words after them."""
    firsts = range(one[0], min(one[1] + NEAR, other[0] - 1) + 1)
    seconds = range(other[0], min(other[1] + NEAR, len(ground.gain) - 1) + 1)
    pairs = [pair for pair in product(firsts, seconds) if ground.apart(*pair) and not {*pair} & {*ground.still}]
    return max(pairs, key=lambda pair: float(ground.gain[pair[0]] + ground.gain[pair[1]]), default=None)
