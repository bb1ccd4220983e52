"""Which letters of a word spell which phones: many-to-many alignment learnt by expectation maximisation.

A graphone is a chunk of letters with the phones it spells, written "letters:phones" ("ph:F", "x:K_S", "e:"). A word
and its pronunciation can be cut into graphones in many ways; the probabilities of the graphones and of the cuts
explain each other (Bisani & Ney 2008, §3, with graphones of the sizes below and no context).
"""

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence

Entry = tuple[str, tuple[str, ...]]
"""A word and one pronunciation of it."""

SIZES = ((1, 1), (1, 0), (2, 1), (1, 2))
"""Letters and phones a graphone may have."""

ITERATIONS = 8


def learn_graphones(entries: Sequence[Entry], *, min_count: float) -> dict[str, float]:
    """Probability of each graphone that `entries` use at least `min_count` times (expected count)."""
    probabilities: Mapping[str, float] | None = None
    counts: dict[str, float] = {}
    for _ in range(ITERATIONS):
        counts = _expected_counts(entries, probabilities)
        total = sum(counts.values())
        probabilities = {graphone: count / total for graphone, count in counts.items()}
    kept = {graphone: count for graphone, count in counts.items() if count >= min_count}
    return {graphone: count / sum(kept.values()) for graphone, count in kept.items()}


def segment(entry: Entry, probabilities: Mapping[str, float]) -> tuple[str, ...] | None:
    """The likeliest cut of `entry` into graphones; None when the graphones cannot spell it."""
    best: dict[tuple[int, int], tuple[float, tuple[str, ...]]] = {(0, 0): (0.0, ())}
    for start, end, graphone in _cuts(entry):
        probability = probabilities.get(graphone, 0.0)
        if start not in best or not probability:
            continue
        score, path = best[start]
        score += math.log(probability)
        if end not in best or score > best[end][0]:
            best[end] = (score, (*path, graphone))
    word, phones = entry
    return best.get((len(word), len(phones)), (0.0, None))[1]


def _expected_counts(entries: Iterable[Entry], probabilities: Mapping[str, float] | None) -> dict[str, float]:
    """How often each graphone is used; without `probabilities` every graphone is as likely as any other."""
    counts: dict[str, float] = defaultdict(float)
    for entry in entries:
        cuts = [
            (start, end, graphone, 1.0 if probabilities is None else probabilities.get(graphone, 0.0))
            for start, end, graphone in _cuts(entry)
        ]
        forward: dict[tuple[int, int], float] = defaultdict(float, {(0, 0): 1.0})
        for start, end, _, probability in cuts:
            forward[end] += forward[start] * probability
        goal = (len(entry[0]), len(entry[1]))
        if not forward[goal]:
            continue
        backward: dict[tuple[int, int], float] = defaultdict(float, {goal: 1.0 / forward[goal]})
        for start, end, graphone, probability in reversed(cuts):
            share = probability * backward[end]
            backward[start] += share
            counts[graphone] += share * forward[start]
    return counts


def _cuts(entry: Entry) -> Iterable[tuple[tuple[int, int], tuple[int, int], str]]:
    """Every graphone at every place of `entry` with the positions before and after it, in an order in which
    a position is reached only by cuts that come earlier than those that leave it."""
    word, phones = entry
    for letter in range(len(word)):
        for phone in range(len(phones) + 1):
            for letters, sounds in SIZES:
                end = (letter + letters, phone + sounds)
                if end[0] <= len(word) and end[1] <= len(phones):
                    yield (letter, phone), end, f"{word[letter : end[0]]}:{'_'.join(phones[phone : end[1]])}"
