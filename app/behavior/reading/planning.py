"""Plans a line: its moments, one idea a phrase, each with its meaning and the reasons (paper §3.4, and beyond it).

People gesture on ideas, not on words: on the new, contrasted or stressed part of a phrase, and on most words not at all
(shared/directing/GUIDE.md). So the plan computes the worth of every family of gesture with its stroke on every word,
takes strokes, a few words apart, whose gain exceeds the price of a gesture, and leaves the rest of the line still. Head
movements and faces are planned for the stretches in which directors would likely want them.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from math import exp, log
from pathlib import Path
from types import MappingProxyType

import numpy as np

from ...model import Channel, Function, Moment, Rejected, SingleArray, Term, Utterance
from .authored_weights import load_weights
from .choice_model import READING, ChoiceModel, log_odds_of, worth_of
from .contrasts import CONTRAST, PlacedStroke, placed_strokes, with_placed
from .decoding import NEAR, gains, spans_of, spread, stretches_of, strokes
from .delivery import Delivery
from .encoder import Encoder, Reading
from .families import OTHER_FAMILY, Families, merged
from .terms import Fact, TermTable, terms_of

AT_WORD_SHARE = 0.5
"""The share of the words' own worths in the reading's expected worth, the rest coming from the nearby worths: measured
by `python -m benchmarks.behavior.directing`."""

QUANTITY_WEIGHT = 0.5
"""How much a gesture's price falls as the quantity doubles, and rises as it halves, divided by ln 2."""

OTHER_SHARE = 0.7
"""The share of the worth of a lexeme's further families that its first family does not already include."""

FULL_GAIN = 1.6
"""The gain at which a gesture has importance 1."""

FAMILIES_TOLD = 4
TERMS_TOLD = 6
REJECTED_TOLD = 3


@dataclass(frozen=True, slots=True, eq=False)
class Planner:
    """The models of planning, loaded once: the encoder, the weights, how much each lexeme shows each family (L, F), and
    the lemmas without which a family cannot be shown (mimes: "drink", "phone")."""

    encoder: Encoder
    choice: ChoiceModel
    shown: SingleArray
    needed_lemmas: Mapping[str, frozenset[str]]
    terms: TermTable

    @classmethod
    def load(cls, models: Path, lexicon: Path, families: Families, predicates: Mapping[str, int]) -> "Planner":
        """Loads from the folders models/acting and lexicon/acting; `predicates` are those of the rules with their
        numbers of arguments.

        Raises ServiceError `model_unreadable`, and AuthoringError for the weights and terms of authors.
        """
        choice = ChoiceModel.load(models / "weights.json")
        authored = load_weights(lexicon / "weights.yaml", choice.families, choice.terms)
        return cls(
            encoder=Encoder.load(models / "encoder.onnx"),
            choice=choice.with_weights(authored),
            shown=shown_by_lexemes(families, choice.families),
            needed_lemmas=MappingProxyType(dict(_needed_lemmas(families))),
            terms=TermTable.load(lexicon / "terms.yaml", predicates),
        )


@dataclass(frozen=True, slots=True, eq=False)
class _Weighed:
    """The worths in a line: of each family with its stroke on each word, by the reading alone and with all terms (W,
    F); and the gain of each lexeme (W, L)."""

    read: SingleArray
    worth: SingleArray
    gain: SingleArray
    terms: tuple[frozenset[str], ...]


def plan(
    planner: Planner,
    utterance: Utterance,
    functions: Sequence[Function],
    facts: Iterable[Fact] = (),
    *,
    quantity: float = 1.0,
    still: Sequence[int] = (),
) -> tuple[Moment, ...]:
    """The moments of a line (gestures, head, face) in order of their words.

    `quantity` scales how much is planned: 1 is as much as directors want, 0 nothing. No stroke falls on the words
    `still`.
    """
    if quantity <= 0 or not utterance.words:
        return ()
    texts = [word.text for word in utterance.words]
    reading, choice = planner.encoder.read(texts, Delivery.of(utterance)), planner.choice
    weighed = _weighed(planner, reading, utterance, terms_of(utterance, functions, planner.terms.of_facts(facts)))
    taken = strokes(weighed.gain, choice.price - QUANTITY_WEIGHT * log(quantity), still=still)
    placed = _placed(planner, weighed, functions, taken, still)
    taken = with_placed(taken, placed.values())
    stretches = stretches_of(texts)
    moments = chain(
        (_in_place(moment, placed) for moment in _gestures(planner, weighed, utterance, taken)),
        _spans(Channel.HEAD, reading.head, stretches, planner.encoder.head, _at_quantity(choice.head, quantity)),
        _spans(Channel.FACE, reading.face, stretches, planner.encoder.face, _at_quantity(choice.face, quantity)),
    )
    return tuple(sorted(moments, key=lambda moment: (moment.stroke, moment.channel, moment.first)))


def meanings(
    planner: Planner,
    utterance: Utterance,
    functions: Sequence[Function],
    facts: Iterable[Fact],
    *,
    words: Collection[int],
) -> dict[int, tuple[str, ...]]:
    """The families of gestures with the highest worth for a stroke on each of these words, the best first, whether or
    not a gesture is planned there."""
    reading = planner.encoder.read([word.text for word in utterance.words], Delivery.of(utterance))
    weighed = _weighed(planner, reading, utterance, terms_of(utterance, functions, planner.terms.of_facts(facts)))
    return {word: tuple(planner.choice.families[place] for place in _best(weighed.worth[word])) for word in words}


def expected_worth(at_word: SingleArray, nearby: SingleArray) -> SingleArray:
    """The expected worth of a stroke on each word (W, F), by the reading alone."""
    return np.asarray(AT_WORD_SHARE * spread(at_word) + (1 - AT_WORD_SHARE) * nearby, np.float32)


def shown_by_lexemes(families: Families, names: Sequence[str]) -> SingleArray:
    """How much each lexeme shows each family (L, F): 1 for its first family, `OTHER_FAMILY` for the others."""
    rows = []
    for shown in families.shows.values():
        row = np.zeros(len(names), np.float32)
        for place, family in enumerate(dict.fromkeys(merged(each) for each in shown)):
            if family in names:
                row[names.index(family)] = OTHER_FAMILY if place else 1.0
        rows.append(row)
    return np.unique(np.stack(rows), axis=0)


def lexeme_worth(worth: SingleArray, shown: SingleArray) -> SingleArray:
    """The worth of each lexeme (W, L): that of its first family, and a share of that of its other families."""
    first, others = (shown == 1).astype(np.float32), np.where(shown < 1, shown, 0)
    certain = np.clip(worth @ first.T, 0, 1)
    return np.asarray(certain + OTHER_SHARE * (worth @ others.T), np.float32)


def _weighed(planner: Planner, reading: Reading, utterance: Utterance, terms: tuple[frozenset[str], ...]) -> _Weighed:
    read = expected_worth(reading.at_word, reading.nearby)
    worth = worth_of(planner.choice.log_odds(read, terms)) * _possible(planner, utterance)
    at_word = reading.at_word @ planner.shown.T
    gain = gains(lexeme_worth(worth, planner.shown), at_word, reading.stroke)
    return _Weighed(read, worth, gain, terms)


def _possible(planner: Planner, utterance: Utterance) -> SingleArray:
    """Which families can be shown on each word (W, F), 0 or 1: some need a word nearby that says what to show."""
    possible = np.ones((len(utterance.words), len(planner.choice.families)), np.float32)
    for family, lemmas in planner.needed_lemmas.items():
        if family in planner.choice.families:
            place = planner.choice.families.index(family)
            possible[:, place] = 0.0
            for token in utterance.parse.tokens:
                if token.lemma.lower() in lemmas:
                    possible[max(0, token.word - NEAR) : token.word + NEAR + 1, place] = 1.0
    return possible


def _needed_lemmas(families: Families) -> Iterator[tuple[str, frozenset[str]]]:
    for family, behaviors in families.gesture.items():
        if all(behavior.lemmas for behavior in behaviors):
            yield merged(family), frozenset[str]().union(*(behavior.lemmas for behavior in behaviors))


def _gestures(planner: Planner, weighed: _Weighed, utterance: Utterance, taken: Sequence[int]) -> Iterator[Moment]:
    families = planner.choice.families
    bounds = [-1, *taken, len(utterance.words)]
    for number, stroke in enumerate(taken):
        worth = weighed.worth[stroke]
        order = _best(worth)
        first, last = _phrase_about(utterance, stroke, bounds[number], bounds[number + 2])
        terms = planner.choice.explained(weighed.read[stroke], weighed.terms[stroke], families[order[0]])
        yield Moment(
            id=f"moment.gesture.{stroke}",
            channel=Channel.GESTURE,
            first=first,
            last=last,
            stroke=stroke,
            families=tuple(families[place] for place in order),
            importance=round(min(1.0, float(weighed.gain[stroke].max()) / FULL_GAIN), 3),
            shares=tuple(round(float(worth[place]), 3) for place in order),
            terms=terms[:TERMS_TOLD],
            rejected=tuple(_rejected(families, weighed, (first, stroke, last), order)),
        )


def _best(worth: SingleArray) -> list[int]:
    """The families with the highest worth, given the worths (F,) on a word."""
    return [int(place) for place in np.argsort(-worth, kind="stable")[:FAMILIES_TOLD]]


def _placed(
    planner: Planner, weighed: _Weighed, functions: Sequence[Function], taken: Sequence[int], still: Sequence[int]
) -> dict[int, PlacedStroke]:
    """The strokes, by word, for the two sides of a contrast, where a stroke would fall near either."""
    worth = weighed.worth[:, planner.choice.families.index(CONTRAST)]
    near = [word for word in range(len(worth)) if any(abs(word - stroke) <= NEAR for stroke in taken)]
    reached = np.zeros_like(worth)
    reached[near] = worth[near]
    placed = placed_strokes(functions, reached, weighed.gain.max(axis=1), still=still)
    return {each.word: each for each in placed}


def _in_place(moment: Moment, placed: Mapping[int, PlacedStroke]) -> Moment:
    """The moment changed into a side of a contrast, if its stroke is one."""
    stroke = placed.get(moment.stroke)
    if stroke is None:
        return moment
    share = max(moment.shares)
    others = [
        pair for pair in zip(moment.families, moment.shares, strict=True) if pair[0] not in (CONTRAST, stroke.side)
    ]
    families, shares = zip((CONTRAST, share), (stroke.side, share), *others[: FAMILIES_TOLD - 2], strict=True)
    return replace(
        moment,
        families=families,
        shares=shares,
        set_against=stroke.other,
    )


def _rejected(
    families: Sequence[str], weighed: _Weighed, span: tuple[int, int, int], order: Sequence[int]
) -> Iterator[Rejected]:
    """The families that lost on the stroke's word, and the family and word of the span with the second-best stroke."""
    first, stroke, last = span
    for place in order[1 : 1 + REJECTED_TOLD]:
        worth = round(float(weighed.worth[stroke, place]), 3)
        yield Rejected((families[place],), worth, f"{families[order[0]]} is worth more on the same word")
    beside = [word for word in range(first, last + 1) if word != stroke]
    if beside:
        word = max(beside, key=lambda each: float(weighed.gain[each].max()))
        place = int(weighed.worth[word].argmax())
        reason = f"a stroke on word {word} would be too near the one on word {stroke}"
        yield Rejected((families[place],), round(float(weighed.worth[word, place]), 3), reason)


def _phrase_about(utterance: Utterance, stroke: int, after: int, before: int) -> tuple[int, int]:
    """The phrase that a stroke's idea fills: the longest that contains its word, cut at the neighbouring strokes."""
    phrases = [phrase for phrase in utterance.parse.phrases if phrase.first <= stroke <= phrase.last]
    widest = max(phrases, key=lambda phrase: phrase.last - phrase.first, default=None)
    first, last = (widest.first, widest.last) if widest else (stroke, stroke)
    return max(first, after + 1), min(last, before - 1)


def _spans(
    channel: Channel,
    likely: SingleArray,
    stretches: Sequence[tuple[int, int]],
    kinds: Sequence[str],
    thresholds: Mapping[str, float],
) -> Iterator[Moment]:
    """Head movements or faces; the stroke of each falls on its likeliest word."""
    for span in spans_of(kinds, likely, stretches, thresholds):
        column = likely[:, kinds.index(span.kind)]
        weight = float(log_odds_of(np.array([span.likely], np.float32))[0])
        yield Moment(
            id=f"moment.{channel}.{span.kind}.{span.first}",
            channel=channel,
            first=span.first,
            last=span.last,
            stroke=span.first + int(column[span.first : span.last + 1].argmax()),
            families=(span.kind,),
            importance=round(span.likely, 3),
            shares=(round(span.likely, 3),),
            terms=(Term(f"{READING}: {span.kind}", round(weight, 2)),),
        )


def _at_quantity(thresholds: Mapping[str, float], quantity: float) -> dict[str, float]:
    """The thresholds for another quantity: their odds fall with the square of the quantity."""
    shift = 2 * log(quantity)
    return {kind: 1 / (1 + exp(-(log(each / (1 - each)) - shift))) for kind, each in thresholds.items()}
