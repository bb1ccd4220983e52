"""Chooses which alternative shows each function, over the whole line (paper §3.4, §3.5).

The functions choose in order of priority, so that time, hands and the character's gesture rate go to the most important
first. Each takes the alternative with the smallest lot / (weight × suitability): a random draw by the rules' weights,
modified by how well the alternative suits what is already kept. A function with other means leaves the hands to nearby
functions that need them. How an alternative is tried is in `attempts.py`.

Suitability follows the paper's heuristics (§3.4): it prefers whole alternatives to parts, usual length to shortened,
gestures that join the one before to gestures that just miss it; it avoids repetition and switching hands.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from math import inf

from ...model import Alternative, Behavior, BehaviorCandidates, Channel
from ..timing.anchoring import asked, interval_of, words_before
from ..timing.conflicts import Kept
from ..timing.time_index import TimeIndex
from .attempts import Attempt, ChoiceContext, attempted, count_made, is_planned
from .hands import HAND_SWITCH_S, stroke_s, switches


def suitability(attempt: Attempt, line: ChoiceContext) -> float:
    """How well an alternative suits what is kept, in [0, 1]; 0 if no part of it fits."""
    suits = 1.0 if not attempt.lost else IN_PART * len(attempt.own) / (len(attempt.own) + len(attempt.lost))
    for each in attempt.own:
        behavior = each.candidate.behavior
        if each.shortened:
            suits *= SHORTENED
        if behavior.kind is Channel.GESTURE:
            suits *= _unity(behavior, attempt.kept, line.character.strokes_per_unit)
            suits *= _habit(behavior, attempt.kept)
        elif any(_repeats(behavior, other.behavior) for other in _begun_around(behavior, attempt.kept)):
            suits *= REPEATED
    with_gesture = any(each.candidate.behavior.kind is Channel.GESTURE for each in attempt.own)
    return suits if with_gesture or not has_idle_hands(attempt.kept, line) else suits * HANDS_IDLE


REPEAT_S = 5.0
"""A gesture repeated within this time, from stroke to stroke, is less suitable."""

HEAD_REPEAT_S = 2.0
"""A head movement, face or gaze repeated within this time is less suitable."""

IN_PART = 0.4
SHORTENED = 0.7
REPEATED = 0.5
HAND_SWITCHED = 0.3
MISSING_THE_UNIT = 0.5
UNIT_TOO_LONG = 0.3

HANDS_IDLE = 0.05
"""Factors on suitability, see `suitability`."""

NEAR_UNIT_S = 1.0
"""A gesture that begins this soon after the end of another could have joined it."""


def has_idle_hands(kept: TimeIndex, line: ChoiceContext) -> bool:
    """Whether the character usually gestures more than is kept."""
    return kept.gestures < line.most_gestures


def _begun_around(behavior: Behavior, kept: TimeIndex) -> Kept:
    return kept.near(behavior.sync.start - HEAD_REPEAT_S, behavior.sync.start + HEAD_REPEAT_S)


def _repeats(behavior: Behavior, other: Behavior) -> bool:
    if other.id == behavior.id or form(other) != form(behavior):
        return False
    return abs(other.sync.start - behavior.sync.start) < HEAD_REPEAT_S


def _habit(gesture: Behavior, kept: TimeIndex) -> float:
    """How well a gesture suits the others around it (paper §3.4: against inordinate switching of hands and repeating a
    gesture). The worth of planned gestures takes account of what was shown just before."""
    at_s = stroke_s(gesture)
    others = (each for each in kept.gestures_near(at_s - REPEAT_S, at_s + REPEAT_S) if each.id != gesture.id)
    apart = [(other, abs(at_s - stroke_s(other))) for other in others]
    repeated = not gesture.moment and any(
        other.lexeme == gesture.lexeme and apart_s < REPEAT_S for other, apart_s in apart
    )
    switched = any(switches(gesture, other) and apart_s < HAND_SWITCH_S for other, apart_s in apart)
    return (REPEATED if repeated else 1.0) * (HAND_SWITCHED if switched else 1.0)


def _unity(gesture: Behavior, kept: TimeIndex, strokes_per_unit: int) -> float:
    """How well a gesture suits its neighbours: single or joined, in units no longer than the character's."""
    strokes = 1 + sum(1 for _ in _joined_before(gesture, kept)) + sum(1 for _ in _joined_after(gesture, kept))
    if strokes > strokes_per_unit:
        return UNIT_TOO_LONG
    others = list(kept.gestures_near(gesture.sync.start - NEAR_UNIT_S, gesture.sync.end + NEAR_UNIT_S))
    near = any(0 < gesture.sync.start - other.sync.end < NEAR_UNIT_S for other in others) or any(
        0 < other.sync.start - gesture.sync.end < NEAR_UNIT_S for other in others
    )
    return MISSING_THE_UNIT if near and strokes == 1 else 1.0


def _joined_before(gesture: Behavior, kept: TimeIndex) -> Iterator[Behavior]:
    at_s = gesture.sync.start
    for other in kept.gestures_near(at_s - NEAR_UNIT_S, at_s + NEAR_UNIT_S):
        if other.sync.end == at_s:
            yield other
            yield from _joined_before(other, kept)


def _joined_after(gesture: Behavior, kept: TimeIndex) -> Iterator[Behavior]:
    at_s = gesture.sync.end
    for other in kept.gestures_near(at_s - NEAR_UNIT_S, at_s + NEAR_UNIT_S):
        if other.sync.start == at_s:
            yield other
            yield from _joined_after(other, kept)


def form(behavior: Behavior) -> tuple[Channel, str]:
    return behavior.kind, behavior.lexeme


HANDS_WANTED = 0.01
"""The factor on the suitability of an alternative that takes the hands from functions that can only use the hands."""

EASILY_S = 1.0
"""Words this long after the performance begins leave time to prepare any gesture."""

NEAR_WORDS = 3
"""Offers that begin within this many words of each other may need the hands at the same time."""


def choose(candidates: Iterable[BehaviorCandidates], line: ChoiceContext) -> tuple[Kept, tuple[Behavior, ...]]:
    """What is kept, and what was asked for and is not, with the reasons; at most one alternative for each function."""
    kept = TimeIndex()
    lost: list[Behavior] = []
    offers = sorted(candidates, key=partial(_rank, line=line))
    manual: dict[int, dict[int, BehaviorCandidates]] = {}
    for turn, offer in enumerate(offers):
        if not is_planned(offer) and _is_manual(offer, line):
            manual.setdefault(offer.rank[1], {})[turn] = offer
    for turn, offer in enumerate(offers):
        manual.get(offer.rank[1], {}).pop(turn, None)
        attempt = _best(offer, kept, line, () if is_planned(offer) else _near(offer, manual))
        kept = attempt.kept
        lost += attempt.lost
    return tuple(kept), tuple(lost)


def _is_manual(offer: BehaviorCandidates, line: ChoiceContext) -> bool:
    """Whether only the hands can show it."""
    return all(
        any(line.character.entries[movement.name].channel is Channel.GESTURE for movement in alternative.movements)
        for alternative in offer.alternatives
    )


def _rank(offer: BehaviorCandidates, line: ChoiceContext) -> tuple[float, bool, tuple[float, int, int, str]]:
    """Sort key: by priority; of equal ones, those choose first for whose gestures there is time."""
    return -offer.priority, _is_hurried(offer, line), offer.rank


def _is_hurried(offer: BehaviorCandidates, line: ChoiceContext) -> bool:
    """Whether one of its strokes would begin at 0 for lack of time."""
    _priority, first, _last, _id = offer.rank
    begun = words_before(line.timed, first + 1)
    if begun and interval_of(line.timed[begun - 1]).start_s >= EASILY_S:
        return False
    movements = (movement for alternative in offer.alternatives for movement in alternative.movements)
    entries = ((movement, line.character.entries[movement.name]) for movement in movements)
    placed = (asked(movement, entry, line.timed, "") for movement, entry in entries if entry.channel is Channel.GESTURE)
    return any(each.behavior.sync.stroke_start == 0 for each in placed)


def _best(
    offer: BehaviorCandidates, kept: TimeIndex, line: ChoiceContext, waiting: Sequence[BehaviorCandidates]
) -> Attempt:
    """The attempt that wins; what the luckiest alternative lost is reported with it. `waiting` are the offers
    nearby that are yet to choose and can only use the hands."""
    lucky = sorted(offer.alternatives, key=_luck)
    attempt_at = partial(attempted, offer, kept=kept, line=line)
    possible = count_made(waiting, kept, line)
    scored = partial(_score, line=line, waiting=waiting, possible=possible)
    first = best = attempt_at(lucky[0], 0)
    score, hands_idle = scored(lucky[0], first), has_idle_hands(kept, line)
    for number, alternative in enumerate(lucky[1:], start=1):
        if _luck(alternative) >= score:
            break
        if _luck(alternative) / most_suitable(alternative, line, hands_idle=hands_idle) >= score:
            continue
        attempt = attempt_at(alternative, number)
        attempt_score = scored(alternative, attempt)
        if attempt_score < score:
            best, score = attempt, attempt_score
    if best is first:
        return best
    told = {form(behavior) for behavior in (*best.lost, *(each.candidate.behavior for each in best.own))}
    # A loser to a part of the alternative that is not made after all would name a winner that does not exist.
    unmade = {each.candidate.behavior.id for each in first.own}
    missed = (each for each in first.lost if form(each) not in told and each.lost_to not in unmade)
    return replace(best, lost=(*best.lost, *missed))


def _luck(alternative: Alternative) -> float:
    return alternative.lot / alternative.weight


def _score(
    alternative: Alternative,
    attempt: Attempt,
    *,
    line: ChoiceContext,
    waiting: Sequence[BehaviorCandidates],
    possible: int,
) -> float:
    """The score of an attempt, the smaller the better; `possible` of the `waiting` could be made without it."""
    suits = suitability(attempt, line)
    if suits and count_made(waiting, attempt.kept, line) < possible:
        suits *= HANDS_WANTED
    return _luck(alternative) / suits if suits else inf


def _near(
    offer: BehaviorCandidates, waiting: Mapping[int, Mapping[int, BehaviorCandidates]]
) -> Sequence[BehaviorCandidates]:
    """The offers that may need the hands at the same time, in order of their turns; `waiting` has them by their first
    word and their turn."""
    first = offer.rank[1]
    words = range(first - NEAR_WORDS, first + NEAR_WORDS + 1)
    near = {turn: each for word in words for turn, each in waiting.get(word, {}).items()}
    return [near[turn] for turn in sorted(near)]


def most_suitable(alternative: Alternative, line: ChoiceContext, *, hands_idle: bool) -> float:
    """The upper bound of an alternative's suitability, given whether the character usually gestures more
    (`hands_idle`)."""
    entries = line.character.entries
    by_hand = any(entries[movement.name].channel is Channel.GESTURE for movement in alternative.movements)
    return HANDS_IDLE if hands_idle and not by_hand else 1.0
