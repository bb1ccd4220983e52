"""Decides which moments are taken: the strokes with the highest total gain, and the head movements and faces of
stretches.

Worths are expected values in [0, 1] of shape (W, N): what a director would give for a gesture with its stroke on a
word, N being families or lexemes. Strokes are spaced in seconds, so that slow talk is not starved and quick talk not
crowded.
"""

from bisect import bisect_right
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...model import SingleArray

USUAL_WORD_S = 0.3
"""Seconds a word, with the pauses, where nothing was heard."""

STROKES_APART_S = 1.0
"""The least time from one stroke to the next: the hand has to come, show something and be seen."""

NEAR = 2
"""Words around a director's stroke within which a stroke still belongs to the same idea."""

PLACE = 0.3
"""The gain of a stroke where directors have any stroke, whatever its meaning, in addition to its worth."""

PRECISE = 0.15
"""The additional gain of a stroke on the very word, not only near it."""

MOST_KINDS = 2
"""The most head movements, or faces, in one stretch."""

DONE_ONCE = frozenset(("nod", "shake", "toss"))
"""The head movements that are over when they are made; the others, and all faces, are held."""

MOST_HELD = 16
"""The most words over which one is held: some five seconds."""

MOUTH = frozenset(("smile", "sad", "lips_pressed", "disgust"))
"""The kinds of face made with the mouth; the others are made with brows and lids."""

_SLACK_S = 1e-6
_SENTENCE_ENDS = ".!?…"

_CONTRARY = (
    frozenset(("nod", "shake")),
    frozenset(("smile", "frown")),
    frozenset(("smile", "sad")),
    frozenset(("smile", "disgust")),
    frozenset(("brows_up", "frown")),
    frozenset(("wide_eyes", "squint")),
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


def gains(worth: SingleArray, at_word: SingleArray, stroke: SingleArray) -> SingleArray:
    """The gain of each of N on each word, before its price: its worth (W, N), more if it is wanted on the very word (W,
    N), and more where any stroke (W,) is likely."""
    return np.asarray(worth + PRECISE * at_word + PLACE * spread(stroke[:, None], 1), np.float32)


def strokes(gain: SingleArray, price: float, times_s: Sequence[float], *, still: Collection[int] = ()) -> list[int]:
    """The words on which strokes fall, in order, such that the sum of their gains (W, N) minus the price is greatest.

    `times_s` are the times of the words, in order. No stroke falls on a word of `still`.
    """
    best = gain.max(axis=1) - price if len(gain) else np.zeros(0, np.float32)
    return _best_apart([float(value) if word not in still else -1.0 for word, value in enumerate(best)], times_s)


def usual_times_s(count: int) -> list[float]:
    """The times of words of which none was heard."""
    return [word * USUAL_WORD_S for word in range(count)]


def spread(values: SingleArray, near: int = NEAR) -> SingleArray:
    """The sums of the values (W, N) within `near` words of each word."""
    padded = np.zeros((len(values) + 2 * near, values.shape[1]), values.dtype)
    padded[near : near + len(values)] = values
    windows = [padded[shift : shift + len(values)] for shift in range(2 * near + 1)]
    return np.asarray(np.sum(windows, axis=0), np.float32)


def spans_of(
    kinds: Sequence[str], likely: SingleArray, stretches: Sequence[tuple[int, int]], thresholds: Mapping[str, float]
) -> Iterator[Span]:
    """The kinds (W, K) that pass their thresholds in each stretch, the clearest first, without contrary pairs.

    Two in one stretch follow each other in the order of their likeliest words, except that a mouth and brows go
    together.
    """
    for first, last in stretches:
        part = likely[first : last + 1]
        level = stretch_level(part).tolist()
        clear = sorted(range(len(kinds)), key=lambda place: -level[place] / thresholds[kinds[place]])
        taken: list[int] = []
        for place in clear:
            passes = level[place] >= thresholds[kinds[place]]
            if passes and len(taken) < MOST_KINDS and not any(_contrary(kinds[place], kinds[each]) for each in taken):
                taken.append(place)
        yield from _one_after_another([(kinds[each], part[:, each]) for each in taken], first, last)


def held(spans: Iterable[Span], ending: Collection[int]) -> Iterator[Span]:
    """The spans in order, those joined that follow each other with the same kind of movement or face within a sentence:
    a head that is tilted over one phrase of a question stays tilted over the next. `ending` are the words that end
    sentences; the stroke of a joined span is that of its first part."""
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
    follows = span.first == before.last + 1 and before.last not in ending
    return follows and span.kind not in DONE_ONCE and span.last - before.first < MOST_HELD


def stretch_level(likely: SingleArray) -> SingleArray:
    """The probability of each kind over a stretch (W, K): halfway between the mean and the maximum of its words."""
    return np.asarray(0.5 * (likely.mean(axis=0) + likely.max(axis=0)), np.float32)


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


def _contrary(one: str, other: str) -> bool:
    return frozenset((one, other)) in _CONTRARY


def _one_after_another(taken: Sequence[tuple[str, SingleArray]], first: int, last: int) -> Iterator[Span]:
    together = sum(kind in MOUTH for kind, _ in taken) == 1
    if len(taken) == MOST_KINDS and together:
        parts = [(first, last)] * MOST_KINDS
    elif len(taken) == MOST_KINDS and last > first:
        taken = sorted(taken, key=lambda each: int(each[1].argmax()))
        middle = first + (last - first + 1) // 2
        parts = [(first, middle - 1), (middle, last)]
    else:
        parts = [(first, last)] * min(len(taken), 1)
    for (kind, likely), (begin, end) in zip(taken, parts, strict=False):
        stroke = begin + int(likely[begin - first : end - first + 1].argmax())
        yield Span(kind, begin, end, float(likely.max()), stroke)


def _best_apart(values: Sequence[float], times_s: Sequence[float]) -> list[int]:
    """The places with the greatest sum of values that are at least `STROKES_APART_S` apart, by dynamic programming."""
    best = [0.0]
    before = [bisect_right(times_s, time_s - STROKES_APART_S + _SLACK_S) for time_s in times_s]
    taken: list[bool] = []
    for place, value in enumerate(values):
        with_it = best[before[place]] + value
        taken.append(value > 0 and with_it > best[-1])
        best.append(with_it if taken[-1] else best[-1])
    places: list[int] = []
    place = len(values)
    while place > 0:
        if taken[place - 1]:
            places.append(place - 1)
            place = before[place - 1]
        else:
            place -= 1
    return places[::-1]
