"""The eyes go where a gesture shows something, then the head, then the hand; they are back on the listener afterwards.

People look at what they point at, at what they measure or draw in the air, and at the two places of a contrast, before
the hand gets there: the eyes some .15 s, the head .09 s before the hand sets out. Such looks are not in the schedule,
whose own looks go first; but eyes that wander off, or go in the direction of a word, make way.

Conventions: seconds, metres in the world.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...model import Behavior, Channel, FloatArray, Hand, Schedule, SyncPoints
from ..body.motion import BodyMotion, Decision
from ..body.skeleton import Skeleton, as_far_as_hands, forward
from ..geometry.rotations import rotate
from ..gestures.gesture_plan import ArmGesture, GesturePlan, Position
from .gaze_targets import LISTENER

ALONG = frozenset(
    {"POINT_LEFT", "POINT_RIGHT", "POINT_FRONT", "POINT_UP", "THERE", "OVER_SHOULDER", "UP", "DOWN", "LEFT", "RIGHT"}
)
"""Gestures that point into the distance: the eyes go there, not to the hand."""

AT_THE_HAND = frozenset(
    {
        *("HEIGHT_HIGH", "HEIGHT_LOW", "WIDE", "NARROW", "LONG", "SHORT", "SMALL", "PINCH", "ROUND", "FLAT"),
        *("CONTAIN", "BETWEEN", "CIRCLE", "PATH_FORWARD", "PATH_ASIDE", "RISE", "FALL", "HERE"),
        *("CONTRAST", "PLACE_LEFT", "PLACE_RIGHT", "WEIGH", "COMPARATIVE", "COMPARATIVE_BIGGER"),
        *("COMPARATIVE_LONGER", "COMPARATIVE_SMALLER"),
    }
)
"""Gestures that measure, draw or place something: the eyes go to the hand."""

WATCH = "WATCH"
"""The lexeme of a look at the own hand, for which the head turns less."""

AHEAD_S = 0.15
"""How much earlier than the hand the eyes set out."""
LONGEST_WAY_S = 0.6
"""A hand counts as setting out at most this long before its stroke."""
THERE_S = 0.25
SHORTEST_S, LONGEST_S = 0.2, 0.9
"""How long the eyes stay after the stroke's end and after its start, at least and at most."""
BACK_S = 0.3

MOST_IN_A_ROW, APART_S = 2, 0.6
"""After so many looks, as at the two places of a contrast, the eyes are on the listener for this long at least before
they go to a hand again: nobody talks to their own hands. What is pointed at is looked at all the same."""

FAR_M = 3.0
_FINGERS_M = 0.12
_STEEP, _ASIDE_RAD = 1.0, np.radians(50.0)
"""From this slope on a way counts as steep, and how far aside one looks along it at most."""
_POINTING = "POINT_"
_FACING: Mapping[Hand, float] = {Hand.LEFT: 1.0, Hand.RIGHT: -1.0}
"""A hand's fingers extend along its joint's x axis, in the direction of its side."""


@dataclass(frozen=True, slots=True)
class Look:
    """A look that goes with a gesture, and where the hand is when it sets out."""

    gaze: Behavior
    at_m: Position
    hand_s: float

    @property
    def decision(self) -> Decision:
        """The decisions about it."""
        start_s, relax_s = self.gaze.sync.start, self.gaze.sync.relax or self.gaze.sync.end
        reason = f"the eyes go with it from {start_s:.2f} s, before the hand at {self.hand_s:.2f} s, to {relax_s:.2f} s"
        return Decision(str(self.gaze.target), "watched", reason)


def accompanying_looks(skeleton: Skeleton, body: BodyMotion, schedule: Schedule, plan: GesturePlan) -> tuple[Look, ...]:
    """The looks that go with the plan's gestures in the motion so far, in order; of two that are close the later one
    begins when the first is over, at hands not more than `MOST_IN_A_ROW`. None where the schedule itself has the eyes
    look somewhere at the stroke."""
    asked = [each.sync for each in schedule.behaviors if _is_gaze(each) and not gives_way(each)]
    found: list[Look] = []
    in_a_row = 0
    for arms in _shown(plan):
        sync, markers = _times(arms[0], _last_word_s(schedule)), arms[0].markers
        if any(each.start < markers.stroke_end and markers.stroke_start < _left_s(each) for each in asked):
            continue
        follows = found and sync.start < _left_s(found[-1].gaze.sync) + APART_S
        in_a_row = in_a_row + 1 if follows else 1
        if in_a_row > MOST_IN_A_ROW and arms[0].placed.clip.category not in ALONG:
            continue
        if found and sync.start < (found[-1].gaze.sync.relax or 0.0):
            before = found[-1].gaze
            cut = replace(before.sync, relax=max(before.sync.ready or 0.0, sync.start))
            found[-1] = replace(found[-1], gaze=replace(before, sync=cut))
        found.append(_look(skeleton, body, arms, sync))
    return tuple(found)


def with_looks(schedule: Schedule, looks: Sequence[Look]) -> Schedule:
    """The schedule with these looks; what gives way to them does not begin meanwhile, and ends as they begin."""
    if not looks:
        return schedule
    spans = [(each.gaze.sync.start, _left_s(each.gaze.sync)) for each in looks]
    kept = (each if not gives_way(each) else _beside(each, spans) for each in schedule.behaviors)
    gazes = (each.gaze for each in looks)
    return replace(schedule, behaviors=(*(each for each in kept if each is not None), *gazes))


def gives_way(gaze: Behavior) -> bool:
    """Whether it is a look or glance to a side of our own schedules, that no moment, note or edit asks for: eyes that
    wander off, or the direction that a word says, which the gesture itself shows better."""
    own = gaze.reason is not None or gaze.rule is not None
    return _is_gaze(gaze) and own and gaze.direction is not None and gaze.moment is None and gaze.edit is None


def _is_gaze(behavior: Behavior) -> bool:
    return behavior.kept and behavior.kind is Channel.GAZE and behavior.lexeme != "SHIFT"


def _left_s(sync: SyncPoints) -> float:
    return sync.end if sync.relax is None else sync.relax


def _beside(gaze: Behavior, spans: Iterable[tuple[float, float]]) -> Behavior | None:
    """The gaze, cut where one of the spans begins; None if it begins in one."""
    sync = gaze.sync
    for start_s, end_s in spans:
        if start_s <= sync.start < end_s:
            return None
        if sync.start < start_s < sync.end:
            ready_s = min(sync.start if sync.ready is None else sync.ready, start_s)
            sync = replace(sync, ready=ready_s, relax=start_s, end=start_s + THERE_S)
    return replace(gaze, sync=sync)


def _shown(plan: GesturePlan) -> Iterator[list[ArmGesture]]:
    """The gestures with which the eyes go, by the arms that make them, the leading one first, in order of strokes."""
    names = dict.fromkeys(each.behavior for each in sorted(plan.gestures, key=lambda arm: arm.markers.stroke))
    for name in names:
        own = (each for each in plan.gestures if each.behavior == name)
        arms = sorted(own, key=lambda arm: arm.markers.stroke)
        category, request = arms[0].placed.clip.category, arms[0].placed.request
        if category in ALONG | AT_THE_HAND and request.target != LISTENER:
            yield arms


def _times(arm: ArmGesture, last_word_s: float) -> SyncPoints:
    """When the eyes go there and back: before the hand, until it relaxes or the last word begins."""
    markers = arm.markers
    start_s = max(_hand_s(arm) - AHEAD_S, 0.0)
    latest_s = max(markers.stroke_end + SHORTEST_S, min(markers.stroke_start + LONGEST_S, last_word_s))
    relax_s = min(max(markers.relax, markers.stroke_end + SHORTEST_S), latest_s)
    return SyncPoints(start=start_s, ready=start_s + THERE_S, relax=relax_s, end=relax_s + BACK_S)


def _hand_s(arm: ArmGesture) -> float:
    """When the hand sets out."""
    return max(arm.markers.start, arm.markers.stroke_start - LONGEST_WAY_S)


def _last_word_s(schedule: Schedule) -> float:
    return max((word.interval.start_s for word in schedule.words if word.interval), default=schedule.duration_s)


def _look(skeleton: Skeleton, body: BodyMotion, arms: Sequence[ArmGesture], sync: SyncPoints) -> Look:
    """The look at where the arms are when their stroke is over."""
    leads = arms[0]
    frame = min(int(np.searchsorted(body.times_s, leads.markers.stroke_end)), len(body.times_s) - 1)
    places_m, turned = forward(skeleton, body.rotations[frame], body.hips_m[frame], as_far_as_hands(skeleton))
    at_m = np.mean([_shown_m(skeleton, places_m, turned, arm) for arm in arms], axis=0)
    x, y, z = (float(each) for each in at_m)
    gaze = Behavior(
        id=f"with {leads.behavior}",
        kind=Channel.GAZE,
        lexeme="LOOK" if leads.placed.clip.category in ALONG else WATCH,
        sync=sync,
        first=0,
        last=0,
        priority=0.0,
        target=leads.behavior,
    )
    return Look(gaze, (x, y, z), _hand_s(leads))


def _shown_m(skeleton: Skeleton, places_m: FloatArray, turned: FloatArray, arm: ArmGesture) -> FloatArray:
    """What a hand shows (3,): a point at its fingers, or far off along the arm, for a pointing finger between where
    that points and the arm."""
    side, category = arm.side, arm.placed.clip.category
    hand, shoulder = (skeleton.index[side.value + joint] for joint in ("Hand", "UpperArm"))
    fingers = rotate(turned[hand], np.array([_FACING[side], 0.0, 0.0]))
    if category not in ALONG:
        return np.asarray(places_m[hand] + _FINGERS_M * fingers)
    arm_m = places_m[hand] - places_m[shoulder]
    way = _ahead(arm_m / np.linalg.norm(arm_m) + (fingers if category.startswith(_POINTING) else 0.0))
    return np.asarray(places_m[hand] + FAR_M * way / np.linalg.norm(way))


def _ahead(way: FloatArray) -> FloatArray:
    """The way (3,), a steep one no farther aside than heads turn at ease: how far an upright arm is aside is chance and
    nobody turns to the side to look at the ground."""
    x, y, z = way
    across = float(np.hypot(x, z))
    if abs(y) < _STEEP * across:
        return way
    aside = float(np.clip(np.arctan2(x, z), -_ASIDE_RAD, _ASIDE_RAD))
    return np.array([across * np.sin(aside), y, across * np.cos(aside)])
