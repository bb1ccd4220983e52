"""The candidate behaviours for each moment, among which timing, free hands and neighbours decide (paper §3.5).

Candidates come from the reading, as behaviours of the moment's families, and from the mapping rules, for functions of
the same words. The same behaviour from both is one candidate with two supports. Each has its worth in log-odds, with
the named parts of that sum.
"""

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from math import exp, log

from ...model import Alternative, BehaviorCandidates, Channel, Moment, Movement, Term, Utterance
from ..reading.conditions import lemmas_about
from ..reading.families import OTHER_FAMILY, POINT, POINTINGS, Families, FamilyBehavior, family_rule, fitting, merged
from ..reading.planning import Plan
from ..reading.player import Player
from ..reading.supports import Support, strongest, supports_of
from ..reading.worths import LineWorths, above_average

LATER_CHOICE = 0.4
"""The worth of each further choice in a director's note, relative to the previous one."""

ASKED_BY_LEMMA = Term("triggered by one of its words", 0.26)
"""What a word that asks for the very behaviour adds to its log-odds."""

USUAL_POINTING = Term("the usual way of pointing", 0.26)
"""What is added for a finger ahead, since the reading does not tell where a thing is."""

MOST_ALTERNATIVES = 6
STEEPNESS = 4.0
"""How much the better of two alternatives is preferred: weights are odds to this power."""

LEAST_ODDS = -9.0
"""What is less likely than this is no alternative."""

LEAST_BEHIND = 0.8
"""How far, in log-odds, a gesture may be behind the best of its moment to come in its place where that has no time or
hand: a hand that shows something else than is meant is worse than one that rests (chosen on held-out lines)."""

LEAST_PRIORITY, PRIORITY_OF_SURE = 2.0, 10.0
"""Priorities of moments with importance 0 and 1, on the scale of functions (rules/functions/priorities.yaml)."""

RULED = frozenset({Channel.GAZE, Channel.EYES, Channel.POSTURE})
"""The channels that mapping rules alone decide; hands, head and face are planned."""


def candidates_of(
    player: Player, utterance: Utterance, plan: Plan, offers: Sequence[BehaviorCandidates]
) -> tuple[BehaviorCandidates, ...]:
    """The candidates for every moment, and what rules offer on the channels that are not planned.

    Functions that the caller gave are shown on all channels, because the caller asked for them.
    """
    supports = tuple(supports_of(offers))
    planned = (_of_moment(player, utterance, moment, plan, supports) for moment in plan.moments)
    ruled = (_ruled(player, offer) for offer in offers)
    return tuple(each for each in (*planned, *ruled) if each is not None)


def _ruled(player: Player, offer: BehaviorCandidates) -> BehaviorCandidates | None:
    """A rule's offer restricted to the channels that are not planned: alternatives that also move others are left
    out."""
    if offer.function and offer.function.given:
        return offer
    alternatives = tuple(
        alternative
        for alternative in offer.alternatives
        if all(player.behaviors[movement.name].channel in RULED for movement in alternative.movements)
    )
    return replace(offer, alternatives=alternatives) if alternatives else None


def _of_moment(
    player: Player, utterance: Utterance, moment: Moment, plan: Plan, supports: Sequence[Support]
) -> BehaviorCandidates | None:
    offered = _offered(player, moment, supports)
    suiting = _suiting(player, utterance, moment, plan)
    rated = {
        name: _log_odds(player, moment, plan, name, offered.get(name))
        + sum(term.weight for term in suiting.get(name, ()))
        for name in (*suiting, *offered)
        if not player.banned(name, moment.first, moment.last)
    }
    behind = LEAST_BEHIND if _weighed(moment, plan) else -LEAST_ODDS
    generator = random.Random(f"{player.seed} {moment.id} {utterance.words[moment.stroke].text}")
    best = sorted(rated.items(), key=lambda item: (-item[1], item[0]))[:MOST_ALTERNATIVES]
    alternatives = tuple(
        Alternative(
            (
                _movement(
                    player, moment, name, support, _parts(player, moment, plan, name, support) + suiting.get(name, ())
                ),
            ),
            weight=exp(STEEPNESS * (odds - best[0][1])),
            lot=generator.uniform(0.9, 1.1),
        )
        for name, odds in best
        for support in (offered.get(name),)
        if odds > max(LEAST_ODDS, best[0][1] - behind)
    )
    return BehaviorCandidates(None, alternatives, moment) if alternatives else None


def _mimed(moment: Moment, plan: Plan) -> Iterator[str]:
    """The mimes of a verb at the moment's stroke."""
    worths = _weighed(moment, plan)
    if worths is not None:
        yield from (mime.name for (word, _lexeme), mime in worths.mimes.items() if word == moment.stroke)


def _suiting(player: Player, utterance: Utterance, moment: Moment, plan: Plan) -> dict[str, tuple[Term, ...]]:
    """The behaviours that suit the moment, of its families, of the gesture for which its stroke was taken and of its
    verb, each with what speaks for it beside its worth."""
    lemmas, usual = lemmas_about(utterance, moment), _usual_pointing(player.families)
    suiting: dict[str, tuple[Term, ...]] = {}
    for behaviors in _listings(player, moment, plan):
        asked = {each.name for each in behaviors if each.lemmas and each.fits(lemmas, utterance.level)}
        for name in fitting(behaviors, lemmas, utterance.level):
            suiting[name] = (ASKED_BY_LEMMA,) if name in asked else suiting.get(name, ())
    if usual in suiting:
        suiting[usual] = suiting[usual] or (USUAL_POINTING,)
    return suiting | dict.fromkeys(_mimed(moment, plan), ())


def _usual_pointing(families: Families) -> str | None:
    """How something is pointed at where neither words nor rules say where it is: as is listed first."""
    return next((each.name for family in POINTINGS for each in families.gesture.get(family, ())), None)


def _listings(player: Player, moment: Moment, plan: Plan) -> Iterator[Sequence[FamilyBehavior]]:
    """The behaviours of each of the moment's families, and those of the gesture for which its stroke was taken."""
    yield from (_behaviors_of(player.families, moment.channel, family) for family in moment.families)
    worths = _weighed(moment, plan)
    if worths is not None:
        best, own = worths.best(moment.stroke), player.behaviors
        listed = (each for family in player.families.gesture.values() for each in family if each.name in own)
        yield [each for each in listed if player.lexeme(each.name) == best]


def _weighed(moment: Moment, plan: Plan) -> LineWorths | None:
    """The plan's worths, if the moment is a gesture that they weighed."""
    planned = moment.channel is Channel.GESTURE and moment.note is None and moment.set_against is None
    return plan.worths if planned else None


def _log_odds(player: Player, moment: Moment, plan: Plan, name: str, support: Support | None) -> float:
    """The log-odds of a behaviour at a moment; from the plan's sum, if a gesture was weighed there."""
    worths = _weighed(moment, plan)
    odds = worths.of(moment.stroke, player.lexeme(name)) if worths else None
    if odds is not None:
        return odds
    worth = max(_worth(player, moment.channel, _shares(moment), name), 1e-6)
    return log(worth) + (support.log_odds if support else 0.0)


def _parts(player: Player, moment: Moment, plan: Plan, name: str, support: Support | None) -> tuple[Term, ...]:
    """The named parts of that, the largest first."""
    worths, lexeme = _weighed(moment, plan), player.lexeme(name)
    if worths and lexeme in worths.lexemes:
        return worths.parts(moment.stroke, lexeme)
    if support is None:
        return moment.terms
    counted = above_average(support)
    return (*(term for term in moment.terms if term.name != counted), *support.parts)


def behaviors_of(families: Families, moment: Moment) -> list[str]:
    """The names of all behaviours that show one of the moment's families."""
    return [each.name for family in moment.families for each in _behaviors_of(families, moment.channel, family)]


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


def _worth(player: Player, channel: Channel, shares: Mapping[str, float], name: str) -> float:
    """The worth of a behaviour: for gestures, of all families it may be read as; for others, of its own kind alone."""
    if channel is not Channel.GESTURE:
        kinds = _listed(player.families, channel)
        return max(
            (share for kind, share in shares.items() if any(each.name == name for each in kinds[kind])), default=0.0
        )
    shown = _all_merged(player.families.shows.get(player.lexeme(name), ()))
    return sum((1.0 if not place else OTHER_FAMILY) * shares.get(family, 0.0) for place, family in enumerate(shown))


@lru_cache(maxsize=1024)
def _all_merged(families: tuple[str, ...]) -> tuple[str, ...]:
    """The families as named in plans, without duplicates."""
    return tuple(dict.fromkeys(map(merged, families)))


def _offered(player: Player, moment: Moment, supports: Iterable[Support]) -> dict[str, Support]:
    """The behaviours that rules offer on the moment's channel for functions on the stroke's word, with the strongest
    support of each."""
    return strongest(
        each
        for each in supports
        if each.function.first <= moment.stroke <= each.function.last
        and player.behaviors[each.name].channel is moment.channel
    )


def _movement(player: Player, moment: Moment, name: str, support: Support | None, parts: tuple[Term, ...]) -> Movement:
    """The movement, with the rule and function that offered it if the offer had a part in its worth."""
    support = support if support and support.parts else None
    return Movement(
        name=name,
        first=moment.first,
        last=moment.last,
        priority=round(LEAST_PRIORITY + (PRIORITY_OF_SURE - LEAST_PRIORITY) * moment.importance, 1),
        rule=support.rule if support else family_rule(moment.channel, _family_of(player, moment, name)),
        function=support.function.id if support else None,
        stroke=moment.stroke,
        moment=moment.id,
        decided_by=tuple(sorted(parts, key=lambda part: -abs(part.weight))),
    )


def _family_of(player: Player, moment: Moment, name: str) -> str:
    """The first of the moment's families that a behaviour shows; of none, as mimes may be, the moment's first."""
    listed = ((family, _behaviors_of(player.families, moment.channel, family)) for family in moment.families)
    return next((family for family, shown in listed if any(each.name == name for each in shown)), moment.families[0])
