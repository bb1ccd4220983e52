"""Builds each arm's timeline: gesture units, the rests between them, and absolute times of all phases.

A gesture that blends into the next is held until the transition is as fast as the next stroke (paper §3.8); otherwise
the arm returns to rest. A preparation from rest takes its natural time, more for long ways, less if there is less time;
the pre-stroke hold is shortened first. Where it is asked when a way begins or ends, the hand is slower or faster on it
within limits, and holds for the rest of the time. Both arms of a unit take the same rest pose after it.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import inf

from ...model import Hand
from ...model.figure import Wait
from ..arms.rest_poses import WAITS
from ..arms.wrist_paths import relax_m, stroke_start_m
from ..gestures.gesture import Markers
from ..gestures.gesture_plan import ArmGesture, ArmRest, PlacedGesture
from .rests import (
    AT_SIDE,
    SHORTEST_REST_S,
    SHORTEST_RETRACTION_S,
    RestChange,
    change_s,
    posture_pose,
    preparation_s,
    rest_way_m,
    shortest_way_s,
)
from .transitions import TransitionContext, blends, in_same_unit, natural_preparation_s, prolonged_relax_s

SHORTEST_STAY_S = 1.0
"""A hand does not go to a rest pose that changes again within this time."""


EASED_SHARE = 0.6
"""Of the time in which bodies gather speed, what is lost to a way that begins there: they make up for it later."""

SOON_S = 1.0
"""Before a first stroke that comes sooner both hands are before the belly, from where it is not far."""

MOST_STRETCHED = 1.5
"""How many times its natural time a way may take before a hold fills the time instead."""

HURRIED_RETRACTION = 0.75
"""The share of its natural time in which the last retraction is made at the fastest."""


@dataclass(frozen=True, slots=True)
class ArmTimeline:
    """One arm's gestures and rests in order; the last rest ends at infinity."""

    gestures: tuple[ArmGesture, ...]
    rests: tuple[ArmRest, ...]


def units_of(gestures: Iterable[PlacedGesture], setting: TransitionContext) -> tuple[tuple[PlacedGesture, ...], ...]:
    """The gestures grouped into units: those that blend into each other, or whose arm has no time to rest in
    between."""
    units: list[list[PlacedGesture]] = []
    for gesture in gestures:
        if units and _joins(units[-1], gesture, setting):
            units[-1].append(gesture)
        else:
            units.append([gesture])
    return tuple(map(tuple, units))


def _joins(unit: Sequence[PlacedGesture], gesture: PlacedGesture, setting: TransitionContext) -> bool:
    if in_same_unit(max(unit, key=lambda each: each.relax_s), gesture, setting):
        return True
    last = ((side, next((each for each in reversed(unit) if side in each.arms), None)) for side in gesture.arms)
    return any(before is not None and blends(before, gesture, side, setting) for side, before in last)


def rest_changes(units: Sequence[Sequence[PlacedGesture]], setting: TransitionContext) -> tuple[RestChange, ...]:
    """The rest poses from the first frame on: they change at the end of a unit and with postures of the schedule.
    Where no end is known, hands are not before the belly before the first unit, since it may be asked for late."""
    ends_s = [0.0, *(max(each.relax_s for each in unit) for unit in units)]
    starts_s = [min(each.stroke_start_s for each in unit) for unit in units]
    two_handed = [False, *(any(len(each.arms) == 2 for each in unit) for unit in units)]
    gaps_s = [start_s - end_s for end_s, start_s in zip(ends_s, starts_s, strict=False)]
    lasts = [max(unit, key=lambda each: each.relax_s) for unit in units]
    waits = setting.waits([*(unit[0] for unit in units[:1]), *lasts])
    waits = (Wait.BELLY, *waits[1:]) if starts_s and starts_s[0] < SOON_S else waits
    poses = [
        setting.gap_pose(gap_s, wait, together=before or after)
        for gap_s, wait, (before, after) in zip(gaps_s, waits, pairwise(two_handed), strict=False)
    ]
    if poses and setting.end_s == inf and poses[0] in WAITS:
        poses[0] = AT_SIDE
    left_s = setting.end_s - ends_s[-1]
    last = setting.gap_pose(left_s, waits[-1], together=False) if units else AT_SIDE
    by_gap = tuple(zip(ends_s, [*poses, last if last in WAITS else AT_SIDE], strict=True))
    times_s = sorted({*ends_s, *(from_s for from_s, _pose in setting.postures)})
    changes = [
        RestChange(time_s, posture_pose(setting.postures, time_s) or _in_force(by_gap, time_s)) for time_s in times_s
    ]
    return (changes[0], *(after for before, after in pairwise(changes) if after.pose != before.pose))


def _in_force(poses: Iterable[tuple[float, str]], time_s: float) -> str:
    return max((change for change in poses if change[0] <= time_s), key=lambda change: change[0])[1]


def arm_timeline(
    side: Hand, own: Sequence[PlacedGesture], changes: tuple[RestChange, ...], setting: TransitionContext
) -> ArmTimeline:
    """The timeline of one arm with its `own` gestures."""
    if not own:
        return ArmTimeline((), tuple(_rests(side, 0.0, inf, changes)))
    between = [_between(first, second, side, changes, setting) for first, second in pairwise(own)]
    ways = [_from_the_first_frame(own[0], side, changes, setting), *between, _to_rest(own[-1], side, changes, setting)]
    played = [_arm_gesture(side, *each) for each in zip(own, ways, ways[1:], strict=False)]
    rests = (rest for way in ways if not way.joined for rest in _rests(side, way.arrival_s, way.start_s, changes))
    return ArmTimeline(tuple(played), tuple(rests))


@dataclass(frozen=True, slots=True)
class _Way:
    """The time between two gestures of an arm: end of the first one's hold, arrival at rest, departure, ready for the
    second. In a blend there is no arrival: the arm departs when the hold ends."""

    relax_s: float
    arrival_s: float
    start_s: float
    ready_s: float
    first: PlacedGesture | None = None
    second: PlacedGesture | None = None
    joined: bool = False
    initial_progress: float = 0.0


def _between(
    first: PlacedGesture, second: PlacedGesture, side: Hand, changes: tuple[RestChange, ...], setting: TransitionContext
) -> _Way:
    if blends(first, second, side, setting):
        relax_s = prolonged_relax_s(first, second, side)
        return _Way(relax_s, relax_s, relax_s, second.stroke_start_s, first, second, joined=True)
    there_s, back_s = _retraction_s(first, side, changes, setting), _preparation_s(second, side, changes)
    relax_s, arrival_s = _arrival(first, there_s, _shortest_to_rest_s(first, side, changes))
    room_s = second.stroke_start_s - arrival_s - (0.0 if first.request.asked.end_s is not None else SHORTEST_REST_S)
    asked = _departure(second, back_s, _shortest_from_rest_s(second, side, changes), room_s)
    if asked is not None:
        return _Way(relax_s, arrival_s, *asked, first, second)
    there_s = arrival_s - relax_s
    window_s = second.stroke_start_s - relax_s
    share = min(1.0, window_s / (there_s + back_s))
    hold_s = _hold_s(second, window_s - there_s - back_s - SHORTEST_REST_S)
    ready_s = second.stroke_start_s - hold_s
    return _Way(relax_s, relax_s + share * there_s, ready_s - share * back_s, ready_s, first, second)


def _from_the_first_frame(
    first: PlacedGesture, side: Hand, changes: tuple[RestChange, ...], setting: TransitionContext
) -> _Way:
    """The way to the first gesture. Speakers raise their hands before the first word, so if there is too little time,
    part of the way has already been covered in the first frame."""
    natural_s, shortest_s = _preparation_s(first, side, changes), _shortest_from_rest_s(first, side, changes)
    asked = _departure(first, natural_s, shortest_s, first.stroke_start_s)
    if asked is not None:
        return _Way(0.0, 0.0, *asked, None, first)
    still_s = min(setting.style.ends.still_s, max(0.0, first.stroke_start_s))
    window_s = max(0.0, first.stroke_start_s - still_s)
    way_s = min(natural_s, window_s)
    ready_s = still_s + window_s - _hold_s(first, window_s - way_s)
    hurried_s = min(window_s, setting.style.ends.eased_s)
    progress = max(0.0, 1.0 - (window_s - EASED_SHARE * hurried_s) / shortest_s)
    return _Way(0.0, 0.0, max(still_s, ready_s - way_s), ready_s, None, first, initial_progress=progress)


def _to_rest(last: PlacedGesture, side: Hand, changes: tuple[RestChange, ...], setting: TransitionContext) -> _Way:
    """The last way to rest, a little faster if that is what it takes to arrive before the end; where that is not enough
    and the body is to end still, the hand stays where it is."""
    natural_s, least_s = _retraction_s(last, side, changes, setting), setting.style.ends.still_s
    if last.request.asked.end_s is not None:
        relax_s, arrival_s = _arrival(last, natural_s, _shortest_to_rest_s(last, side, changes))
        return _Way(relax_s, arrival_s, inf, inf, last)
    left_s = setting.end_s - last.relax_s
    if least_s and left_s - least_s < HURRIED_RETRACTION * natural_s:
        relax_s = max(last.relax_s, setting.end_s)
        return _Way(relax_s, relax_s + natural_s, inf, inf, last)
    there_s = min(natural_s, max(left_s - least_s, HURRIED_RETRACTION * natural_s))
    return _Way(last.relax_s, last.relax_s + there_s, inf, inf, last)


def _departure(
    gesture: PlacedGesture, natural_s: float, shortest_s: float, room_s: float
) -> tuple[float, float] | None:
    """When the hand departs and is ready, if it can depart when it is asked to or, with less time before the stroke
    (`room_s`), as soon as there is any; None if that leaves too little time or nothing is asked."""
    asked = gesture.request.asked
    if asked.start_s is None:
        return None
    whole_s = max(min(gesture.stroke_start_s - asked.start_s, room_s), shortest_s)
    if whole_s > room_s:
        return None
    hold_s = max(_hold_s(gesture, whole_s - natural_s), whole_s - MOST_STRETCHED * natural_s)
    if asked.ready_s is not None:
        hold_s = min(max(gesture.stroke_start_s - asked.ready_s, 0.0), whole_s - shortest_s)
    return gesture.stroke_start_s - whole_s, gesture.stroke_start_s - hold_s


def _arrival(gesture: PlacedGesture, natural_s: float, shortest_s: float) -> tuple[float, float]:
    """When the hold ends and the hand is at rest: if it is asked when, at that time within limits of speed."""
    asked = gesture.request.asked
    end_s = asked.end_s
    if end_s is None:
        return gesture.relax_s, gesture.relax_s + natural_s
    earliest_s = max([gesture.stroke_end_s, *(each.end_s for each in gesture.repeats)])
    latest_s = max(earliest_s, end_s - shortest_s)
    slow_s = 0.0 if asked.relax_s is not None else end_s - MOST_STRETCHED * natural_s
    relax_s = min(max(gesture.relax_s, slow_s), latest_s)
    return relax_s, max(end_s, relax_s + shortest_s)


def _shortest_from_rest_s(gesture: PlacedGesture, side: Hand, changes: tuple[RestChange, ...]) -> float:
    pose = pose_at(changes, max(0.0, gesture.stroke_start_s - natural_preparation_s(gesture)))
    return shortest_way_s(rest_way_m(pose, side, stroke_start_m(gesture, side)))


def _shortest_to_rest_s(gesture: PlacedGesture, side: Hand, changes: tuple[RestChange, ...]) -> float:
    pose = pose_on_arrival(changes, gesture.relax_s + SHORTEST_RETRACTION_S)
    return shortest_way_s(rest_way_m(pose, side, relax_m(gesture, side)))


def _hold_s(gesture: PlacedGesture, room_s: float) -> float:
    """The pre-stroke hold, as long as there is time for it."""
    natural_s = gesture.clip.markers.stroke_start - gesture.clip.markers.ready
    return max(0.0, min(natural_s, room_s))


def _preparation_s(gesture: PlacedGesture, side: Hand, changes: tuple[RestChange, ...]) -> float:
    natural_s = natural_preparation_s(gesture)
    pose = pose_at(changes, max(0.0, gesture.stroke_start_s - natural_s))
    return preparation_s(rest_way_m(pose, side, stroke_start_m(gesture, side)), natural_s)


def _retraction_s(
    gesture: PlacedGesture, side: Hand, changes: tuple[RestChange, ...], setting: TransitionContext
) -> float:
    pose = pose_on_arrival(changes, gesture.relax_s + SHORTEST_RETRACTION_S)
    return setting.retraction_s(gesture, rest_way_m(pose, side, relax_m(gesture, side)))


def _arm_gesture(side: Hand, gesture: PlacedGesture, before: _Way, after: _Way) -> ArmGesture:
    markers = Markers(
        start=before.start_s,
        ready=before.ready_s,
        stroke_start=gesture.stroke_start_s,
        stroke=gesture.request.stroke_s,
        stroke_end=gesture.stroke_end_s,
        relax=after.relax_s,
        end=after.arrival_s,
    )
    return ArmGesture(
        side=side,
        placed=gesture,
        markers=markers,
        blended_from=before.first.request.behavior if before.joined and before.first else None,
        blended_to=after.second.request.behavior if after.joined and after.second else None,
        initial_progress=before.initial_progress,
    )


def pose_at(changes: Iterable[RestChange], time_s: float) -> str:
    """The rest pose at a time."""
    return max((each for each in changes if each.from_s <= time_s), key=lambda each: each.from_s).pose


def pose_on_arrival(changes: Iterable[RestChange], time_s: float) -> str:
    """The rest pose of a hand that arrives at `time_s`: already the next one if it changes soon."""
    return pose_at(changes, time_s + SHORTEST_STAY_S)


def _rests(side: Hand, start_s: float, end_s: float, changes: Iterable[RestChange]) -> Iterator[ArmRest]:
    """An arm's rests from arrival to departure, with those changes of pose for which there is time. Hands that do not
    stay in the first frame are not yet where they would go."""
    leaves = start_s <= 0.0 and end_s < SHORTEST_STAY_S
    pose = pose_at(changes, start_s) if leaves else pose_on_arrival(changes, start_s)
    for change in changes:
        if change.from_s <= start_s + SHORTEST_STAY_S or change.pose == pose:
            continue
        arrival_s = change.from_s + change_s(pose, change.pose, side)
        if arrival_s > end_s:
            break
        yield ArmRest(side, pose, start_s, change.from_s)
        pose, start_s = change.pose, arrival_s
    yield ArmRest(side, pose, start_s, end_s)
