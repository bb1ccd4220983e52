"""Tries an alternative beside what is kept: which parts of it fit, with which hand, and what is shortened for it.

Planned moments, of which there are many more candidates than people make gestures, meet stricter conditions than what
is asked for: the hand is not switched within `HAND_SWITCH_S`, except to the hand that the gesture needs and after the
other one is done, and there are no more than the character usually makes.
(What was shown just before is a part of their worth.) What functions ask for by priority alone, or a director, is made
if there is time for it (paper §3.5), if necessary with the other hand. Where there is little time, both are made with a
smaller and shorter stroke.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace

from ...model import Alternative, Behavior, BehaviorCandidates, Channel, Hand, Limit, Word
from ..characters.overlays import Character
from ..reading.player import Ban
from ..timing.anchoring import PlacedBehavior, asked
from ..timing.conflicts import FittedBehavior, fitted
from ..timing.time_index import TimeIndex
from .hands import (
    HAND_SWITCH_S,
    fitted_as_asked,
    fitted_by_either_hand,
    lost_to,
    made_already,
    stroke_s,
    switches,
    take_turns,
    with_hand,
)
from .necessity import WEIGHT


@dataclass(frozen=True, slots=True)
class ChoiceContext:
    """What the choice depends on besides the candidates: the timed words, the character, the most gestures (usual and
    planned), the most that functions may ask for by their priority alone, and what is forbidden where."""

    timed: tuple[Word, ...]
    character: Character
    most_gestures: int
    most_asked: int
    bans: tuple[Ban, ...] = ()


@dataclass(frozen=True, slots=True)
class Attempt:
    """An alternative as it would be made: everything kept with it, its own part of that, and its behaviours that
    lost."""

    kept: TimeIndex
    own: tuple[FittedBehavior, ...]
    lost: tuple[Behavior, ...]


def attempted(
    offer: BehaviorCandidates, alternative: Alternative, number: int, *, kept: TimeIndex, line: ChoiceContext
) -> Attempt:
    """The attempt at one of the offer's alternatives, `number` in the order of their luck."""
    own: list[FittedBehavior] = []
    lost: list[Behavior] = []
    for place, movement in enumerate(alternative.movements):
        name = f"{movement.moment or movement.function}.{number}.{place}"
        entry = line.character.entries[movement.name]
        candidate = asked(movement, entry, line.timed, name, may_be_brief=True)
        candidate = with_hand(candidate, kept, line.character.handedness)
        outcome = _outcome(candidate, offer, kept, line, hand=entry.hand)
        if isinstance(outcome, FittedBehavior):
            own.append(outcome)
            kept = outcome.kept
        else:
            lost.append(outcome)
    return Attempt(kept, tuple(own), tuple(lost))


def _outcome(
    candidate: PlacedBehavior, offer: BehaviorCandidates, kept: TimeIndex, line: ChoiceContext, *, hand: Hand | None
) -> FittedBehavior | Behavior:
    """The candidate among the kept, or its behaviour as a loser; a director's notes are not limited by the character's
    rate. `hand` is that of the table."""
    planned = is_planned(offer)
    if not candidate.behavior.kept:
        return candidate.behavior
    if planned or offer.moment is None:
        switching = _refused_hand(candidate.behavior, kept, needs_hand=hand is not None) if planned else None
        refused = switching or _refused_rate(candidate.behavior, kept, line, planned=planned)
        if refused is not None:
            return refused
    if planned:
        return fitted(candidate, kept)
    return fitted_as_asked(candidate, kept, hand=hand, by_either_hand=_is_worth_a_hand(offer))


def count_made(offers: Iterable[BehaviorCandidates], kept: TimeIndex, line: ChoiceContext) -> int:
    """How many of the offers that need the hands can be made one after the other, or are made already, beside the
    kept."""
    count = 0
    for offer in offers:
        with_it = next((made for each in offer.alternatives if (made := _with_gesture(each, kept, line))), None)
        kept = with_it or kept
        count += with_it is not None
    return count


def is_planned(offer: BehaviorCandidates) -> bool:
    """Whether it comes from the plan, rather than from a function's priority alone or a director."""
    return offer.moment is not None and offer.moment.note is None and not offer.moment.demanded


def _is_worth_a_hand(offer: BehaviorCandidates) -> bool:
    """Whether the other hand may be used for it: not for functions that only give weight."""
    return offer.function is None or offer.function.class_name not in WEIGHT


def _with_gesture(alternative: Alternative, kept: TimeIndex, line: ChoiceContext) -> TimeIndex | None:
    """What is kept with the gesture of an alternative that is asked for; None where it cannot be made."""
    for movement in alternative.movements:
        entry = line.character.entries[movement.name]
        candidate = asked(movement, entry, line.timed, "", may_be_brief=True)
        candidate = with_hand(candidate, kept, line.character.handedness)
        if entry.channel is Channel.GESTURE and candidate.behavior.kept:
            if made_already(candidate.behavior, kept) is not None:
                return kept
            outcome = fitted_by_either_hand(candidate, kept, hand=entry.hand)
            return outcome.kept if isinstance(outcome, FittedBehavior) else None
    return None


def _refused_hand(gesture: Behavior, kept: TimeIndex, *, needs_hand: bool) -> Behavior | None:
    """The gesture as a loser, if the character would not change hands for it, else None. What only one hand can show,
    as to the left with the left, is shown by it once the other hand is done."""
    if gesture.kind is not Channel.GESTURE:
        return None
    at_s = stroke_s(gesture)
    for other in kept.gestures_near(at_s - HAND_SWITCH_S, at_s + HAND_SWITCH_S):
        near = switches(gesture, other) and abs(at_s - stroke_s(other)) < HAND_SWITCH_S
        if near and not (needs_hand and take_turns(gesture, other)):
            return lost_to(other, gesture, f"the other hand is in use for {other.lexeme}")
    return None


def _refused_rate(gesture: Behavior, kept: TimeIndex, line: ChoiceContext, *, planned: bool) -> Behavior | None:
    """The gesture as a loser, if the character already makes as many as it does; else None."""
    most = line.most_gestures if planned else line.most_asked
    if gesture.kind is Channel.GESTURE and kept.gestures >= most:
        reason = f"beyond the character's gesture rate, which gives this line {most}"
        return replace(gesture, kept=False, limit=Limit.RATE, reason=reason)
    return None
