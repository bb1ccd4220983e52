"""Decides which hand makes a gesture: the one in use, or another if that one has no time.

People keep to a hand for a while (paper §3.4: no inordinate switching), but where ideas crowd the other hand makes the
next gesture, and a gesture of both hands is made by one. Two hands do not make separate strokes at the same time. Times
are seconds, from stroke to stroke.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import inf
from types import MappingProxyType

from ...model import Behavior, Channel, Hand
from ...model.limits import Forms
from ..table.behavior_table import Timing
from ..timing.anchoring import PlacedBehavior
from ..timing.conflicts import REACH_S, FittedBehavior, compete, fitted
from ..timing.phases import Window, placed
from ..timing.time_index import TimeIndex

HAND_SWITCH_S = 2.0
"""The hand in use stays in use for this long."""

AT_ONCE_S = 0.25
"""Strokes within this time of each other, a syllable, are simultaneous."""

_SLACK_S = 1e-6

_OTHER: Mapping[Hand | None, Hand] = MappingProxyType({Hand.LEFT: Hand.RIGHT, Hand.RIGHT: Hand.LEFT})


def with_hand(candidate: PlacedBehavior, kept: TimeIndex, own_hand: Hand) -> PlacedBehavior:
    """The candidate with its hand: a gesture that may take either takes the one in use around then, else the
    character's own."""
    behavior = candidate.behavior
    if behavior.kind is not Channel.GESTURE or behavior.hand is not None:
        return candidate
    at_s = stroke_s(behavior)
    near = [
        (abs(stroke_s(other) - at_s), other.id, other.hand)
        for other in kept.gestures_near(at_s - HAND_SWITCH_S, at_s + HAND_SWITCH_S)
        if other.hand is not Hand.BOTH
    ]
    apart_s, _, hand = min(near, default=(inf, "", None))
    return replace(candidate, behavior=replace(behavior, hand=hand if hand and apart_s < HAND_SWITCH_S else own_hand))


def fitted_as_asked(
    candidate: PlacedBehavior, kept: TimeIndex, *, hand: Hand | None, by_either_hand: bool
) -> FittedBehavior | Behavior:
    """What a function or a director asks for among the kept, or its behaviour as a loser; `by_either_hand` allows
    another hand. `hand` is that of the table, None if it may be either."""
    same = made_already(candidate.behavior, kept)
    if same is not None:
        return lost_to(same, candidate.behavior, f"{same.lexeme} shows it already")
    return fitted_by_either_hand(candidate, kept, hand=hand) if by_either_hand else _fitted_alone(candidate, kept)


def fitted_by_either_hand(
    candidate: PlacedBehavior, kept: TimeIndex, *, hand: Hand | None
) -> FittedBehavior | Behavior:
    """The candidate among the kept, with its own hand or else the other, or beside a gesture of both hands that is
    reduced to one."""
    outcome = _fitted_alone(candidate, kept)
    for made, beside in _by_other_hands(candidate, kept, hand):
        if isinstance(outcome, FittedBehavior):
            return outcome
        by_other = _fitted_alone(made, beside)
        outcome = by_other if isinstance(by_other, FittedBehavior) else outcome
    return outcome


def made_already(gesture: Behavior, kept: TimeIndex) -> Behavior | None:
    """A kept gesture that is the same at the same time, or None."""
    return next((each for each in _at_once(gesture, kept) if each.lexeme == gesture.lexeme), None)


def lost_to(winner: Behavior, behavior: Behavior, reason: str) -> Behavior:
    return replace(behavior, kept=False, lost_to=winner.id, reason=reason)


def switches(one: Behavior, other: Behavior) -> bool:
    """Whether two gestures are made by different single hands."""
    return one.hand is not other.hand and Hand.BOTH not in (one.hand, other.hand)


def take_turns(one: Behavior, other: Behavior) -> bool:
    """Whether the earlier of two gestures is over when the later one has its stroke."""
    earlier, later = sorted((one, other), key=stroke_s)
    return earlier.sync.end <= stroke_s(later)


def stroke_s(gesture: Behavior) -> float:
    """The time of a gesture's stroke."""
    return gesture.sync.stroke if gesture.sync.stroke is not None else gesture.sync.start


def _fitted_alone(candidate: PlacedBehavior, kept: TimeIndex) -> FittedBehavior | Behavior:
    """The candidate among the kept, unless the other hand has a simultaneous stroke."""
    for other in _at_once(candidate.behavior, kept):
        if switches(other, candidate.behavior):
            return lost_to(other, candidate.behavior, f"the other hand is in use for {other.lexeme}")
    return fitted(candidate, kept)


def _at_once(gesture: Behavior, kept: TimeIndex) -> Iterator[Behavior]:
    if gesture.kind is Channel.GESTURE:
        at_s = stroke_s(gesture)
        gestures = kept.gestures_near(at_s - AT_ONCE_S, at_s + AT_ONCE_S)
        yield from (each for each in gestures if abs(stroke_s(each) - at_s) < AT_ONCE_S)


def _by_other_hands(
    candidate: PlacedBehavior, kept: TimeIndex, hand: Hand | None
) -> Iterator[tuple[PlacedBehavior, TimeIndex]]:
    """The candidate with the other hands that could make it, and what is then kept beside it."""
    own = candidate.behavior.hand
    if hand is None and own in _OTHER:
        yield _made_by(candidate, _OTHER[own]), kept
    if own is Hand.BOTH:
        yield from ((_made_by(candidate, each), kept) for each in _OTHER.values() if _makes_it_alone(each, candidate))
        return
    for each in (own,) if hand else (own, _OTHER[own]) if own in _OTHER else ():
        made = candidate if each is own else _made_by(candidate, _OTHER[own])
        yield from ((made, beside) for beside in _left_to_one_hand(made, kept))


def _made_by(gesture: PlacedBehavior, hand: Hand) -> PlacedBehavior:
    reason = f"with the {hand} hand, because there is no time for the usual one"
    return replace(gesture, behavior=replace(gesture.behavior, hand=hand, reason=reason))


def _left_to_one_hand(candidate: PlacedBehavior, kept: TimeIndex) -> Iterator[TimeIndex]:
    """What is kept if a gesture of both hands leaves one hand to the candidate."""
    free = _OTHER[candidate.behavior.hand]
    sync = candidate.behavior.sync
    for rival in kept.near(sync.start - 2 * REACH_S, sync.end + 2 * REACH_S):
        asked_for = rival.brief is not None and rival.behavior.hand is Hand.BOTH and _makes_it_alone(free, rival)
        if asked_for and compete(rival.behavior, candidate.behavior):
            by_one = fitted(_made_by(_at_its_usual_length(rival), free), kept.without(rival))
            if isinstance(by_one, FittedBehavior):
                yield by_one.kept


def _at_its_usual_length(gesture: PlacedBehavior) -> PlacedBehavior:
    """A gesture as it was before its neighbours shortened it."""
    sync = placed(gesture.basis, Window())
    return gesture if sync is None else replace(gesture, behavior=replace(gesture.behavior, sync=sync))


def _makes_it_alone(hand: Hand, gesture: PlacedBehavior) -> bool:
    """Whether one hand makes a gesture of both hands in the same time."""
    ways = [(gesture.forms, gesture.basis.timing)]
    if gesture.brief:
        ways.append((gesture.brief.forms, gesture.brief.timing))
    return all(_takes_no_longer(forms.get(hand, ()), timing) for forms, timing in ways)


def _takes_no_longer(forms: Forms, timing: Timing) -> bool:
    before_s = timing.emphasis * timing.stroke.usual_s + _SLACK_S
    after_s = (1 - timing.emphasis) * timing.stroke.usual_s + _SLACK_S
    return bool(forms) and all(form.before_s <= before_s and form.after_s <= after_s for form in forms)
