"""Selects the sequence of gestures and their hands (NGS §3.3, steps 4 and 5).

The gestures form a Markov chain over places. A gesture of lexeme g on a place, after one of lexeme h, has the weight
P(g∣s) · P(g∣h) / P(g), times a constant per gesture, chosen such that the expected number of gestures is the speaker's
for that time. The paper takes the most probable sequence, which always consists of the same few gestures. We sample a
sequence by its probability, so that the distribution of gestures is the speaker's (`benchmarks.profiles` compares
both). Hands are a chain likewise, over P(hand∣g) and the previous hand.

Weights are logarithms. Times are seconds.
"""

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from ...model import FloatArray, Hand
from ..profile import FIRST, Profile
from .candidates import Repertoire, StrokeWord

APART_S = 0.8
"""The minimum time between the strokes of two gestures."""

LEAST, IMPOSSIBLE = 1e-6, -1e9
NEVER = 1e-30
WIDEST, EXACT = 30.0, 1e-3
"""The range (±) in which the log weight per gesture is sought, and the tolerance."""

DRAWS = 12
NEARLY_ALL = 0.98
"""The largest expected number of gestures, as a share of the most that fit."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """A gesture on a place."""

    place: StrokeWord
    lexeme: str


@dataclass(frozen=True, slots=True)
class _Chain:
    """The Markov chain of a line: log weights of lexemes on places (P, L), of transitions (L, L), of the first lexeme
    (L,), and for each place the number of earlier places that are far enough away."""

    weights: FloatArray
    follows: FloatArray
    first: FloatArray
    before: tuple[int, ...]


def drawn_gestures(
    profile: Profile,
    places: Sequence[StrokeWord],
    *,
    expected: float,
    rng: random.Random,
    likeliest: bool = False,
    before: str = FIRST,
) -> tuple[Drawn, ...]:
    """The gestures of a stretch of speech after the lexeme `before`, `expected` in number on average; with `likeliest`
    the most probable chain."""
    lexemes = sorted({lexeme for place in places for lexeme in place.weights})
    if not lexemes or expected <= 0:
        return ()
    chain = _chain(profile, places, lexemes, before)
    expected = min(expected, NEARLY_ALL * _most(chain))
    found = _likeliest_of(chain, expected) if likeliest else _drawn(chain, expected, rng)
    return tuple(Drawn(places[place], lexemes[lexeme]) for place, lexeme in reversed(found))


def drawn_hands(
    profile: Profile, gestures: Sequence[Drawn], repertoire: Repertoire, *, rng: random.Random
) -> tuple[Hand, ...]:
    """The hand of each gesture, drawn by P(hand∣g) · P(hand∣hand before) / P(hand) among those that may make it."""
    hands: list[Hand] = []
    usual = _hand_shares(profile)
    for gesture in gestures:
        own = profile.lexemes[gesture.lexeme].hands if gesture.lexeme in profile.lexemes else usual
        row = profile.hand_follows.get(hands[-1] if hands else FIRST, usual)
        allowed = [hand for hand in Hand if hand in repertoire.gestures[gesture.lexeme].forms]
        weights = [max(own.get(hand, 0.0), LEAST) * row.get(hand, 0.0) / usual[hand] + LEAST for hand in allowed]
        hands.append(rng.choices(allowed, weights)[0])
    return tuple(hands)


def _hand_shares(profile: Profile) -> Mapping[Hand, float]:
    habits = profile.lexemes.values()
    return {hand: max(sum(each.share * each.hands.get(hand, 0.0) for each in habits), LEAST) for hand in Hand}


def _chain(profile: Profile, places: Sequence[StrokeWord], lexemes: Sequence[str], following: str) -> _Chain:
    shares = np.array([max(_share(profile, lexeme), LEAST) for lexeme in lexemes])
    weights = np.array([[max(place.weights.get(lexeme, 0.0), NEVER) for lexeme in lexemes] for place in places])
    follows = np.array([_row(profile, lexeme, lexemes, shares) for lexeme in lexemes])
    first = _row(profile, following, lexemes, shares)
    before = tuple(sum(other.end_s <= place.end_s - APART_S for other in places) for place in places)
    return _Chain(np.log(weights), np.log(follows / shares), np.log(first / shares), before)


def _share(profile: Profile, lexeme: str) -> float:
    return profile.lexemes[lexeme].share if lexeme in profile.lexemes else 0.0


def _row(profile: Profile, before: str, lexemes: Sequence[str], shares: FloatArray) -> FloatArray:
    """P(lexeme∣before) (L,): the row's values; its remaining probability is divided among the lexemes it does not name,
    in proportion to their shares."""
    row = profile.follows.get(before)
    if row is None:
        return shares
    said = np.array([row.get(lexeme, 0.0) for lexeme in lexemes])
    unsaid = np.where(said > 0, 0.0, shares)
    left = max(0.0, 1 - sum(row.values()))
    return np.asarray(np.maximum(said + left * unsaid / max(float(unsaid.sum()), LEAST), LEAST))


def _log_sum(values: FloatArray) -> FloatArray:
    """The logarithm of the sum of each column."""
    most = values.max(axis=0)
    return np.asarray(most + np.log(np.exp(values - most).sum(axis=0)))


def _log_maximum(values: FloatArray) -> FloatArray:
    return np.asarray(values.max(axis=0))


@dataclass(frozen=True, slots=True)
class _Adding:
    """The addition of chains (sum or maximum): of two, and along a column."""

    two: Callable[[FloatArray, FloatArray], FloatArray]
    many: Callable[[FloatArray], FloatArray]


ALL = _Adding(np.logaddexp, _log_sum)
LIKELIEST = _Adding(np.maximum, _log_maximum)


def _forward(chain: _Chain, weight: float, adding: _Adding) -> FloatArray:
    """The log weight (P, L) of all chains that end with a lexeme on a place, or of the most probable of them."""
    forward = np.empty_like(chain.weights)
    until = np.full((len(forward) + 1, forward.shape[1]), IMPOSSIBLE)
    for place, before in enumerate(chain.before):
        come = adding.two(chain.first, adding.many(until[before][:, None] + chain.follows))
        forward[place] = weight + chain.weights[place] + come
        until[place + 1] = adding.two(until[place], forward[place])
    return forward


def _backward(chain: _Chain, forward: FloatArray, pick: Callable[[FloatArray], int]) -> Iterator[tuple[int, int]]:
    """The places and lexemes of a chain, in reverse order."""
    columns = forward.shape[1]
    towards: FloatArray = np.zeros(columns)
    reached, stop = len(forward), 0.0
    while True:
        chosen = pick(np.append((forward[:reached] + towards).ravel(), stop))
        if chosen == reached * columns:
            return
        place, lexeme = divmod(chosen, columns)
        yield place, lexeme
        reached, towards, stop = chain.before[place], chain.follows[:, lexeme], float(chain.first[lexeme])


def _sampled(rng: random.Random, scores: FloatArray) -> int:
    shares = np.cumsum(np.exp(scores - scores.max()))
    return min(int(np.searchsorted(shares, rng.random() * shares[-1], side="right")), len(scores) - 1)


def _likeliest(scores: FloatArray) -> int:
    return int(scores.argmax())


def _drawn(chain: _Chain, expected: float, rng: random.Random) -> list[tuple[int, int]]:
    """Draws several chains and returns the first whose number of gestures is nearest to the expected one, because a
    speaker's rate varies less between lines than chance would imply."""
    forward = _forward(chain, _weight_for(lambda weight: _expected(chain, weight), expected), ALL)
    wanted = int(expected + rng.random())
    drawn = [list(_backward(chain, forward, partial(_sampled, rng))) for _draw in range(DRAWS)]
    return min(drawn, key=lambda found: abs(len(found) - wanted))


def _likeliest_of(chain: _Chain, expected: float) -> list[tuple[int, int]]:
    """The most probable chain with this number of gestures."""

    def chain_at(weight: float) -> list[tuple[int, int]]:
        return list(_backward(chain, _forward(chain, weight, LIKELIEST), _likeliest))

    return chain_at(EXACT + _weight_for(lambda weight: float(len(chain_at(weight))), expected - 0.5))


def _weight_for(count: Callable[[float], float], wanted: float) -> float:
    """The log weight per gesture for which the expected number is reached, or the nearest possible one."""
    from scipy.optimize import brentq  # imported late: only speakers of a profile need it, and it takes .3 s

    if wanted <= count(-WIDEST):
        return -WIDEST
    if wanted >= count(WIDEST):
        return WIDEST
    return float(brentq(lambda weight: count(weight) - wanted, -WIDEST, WIDEST, xtol=EXACT))


def _expected(chain: _Chain, weight: float) -> float:
    """The expected number of gestures in a chain: the derivative of the log total weight by the log weight per
    gesture."""
    return (_all(chain, weight + EXACT) - _all(chain, weight - EXACT)) / (2 * EXACT)


def _all(chain: _Chain, weight: float) -> float:
    """The log of the total weight of all chains, including the one without gestures."""
    return float(_log_sum(np.append(_forward(chain, weight, ALL).ravel(), 0.0)[:, None])[0])


def _most(chain: _Chain) -> int:
    """The largest number of gestures that fit."""
    longest = [0] * (len(chain.before) + 1)
    for place, before in enumerate(chain.before):
        longest[place + 1] = max(longest[place], longest[before] + 1)
    return longest[-1]
