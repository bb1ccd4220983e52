"""Which alternative shows each function, settled over the whole line (paper §3.4, §3.5).

The functions choose in order of priority, so that the most important have the clock, the hands and the character's
gestures a minute to themselves. Each takes the alternative with the smallest lot / (weight × suitability): luck by the
rules' weights, bent by how well an alternative suits what is there already (the paper's heuristics): wholly rather
than in part, at its usual length rather than shortened, with a gesture that joins the one before it rather than one
that just misses it. What may not be at all is the same gesture again within `REPEAT_S`, another hand within
`HAND_SWITCH_S`, and more gestures than the character makes: then the alternative goes without, or another is taken.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from math import inf

from ....model import Alternative, Behavior, BehaviorCandidates, Channel, Hand, Word
from ..characters.characters import Character
from ..timing.candidates import PlacedBehavior, asked, interval_of
from ..timing.conflicts import Fitted, Kept, fitted

REPEAT_S = 5.0
"""No gesture is made twice within this time, from stroke to stroke."""

PLANNED_REPEAT_S = 1.2
"""The same for planned gestures: directors have people deny twice what they deny twice."""

HAND_SWITCH_S = 2.0
"""The hand in use stays in use for this long, from stroke to stroke."""

HEAD_REPEAT_S = 2.0
"""A head movement, face or gaze again within this time is less suitable."""

IN_PART = 0.4
SHORTENED = 0.7
REPEATED = 0.5
MISSING_THE_UNIT = 0.5
UNIT_TOO_LONG = 0.3
HANDS_IDLE = 0.05
"""What an alternative is worth of a perfect one: see `_suitability`."""

EASILY_S = 1.0
"""What is said this long after the performance begins leaves time for any gesture."""

NEAR_UNIT_S = 1.0
"""A gesture that begins this soon after another is over could have joined it."""


@dataclass(frozen=True, slots=True)
class Line:
    """What the choice depends on besides the candidates: the timed words, who moves, and how many gestures."""

    timed: tuple[Word, ...]
    character: Character
    most_gestures: int


@dataclass(frozen=True, slots=True)
class _Attempt:
    """An alternative as it would go: all that is kept with it, its own part of that, and what it lost."""

    kept: Kept
    own: tuple[Fitted, ...]
    lost: tuple[Behavior, ...]


def choose(candidates: Iterable[BehaviorCandidates], line: Line) -> tuple[Kept, tuple[Behavior, ...]]:
    """What is done, and what was asked and is not, with the reasons; each function by one alternative at most."""
    kept: Kept = ()
    lost: list[Behavior] = []
    for offer in sorted(candidates, key=partial(_rank, line=line)):
        attempt = _best(offer, kept, line)
        kept = attempt.kept
        lost += attempt.lost
    return kept, tuple(lost)


def _rank(offer: BehaviorCandidates, line: Line) -> tuple[float, bool, tuple[float, int, int, str]]:
    """Of equal priority, those choose first for whose gestures there is time."""
    return -offer.priority, _is_hurried(offer, line), offer.rank


def _is_hurried(offer: BehaviorCandidates, line: Line) -> bool:
    """Whether a stroke of it would begin with the performance, for want of time."""
    _priority, first, _last, _id = offer.rank
    begun = [word for word in line.timed if word.index <= first]
    if begun and interval_of(begun[-1]).start_s >= EASILY_S:
        return False
    movements = (movement for alternative in offer.alternatives for movement in alternative.movements)
    placed = (asked(movement, line.character.entries[movement.name], line.timed, "") for movement in movements)
    return any(each.behavior.kind is Channel.GESTURE and each.behavior.sync.stroke_start == 0 for each in placed)


def _best(offer: BehaviorCandidates, kept: Kept, line: Line) -> _Attempt:
    """The attempt that wins; what the luckiest alternative lost is told with it."""
    lucky = sorted(offer.alternatives, key=_luck)
    first = best = _attempted(lucky[0], 0, kept, line)
    score = _score(lucky[0], first, line)
    for number, alternative in enumerate(lucky[1:], start=1):
        if _luck(alternative) >= score:
            break
        attempt = _attempted(alternative, number, kept, line)
        attempt_score = _score(alternative, attempt, line)
        if attempt_score < score:
            best, score = attempt, attempt_score
    if best is first:
        return best
    told = {_form(behavior) for behavior in (*best.lost, *(each.candidate.behavior for each in best.own))}
    # What lost to a part of the alternative that is not made lost to nothing that anybody could look up.
    unmade = {each.candidate.behavior.id for each in first.own}
    missed = (each for each in first.lost if _form(each) not in told and each.lost_to not in unmade)
    return replace(best, lost=(*best.lost, *missed))


def _luck(alternative: Alternative) -> float:
    return alternative.lot / alternative.weight


def _score(alternative: Alternative, attempt: _Attempt, line: Line) -> float:
    suitability = _suitability(attempt, line)
    return _luck(alternative) / suitability if suitability else inf


def _form(behavior: Behavior) -> tuple[Channel, str]:
    return behavior.kind, behavior.lexeme


def _attempted(alternative: Alternative, number: int, kept: Kept, line: Line) -> _Attempt:
    own: list[Fitted] = []
    lost: list[Behavior] = []
    for place, movement in enumerate(alternative.movements):
        name = f"{movement.moment or movement.function}.{number}.{place}"
        candidate = asked(movement, line.character.entries[movement.name], line.timed, name)
        outcome = _taken(with_hand(candidate, kept, line.character.handedness), kept, line)
        if isinstance(outcome, Fitted):
            own.append(outcome)
            kept = outcome.kept
        else:
            lost.append(outcome)
    return _Attempt(kept, tuple(own), tuple(lost))


def _taken(candidate: PlacedBehavior, kept: Kept, line: Line) -> Fitted | Behavior:
    behavior = candidate.behavior
    if not behavior.kept:
        return behavior
    if behavior.kind is Channel.GESTURE:
        gestures = [other.behavior for other in kept if other.behavior.kind is Channel.GESTURE]
        refused = _refused(behavior, gestures, line.most_gestures)
        if refused is not None:
            return refused
    return fitted(candidate, kept)


def _refused(behavior: Behavior, gestures: list[Behavior], most_gestures: int) -> Behavior | None:
    """The gesture as a loser where the character would not make it beside those it makes."""
    for other in gestures:
        apart_s = abs(_stroke_s(behavior) - _stroke_s(other))
        repeat_s = PLANNED_REPEAT_S if behavior.moment else REPEAT_S
        if other.lexeme == behavior.lexeme and apart_s < repeat_s:
            return _lost_to(other, behavior, f"{other.lexeme} is made already within {repeat_s:g} s")
        if _switches(behavior, other) and apart_s < HAND_SWITCH_S:
            return _lost_to(other, behavior, f"the other hand is in use for {other.lexeme}")
    if len(gestures) >= most_gestures:
        reason = f"beyond the character's gesture rate, which gives this line {most_gestures}"
        return replace(behavior, kept=False, reason=reason)
    return None


def _lost_to(winner: Behavior, behavior: Behavior, reason: str) -> Behavior:
    return replace(behavior, kept=False, lost_to=winner.id, reason=reason)


def _switches(one: Behavior, other: Behavior) -> bool:
    return one.hand is not other.hand and Hand.BOTH not in (one.hand, other.hand)


def with_hand(candidate: PlacedBehavior, kept: Kept, own_hand: Hand) -> PlacedBehavior:
    """A gesture that may take either hand takes the one in use about then, else the character's own."""
    behavior = candidate.behavior
    if behavior.kind is not Channel.GESTURE or behavior.hand is not None:
        return candidate
    near = [
        (abs(_stroke_s(other.behavior) - _stroke_s(behavior)), other.behavior.id, other.behavior.hand)
        for other in kept
        if other.behavior.kind is Channel.GESTURE and other.behavior.hand is not Hand.BOTH
    ]
    apart_s, _, hand = min(near, default=(inf, "", None))
    return replace(candidate, behavior=replace(behavior, hand=hand if hand and apart_s < HAND_SWITCH_S else own_hand))


def _suitability(attempt: _Attempt, line: Line) -> float:
    """How well an alternative suits what is there, in [0, 1]; 0 when nothing of it can be."""
    suitability = 1.0 if not attempt.lost else IN_PART * len(attempt.own) / (len(attempt.own) + len(attempt.lost))
    for each in attempt.own:
        behavior = each.candidate.behavior
        if each.shortened:
            suitability *= SHORTENED
        if behavior.kind is Channel.GESTURE:
            suitability *= _unity(behavior, attempt.kept, line.character.strokes_per_unit)
        elif any(_repeats(behavior, other.behavior) for other in attempt.kept):
            suitability *= REPEATED
    gestures = sum(other.behavior.kind is Channel.GESTURE for other in attempt.kept)
    with_gesture = any(each.candidate.behavior.kind is Channel.GESTURE for each in attempt.own)
    return suitability if with_gesture or gestures >= line.most_gestures else suitability * HANDS_IDLE


def _repeats(behavior: Behavior, other: Behavior) -> bool:
    if other.id == behavior.id or _form(other) != _form(behavior):
        return False
    return abs(other.sync.start - behavior.sync.start) < HEAD_REPEAT_S


def _unity(gesture: Behavior, kept: Kept, strokes_per_unit: int) -> float:
    """How well a gesture goes with its neighbours: alone or joined, in no longer a unit than the character's."""
    others = [other.behavior for other in kept if other.behavior.kind is Channel.GESTURE]
    strokes = 1 + sum(1 for _ in _joined_before(gesture, others)) + sum(1 for _ in _joined_after(gesture, others))
    if strokes > strokes_per_unit:
        return UNIT_TOO_LONG
    near = any(0 < gesture.sync.start - other.sync.end < NEAR_UNIT_S for other in others) or any(
        0 < other.sync.start - gesture.sync.end < NEAR_UNIT_S for other in others
    )
    return MISSING_THE_UNIT if near and strokes == 1 else 1.0


def _joined_before(gesture: Behavior, others: list[Behavior]) -> Iterator[Behavior]:
    for other in others:
        if other.sync.end == gesture.sync.start:
            yield other
            yield from _joined_before(other, others)


def _joined_after(gesture: Behavior, others: list[Behavior]) -> Iterator[Behavior]:
    for other in others:
        if other.sync.start == gesture.sync.end:
            yield other
            yield from _joined_after(other, others)


def _stroke_s(gesture: Behavior) -> float:
    return gesture.sync.stroke if gesture.sync.stroke is not None else gesture.sync.start
