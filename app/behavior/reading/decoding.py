"""Decides which head movements and faces are made: those that are likely wanted over a stretch of the line.

Probabilities have the shape (W, K): how likely a director wants a kind of movement on a word. Which strokes are taken
is decided in `strokes.py`.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain, pairwise
from types import MappingProxyType

import numpy as np

from ...model import SingleArray
from .choice_model import log_odds_of, worth_of

MOST_KINDS = 2
"""The most head movements, or faces, in one stretch."""

TILTED_NOD = "tilted_nod"
BOTH_AT_ONCE: Mapping[str, tuple[str, str]] = MappingProxyType({TILTED_NOD: ("nod", "tilt")})
"""Head movements that are two kinds at once, in place of half a stretch of each: neither is in the other's way then
(docs/measurements/choice.md)."""

DONE_ONCE = frozenset(("nod", "shake", "toss", TILTED_NOD))
"""The head movements that are over when they are made; the others, and all faces, are held."""

MOST_HELD = 16
"""The most words over which one is held: some five seconds."""

ATTITUDES = frozenset(("smile", "frown", "sad", "disgust"))
"""Faces that tell how somebody feels: they outlast what they are shown for."""

LASTING = 0.3
"""An attitude lasts over the stretches beside its own while it is this likely there, as a share of its threshold.
Chosen on held-out lines (docs/measurements/choice.md)."""

MOOD = 0.3
"""How far an attitude over one stretch follows the whole line, in log-odds: one who smiles at the end of a line does so
more likely at its start. Chosen on held-out lines (docs/decisions/choice-experiments.md)."""

MOUTH = frozenset(("smile", "sad", "lips_pressed", "disgust"))
BROWS = frozenset(("brows_up", "frown", "squint", "wide_eyes"))
"""The kinds of face made with the mouth, and those made with brows and lids; a stretch has one of each at most."""

_SENTENCE_ENDS = ".!?…"

_CONTRARY = (
    frozenset(("nod", "shake")),
    frozenset(("smile", "frown")),
)
"""Kinds that a face does not show, or a head does not make, in the same stretch."""


@dataclass(frozen=True, slots=True)
class Span:
    """A kind of movement over words `first` to `last`, the probability that directors want it there, and the word
    `stroke` on which they most likely do."""

    kind: str
    first: int
    last: int
    likely: float
    stroke: int


def spans_of(
    kinds: Sequence[str],
    likely: SingleArray,
    stretches: Sequence[tuple[int, int]],
    thresholds: Mapping[str, float],
    *,
    asked: Collection[tuple[int, str]] = (),
) -> Iterator[Span]:
    """The kinds (W, K) that pass their thresholds in each stretch, the likeliest first, without contrary pairs.

    Two in one stretch follow each other in the order of their likeliest words, except that a mouth and brows go
    together, and that a head nods while it is tilted (`BOTH_AT_ONCE`). They share it by halves, unless a rule `asked`
    for one on a word of the other half. Attitudes last over the stretches beside their own.
    """
    least = np.array([thresholds[kind] for kind in kinds], np.float32)
    parts = [likely[first : last + 1] for first, last in stretches]
    levels = stretch_levels(kinds, likely, stretches) / least
    taken = _lasting(map(partial(_passing, kinds), levels, parts), kinds, levels)
    for (first, last), part, places in zip(stretches, parts, taken, strict=True):
        own = [(kinds[each], part[:, each]) for each in places]
        wanted = {kind for word, kind in asked if first <= word <= last}
        at_once = () if wanted.intersection(kind for kind, _ in own) else _at_once(own, first, last)
        yield from at_once or _one_after_another(own, first, last, asked)


def _passing(kinds: Sequence[str], level: SingleArray, likely: SingleArray) -> list[int]:
    """The places of the kinds that a stretch has, those with the likeliest word first; `level` are their probabilities
    over the stretch (K,) as multiples of their thresholds, `likely` those on its words (W, K)."""
    taken: list[int] = []
    for place in np.argsort(-likely.max(axis=0), kind="stable").tolist():
        if level[place] >= 1 and not any(_exclude(kinds[place], kinds[each]) for each in taken):
            taken.append(place)
    return taken[:MOST_KINDS]


def _lasting(passing: Iterable[list[int]], kinds: Sequence[str], levels: SingleArray) -> Sequence[Sequence[int]]:
    """The kinds of each stretch, with the attitudes that last from its neighbours and leave those it has; `levels` are
    multiples of thresholds (S, K)."""
    taken = list(passing)
    onwards = range(len(taken))
    for here, beside in chain(pairwise(onwards), pairwise(reversed(onwards))):
        for place in taken[here]:
            lasts = kinds[place] in ATTITUDES and levels[beside][place] >= LASTING
            others = taken[beside]
            if lasts and len(others) < MOST_KINDS and all(_together(kinds[place], kinds[each]) for each in others):
                taken[beside] = [*others, place]
    return taken


def held(spans: Iterable[Span], ending: Collection[int]) -> Iterator[Span]:
    """The spans in order, those joined that follow each other with the same kind of movement or face within a sentence:
    a head that is tilted over one phrase of a question stays tilted over the next. Attitudes are joined over the ends
    of sentences, which are the words `ending`; the stroke of a joined span is that of its first part."""
    going_on: dict[str, Span] = {}
    for span in sorted(spans, key=lambda each: (each.first, each.last, each.kind)):
        before = going_on.get(span.kind)
        if before and _goes_on(before, span, ending):
            likely = max(before.likely, span.likely)
            going_on[span.kind] = replace(before, last=span.last, likely=likely)
            continue
        if before:
            yield before
        going_on[span.kind] = span
    yield from going_on.values()


def _goes_on(before: Span, span: Span, ending: Collection[int]) -> bool:
    """Whether a span is the continuation of the one before it."""
    follows = span.first == before.last + 1 and (before.last not in ending or span.kind in ATTITUDES)
    return follows and span.kind not in DONE_ONCE and span.last - before.first < MOST_HELD


def stretch_levels(kinds: Sequence[str], likely: SingleArray, stretches: Sequence[tuple[int, int]]) -> SingleArray:
    """The probability of each kind over each stretch (S, K): halfway between the mean and the maximum of its words; of
    attitudes, part of the way from there to that of the whole line."""
    if not stretches:
        return np.empty((0, len(kinds)), np.float32)
    parts = [likely[first : last + 1] for first, last in stretches]
    levels = np.array([0.5 * (part.mean(axis=0) + part.max(axis=0)) for part in parts], np.float32)
    attitudes = [place for place, kind in enumerate(kinds) if kind in ATTITUDES]
    odds = log_odds_of(levels[:, attitudes])
    whole = np.average(odds, axis=0, weights=[len(part) for part in parts])
    levels[:, attitudes] = worth_of((1 - MOOD) * odds + MOOD * whole)
    return levels


def stretches_of(texts: Sequence[str]) -> list[tuple[int, int]]:
    """The stretches of a line over which head and face express one thing: the words between punctuation marks, joined
    to the next where they are under three, and halved where they are over eight."""
    stretches: list[tuple[int, int]] = []
    first = 0
    for word, text in enumerate(texts):
        mark = _mark(text)
        ends = word == len(texts) - 1 or mark in _SENTENCE_ENDS or (mark in ",;:—–-" and word - first >= 2)
        if not ends or not text:
            continue
        while word - first >= 8:
            middle = first + (word - first + 1) // 2
            stretches.append((first, middle - 1))
            first = middle
        stretches.append((first, word))
        first = word + 1
    return stretches


def sentence_ends(texts: Sequence[str]) -> frozenset[int]:
    """The words that end sentences, by their marks."""
    return frozenset(word for word, text in enumerate(texts) if text and _mark(text) in _SENTENCE_ENDS)


def _mark(text: str) -> str:
    """The last character of a word as written, without closing quotes and brackets."""
    return text.rstrip("'\"”’)")[-1:]


def _exclude(one: str, other: str) -> bool:
    """Whether a stretch has no more than one of two kinds."""
    return frozenset((one, other)) in _CONTRARY or any({one, other} <= part for part in (MOUTH, BROWS))


def _together(one: str, other: str) -> bool:
    """Whether two kinds of face can be shown at the same time: one with the mouth, one with brows and lids."""
    return one in MOUTH | BROWS and not _exclude(one, other)


def _at_once(taken: Sequence[tuple[str, SingleArray]], first: int, last: int) -> list[Span]:
    """The movement that is both of the kinds of a stretch, if there is one; its stroke is that of its first kind."""
    likely = dict(taken)
    return [
        Span(
            kind, first, last, max(float(likely[part].max()) for part in parts), first + int(likely[parts[0]].argmax())
        )
        for kind, parts in BOTH_AT_ONCE.items()
        if likely.keys() == set(parts)
    ]


def _one_after_another(
    taken: Sequence[tuple[str, SingleArray]], first: int, last: int, asked: Collection[tuple[int, str]]
) -> Iterator[Span]:
    if len(taken) == MOST_KINDS and _together(taken[0][0], taken[1][0]):
        parts = [(first, last)] * MOST_KINDS
    elif len(taken) == MOST_KINDS and last > first:
        taken = sorted(taken, key=lambda each: int(each[1].argmax()))
        middle = _middle(taken, first, last, asked)
        parts = [(first, middle - 1), (middle, last)]
    else:
        parts = [(first, last)] * min(len(taken), 1)
    for (kind, likely), (begin, end) in zip(taken, parts, strict=False):
        stroke = begin + int(likely[begin - first : end - first + 1].argmax())
        yield Span(kind, begin, end, float(likely.max()), stroke)


def _middle(taken: Sequence[tuple[str, SingleArray]], first: int, last: int, asked: Collection[tuple[int, str]]) -> int:
    """The word on which the second of two kinds begins: half way, or where the likeliest word of each that a rule asked
    for there is its own."""
    middle = first + (last - first + 1) // 2
    before, after = (first + int(likely.argmax()) for _kind, likely in taken)
    if (after, taken[1][0]) in asked:
        middle = min(middle, after)
    if (before, taken[0][0]) in asked:
        middle = max(middle, before + 1)
    return min(max(middle, first + 1), last)
