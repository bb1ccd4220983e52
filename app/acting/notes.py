"""A director's notes on a line: what is wrong with them, and what they leave of a plan (docs/directing.md).

A note speaks of the channels that it names kinds for (`understudy.acting.vocabulary`) and leaves the others to the
rules. Where it speaks it has the last word: its moments stand in place of the planned ones that overlap them on their
channel. Notes are numbered from 0, as words are.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from itertools import combinations, compress

from ..errors import LONGEST_SHOWN, InputError, shown
from ..model import Avoidance, Behavior, Channel, DirectedMoment, Direction, Moment, Notice, Rejected, Term
from .vocabulary import ANYTHING, AVOIDABLE, HANDS, KINDS, NEUTRAL, STILL

FIELD = "direction"

WORDS_NEAR = 1
"""What is wrong on some words is wrong on the words next to them: a stroke is seen that long."""

IMPORTANCE = (1, 3)
LISTENER = "listener"
DIRECTOR = "director"
"""The term that makes a note's moment win."""

_AT_REST = frozenset({STILL, NEUTRAL})


def check_direction(direction: Direction, *, words: int) -> None:
    """Raises InputError `direction_family` for what is in no vocabulary, `direction_span` for words that are not among
    the line's `words` and `direction_importance`, each with the note and its key; the first mistake is told."""
    for number, moment in enumerate(direction.moments):
        where = f"moments[{number}]"
        _check_words(where, {"first": moment.first, "stroke": moment.stroke, "last": moment.last}, words)
        for channel, kinds in KINDS.items():
            _check_kinds(f"{where}.{channel}", kinds_of(moment, channel), kinds)
        if not IMPORTANCE[0] <= moment.importance <= IMPORTANCE[1]:
            message = f"{where}.importance: {moment.importance}; it is 1 (nice), 2 or 3 (the line fails without it)"
            raise InputError("direction_importance", message, field=FIELD)
    for number, avoidance in enumerate(direction.avoid):
        where = f"avoid[{number}]"
        _check_words(where, {"first": avoidance.first, "last": avoidance.last}, words)
        _check_kinds(f"{where}.what", avoidance.what, AVOIDABLE)


def conflicts(direction: Direction) -> tuple[Notice, ...]:
    """What the notes say against each other, and which of them is followed."""
    return (*_same_strokes(direction), *_stirred(direction), *_avoided_moments(direction))


def is_avoided(
    direction: Direction, word: int, families: Collection[str], *, channel: Channel = Channel.GESTURE
) -> bool:
    """Whether all that a movement on `word` may be read as, its `families`, is to be avoided there or beside it."""
    return any(
        avoidance.first - WORDS_NEAR <= word <= avoidance.last + WORDS_NEAR and _covers(avoidance, families, channel)
        for avoidance in direction.avoid
    )


def directed(direction: Direction, moments: Sequence[Moment]) -> tuple[Moment, ...]:
    """The planned moments as the notes change them, in order of their words.

    A note's moment outranks all planned ones and names its note; what it displaced is among its `rejected`. Families to
    be avoided are taken out of planned moments, and those without any left go. Where a note asks for rest, and for the
    hands where the notes are `complete`, nothing planned stays.
    """
    planned = [left for moment in moments if (left := _allowed(direction, moment)) is not None]
    notes = list(_notes(direction))
    ranked_above = max((moment.importance for moment in moments), default=0.0)
    own = [_moment(note, direction, planned, ranked_above) for note in notes if not note.at_rest]
    kept = [moment for moment in planned if not any(note.displaces(moment) for note in notes)]
    if direction.complete:
        kept = [moment for moment in kept if moment.channel is not Channel.GESTURE]
    return tuple(sorted((*kept, *own), key=lambda moment: (moment.first, moment.stroke, moment.id)))


def unplayed_notes(moments: Iterable[Moment], behaviors: Iterable[Behavior]) -> tuple[Notice, ...]:
    """Which notes no movement that is kept carries out; a look at one who is looked at already needs none."""
    kept = {behavior.moment for behavior in behaviors if behavior.kept}
    return tuple(
        Notice(
            "direction_unplayed",
            f"note {moment.note}: no {moment.channel} for {moment.families[0]} fits on word {moment.stroke}",
        )
        for moment in moments
        if moment.note is not None and moment.id not in kept and moment.families[0] != LISTENER
    )


def kinds_of(moment: DirectedMoment, channel: Channel) -> tuple[str, ...]:
    """What a note asks of a channel, the best first."""
    by_channel: Mapping[Channel, tuple[str, ...]] = {
        Channel.GESTURE: moment.gesture,
        Channel.HEAD: moment.head,
        Channel.FACE: moment.face,
        Channel.GAZE: moment.gaze,
    }
    return by_channel[channel]


@dataclass(frozen=True, slots=True)
class _Note:
    """What the note `number` says of one channel; a channel whose best is rest is `at_rest`."""

    number: int
    moment: DirectedMoment
    channel: Channel
    kinds: tuple[str, ...]

    @property
    def at_rest(self) -> bool:
        return self.kinds[0] in _AT_REST

    def displaces(self, moment: Moment) -> bool:
        own = self.moment
        return moment.channel is self.channel and moment.first <= own.last and own.first <= moment.last


def _notes(direction: Direction) -> Iterator[_Note]:
    """All that the notes say, channel by channel; of gestures on the same word only the one that is followed."""
    outdone = {loser for loser, _winner in _rivals(direction)}
    for number, moment in enumerate(direction.moments):
        for channel in KINDS:
            kinds = kinds_of(moment, channel)
            if kinds and not (channel is Channel.GESTURE and number in outdone):
                yield _Note(number, moment, channel, kinds)


def _moment(note: _Note, direction: Direction, planned: Iterable[Moment], ranked_above: float) -> Moment:
    own = note.moment
    kinds = tuple(kind for kind in note.kinds if kind not in _AT_REST)
    wanted = tuple(kind for kind in kinds if not _wrong(direction, note.channel, own, kind))
    reason = f"the director's note {note.number} stands in its place"
    return Moment(
        id=f"note{note.number}.{note.channel}",
        channel=note.channel,
        first=own.first,
        last=own.last,
        stroke=own.stroke,
        families=wanted or kinds,
        importance=ranked_above + own.importance,
        terms=(Term(DIRECTOR, float(own.importance)),),
        rejected=tuple(
            Rejected(moment.families, moment.importance, reason) for moment in planned if note.displaces(moment)
        ),
        note=note.number,
    )


def _allowed(direction: Direction, moment: Moment) -> Moment | None:
    """The planned moment without what is to be avoided; None when nothing is left."""
    kept = [not _wrong(direction, moment.channel, moment, family) for family in moment.families]
    if all(kept):
        return moment
    families = tuple(compress(moment.families, kept))
    return replace(moment, families=families, shares=tuple(compress(moment.shares, kept))) if families else None


def _wrong(direction: Direction, channel: Channel, moment: Moment | DirectedMoment, family: str) -> bool:
    """Whether a family is to be avoided where the moment is seen: a gesture on its stroke, all else on every word."""
    if channel is Channel.GESTURE:
        return is_avoided(direction, moment.stroke, (family,))
    return any(
        moment.first <= avoidance.last and avoidance.first <= moment.last and _covers(avoidance, (family,), channel)
        for avoidance in direction.avoid
    )


def _covers(avoidance: Avoidance, families: Collection[str], channel: Channel) -> bool:
    if ANYTHING in avoidance.what or (channel is Channel.GESTURE and HANDS in avoidance.what):
        return True
    return bool(families) and set(families) <= set(avoidance.what)


def _rivals(direction: Direction) -> Iterator[tuple[int, int]]:
    """Notes that want another gesture on the same word: the one that loses, less important or later, and the winner."""
    gestural = [(number, moment) for number, moment in enumerate(direction.moments) if _gestures(moment)]
    for (first, one), (second, other) in combinations(gestural, 2):
        if one.stroke == other.stroke:
            yield (second, first) if one.importance >= other.importance else (first, second)


def _gestures(moment: DirectedMoment) -> bool:
    return bool(moment.gesture) and moment.gesture[0] not in _AT_REST


def _same_strokes(direction: Direction) -> Iterator[Notice]:
    for loser, winner in _rivals(direction):
        stroke = direction.moments[loser].stroke
        message = f"moments[{loser}] and moments[{winner}] both have their stroke on word {stroke}; "
        yield Notice("direction_strokes", f"{message}the gesture of moments[{winner}] is made")


def _stirred(direction: Direction) -> Iterator[Notice]:
    """Gestures asked for where another note wants the hands still."""
    for number, still in enumerate(direction.moments):
        if still.gesture[:1] != (STILL,):
            continue
        for other, moment in enumerate(direction.moments):
            if _gestures(moment) and still.first <= moment.stroke <= still.last:
                message = f"moments[{number}] keeps the hands still on words {still.first} to {still.last}; "
                yield Notice("direction_still", f"{message}the gesture of moments[{other}] is made all the same")


def _avoided_moments(direction: Direction) -> Iterator[Notice]:
    """Moments whose every kind is to be avoided on their very words; their neighbours' avoidances do not count."""
    for number, moment in enumerate(direction.moments):
        for channel in KINDS:
            kinds = [kind for kind in kinds_of(moment, channel) if kind not in _AT_REST]
            for place, avoidance in enumerate(direction.avoid):
                if kinds and avoidance.first <= moment.stroke <= avoidance.last and _covers(avoidance, kinds, channel):
                    message = f"moments[{number}] asks for the {channel} that avoid[{place}] is against; it is made"
                    yield Notice("direction_avoided", message)


def _check_words(where: str, places: Mapping[str, int], words: int) -> None:
    for key, word in places.items():
        if not 0 <= word < words:
            message = f"{where}.{key}: there is no word {word}; the line's words are 0 to {words - 1}"
            raise InputError("direction_span", message, field=FIELD)
    if list(places.values()) != sorted(places.values()):
        told = ", ".join(f"{key} {word}" for key, word in places.items())
        order = ", ".join(places)
        raise InputError("direction_span", f"{where}: {told}: the order is {order}", field=FIELD)


def _check_kinds(where: str, asked: Sequence[str], known: Collection[str]) -> None:
    for kind in asked:
        if kind not in known:
            close = get_close_matches(kind[:LONGEST_SHOWN], sorted(known), n=1)
            hint = f"did you mean {close[0]!r}?" if close else f"known are {', '.join(sorted(known))}"
            raise InputError("direction_family", f"{where}: unknown {shown(kind)}; {hint}", field=FIELD)
