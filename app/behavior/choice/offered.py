"""What was offered, came near and is not shown, with what took its place or forbade it.

The mapping rules offer many behaviours for functions; most lose by far before hands and time are considered. The same
movement for the same idea from several offers is one candidate with several supports: a gesture on words that touch, a
kind of head movement or face in a stretch between marks. Told is what an author forbids, and what comes within `NEAR`
of what would have been enough: the worth of the gesture that has its place, else the price of a gesture; the threshold
of a kind. `lost_to` names the behaviour that has its place, `limit` what forbade it otherwise.
"""

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import inf, log

from ...model import Behavior, Channel, Interval, Limit, Moment, SyncPoints, Term, Word
from ..candidates.planned import behaviors_of
from ..reading.decoding import stretches_of
from ..reading.planning import Plan, Understood
from ..reading.player import Player
from ..reading.strokes import STROKES_APART_S
from ..reading.supports import Support, supports_of

NEAR = log(4)
"""What has at least a quarter of the odds that would have been enough came near."""

_PLANNED = frozenset({Channel.GESTURE, Channel.HEAD, Channel.FACE})
_OFFERED = ".offered"
_UNWEIGHED = "of no family that is scored (lexicon/acting/families.yaml)"


@dataclass(frozen=True, slots=True)
class _Candidate:
    """A movement over words `first` to `last`: of a moment that is not shown, or offered with `supports`, the strongest
    first."""

    name: str
    channel: Channel
    first: int
    last: int
    supports: tuple[Support, ...] = ()
    moment: Moment | None = None


@dataclass(frozen=True, slots=True)
class _Forms:
    """What makes two behaviours the same movement: the kind of a head movement or face, else the lexeme. `lexemes` are
    those of all behaviours of a form."""

    kinds: Mapping[str, str]
    by_name: Mapping[str, str]
    lexemes: Mapping[str, frozenset[str]]

    @classmethod
    def of(cls, player: Player) -> "_Forms":
        """The forms of the behaviours that a player has."""
        listed = {Channel.HEAD: player.families.head, Channel.FACE: player.families.face}
        kinds: dict[str, str] = {}
        for channel, families in listed.items():
            for name, kind in ((each.name, kind) for kind, shown in families.items() for each in shown):
                if name in player.behaviors and player.behaviors[name].channel is channel:
                    kinds.setdefault(name, kind)
        by_name = {name: kinds.get(name, entry.lexeme) for name, entry in player.behaviors.items()}
        lexemes = defaultdict[str, set[str]](set)
        for name, form in by_name.items():
            lexemes[form].add(player.behaviors[name].lexeme)
        return cls(kinds, by_name, {form: frozenset(names) for form, names in lexemes.items()})


@dataclass(frozen=True, slots=True)
class _Shown:
    """What candidates are beside: the plan and who plays it, the movements that are made for its moments, the words."""

    planned: Plan
    player: Player
    forms: _Forms
    winners: Sequence[Behavior]
    words: Sequence[Word]


@dataclass(frozen=True, slots=True)
class _CandidateWorth:
    """What a candidate is worth in log-odds and what would have been enough; `explained` gives the parts of the sum,
    the largest first, which most candidates do without."""

    worth: float
    enough: float
    explained: Callable[[], tuple[Term, ...]]


def not_taken(
    line: Understood, planned: Plan, player: Player, behaviors: Sequence[Behavior], *, near: float = NEAR
) -> tuple[Behavior, ...]:
    """The movements that rules offered for the line's functions, or that its moments were read as, that came `near`,
    and of which `behaviors`, the schedule, has nothing on their words; in order of their words."""
    forms = _Forms.of(player)
    offered = (each for each in _offered(line, player, forms) if not _is_scheduled(each, forms, behaviors))
    winners = [each for each in behaviors if each.kept and each.moment is not None]
    shown = _Shown(planned, player, forms, winners, line.utterance.words)
    told = (_told(each, shown, near) for each in (*_banned_moments(planned, player), *offered))
    in_order = sorted(filter(None, told), key=lambda each: (each.first, each.last, each.id))
    return tuple(replace(each, id=f"{each.kind}{_OFFERED}{number}") for number, each in enumerate(in_order, start=1))


def is_offered(behavior: Behavior) -> bool:
    """Whether it is one of `not_taken`, which was never in the schedule."""
    return _OFFERED in behavior.id


def _offered(line: Understood, player: Player, forms: _Forms) -> Iterator[_Candidate]:
    """What rules offer for hands, head and face, each movement once for an idea, about the strongest offer of it."""
    stretches = stretches_of([word.text for word in line.utterance.words])
    by_form: dict[tuple[Channel, str], list[Support]] = {}
    for support in supports_of(line.offers):
        entry = player.behaviors[support.name]
        if entry.channel in _PLANNED:
            by_form.setdefault((entry.channel, forms.by_name[support.name]), []).append(support)
    for (channel, _), supports in by_form.items():
        left = sorted(supports, key=lambda each: -each.log_odds)
        while left:
            first, last = left[0].function.first, left[0].function.last
            if channel is not Channel.GESTURE:
                first, last = next((each for each in stretches if each[0] <= first <= each[1]), (first, last))
            joined, left = _parted(left, first, last, channel)
            yield _Candidate(joined[0].name, channel, first, last, tuple(joined))


def _parted(
    supports: Iterable[Support], first: int, last: int, channel: Channel
) -> tuple[list[Support], list[Support]]:
    """Those whose words touch the words from `first` to `last`, and the others."""
    if channel is Channel.GESTURE:
        first, last = first - 1, last + 1
    touching, others = list[Support](), list[Support]()
    for each in supports:
        touches = each.function.first <= last and first <= each.function.last
        (touching if touches else others).append(each)
    return touching, others


def _is_scheduled(candidate: _Candidate, forms: _Forms, behaviors: Iterable[Behavior]) -> bool:
    """Whether the schedule has the movement on words that touch, kept or with its own reason why not."""
    same = forms.lexemes[forms.by_name[candidate.name]]
    return any(
        each.kind is candidate.channel
        and each.lexeme in same
        and each.rule is not None
        and each.first <= candidate.last + 1
        and candidate.first <= each.last + 1
        for each in behaviors
    )


def _banned_moments(planned: Plan, player: Player) -> Iterator[_Candidate]:
    """The planned moments for which everything that could show them is forbidden, or what was asked for always."""
    for moment in planned.moments:
        names = behaviors_of(player.families, moment)
        barred = [name for name in names if player.banned(name, moment.first, moment.last)]
        if barred and (moment.demanded or len(barred) == len(names)):
            yield _Candidate(barred[0], moment.channel, moment.first, moment.last, moment=moment)


def _told(candidate: _Candidate, shown: _Shown, near: float) -> Behavior | None:
    """The candidate as a behaviour with its time and the reason; None where none of its words is spoken, or it did not
    come near."""
    player, words = shown.player, shown.words
    heard = [word.interval for word in words[candidate.first : candidate.last + 1] if word.interval]
    if not heard:
        return None
    interval = Interval(heard[0].start_s, heard[-1].end_s)
    ban = player.banned(candidate.name, candidate.first, candidate.last)
    winner = None if ban else _in_its_place(candidate.channel, shown.winners, interval)
    weighed = _weighed(candidate, shown, winner)
    if ban is None and weighed.worth < weighed.enough - near:
        return None
    behavior = replace(_behavior(candidate, player, interval), decided_by=weighed.explained())
    if ban is not None:
        return replace(behavior, limit=Limit.NEVER, reason=ban.why)
    if winner is None:
        below = weighed.worth - weighed.enough
        why = f"scores too low there ({below:+.1f} log-odds)" if below > -inf else _UNWEIGHED
        return replace(behavior, limit=Limit.PRICE, reason=why + _also(candidate))
    beside = weighed.worth - weighed.enough
    worth = f"scores {beside:+.1f} log-odds" if beside > -inf else f"is {_UNWEIGHED}"
    why = f"{winner.lexeme} takes its place; this {worth}"
    return replace(behavior, lost_to=winner.id, reason=why + _also(candidate))


def _also(candidate: _Candidate) -> str:
    """The further offers of the movement."""
    rules = dict.fromkeys(each.rule for each in candidate.supports[1:])
    others = ", ".join(rule for rule in rules if rule != candidate.supports[0].rule)
    return f"; also offered by {others}" if others else ""


def _behavior(candidate: _Candidate, player: Player, interval: Interval) -> Behavior:
    entry, moment = player.behaviors[candidate.name], candidate.moment
    support = candidate.supports[0] if candidate.supports else None
    return Behavior(
        id=candidate.name,
        kind=entry.channel,
        lexeme=entry.lexeme,
        sync=SyncPoints(interval.start_s, interval.end_s),
        first=candidate.first,
        last=candidate.last,
        priority=support.function.priority if support else 0.0,
        rule=support.rule if support else f"{candidate.channel}_family_{moment.families[0]}" if moment else None,
        function=support.function.id if support else None,
        moment=moment.id if moment else None,
        kept=False,
    )


def _weighed(candidate: _Candidate, shown: _Shown, winner: Behavior | None) -> _CandidateWorth:
    """What the candidate is worth where it is worth most, and what would have been enough."""
    moment = candidate.moment
    if moment is not None:
        return _CandidateWorth(0.0, 0.0, lambda: moment.terms)
    if candidate.channel is Channel.GESTURE:
        weighed = _as_gesture(candidate, shown.planned, shown.player, winner)
    else:
        weighed = _as_kind(candidate, shown.planned, shown.forms.kinds.get(candidate.name))
    return weighed or _CandidateWorth(-inf, 0.0, lambda: candidate.supports[0].parts if candidate.supports else ())


def _as_gesture(
    candidate: _Candidate, planned: Plan, player: Player, winner: Behavior | None
) -> _CandidateWorth | None:
    worths, lexeme = planned.worths, player.lexeme(candidate.name)
    if worths is None or lexeme not in worths.lexemes:
        return None
    by_word = {word: worths.of(word, lexeme) or 0.0 for word in range(candidate.first, candidate.last + 1)}
    word = max(by_word, key=lambda each: by_word[each])
    stroke = next((each.stroke for each in planned.moments if winner and each.id == winner.moment), None)
    made = None if winner is None or stroke is None else worths.of(stroke, winner.lexeme)
    price = min(max(planned.price, 0.01), 0.99)
    enough = log(price / (1 - price)) if made is None else made
    return _CandidateWorth(by_word[word], enough, partial(worths.parts, word, lexeme))


def _as_kind(candidate: _Candidate, planned: Plan, kind: str | None) -> _CandidateWorth | None:
    """A head movement or face beside the threshold of its kind."""
    worths = planned.kinds.get(candidate.channel)
    if worths is None or kind is None or kind not in worths.kinds:
        return None
    margin, column = worths.margin(kind, candidate.first, candidate.last), worths.kinds.index(kind)
    word = max(range(candidate.first, candidate.last + 1), key=lambda each: float(worths.likely[each, column]))
    return _CandidateWorth(margin, 0.0, partial(worths.parts, kind, word))


def _in_its_place(channel: Channel, behaviors: Iterable[Behavior], interval: Interval) -> Behavior | None:
    """The kept behaviour of the same channel that is nearest in time, if it leaves no room for another."""
    apart_s = STROKES_APART_S if channel is Channel.GESTURE else 0.0
    near = [
        each
        for each in behaviors
        if each.kind is channel
        and each.sync.start < interval.end_s + apart_s
        and interval.start_s - apart_s < each.sync.end
    ]
    middle_s = (interval.start_s + interval.end_s) / 2
    return min(near, key=lambda each: (abs((each.sync.stroke or each.sync.start) - middle_s), each.id), default=None)
