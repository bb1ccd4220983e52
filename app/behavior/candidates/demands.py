"""What comes always, and what never: an author's word, above all worths.

A mapping rule, a character or a note may demand a behaviour, a lexeme or a family, or forbid these or a channel.
What is demanded has its place before anything else is chosen, and is shown wherever time and hands allow; what is
forbidden is no candidate, and what nobody asked for does not come either.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain

from ...errors import InputError, did_you_mean, shown
from ...model import Alternative, BehaviorCandidates, Channel, Demand, Moment, Movement, Term, Utterance
from ..reading.decoding import BOTH_AT_ONCE
from ..reading.families import Families, Playable, family_rule, fitting
from ..reading.player import Ban, Player
from ..reading.strokes import STROKES_APART_S
from ..reading.supports import Support
from .vocabulary import ANYTHING, BANNABLE, HANDS

ALWAYS = "always"
PRIORITY = 1000.0
"""Above every function's, so that what is demanded is placed first."""

DEMANDED_LOG_ODDS = 99.0
"""What the author's word is told to weigh."""

STEEPNESS = 10.0
"""How many times as much each behaviour of what is asked for weighs as the next."""

_CHANNELS = frozenset({*Channel, HANDS, ANYTHING})


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


def wherever_offered(names: Iterable[str], supports: Iterable[Support], player: Player, by: str) -> Iterator[Demand]:
    """The demands of a character who always shows these wherever a rule offers them: behaviours, or of a lexeme, family
    or channel the behaviour of a function that is offered most strongly."""
    offered = tuple(supports)
    for what in names:
        wanted = {what} if what in player.behaviors else meant(what, player.families, player.behaviors)
        best: dict[str, Support] = {}
        for support in (each for each in offered if each.name in wanted):
            so_far = best.get(support.function.id)
            if so_far is None or support.log_odds > so_far.log_odds:
                best[support.function.id] = support
        for key, support in best.items():
            yield Demand(support.name, support.function.first, support.function.last, True, by, key)


def check_demands(demands: Iterable[Demand], families: Families, behaviors: Mapping[str, Playable]) -> None:
    """Raises InputError `direction_family` for what notes ask for or forbid that is nothing known, or that is a channel
    and is to come always, since a channel does not say which movement."""
    for demand in demands:
        if demand.always and demand.what in _CHANNELS:
            message = f"{demand.by}: {shown(demand.what)} does not say which movement; name a behaviour or family"
            raise InputError("direction_family", message, field="direction")
        if not meant(demand.what, families, behaviors) and not meant(demand.what.upper(), families, behaviors):
            known = did_you_mean(demand.what, {*behaviors, *BANNABLE})
            message = f"{demand.by}: there is no behaviour, lexeme or family {shown(demand.what)}{known}"
            raise InputError("direction_family", f"{message}; docs/behaviors.md has them", field="direction")


def demanded(player: Player, demands: Iterable[Demand], utterance: Utterance) -> tuple[BehaviorCandidates, ...]:
    """The candidates that the demands ask for, each a moment of its own; nothing that is forbidden there."""
    found = ((demand, _allowed(player, demand, utterance)) for demand in _asked(demands))
    return tuple(_candidates(player, demand, names) for demand, names in found if names)


def overruled(player: Player, demands: Iterable[Demand], utterance: Utterance) -> Iterator[Moment]:
    """The moments of what is asked for always though all that would show it is forbidden there."""
    for demand in _asked(demands):
        names = _named(player, demand, utterance)
        if names and not _allowed(player, demand, utterance):
            yield _moment(player, demand, names[0])


def _asked(demands: Iterable[Demand]) -> tuple[Demand, ...]:
    """What is to come always, each once: several functions of the same words may ask for it."""
    found: dict[tuple[str, int, int], Demand] = {}
    for demand in demands:
        if demand.always:
            found.setdefault((demand.what, demand.first, demand.last), demand)
    return tuple(found.values())


def _allowed(player: Player, demand: Demand, utterance: Utterance) -> tuple[str, ...]:
    names = _named(player, demand, utterance)
    return tuple(name for name in names if not player.banned(name, demand.first, demand.last))


def _named(player: Player, demand: Demand, utterance: Utterance) -> tuple[str, ...]:
    """The behaviours that show what is asked for, the best first: that of the name, those of a family that suit the
    words, or those of the lexeme."""
    if demand.what in player.behaviors:
        return (demand.what,)
    families = player.families
    listed = families.gesture.get(demand.what) or families.kinds.get(demand.what, ())
    words = range(demand.first, demand.last + 1)
    lemmas = frozenset(token.lemma.lower() for token in utterance.parse.tokens if token.word in words)
    lexeme = demand.what.upper()
    return fitting(listed, lemmas, utterance.level) or tuple(
        name for name, entry in player.behaviors.items() if entry.lexeme == lexeme
    )


def _candidates(player: Player, demand: Demand, names: Sequence[str]) -> BehaviorCandidates:
    """The first of these behaviours, or the next where that has no time or hand."""
    moment = _moment(player, demand, names[0])
    weights = (STEEPNESS**-place for place in range(len(names)))
    alternatives = (
        Alternative((_movement(demand, name, moment),), weight, 1.0)
        for name, weight in zip(names, weights, strict=True)
    )
    return BehaviorCandidates(None, tuple(alternatives), moment)


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
    """The lexemes that an audience reads as a family of gestures first, and those of the behaviours of a kind, also
    where it goes with another."""
    first = {lexeme for lexeme, shown in families.shows.items() if shown[0] == what}
    kinds = (what, *(kind for kind, parts in BOTH_AT_ONCE.items() if what in parts))
    listed = chain.from_iterable(families.kinds.get(kind, ()) for kind in kinds)
    return first | {behaviors[each.name].lexeme for each in listed}


def _moment(player: Player, demand: Demand, name: str) -> Moment:
    return Moment(
        id=f"{ALWAYS}.{demand.what}.{demand.first}.{demand.last}",
        channel=player.behaviors[name].channel,
        first=demand.first,
        last=demand.last,
        stroke=demand.last,
        families=_read_as(player, name),
        importance=1.0,
        terms=(Term(f"required by {demand.by}", DEMANDED_LOG_ODDS),),
        demanded=True,
    )


def _read_as(player: Player, name: str) -> tuple[str, ...]:
    """The families or the kind that a behaviour shows; its own name where there is none."""
    families, entry = player.families, player.behaviors[name]
    if entry.channel is Channel.GESTURE:
        return families.shows.get(entry.lexeme, (name,))
    kinds = (kind for kind, listed in families.kinds.items() if any(each.name == name for each in listed))
    return (next(kinds, name),)


def _movement(demand: Demand, name: str, moment: Moment) -> Movement:
    rule = demand.by.removeprefix("rule ") if demand.by.startswith("rule ") else family_rule(moment.channel, ALWAYS)
    return Movement(
        name=name,
        first=demand.first,
        last=demand.last,
        priority=PRIORITY,
        rule=rule,
        function=demand.function,
        moment=moment.id,
        decided_by=moment.terms,
    )
