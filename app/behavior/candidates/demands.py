"""What comes always, and what never: an author's word, above all worths.

A mapping rule, a character or a note may demand a behaviour, or forbid a behaviour, a lexeme, a family or a channel.
What is demanded has its place before anything else is chosen, and is shown wherever time and hands allow; what is
forbidden is no candidate, and what nobody asked for does not come either.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain

from ...errors import InputError, did_you_mean, shown
from ...model import Alternative, BehaviorCandidates, Channel, Demand, Moment, Movement, Term
from ..reading.families import Families, Playable, family_rule
from ..reading.player import Ban, Player
from ..reading.strokes import STROKES_APART_S
from ..reading.supports import Support
from .vocabulary import ANYTHING, HANDS

ALWAYS = "always"
PRIORITY = 1000.0
"""Above every function's, so that what is demanded is placed first."""

DEMANDED_LOG_ODDS = 99.0
"""What the author's word is told to weigh."""


def meant(what: str, families: Families, behaviors: Mapping[str, Playable]) -> frozenset[str]:
    """The behaviours that a word of the author forbids: those with the lexeme of a behaviour, of a lexeme, of a family
    or kind, of a channel, or all; none where no such thing is known."""
    if what == ANYTHING:
        return frozenset(behaviors)
    channel = Channel.GESTURE if what == HANDS else next((each for each in Channel if each == what), None)
    if channel is not None:
        return frozenset(name for name, entry in behaviors.items() if entry.channel is channel)
    lexemes = {what} | _lexemes_of(what, families, behaviors)
    if what in behaviors:
        lexemes.add(behaviors[what].lexeme)
    return frozenset(name for name, entry in behaviors.items() if entry.lexeme in lexemes)


def banned_by(demands: Iterable[Demand], families: Families, behaviors: Mapping[str, Playable]) -> Iterator[Ban]:
    """What the demands forbid."""
    for demand in demands:
        if not demand.always:
            yield Ban(demand.first, demand.last, meant(demand.what, families, behaviors), f"excluded by {demand.by}")


def wherever_offered(names: Iterable[str], supports: Iterable[Support], by: str) -> Iterator[Demand]:
    """The demands of a character who always shows these behaviours where a rule offers them."""
    wanted = frozenset(names)
    for support in supports:
        if support.name in wanted:
            function = support.function
            yield Demand(support.name, function.first, function.last, always=True, by=by, function=function.id)


def named(demands: Iterable[Demand], behaviors: Mapping[str, Playable]) -> Iterator[Demand]:
    """The demands, each with the name of a behaviour where a note asks for its lexeme; raises InputError
    `direction_family` for what is always to come and is neither."""
    for demand in demands:
        if not demand.always or demand.what in behaviors:
            yield demand
            continue
        shows = [name for name, entry in behaviors.items() if entry.lexeme == demand.what.upper()]
        if not shows:
            known = did_you_mean(demand.what, behaviors)
            message = f"{demand.by}: there is no behaviour {shown(demand.what)}{known}; docs/behaviors.md has them"
            raise InputError("direction_family", message, field="direction")
        yield replace(demand, what=shows[0])


def demanded(player: Player, demands: Iterable[Demand]) -> tuple[BehaviorCandidates, ...]:
    """The candidates that the demands ask for, each a moment of its own; nothing that is forbidden there."""
    wanted = dict.fromkeys(each for each in demands if each.always)
    return tuple(
        BehaviorCandidates(None, (Alternative((_movement(demand, moment),), 1.0, 1.0),), moment)
        for demand in wanted
        if not player.banned(demand.what, demand.first, demand.last)
        for moment in (_moment(player, demand),)
    )


def permitted(candidates: Iterable[BehaviorCandidates], player: Player) -> tuple[BehaviorCandidates, ...]:
    """The candidates without the movements that are forbidden on their words."""
    if not player.bans:
        return tuple(candidates)
    left = (replace(each, alternatives=tuple(_permitted(each, player))) for each in candidates)
    return tuple(each for each in left if each.alternatives)


def _permitted(offer: BehaviorCandidates, player: Player) -> Iterator[Alternative]:
    for alternative in offer.alternatives:
        movements = tuple(each for each in alternative.movements if not player.banned(each.name, each.first, each.last))
        if movements:
            yield replace(alternative, movements=movements)


def kept_free(demanded: Iterable[BehaviorCandidates], times_s: Sequence[float]) -> list[int]:
    """The words on which no further stroke has time beside the gestures that are demanded."""
    spans = [each.moment for each in demanded if each.moment and each.moment.channel is Channel.GESTURE]
    return [
        word
        for word, time_s in enumerate(times_s)
        if any(times_s[each.first] - STROKES_APART_S < time_s < times_s[each.last] + STROKES_APART_S for each in spans)
    ]


def beside(moments: Iterable[Moment], demanded: Sequence[BehaviorCandidates]) -> tuple[Moment, ...]:
    """The planned moments without those of head, face and gaze on the words for which another is demanded."""
    asked = [each.moment for each in demanded if each.moment]
    return tuple(
        moment
        for moment in moments
        if moment.channel is Channel.GESTURE
        or not any(
            each.channel is moment.channel and each.first <= moment.last and moment.first <= each.last for each in asked
        )
    )


def _lexemes_of(what: str, families: Families, behaviors: Mapping[str, Playable]) -> set[str]:
    """The lexemes that an audience reads as a family of gestures first, and those of the behaviours of a kind."""
    first = {lexeme for lexeme, shown in families.shows.items() if shown[0] == what}
    listed = chain(*(kinds.get(what, ()) for kinds in (families.head, families.face, families.gaze)))
    return first | {behaviors[each.name].lexeme for each in listed}


def _moment(player: Player, demand: Demand) -> Moment:
    entry = player.behaviors[demand.what]
    shown = player.families.shows.get(entry.lexeme, (demand.what,))
    return Moment(
        id=f"{ALWAYS}.{demand.what}.{demand.first}",
        channel=entry.channel,
        first=demand.first,
        last=demand.last,
        stroke=demand.last,
        families=shown,
        importance=1.0,
        terms=(Term(f"required by {demand.by}", DEMANDED_LOG_ODDS),),
        demanded=True,
    )


def _movement(demand: Demand, moment: Moment) -> Movement:
    rule = demand.by.removeprefix("rule ") if demand.by.startswith("rule ") else family_rule(moment.channel, ALWAYS)
    return Movement(
        name=demand.what,
        first=demand.first,
        last=demand.last,
        priority=PRIORITY,
        rule=rule,
        function=demand.function,
        moment=moment.id,
        decided_by=moment.terms,
    )
