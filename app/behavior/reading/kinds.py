"""The worth of every kind of head movement or face on every word: the reading, what authors' weights and offers add,
and chance, in log-odds. Shapes: W words, K kinds.

What the rules usually offer is in the reading's thresholds already; an offer adds what its support (`supports.py`)
exceeds the usual by, so that a rule of great weight or a function of high priority is heard.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import log

import numpy as np

from ...model import Channel, SingleArray, Term
from .choice_model import READING, log_odds_of, worth_of
from .decoding import stretch_level
from .families import FamilyBehavior
from .supports import Support

USUAL_SUPPORT = 1.2
"""What an offer of the shipped rules adds at most."""

FAINT = 0.05
"""Parts that are smaller are not told."""

AUTHORS = "authors' weights"


@dataclass(frozen=True, slots=True, eq=False)
class KindWorths:
    """The worths of the kinds of one channel: `read` by the reading alone, `added` by authors' weights, `chance`, and
    `likely` of all together as probabilities, all (W, K); `supports` by word and kind; the least of `likely` for which
    a kind is planned."""

    channel: Channel
    kinds: tuple[str, ...]
    read: SingleArray
    added: SingleArray
    chance: SingleArray
    supports: Mapping[tuple[int, str], Support]
    likely: SingleArray
    thresholds: Mapping[str, float]

    def margin(self, kind: str, first: int, last: int) -> float:
        """How far the kind is above its threshold over words `first` to `last`, in log-odds."""
        level = stretch_level(self.likely[first : last + 1])[self.kinds.index(kind)]
        threshold = self.thresholds[kind]
        return float(log_odds_of(np.array([level], np.float32))[0]) - log(threshold / (1 - threshold))

    def parts(self, kind: str, word: int) -> tuple[Term, ...]:
        """The named parts of the kind's worth on a word, the largest first."""
        place = self.kinds.index(kind)
        support = self.supports.get((word, kind))
        parts = [
            Term(f"{READING}: {kind}", round(float(self.read[word, place]), 2)),
            Term(AUTHORS, round(float(self.added[word, place]), 2)),
            Term("chance", round(float(self.chance[0, place]), 2)),
        ]
        if support is not None:
            parts.append(Term(f"rule {support.rule}, more than usual", round(surplus(support), 2)))
        heavy = (part for part in parts[1:] if abs(part.weight) >= FAINT)
        return tuple(sorted((parts[0], *heavy), key=lambda part: (-abs(part.weight), part.name)))


def kind_worths(
    channel: Channel,
    kinds: Sequence[str],
    parts: tuple[SingleArray, SingleArray, SingleArray],
    supports: Mapping[tuple[int, str], Support],
    thresholds: Mapping[str, float],
) -> KindWorths:
    """The worths of a channel, from the `parts` reading (probabilities), authors' weights and chance."""
    likely, added, chance = parts
    read = log_odds_of(likely)
    total = read + added + chance
    for (word, kind), support in supports.items():
        total[word, kinds.index(kind)] += surplus(support)
    return KindWorths(channel, tuple(kinds), read, added, chance, supports, worth_of(total), thresholds)


def kind_supports(
    supports: Iterable[Support], kinds: Mapping[str, Iterable[FamilyBehavior]]
) -> Mapping[tuple[int, str], Support]:
    """The strongest offer of each kind on each word, of those that exceed the usual."""
    by_name = {each.name: kind for kind, listed in kinds.items() for each in listed}
    best: dict[tuple[int, str], Support] = {}
    for support in supports:
        if support.name not in by_name or surplus(support) == 0:
            continue
        for word in range(support.function.first, support.function.last + 1):
            held = best.get((word, by_name[support.name]))
            if held is None or support.log_odds > held.log_odds:
                best[word, by_name[support.name]] = support
    return best


def surplus(support: Support) -> float:
    """What an offer adds to the worth of a kind."""
    return max(0.0, support.log_odds - USUAL_SUPPORT)
