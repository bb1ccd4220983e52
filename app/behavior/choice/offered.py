"""What was offered and is not shown, with what took its place or forbade it.

The mapping rules offer behaviours for functions, and the plan has moments; most of them lose before hands and time are
considered. Each is told once: `lost_to` names the behaviour that has its place, `limit` what forbade it otherwise.
"""

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

from ...model import Behavior, Channel, Function, Interval, Moment, SyncPoints, Term, Word
from ..candidates.planned import behaviors_of
from ..reading.decoding import STROKES_APART_S
from ..reading.planning import Plan, Understood
from ..reading.player import Player
from ..reading.supports import Support, strongest, supports_of

NEVER, PRICE = "never", "price"

_PLANNED = frozenset({Channel.GESTURE, Channel.HEAD, Channel.FACE})


_OFFERED = ".offered"


def not_taken(line: Understood, planned: Plan, player: Player, behaviors: Sequence[Behavior]) -> tuple[Behavior, ...]:
    """The behaviours that rules offered for the line's functions, or that its moments were read as, and of which
    `behaviors`, the schedule, has nothing; in order of their words."""
    words = line.utterance.words
    shown = {(each.kind, each.lexeme, each.function) for each in behaviors}
    found = [*_banned_moments(planned, player), *_offered(line, player, shown)]
    winners = [each for each in behaviors if each.kept and each.moment is not None]
    told = (_told(each, planned, player, winners, words) for each in found)
    in_order = sorted(filter(None, told), key=lambda each: (each.first, each.last, each.id))
    return tuple(replace(each, id=f"{each.kind}{_OFFERED}{number}") for number, each in enumerate(in_order, start=1))


def is_offered(behavior: Behavior) -> bool:
    """Whether it is one of `not_taken`, which was never in the schedule."""
    return _OFFERED in behavior.id


def _offered(
    line: Understood, player: Player, shown: Collection[tuple[Channel, str, str | None]]
) -> Iterator[Behavior]:
    """The offers of each function that are not in the schedule."""
    by_function: dict[str, list[Support]] = {}
    for support in supports_of(line.offers):
        by_function.setdefault(support.function.id, []).append(support)
    for supports in by_function.values():
        for support in strongest(supports).values():
            entry = player.behaviors[support.name]
            if entry.channel in _PLANNED and (entry.channel, entry.lexeme, support.function.id) not in shown:
                yield _behavior(support.name, player, support.function, support.rule, support.parts)


def _banned_moments(planned: Plan, player: Player) -> Iterator[Behavior]:
    """The planned moments for which everything that could show them is forbidden."""
    for moment in planned.moments:
        names = behaviors_of(player.families, moment)
        bans = [player.banned(name, moment.first, moment.last) for name in names]
        if names and all(bans):
            yield _behavior(names[0], player, moment, f"{moment.channel}_family_{moment.families[0]}", moment.terms)


def _behavior(name: str, player: Player, shown: Function | Moment, rule: str, parts: tuple[Term, ...]) -> Behavior:
    entry = player.behaviors[name]
    return Behavior(
        id=name,
        kind=entry.channel,
        lexeme=entry.lexeme,
        sync=SyncPoints(0.0, 0.0),
        first=shown.first,
        last=shown.last,
        priority=shown.priority if isinstance(shown, Function) else 0.0,
        rule=rule,
        function=shown.id if isinstance(shown, Function) else None,
        moment=shown.id if isinstance(shown, Moment) else None,
        kept=False,
        decided_by=parts,
    )


def _told(
    behavior: Behavior, planned: Plan, player: Player, winners: Sequence[Behavior], words: Sequence[Word]
) -> Behavior | None:
    """The behaviour with its time and the reason; None where none of its words is spoken."""
    heard = [word.interval for word in words[behavior.first : behavior.last + 1] if word.interval]
    if not heard:
        return None
    interval = Interval(heard[0].start_s, heard[-1].end_s)
    sync = SyncPoints(interval.start_s, interval.end_s)
    ban = player.banned(behavior.id, behavior.first, behavior.last)
    if ban is not None:
        return replace(behavior, sync=sync, limit=NEVER, reason=ban.why)
    own = _worth(behavior, planned)
    winner = _in_its_place(behavior, winners, interval)
    told = "" if own is None else f" ({own:+.1f} in log-odds)"
    if winner is None:
        return replace(behavior, sync=sync, limit=PRICE, reason=f"worth too little to be made there{told}")
    return replace(
        behavior, sync=sync, lost_to=winner.id, reason=f"{winner.lexeme} is worth more there than this{told}"
    )


def _worth(behavior: Behavior, planned: Plan) -> float | None:
    """The most that a gesture is worth on its words."""
    if planned.worths is None or behavior.kind is not Channel.GESTURE:
        return None
    worths = (planned.worths.of(word, behavior.lexeme) for word in range(behavior.first, behavior.last + 1))
    return max((each for each in worths if each is not None), default=None)


def _in_its_place(behavior: Behavior, behaviors: Iterable[Behavior], interval: Interval) -> Behavior | None:
    """The kept behaviour of the same channel that is nearest in time, if it leaves no room for another."""
    apart_s = STROKES_APART_S if behavior.kind is Channel.GESTURE else 0.0
    near = [
        each
        for each in behaviors
        if each.kind is behavior.kind
        and each.sync.start < interval.end_s + apart_s
        and interval.start_s - apart_s < each.sync.end
    ]
    middle_s = (interval.start_s + interval.end_s) / 2
    return min(near, key=lambda each: (abs((each.sync.stroke or each.sync.start) - middle_s), each.id), default=None)
