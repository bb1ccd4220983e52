"""Plans a line: its moments, one idea a phrase, each with its meaning and the reasons (paper §3.4, and beyond it).

People gesture on ideas, not on words: on the new, contrasted or stressed part of a phrase, and on most words not at
all. So the plan sums up the worth of every gesture with its stroke on every word (`worths.py`), takes strokes, some
time apart, whose gain exceeds the price of a gesture, and leaves the rest of the line still. Head movements and faces
are planned for the stretches in which directors would likely want them.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain
from math import exp, log
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...model import BehaviorCandidates, Channel, Function, Moment, RejectedAlternative, SingleArray, Term, Utterance
from .choice_model import log_odds_of, worth_of
from .conditions import NO_WINDOWS, possible_families, possible_lexemes
from .decoding import BOTH_AT_ONCE, held, sentence_ends, spans_of, stretches_of
from .encoder import Delivery, Reading
from .families import FamilyBehavior
from .mimes import Mime, mimes_in
from .parallels import CONTRAST, Ground, PlacedStroke, parallel_strokes, placed_strokes, with_placed
from .planner import Planner
from .player import Player
from .resumptions import with_resumed
from .strokes import NEAR, WHOLE, Window, Worth, strokes, windowed
from .supports import Support, supports_of
from .terms import Fact, terms_of
from .word_times import pace_of, times_s_of
from .worths import (
    KindWorths,
    LineWorths,
    after_what_was_shown,
    chance_of,
    chance_of_lexemes,
    focus_of,
    kind_supports,
    kind_worths,
    kinds_added,
    lexeme_worth,
    summed,
)

AT_WORD_SHARE = 0.7
"""The share of the words' own worths in the reading's expected worth, the rest coming from the nearby worths: chosen on
held-out lines (`python -m training.acting.constants`)."""

QUANTITY_WEIGHT = 0.5
"""How much a gesture's price falls as the quantity doubles, and rises as it halves, divided by ln 2."""

PACE_WEIGHT = 0.5
"""How much the quantity of a word follows its time: slow talk has more gestures a word, and as many a second."""

SPARING = 0.3
"""With less than this quantity parallel phrases are not placed for their own sake."""

FORBIDDEN = -30.0
"""The log-odds of what is never made."""

ONE_OF_BOTH = 0.5
"""What one of two kinds of head movement is worth where both are wanted at once."""

FULL_GAIN = 1.6
"""The gain at which a gesture has importance 1."""

MIMED = "emblem_other"
"""The family of mimes."""

FAMILIES_TOLD = 4
TERMS_TOLD = 6
REJECTED_TOLD = 3


@dataclass(frozen=True, slots=True)
class Understood:
    """What a plan is made from: the utterance, its functions, the facts of the rules, and what the mapping rules
    offer."""

    utterance: Utterance
    functions: Sequence[Function]
    facts: Iterable[Fact] = ()
    offers: Sequence[BehaviorCandidates] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Plan:
    """The moments of a line in order of their words, the worths by which the gestures among them were chosen (None
    where nothing was weighed) with their price, and those of the kinds of head movement and face, by channel."""

    moments: tuple[Moment, ...] = ()
    worths: LineWorths | None = None
    price: float = 0.0
    kinds: Mapping[Channel, KindWorths] = field(default_factory=dict)


def plan(planner: Planner, line: Understood, player: Player, *, still: Sequence[int] = ()) -> Plan:
    """The plan of a line: gestures, head, face. No stroke falls on the words `still`."""
    utterance = line.utterance
    if player.quantity <= 0 or not utterance.words:
        return Plan()
    reading = planner.encoder.read([word.text for word in utterance.words], Delivery.of(utterance))
    taken = _taken(planner, reading, line, player, still)
    worths = taken.worths
    kinds = {each.channel: each for each in _heads_and_faces(planner, reading, line, worths.terms, player)}
    texts = [word.text for word in utterance.words]
    moments = chain(
        (_in_place(moment, taken.placed) for moment in _gestures(worths, utterance, taken.words, taken.ground)),
        *(_spans(each, texts) for each in kinds.values()),
    )
    in_order = sorted(moments, key=lambda moment: (moment.stroke, moment.channel, moment.first))
    return Plan(tuple(in_order), worths, taken.price, kinds)


@dataclass(frozen=True, slots=True, eq=False)
class _StrokeSelection:
    """The words taken for strokes, those of them that are sides of a contrast, where strokes can fall, and what they
    are worth beside each other, with the price of one."""

    words: Sequence[int]
    placed: Mapping[int, PlacedStroke]
    ground: Ground
    worths: LineWorths
    price: float


def _taken(
    planner: Planner, reading: Reading, line: Understood, player: Player, still: Sequence[int]
) -> _StrokeSelection:
    utterance, quantity = line.utterance, player.quantity * player.by_agitation
    worths = _worths(planner, reading, line, player)
    worth = Worth(worth_of(worths.log_odds), reading.at_word @ planner.shown.T, reading.stroke)
    ground = Ground(times_s_of(utterance), worth.gains(), still)
    price = planner.choice.price - QUANTITY_WEIGHT * log(quantity * pace_of(utterance) ** PACE_WEIGHT)
    found = {each.word: each for each in strokes(worth, price, ground.times_s, still=still)}
    contrast = worths.family[:, planner.choice.families.index(CONTRAST)]
    parallel = parallel_strokes(utterance, ground, contrast) if quantity > SPARING else ()
    placed = {each.word: each for each in parallel} or _placed(contrast, line.functions, [*found], ground)
    words = with_placed(found, placed.values(), ground)
    windows = {word: found[word].window for word in words if word not in placed}
    worths = _in_windows(worths, windows, planner, player, utterance)
    shares = {word: worth.share(window)[word] for word, window in windows.items()}
    worths = after_what_was_shown(worths, shares, ground.times_s)
    worth_it = replace(worth, whole=worth_of(worths.log_odds)).gains() >= price
    taken = [word for word in words if word in placed or worth_it[word]]
    worths, taken = with_resumed(worths, taken, utterance.parse.tokens, ground)
    return _StrokeSelection(taken, placed, ground, worths, price)


def _heads_and_faces(
    planner: Planner, reading: Reading, line: Understood, terms: Sequence[frozenset[str]], player: Player
) -> Iterator[KindWorths]:
    encoder, choice = planner.encoder, planner.choice
    read: tuple[_Kinds, ...] = (
        (Channel.HEAD, reading.head, encoder.head, choice.head, player.families.head),
        (Channel.FACE, reading.face, encoder.face, choice.face, player.families.face),
    )
    offered = tuple(supports_of(line.offers))
    for channel, likely, kinds, levels, listed in read:
        added = kinds_added(kinds, terms, planner.kind_weights)
        chance = _of_chance(channel, player, line.utterance, len(kinds))
        supports = kind_supports(offered, {kind: listed[kind] for kind in kinds if kind in listed})
        yield kind_worths(channel, kinds, (likely, added, chance), supports, _at_quantity(levels, player.quantity))


_Kinds: TypeAlias = tuple[
    Channel, SingleArray, Sequence[str], Mapping[str, float], Mapping[str, tuple[FamilyBehavior, ...]]
]
"""A channel, how likely its kinds are on each word (W, K), the kinds, their thresholds, and what shows them."""


def _of_chance(channel: Channel, player: Player, utterance: Utterance, kinds: int) -> SingleArray:
    """The draws of a take for each kind, the same on all words of the line."""
    text = " ".join((channel, *(word.text for word in utterance.words)))
    return chance_of(player.seed, text, (1, kinds))


def meanings(planner: Planner, line: Understood, player: Player, words: Collection[int]) -> dict[int, tuple[str, ...]]:
    """The families of gestures with the highest worth for a stroke on each of these words, the best first, whether or
    not a gesture is planned there."""
    utterance = line.utterance
    reading = planner.encoder.read([word.text for word in utterance.words], Delivery.of(utterance))
    worths = _worths(planner, reading, line, player)
    return {word: tuple(planner.choice.families[place] for place in _best(worths.family[word])) for word in words}


def expected_worth(at_word: SingleArray, nearby: SingleArray) -> SingleArray:
    """The expected worth of a stroke on each word (W, F), by the reading alone."""
    return np.asarray(AT_WORD_SHARE * windowed(at_word, WHOLE) + (1 - AT_WORD_SHARE) * nearby, np.float32)


def _worths(planner: Planner, reading: Reading, line: Understood, player: Player) -> LineWorths:
    utterance, choice = line.utterance, planner.choice
    terms = terms_of(utterance, line.functions, planner.terms.of_facts(line.facts))
    read = expected_worth(reading.at_word, reading.nearby)
    mimes = [each for each in mimes_in(planner.mimes, utterance.parse.tokens) if each.name in player.behaviors]
    worth = worth_of(choice.log_odds(read, terms)) * _possible(planner, utterance, mimes)
    supports = _supports(planner, line.offers, player)
    focus = focus_of(Delivery.of(utterance).focus, len(utterance.words))
    text = " ".join(word.text for word in utterance.words)
    chance = chance_of_lexemes(player.seed, text, len(worth), planner.shown)
    total = summed(lexeme_worth(worth, planner.shown), supports, planner.lexemes, chance + focus[:, None])
    mimed = {place: mime for place, mime in _mimed_lexemes(mimes, player) if place[1] in planner.lexemes}
    for (word, lexeme), mime in mimed.items():
        total[word, planner.lexemes[lexeme]] += mime.part.weight
    total[~_playable(planner, player, utterance, (*supports, *mimed))] = FORBIDDEN
    for ban, lexemes in player.banned_lexemes():
        total[ban.first : ban.last + 1, [planner.lexemes[each] for each in lexemes if each in planner.lexemes]] = (
            FORBIDDEN
        )
    return LineWorths(
        choice, planner.lexemes, planner.shown, read, terms, worth, supports, focus, chance, total, mimes=mimed
    )


def _in_windows(
    worths: LineWorths, windows: Mapping[int, Window], planner: Planner, player: Player, utterance: Utterance
) -> LineWorths:
    """The worths without what would show a word outside a stroke's window: one of two strokes about it shows it."""
    narrow = {word: window for word, window in windows.items() if window != WHOLE}
    if not narrow:
        return worths
    asked = (*worths.supports, *worths.mimes)
    total = worths.log_odds.copy()
    total[~_playable(planner, player, utterance, asked, narrow)] = FORBIDDEN
    return replace(worths, log_odds=total)


def _mimed_lexemes(mimes: Iterable[Mime], player: Player) -> Iterator[tuple[tuple[int, str], Mime]]:
    """The mimes with the words of their verbs and objects and the lexemes that show them."""
    for mime in mimes:
        yield from (((word, player.lexeme(mime.name)), mime) for word in range(mime.first, mime.last + 1))


def _playable(
    planner: Planner,
    player: Player,
    utterance: Utterance,
    asked: Iterable[tuple[int, str]],
    windows: Mapping[int, Window] = NO_WINDOWS,
) -> NDArray[np.bool_]:
    """The words and lexemes (W, L) for which the character has a behaviour that suits the words; those `asked` for by a
    rule or a verb suit them."""
    playable = possible_lexemes(planner.lexemes, player, utterance, windows)
    for word, lexeme in asked:
        playable[word, planner.lexemes[lexeme]] = True
    return playable


def _supports(
    planner: Planner, offers: Iterable[BehaviorCandidates], player: Player
) -> Mapping[tuple[int, str], Support]:
    """The strongest support of each gesture by word and lexeme."""
    best: dict[tuple[int, str], Support] = {}
    for support in supports_of(offers):
        entry = player.behaviors[support.name]
        lexeme = player.lexeme(support.name)
        if entry.channel is not Channel.GESTURE or lexeme not in planner.lexemes:
            continue
        for word in range(support.function.first, support.function.last + 1):
            held = best.get((word, lexeme))
            if held is None or support.log_odds > held.log_odds:
                best[word, lexeme] = support
    return best


def _possible(planner: Planner, utterance: Utterance, mimes: Iterable[Mime]) -> SingleArray:
    """Which families can be shown on each word (W, F), 0 or 1."""
    possible = possible_families(planner.needed_lemmas, planner.choice.families, utterance)
    place = planner.choice.families.index(MIMED)
    for mime in mimes:
        possible[max(0, mime.first - NEAR) : mime.last + NEAR + 1, place] = 1.0
    return possible


def _gestures(worths: LineWorths, utterance: Utterance, taken: Sequence[int], ground: Ground) -> Iterator[Moment]:
    families = worths.choice.families
    bounds = [-1, *taken, len(utterance.words)]
    for number, stroke in enumerate(taken):
        worth = worths.family[stroke]
        best = worths.best(stroke)
        order = _best(worth, first=int(worths.shown[worths.lexemes[best]].argmax()))
        first, last = _phrase_about(utterance, stroke, bounds[number], bounds[number + 2])
        yield Moment(
            id=f"moment.gesture.{stroke}",
            channel=Channel.GESTURE,
            first=first,
            last=last,
            stroke=stroke,
            families=tuple(families[place] for place in order),
            importance=round(min(1.0, float(ground.gain[stroke]) / FULL_GAIN), 3),
            shares=tuple(round(float(worth[place]), 3) for place in order),
            terms=worths.parts(stroke, best)[:TERMS_TOLD],
            rejected=tuple(_rejected(worths, ground, (first, stroke, last), order)),
        )


def _best(worth: SingleArray, first: int | None = None) -> list[int]:
    """The families with the highest worth, given the worths (F,) on a word; `first` before all others."""
    order = [int(place) for place in np.argsort(-worth, kind="stable")[:FAMILIES_TOLD]]
    return order if first is None else [first, *(place for place in order if place != first)][:FAMILIES_TOLD]


def _placed(
    contrast: SingleArray, functions: Sequence[Function], taken: Sequence[int], ground: Ground
) -> dict[int, PlacedStroke]:
    """The strokes, by word, for the two sides of a contrast, of the worth `contrast` (W,), where a stroke would fall
    near either."""
    near = [word for word in range(len(contrast)) if any(abs(word - stroke) <= NEAR for stroke in taken)]
    reached = np.zeros_like(contrast)
    reached[near] = contrast[near]
    return {each.word: each for each in placed_strokes(functions, reached, ground)}


def _in_place(moment: Moment, placed: Mapping[int, PlacedStroke]) -> Moment:
    """The moment changed into a side of a contrast, if its stroke is one."""
    stroke = placed.get(moment.stroke)
    if stroke is None:
        return moment
    share = max(moment.shares) if stroke.log_odds is None else 1.0
    told = stroke.log_odds if stroke.log_odds is not None else float(log_odds_of(np.array([share], np.float32))[0])
    others = [
        pair for pair in zip(moment.families, moment.shares, strict=True) if pair[0] not in (CONTRAST, stroke.side)
    ]
    families, shares = zip((CONTRAST, share), (stroke.side, share), *others[: FAMILIES_TOLD - 2], strict=True)
    return replace(
        moment,
        families=families,
        shares=shares,
        set_against=stroke.other,
        terms=(Term(f"contrasted with word {stroke.other}", round(told, 2)),),
    )


def _rejected(
    worths: LineWorths, ground: Ground, span: tuple[int, int, int], order: Sequence[int]
) -> Iterator[RejectedAlternative]:
    """The families that lost on the stroke's word, and the family and word of the span with the second-best stroke."""
    first, stroke, last = span
    families = worths.choice.families
    for place in order[1 : 1 + REJECTED_TOLD]:
        worth = round(float(worths.family[stroke, place]), 3)
        yield RejectedAlternative((families[place],), worth, f"{families[order[0]]} scores higher on the same word")
    beside = [word for word in range(first, last + 1) if word != stroke]
    if beside:
        word = max(beside, key=lambda each: float(ground.gain[each]))
        place = int(worths.family[word].argmax())
        reason = f"a stroke on word {word} would be too near the one on word {stroke}"
        yield RejectedAlternative((families[place],), round(float(worths.family[word, place]), 3), reason)


def _phrase_about(utterance: Utterance, stroke: int, after: int, before: int) -> tuple[int, int]:
    """The phrase that a stroke's idea fills: the longest that contains its word, cut at the neighbouring strokes."""
    phrases = [phrase for phrase in utterance.parse.phrases if phrase.first <= stroke <= phrase.last]
    widest = max(phrases, key=lambda phrase: phrase.last - phrase.first, default=None)
    first, last = (widest.first, widest.last) if widest else (stroke, stroke)
    return max(first, after + 1), min(last, before - 1)


def _spans(worths: KindWorths, texts: Sequence[str]) -> Iterator[Moment]:
    """Head movements or faces; the stroke of each falls on its likeliest word."""
    spans = spans_of(worths.kinds, worths.likely, stretches_of(texts), worths.thresholds, asked=worths.supports)
    for span in held(spans, sentence_ends(texts)):
        parts = BOTH_AT_ONCE.get(span.kind, ())
        yield Moment(
            id=f"moment.{worths.channel}.{span.kind}.{span.first}",
            channel=worths.channel,
            first=span.first,
            last=span.last,
            stroke=span.stroke,
            families=(span.kind, *parts),
            importance=round(span.likely, 3),
            shares=(round(span.likely, 3), *(round(span.likely * ONE_OF_BOTH, 3) for _ in parts)),
            terms=tuple(chain.from_iterable(worths.parts(kind, span.stroke) for kind in parts or (span.kind,))),
        )


def _at_quantity(thresholds: Mapping[str, float], quantity: float) -> dict[str, float]:
    """The thresholds for another quantity: their odds fall with the square of the quantity."""
    shift = 2 * log(quantity)
    return {kind: 1 / (1 + exp(-(log(each / (1 - each)) - shift))) for kind, each in thresholds.items()}
