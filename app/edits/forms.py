"""Replaces the movement, hand or size of a behaviour, and adds behaviours that were not chosen.

Every movement of the behaviour table is allowed. A replacement has its stroke where the replaced one had it; its phases
are as long as the table and the gesture library have them.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from ..behavior.characters.gesture_forms import stroke_timing
from ..behavior.characters.overlays import Character
from ..behavior.table.behavior_table import STROKED, BehaviorEntry
from ..behavior.timing.anchoring import asked
from ..behavior.timing.phases import TimingBasis, Window, placed, soonest, underway
from ..errors import did_you_mean
from ..model import Behavior, Channel, Hand, Movement, Notice, SyncPoints, Word
from ..model.edits import BehaviorEdit
from ..model.limits import Forms

PRIORITY = 10.0
"""As high as that of the most important moment of a plan."""


@dataclass(frozen=True, slots=True)
class ChangedBehavior:
    """The changed behaviour, None if it cannot be made, and notices about what could not be changed."""

    behavior: Behavior | None
    notices: tuple[Notice, ...] = ()


def added(edit: BehaviorEdit, number: int, word: int, words: Sequence[Word], character: Character) -> ChangedBehavior:
    """The behaviour that an edit describes, on a word."""
    lexeme = edit.lexeme or (edit.of.lexeme if edit.of else None) or ""
    entry = entry_of(character, edit.channel, lexeme, direction=edit.direction, hand=edit.hand)
    if entry is None:
        return ChangedBehavior(None, (_unknown(number, edit.channel, lexeme, character),))
    movement = Movement(entry.name, word, word, PRIORITY, "", None, stroke=word)
    made = asked(movement, entry, tuple(each for each in words if each.interval), f"edit.{number}").behavior
    if not made.kept:
        return ChangedBehavior(None, (unplayed(number, f"{made.reason}"),))
    hand, notices = _hand(edit.hand, entry, made, character, number)
    behavior = replace(made, hand=hand, direction=edit.direction or made.direction, edit=number)
    return ChangedBehavior(_sized(behavior, edit.amount), notices)


def formed(edit: BehaviorEdit, number: int, behavior: Behavior, character: Character) -> ChangedBehavior:
    """The behaviour with the edit applied; what cannot be applied leaves it unchanged."""
    lexeme = edit.lexeme or (edit.of.lexeme if edit.of and edit.lock else None) or behavior.lexeme
    direction = edit.direction or (None if lexeme != behavior.lexeme else behavior.direction)
    hand_asked = edit.hand or behavior.hand
    entry = entry_of(character, behavior.kind, lexeme, direction=direction, hand=hand_asked)
    mine = replace(behavior, priority=max(behavior.priority, PRIORITY), edit=number)
    if entry is None:
        return ChangedBehavior(_sized(mine, edit.amount), (_unknown(number, behavior.kind, lexeme, character),))
    hand, notices = _hand(edit.hand, entry, behavior, character, number)
    if (lexeme, hand, direction) != (behavior.lexeme, behavior.hand, behavior.direction):
        mine = _replaced(mine, entry, hand)
        mine = replace(mine, direction=direction or mine.direction)
    return ChangedBehavior(_sized(mine, edit.amount), notices)


def entry_of(
    character: Character, channel: Channel, lexeme: str, *, direction: str | None = None, hand: Hand | None = None
) -> BehaviorEntry | None:
    """The entry of the table with this lexeme, preferably also with this direction and hand."""
    entries = [each for each in character.entries.values() if (each.channel, each.lexeme) == (channel, lexeme)]

    def unlikeness(entry: BehaviorEntry) -> tuple[bool, bool]:
        return entry.direction != direction, entry.hand not in {None, hand}

    return min(entries, key=unlikeness, default=None)


def forms_of(behavior: Behavior, character: Character) -> Forms:
    """The forms of a gesture for the hand that makes it; other behaviours have none."""
    if behavior.kind is not Channel.GESTURE:
        return ()
    entry = entry_of(character, behavior.kind, behavior.lexeme, hand=behavior.hand)
    return entry.forms.get(behavior.hand or Hand.RIGHT, ()) if entry else ()


def unplayed(number: int, reason: str) -> Notice:
    """The notice that the behaviour of an edit is not made."""
    return Notice("edit_unplayed", f"behaviors[{number}]: not made: {reason}")


def _replaced(behavior: Behavior, entry: BehaviorEntry, hand: Hand | None) -> Behavior:
    forms = entry.forms.get(hand or Hand.RIGHT, ())
    timing = stroke_timing(entry.timing, forms) if forms else entry.timing
    sync, stroked = behavior.sync, entry.channel in STROKED
    until_s = sync.end if sync.relax is None else sync.relax
    struck_s = next(each for each in (sync.stroke, sync.ready, sync.start) if each is not None)
    ahead_s = (timing.alignment - timing.emphasis) * timing.stroke.usual_s if stroked else 0.0
    basis = TimingBasis(timing, max(0.0, struck_s + ahead_s), until_s, stroked)
    return replace(
        behavior,
        lexeme=entry.lexeme,
        hand=hand,
        sync=_timed(basis, entry.channel),
        target=entry.target or (behavior.target if entry.lexeme == behavior.lexeme else None),
        direction=entry.direction,
        amount=entry.amount if behavior.amount is None or entry.channel is Channel.GAZE else behavior.amount,
        repetitions=entry.repetitions if entry.lexeme != behavior.lexeme else behavior.repetitions,
        after_strokes_s=None,
    )


def _timed(basis: TimingBasis, channel: Channel) -> SyncPoints:
    """The phases; those for which there is no time before the stroke begin with the performance."""
    sync = placed(basis, Window())
    if sync is None:
        sync = placed(underway(basis) if channel is Channel.GESTURE else soonest(basis), Window())
    assert sync is not None, "what begins at 0 has room"
    return sync


def _hand(
    wanted: Hand | None, entry: BehaviorEntry, behavior: Behavior, character: Character, number: int
) -> tuple[Hand | None, tuple[Notice, ...]]:
    """The hand that makes it: the wanted one, else the table's, the former one or the one the character prefers."""
    if entry.channel is not Channel.GESTURE:
        return behavior.hand, ()
    usual = entry.hand or behavior.hand or character.handedness
    possible = [hand for hand in Hand if hand in entry.forms] or list(Hand)
    hand = wanted or usual
    if hand in possible:
        return hand, ()
    instead = usual if usual in possible else possible[0]
    message = f"behaviors[{number}]: {entry.lexeme} has no form for the {hand} hand; {instead} is used"
    return instead, ((Notice("edit_hand_unknown", message),) if wanted else ())


def _sized(behavior: Behavior, amount: float | None) -> Behavior:
    return behavior if amount is None else replace(behavior, amount=amount)


def _unknown(number: int, channel: Channel, lexeme: str, character: Character) -> Notice:
    known = sorted(set(_lexemes(character, channel)))
    message = f"behaviors[{number}]: no {channel} is called {lexeme!r}{did_you_mean(lexeme, known)}; "
    return Notice("edit_lexeme_unknown", f"{message}that part of the edit is left out")


def _lexemes(character: Character, channel: Channel) -> Iterator[str]:
    return (entry.lexeme for entry in character.entries.values() if entry.channel is channel)
