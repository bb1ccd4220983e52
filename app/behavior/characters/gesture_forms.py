"""Applies the gesture library to the table's entries: durations of strokes, and the times needed between gestures.

The durations of strokes in the table are averages measured on people; a scheduled gesture has the stroke of its clip,
which is never time-warped (paper §3.8), or the last part of it if there is no time for the whole. If a gesture may take
several forms, the longest counts.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain

from ...loading import OnDemand
from ...model import Channel, Hand, Level
from ...model.figure import GestureManner
from ...model.limits import Forms, GestureTable
from ..table.behavior_table import BehaviorEntry, BriefGesture, PhaseDuration, Timing
from .overlays import Character, Characters


@dataclass(frozen=True, slots=True, eq=False)
class FormedCharacters:
    """All characters with the forms of their gestures at every level of agitation, each computed on first use."""

    characters: Characters
    formed: Mapping[tuple[str, Level], OnDemand[Character]]

    @classmethod
    def of(cls, characters: Characters, table: GestureTable) -> "FormedCharacters":
        return cls(
            characters,
            {
                (name, level): OnDemand(partial(with_forms, character, table, level))
                for name, character in characters.by_name.items()
                for level in Level
            },
        )

    def named(self, name: str, level: Level) -> Character:
        """Raises InputError `unknown_character`."""
        return self.formed[self.characters.named(name).name, level].get()


def with_forms(character: Character, table: GestureTable, level: Level) -> Character:
    """The character with the forms of its gestures at a level of agitation, in its own manner."""
    manner = character.figure.manner
    entries = {name: _with_forms(entry, table, level, manner) for name, entry in character.entries.items()}
    return replace(character, entries=entries)


def _with_forms(entry: BehaviorEntry, table: GestureTable, level: Level, manner: GestureManner) -> BehaviorEntry:
    found = table.of(entry.lexeme, level) if entry.channel is Channel.GESTURE else {}
    forms = {hand: tuple(form.in_manner(manner) for form in of_hand) for hand, of_hand in found.items()}
    if not forms:
        return entry
    entry = entry.at(level)
    longest_s = _briefest_s(_of_hands(forms, entry.hand))
    brief = {hand: tuple(form.within(longest_s) for form in of_hand) for hand, of_hand in forms.items()}
    return replace(
        entry,
        forms=forms,
        timing=stroke_timing(entry.timing, _of_hands(forms, entry.hand)),
        brief=BriefGesture(stroke_timing(_without_hold(entry.timing), _of_hands(brief, entry.hand)), brief),
    )


def _briefest_s(forms: Forms) -> float:
    """The least stroke duration in which any of the forms can be made; forms that take little longer than their brief
    ones are made whole."""
    longest_s = max(form.brief_stroke_s for form in forms)
    while (needed_s := max(form.stroke_within_s(longest_s) for form in forms)) > longest_s:
        longest_s = needed_s
    return longest_s


def _of_hands(forms: Mapping[Hand, Forms], hand: Hand | None) -> Forms:
    """The forms made by the hand; by either single hand if it is not decided."""
    hands = (Hand.LEFT, Hand.RIGHT) if hand is None else (hand,)
    return tuple(chain.from_iterable(forms.get(each, ()) for each in hands))


def stroke_timing(timing: Timing, forms: Forms) -> Timing:
    """The timing with a stroke as long as the longest of the forms."""
    before_s, after_s = max(form.before_s for form in forms), max(form.after_s for form in forms)
    stroke_s = before_s + after_s
    return replace(timing, stroke=PhaseDuration(stroke_s, stroke_s), emphasis=before_s / stroke_s)


def _without_hold(timing: Timing) -> Timing:
    """The timing with a hold that may be left out."""
    return replace(timing, hold=PhaseDuration(0.0, timing.hold.usual_s))
