"""The worths, in log-odds, of every gesture, head movement and face on every word of a line: each is one sum of named
parts.

    log-odds(word, lexeme) = those of its families (reading, how common they are, terms) + a mapping rule's support
                             + the verb that a mime shows + the focus on the word + what was shown just before
                             + what was pointed at before + chance

So the reading, the paper's rules, the voice, the author and chance are heard at once, and each choice can name what
decided it. Shapes: W words, F families, L lexemes, K kinds.

A kind of head movement or face is worth what the reading, authors' weights, offers and chance add up to. What the rules
usually offer is in the reading's thresholds already; an offer adds what its support (`supports.py`) exceeds the usual
by, so that a rule of great weight or a function of high priority is heard.
"""

import random
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import log

import numpy as np

from ...model import Channel, SingleArray, Term
from .choice_model import READING, ChoiceModel, log_odds_of, worth_of
from .decoding import stretch_levels
from .families import OTHER_FAMILY, FamilyBehavior, merged
from .mimes import Mime
from .supports import Support

OTHER_SHARE = 0.7
"""The share of the worth of a lexeme's further families that its first family does not already include."""

FOCUS_WEIGHT = 0.3
"""How much the odds of a stroke follow the share of its word in the focus, relative to an even share."""

LEAST_SHARE, MOST_SHARE = 0.25, 6.0
"""The focus counts between these multiples of an even share."""

TEMPERATURE = 0.27
"""The size of chance in log-odds: the scale of the logistic draws of every seed but 0, which takes the best set."""

VARIETY = 6.0
"""How much larger chance is among gestures with the same meaning."""

JUST_SHOWN, JUST_SHOWN_S = -1.5, 5.0
"""What a gesture loses in log-odds right after it was shown, and regains evenly within this time (paper §3.4: none is
repeated inordinately). Of strokes that follow within 14 words directors show 15 % with the same meaning as the one
before; the plans of 500 of their lines do so in 28 % without this part, in 25 % with it, and agree with them as often
(.70 of meanings)."""

LEAST_WORTH = 5e-4
MOST_WORTH = 0.98
FAINT = 0.05
"""Parts that are smaller are not told."""

CHANCE, FOCUS, OTHER_READINGS = "chance", "focus of the voice", "other readings of the gesture"
JUST_BEFORE, BESIDE = "shown just before", "shared with a stroke nearby"

Place = tuple[int, int]
"""A word and the column of a lexeme."""


@dataclass(frozen=True, slots=True, eq=False)
class LineWorths:
    """The worths of a line: `read` the reading's expected worth and `family` the worth with all terms (W, F), `terms`
    the terms of each word, `log_odds` the whole sum (W, L), with `supports` and `mimes` by word and lexeme, `focus`
    (W,), `chance` (W, L), and by word and column what lexemes lose that were shown just before and what pointings gain
    where they are `resumed`, as its further parts. `lexemes` are the columns, `shown` (L, F) how much each shows each
    family."""

    choice: ChoiceModel
    lexemes: Mapping[str, int]
    shown: SingleArray
    read: SingleArray
    terms: tuple[frozenset[str], ...]
    family: SingleArray
    supports: Mapping[tuple[int, str], Support]
    focus: SingleArray
    chance: SingleArray
    log_odds: SingleArray
    just_shown: Mapping[Place, float] = field(default_factory=dict)
    beside: Mapping[Place, float] = field(default_factory=dict)
    mimes: Mapping[tuple[int, str], Mime] = field(default_factory=dict)
    resumed: Mapping[Place, Term] = field(default_factory=dict)

    def of(self, word: int, lexeme: str) -> float | None:
        """The log-odds of a lexeme with its stroke on a word; None for one without an entry in `shows`."""
        column = self.lexemes.get(lexeme)
        return None if column is None else float(self.log_odds[word, column])

    def best(self, word: int) -> str:
        """The lexeme with the highest log-odds with its stroke on a word."""
        column = int(self.log_odds[word].argmax())
        return next(lexeme for lexeme, each in self.lexemes.items() if each == column)

    def parts(self, word: int, lexeme: str) -> tuple[Term, ...]:
        """The named parts of that sum, the largest first."""
        column = self.lexemes[lexeme]
        shown = self.shown[column]
        first = int(shown.argmax())
        of_family = float(self.family[word, first])
        whole = float(lexeme_worth(self.family[word : word + 1], self.shown[column : column + 1])[0, 0])
        parts = [*self.choice.explained(self.read[word], self.terms[word], self.choice.families[first])]
        parts.append(Term(OTHER_READINGS, round(_log_odds(whole) - _log_odds(of_family), 2)))
        parts.append(Term(FOCUS, round(float(self.focus[word]), 2)))
        parts.append(Term(CHANCE, round(float(self.chance[word, column]), 2)))
        parts.append(Term(JUST_BEFORE, round(self.just_shown.get((word, column), 0.0), 2)))
        parts.append(Term(BESIDE, round(self.beside.get((word, column), 0.0), 2)))
        support = self.supports.get((word, lexeme))
        parts += support.parts if support else ()
        mime = self.mimes.get((word, lexeme))
        parts += (mime.part,) if mime else ()
        resumed = self.resumed.get((word, column))
        parts += (resumed,) if resumed else ()
        heavy = (part for part in parts if abs(part.weight) >= FAINT)
        return tuple(sorted(heavy, key=lambda part: (-abs(part.weight), part.name)))


def lexeme_worth(worth: SingleArray, shown: SingleArray) -> SingleArray:
    """The worth of each lexeme (W, L): that of its first family, and a share of that of its other families."""
    first, others = (shown == 1).astype(np.float32), np.where(shown < 1, shown, 0)
    certain = np.clip(worth @ first.T, 0, 1)
    return np.asarray(certain + OTHER_SHARE * (worth @ others.T), np.float32)


def shown_by_lexemes(shows: Mapping[str, Sequence[str]], names: Sequence[str]) -> SingleArray:
    """How much each lexeme shows each family (L, F): 1 for its first family, `OTHER_FAMILY` for the others; `shows` are
    the families of each lexeme, likeliest first."""
    shown = np.zeros((len(shows), len(names)), np.float32)
    for row, families in zip(shown, shows.values(), strict=True):
        for place, family in enumerate(dict.fromkeys(map(merged, families))):
            if family in names:
                row[names.index(family)] = OTHER_FAMILY if place else 1.0
    return shown


def focus_of(shares: Sequence[float] | None, words: int) -> SingleArray:
    """What the focus adds on each word (W,), by its share; 0 where no focus is heard."""
    if shares is None:
        return np.zeros(words, np.float32)
    relative = np.clip(np.array(shares) * words, LEAST_SHARE, MOST_SHARE)
    return np.asarray(FOCUS_WEIGHT * np.log(relative), np.float32)


def kinds_added(
    kinds: Sequence[str], terms: Sequence[frozenset[str]], weights: Mapping[str, Mapping[str, float]]
) -> SingleArray:
    """What authors' weights add to each kind of head movement or face on each word (W, K)."""
    added = np.zeros((len(terms), len(kinds)), np.float32)
    for term, by_kind in weights.items():
        for kind, weight in by_kind.items():
            if kind in kinds:
                added[[term in names for names in terms], kinds.index(kind)] += weight
    return added


def chance_of(seed: int, text: str, shape: tuple[int, int]) -> SingleArray:
    """The draws (W, L) of a seed for a text; none for seed 0."""
    if not seed:
        return np.zeros(shape, np.float32)
    generator = np.random.default_rng(random.Random(f"{seed} {text}").getrandbits(64))
    return np.asarray(generator.logistic(0.0, TEMPERATURE, shape), np.float32)


def chance_of_lexemes(seed: int, text: str, words: int, shown: SingleArray) -> SingleArray:
    """The draws (W, L) for lexemes: one for each family that is read first, and less for all but one lexeme of it, so
    that a take shows the same meanings by other gestures more often than other meanings."""
    if not seed:
        return np.zeros((words, len(shown)), np.float32)
    first = shown.argmax(axis=1)
    of_family = chance_of(seed, text, (words, shown.shape[1]))[:, first]
    own = VARIETY * np.abs(chance_of(seed, f"{text} forms", (words, len(shown))))
    least = np.full((words, shown.shape[1]), np.inf, np.float32)
    for column, family in enumerate(first):
        least[:, family] = np.minimum(least[:, family], own[:, column])
    return np.asarray(of_family - own + least[:, first], np.float32)


def summed(
    worth: SingleArray, supports: Mapping[tuple[int, str], Support], columns: Mapping[str, int], others: SingleArray
) -> SingleArray:
    """The log-odds (W, L): of worths (W, L), of supports by word and lexeme, and of all other parts (W, L) together."""
    total = log_odds_of(np.clip(worth, LEAST_WORTH, MOST_WORTH)) + others
    for (word, lexeme), support in supports.items():
        total[word, columns[lexeme]] += support.log_odds
    return np.asarray(total, np.float32)


def after_what_was_shown(worths: LineWorths, taken: Mapping[int, SingleArray], times_s: Sequence[float]) -> LineWorths:
    """The worths on the words `taken` for strokes, in order, less for what lies nearer to other strokes, by the share
    (L,) that is a stroke's own, and for what the strokes before show: the best on their words. What is wholly its own
    loses nothing, not by rounding either."""
    total, shown = worths.log_odds.copy(), dict[int, float]()
    before, beside = dict[Place, float](), dict[Place, float]()
    for word, share in taken.items():
        less = np.minimum(total[word], log_odds_of(worth_of(total[word]) * share))
        own = np.where(share < 1, less, total[word])
        beside |= {(word, column): float(lost) for column, lost in enumerate(own - total[word]) if lost}
        total[word] = own
        for column, shown_s in shown.items():
            left = 1 - (times_s[word] - shown_s) / JUST_SHOWN_S
            if left > 0:
                before[word, column] = JUST_SHOWN * left
                total[word, column] += before[word, column]
        shown[int(total[word].argmax())] = times_s[word]
    return replace(worths, log_odds=total, just_shown=before, beside=beside)


def _log_odds(worth: float) -> float:
    kept_off = min(max(worth, LEAST_WORTH), MOST_WORTH)
    return log(kept_off / (1 - kept_off))


USUAL_SUPPORT = 1.2
"""What an offer of the shipped rules adds at most."""


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
        """How far the kind is above its threshold over words `first` to `last`, in log-odds; what comes before and
        after them is the rest of the line."""
        parts = [(0, first - 1), (first, last), (last + 1, len(self.likely) - 1)]
        stretches = [(begin, end) for begin, end in parts if begin <= end]
        levels = stretch_levels(self.kinds, self.likely, stretches)[stretches.index((first, last))]
        threshold = self.thresholds[kind]
        return float(log_odds_of(levels)[self.kinds.index(kind)]) - log(threshold / (1 - threshold))

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
            parts.append(Term(above_average(support), round(surplus(support), 2)))
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


def above_average(support: Support) -> str:
    """The name of the part that an offer has in the worth of a kind."""
    return f"rule {support.rule}, above average"


def surplus(support: Support) -> float:
    """What an offer adds to the worth of a kind."""
    return max(0.0, support.log_odds - USUAL_SUPPORT)
