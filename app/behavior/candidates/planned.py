"""The candidate behaviours for each moment, among which timing, free hands and neighbours decide (paper §3.5).

The worth of a lexeme sums the worths that its families have at the moment: in full for the family that an audience
reads in it first, by half for the others. Where a mapping rule offers a lexeme for a function of the same words, the
rule and its function are named and the lexeme is preferred, because rules take the words into account ("two fingers",
"to the left").
"""

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from ...model import (
    Alternative,
    BehaviorCandidates,
    Channel,
    Function,
    Level,
    Moment,
    Movement,
    Utterance,
)
from ..reading.families import (
    OTHER_FAMILY,
    POINT,
    POINTINGS,
    Families,
    FamilyBehavior,
    Playable,
    family_rule,
    fitting,
    merged,
)

LATER_CHOICE = 0.4
"""The worth of each further choice in a director's note, relative to the previous one."""

OFFERED = 1.2
ASKED_BY_LEMMA = 1.3
MOST_ALTERNATIVES = 6
STEEPNESS = 4.0
"""How much the better of two alternatives is preferred: weights are worths to this power."""

LEAST_PRIORITY, PRIORITY_OF_SURE = 2.0, 10.0
"""Priorities of moments with importance 0 and 1, on the scale of functions (rules/functions/priorities.yaml)."""

RULED = frozenset({Channel.GAZE, Channel.EYES, Channel.POSTURE})
"""The channels that mapping rules alone decide; hands, head and face are planned."""


@dataclass(frozen=True, slots=True)
class Stage:
    """What the choice of behaviours depends on besides the moment: the families, the table of behaviours, and the
    seed."""

    families: Families
    behaviors: Mapping[str, Playable]
    seed: int


def candidates_of(
    stage: Stage, utterance: Utterance, moments: Iterable[Moment], offers: Sequence[BehaviorCandidates]
) -> tuple[BehaviorCandidates, ...]:
    """The candidates for every moment, and what rules offer on the channels that are not planned.

    Functions that the caller gave are shown on all channels, because the caller asked for them.
    """
    level = utterance.level
    by_rank = sorted(offers, key=lambda each: each.rank, reverse=True)
    planned = (_of_moment(stage, utterance, moment, by_rank, level) for moment in moments)
    ruled = (_ruled(stage, offer) for offer in offers)
    return tuple(each for each in (*planned, *ruled) if each is not None)


def _ruled(stage: Stage, offer: BehaviorCandidates) -> BehaviorCandidates | None:
    """A rule's offer restricted to the channels that are not planned: alternatives that also move others are left
    out."""
    if offer.function and offer.function.given:
        return offer
    alternatives = tuple(
        alternative
        for alternative in offer.alternatives
        if all(stage.behaviors[movement.name].channel in RULED for movement in alternative.movements)
    )
    return replace(offer, alternatives=alternatives) if alternatives else None


def _of_moment(
    stage: Stage, utterance: Utterance, moment: Moment, offers: Sequence[BehaviorCandidates], level: Level
) -> BehaviorCandidates | None:
    lemmas = frozenset(
        token.lemma.lower() for token in utterance.parse.tokens if moment.first <= token.word <= moment.last
    )
    offered = dict(_offered(stage, moment, offers))
    shares = _shares(moment)
    worths: dict[str, float] = {}
    for family in moment.families:
        listed = _behaviors_of(stage.families, moment.channel, family)
        asking = {each.name for each in listed if each.lemmas}
        for name in fitting(listed, lemmas, level):
            worth = _worth(stage, moment.channel, shares, name) * (ASKED_BY_LEMMA if name in asking else 1.0)
            worths[name] = max(worths.get(name, 0.0), worth * (OFFERED if name in offered else 1.0))
    for name in offered:
        worths.setdefault(name, OFFERED * _worth(stage, moment.channel, shares, name))
    generator = random.Random(f"{stage.seed} {moment.id} {utterance.words[moment.stroke].text}")
    best = sorted(worths.items(), key=lambda item: (-item[1], item[0]))[:MOST_ALTERNATIVES]
    function = _function_at(moment, offers)
    alternatives = tuple(
        Alternative(
            (_movement(moment, name, *offered.get(name, (family_rule(moment.channel, moment.families[0]), function))),),
            weight=max(worth, 1e-3) ** STEEPNESS,
            lot=generator.uniform(0.9, 1.1),
        )
        for name, worth in best
        if worth > 0
    )
    return BehaviorCandidates(None, alternatives, moment) if alternatives else None


def _behaviors_of(families: Families, channel: Channel, family: str) -> tuple[FamilyBehavior, ...]:
    listed = _listed(families, channel)
    names = POINTINGS if family == POINT else (family,)
    return tuple(behavior for name in names for behavior in listed.get(name, ()))


def _listed(families: Families, channel: Channel) -> Mapping[str, tuple[FamilyBehavior, ...]]:
    by_channel = {
        Channel.GESTURE: families.gesture,
        Channel.HEAD: families.head,
        Channel.FACE: families.face,
        Channel.GAZE: families.gaze,
    }
    return by_channel[channel]


def _shares(moment: Moment) -> Mapping[str, float]:
    """The worth of each family at the moment."""
    shares: dict[str, float] = {}
    unsaid = tuple(LATER_CHOICE**place for place in range(len(moment.families)))
    for family, share in zip(moment.families, moment.shares or unsaid, strict=True):
        shares[merged(family)] = max(share, shares.get(merged(family), 0.0))
    return shares


def _worth(stage: Stage, channel: Channel, shares: Mapping[str, float], name: str) -> float:
    """The worth of a behaviour: for gestures, of all families it may be read as; for others, of its own kind alone."""
    if channel is not Channel.GESTURE:
        kinds = _listed(stage.families, channel)
        return max(
            (share for kind, share in shares.items() if any(each.name == name for each in kinds[kind])), default=0.0
        )
    shown = _all_merged(stage.families.shows.get(stage.behaviors[name].lexeme, ()))
    return sum((1.0 if not place else OTHER_FAMILY) * shares.get(family, 0.0) for place, family in enumerate(shown))


@lru_cache(maxsize=1024)
def _all_merged(families: tuple[str, ...]) -> tuple[str, ...]:
    """The families as named in plans, without duplicates."""
    return tuple(dict.fromkeys(map(merged, families)))


def _offered(
    stage: Stage, moment: Moment, offers: Sequence[BehaviorCandidates]
) -> Iterator[tuple[str, tuple[str, str | None]]]:
    """The behaviours that rules offer for functions on the stroke's word: name, rule and function, the most important
    function last."""
    for offer in offers:
        if offer.function is None or not offer.function.first <= moment.stroke <= offer.function.last:
            continue
        for alternative in offer.alternatives:
            for movement in alternative.movements:
                if stage.behaviors[movement.name].channel is moment.channel:
                    yield movement.name, (movement.rule, movement.function)


def _function_at(moment: Moment, offers: Sequence[BehaviorCandidates]) -> str | None:
    """The most important function on the stroke's word, which the moment shows too."""
    functions: list[Function] = [offer.function for offer in offers if offer.function is not None]
    on_word = [each for each in functions if each.first <= moment.stroke <= each.last]
    return max(on_word, key=lambda each: (each.priority, each.id)).id if on_word else None


def _movement(moment: Moment, name: str, rule: str, function: str | None) -> Movement:
    return Movement(
        name=name,
        first=moment.first,
        last=moment.last,
        priority=round(LEAST_PRIORITY + (PRIORITY_OF_SURE - LEAST_PRIORITY) * moment.importance, 1),
        rule=rule,
        function=function,
        stroke=moment.stroke,
        moment=moment.id,
    )
