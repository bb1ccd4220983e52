"""Checks a director's notes on a line and applies them to its plan (docs/directing.md).

A note decides about the channels for which it names kinds (`understudy.behavior.candidates.vocabulary`) and leaves the
others to the rules. There its moments replace the planned ones that overlap them. Notes are numbered from 0, as words
are.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, compress

from ...errors import InputError, did_you_mean, shown
from ...model import Avoidance, Behavior, Channel, DirectedMoment, Direction, Moment, Notice, RejectedAlternative, Term
from .vocabulary import ANYTHING, AVOIDABLE, HANDS, KINDS, NEUTRAL, STILL

FIELD = "direction"

WORDS_NEAR = 1
"""What is to be avoided on some words is to be avoided on their neighbours too: a stroke is visible that long."""

IMPORTANCE = (1, 3)
LISTENER = "listener"
DIRECTOR = "director"
"""The term that explains why a note's moment wins."""

_AT_REST = frozenset({STILL, NEUTRAL})


def check_direction(direction: Direction, *, words: int) -> None:
    """Raises InputError `direction_family` for a kind that is not in the vocabulary, `direction_span` for words that
    are not among the line's `words`, and `direction_importance`, with the note and its key. Only the first mistake is
    reported."""
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
    for demand in direction.demands:
        _check_words(demand.by.removeprefix("the note "), {"first": demand.first, "last": demand.last}, words)


def conflicts(direction: Direction) -> tuple[Notice, ...]:
    """Notices about contradictory notes, which say which of them is followed."""
    return (*_same_strokes(direction), *_stirred(direction), *_avoided_moments(direction))


def is_avoided(
    direction: Direction, word: int, families: Collection[str], *, channel: Channel = Channel.GESTURE
) -> bool:
    """Whether everything that a movement on `word` may be read as, its `families`, is to be avoided there or next to
    it."""
    return any(
        avoidance.first - WORDS_NEAR <= word <= avoidance.last + WORDS_NEAR and _covers(avoidance, families, channel)
        for avoidance in direction.avoid
    )


def directed(direction: Direction, moments: Sequence[Moment]) -> tuple[Moment, ...]:
    """The planned moments as changed by the notes, in order of their words.

    A note's moment outranks all planned ones and names its note; the moments it replaces are among its `rejected`.
    Families to be avoided are removed from planned moments, and moments without any left are dropped. Planned moments
    are also dropped where a note asks for rest, and all planned gestures if the notes are `complete`.
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
    """Notices about notes for which no movement was kept; a look at the listener needs none."""
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
    """The kinds a note asks for on a channel, the best first."""
    by_channel: Mapping[Channel, tuple[str, ...]] = {
        Channel.GESTURE: moment.gesture,
        Channel.HEAD: moment.head,
        Channel.FACE: moment.face,
        Channel.GAZE: moment.gaze,
    }
    return by_channel[channel]


@dataclass(frozen=True, slots=True)
class _Note:
    """What note `number` says about one channel; it is `at_rest` if its best kind is rest."""

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
    """The notes, channel by channel; of gestures on the same word only the one that is followed."""
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
    reason = f"replaced by the director's note {note.number}"
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
            RejectedAlternative(moment.families, moment.importance, reason)
            for moment in planned
            if note.displaces(moment)
        ),
        note=note.number,
    )


def _allowed(direction: Direction, moment: Moment) -> Moment | None:
    """The planned moment without the families to be avoided; None when none is left."""
    kept = [not _wrong(direction, moment.channel, moment, family) for family in moment.families]
    if all(kept):
        return moment
    families = tuple(compress(moment.families, kept))
    return replace(moment, families=families, shares=tuple(compress(moment.shares, kept))) if families else None


def _wrong(direction: Direction, channel: Channel, moment: Moment | DirectedMoment, family: str) -> bool:
    """Whether a family is to be avoided at the moment: a gesture at its stroke, all else on all of its words."""
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
    """Pairs of notes that want different gestures on the same word: the loser (less important, or later) and the
    winner."""
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
                yield Notice("direction_still", f"{message}the gesture of moments[{other}] is made anyway")


def _avoided_moments(direction: Direction) -> Iterator[Notice]:
    """Moments all of whose kinds are to be avoided on their own words; avoidances on neighbouring words are ignored."""
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
        listed = ", ".join(f"{key} {word}" for key, word in places.items())
        order = ", ".join(places)
        raise InputError("direction_span", f"{where}: {listed}: the order is {order}", field=FIELD)


def _check_kinds(where: str, asked: Sequence[str], known: Collection[str]) -> None:
    for kind in asked:
        if kind not in known:
            hint = did_you_mean(kind, known, otherwise=f"; known are {', '.join(sorted(known))}")
            raise InputError("direction_family", f"{where}: unknown {shown(kind)}{hint}", field=FIELD)
