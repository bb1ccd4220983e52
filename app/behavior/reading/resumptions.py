"""Things that are pointed at again: "See that tower? The king was born in that tower."

What was shown at a place is there until something else is (McNeill 1992). Where a demonstrative phrase names a thing
that a planned stroke points at, the hand goes back to it, even if the reading alone would not have a gesture there: the
words rely on the listener's having seen the place.
"""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

from ...model import Term, Token
from .families import POINT
from .parallels import Ground
from .strokes import NEAR
from .worths import LineWorths, Place

RESUMED = 6.0
"""What pointing gains, in log-odds, on a thing that was pointed at before: with it no other meaning wins there."""

_DEMONSTRATIVES = frozenset({"this", "that", "these", "those"})
_NOUNS = frozenset({"NOUN", "PROPN"})


@dataclass(frozen=True, slots=True)
class ResumedStroke:
    """A stroke on `word`, which names what the stroke on word `before` points at; it takes the place of one on word
    `instead`, if any, which would point at it beside its name."""

    word: int
    before: int
    instead: int | None = None


def with_resumed(
    worths: LineWorths, taken: Collection[int], tokens: Sequence[Token], ground: Ground
) -> tuple[LineWorths, list[int]]:
    """The worths with what is pointed at again, and the words `taken` for strokes with these."""
    pointing = worths.shown[:, worths.choice.families.index(POINT)] == 1
    pointed = [word for word in taken if pointing[int(worths.log_odds[word].argmax())]]
    resumed = list(resumed_strokes(tokens, pointed, taken, ground))
    if not resumed:
        return worths, list(taken)
    total, parts = worths.log_odds.copy(), dict[Place, Term]()
    for stroke in resumed:
        total[stroke.word, pointing] += RESUMED
        part = Term(f"pointed at on word {stroke.before}", RESUMED)
        parts |= {(stroke.word, int(column)): part for column in pointing.nonzero()[0]}
    words = {*taken, *(stroke.word for stroke in resumed)} - {stroke.instead for stroke in resumed}
    return replace(worths, log_odds=total, resumed=parts), sorted(words)


def resumed_strokes(
    tokens: Sequence[Token], pointed: Collection[int], taken: Collection[int], ground: Ground
) -> Iterator[ResumedStroke]:
    """The strokes on things at which strokes on the words `pointed` point, far enough from all others that are
    `taken`."""
    words = list(taken)
    for demonstrative, noun in _pointed_out(tokens):
        before = max((word for word in pointed if word < noun.word - NEAR and _names(tokens, noun, word)), default=None)
        if before is None:
            continue
        again = max((word for word in pointed if abs(word - noun.word) <= NEAR), default=None)
        if again is not None and demonstrative.word <= again <= noun.word:
            yield ResumedStroke(again, before)
        elif noun.word not in ground.still and all(ground.apart(noun.word, word) for word in words if word != again):
            words.append(noun.word)
            yield ResumedStroke(noun.word, before, instead=again)


def _pointed_out(tokens: Sequence[Token]) -> Iterator[tuple[Token, Token]]:
    """The nouns with their demonstratives."""
    for each in tokens:
        noun = tokens[each.head]
        if each.part_of_speech == "DET" and each.lemma.lower() in _DEMONSTRATIVES and noun.part_of_speech in _NOUNS:
            yield each, noun


def _names(tokens: Sequence[Token], thing: Token, word: int) -> bool:
    """Whether the same thing is named about a word, before it is named again."""
    return any(
        each.lemma == thing.lemma and each.word < thing.word and abs(each.word - word) <= NEAR
        for each in tokens
        if each.part_of_speech in _NOUNS
    )
