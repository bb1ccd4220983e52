"""Transitions between neighbouring gestures (paper §3.8): which blend, how fast they are, how long holds last.

The paper has one timeline; here each arm has one, and the rules apply to each separately: gestures of different hands
do not conflict, and a two-handed one has a neighbour on either arm.

A gesture blends into the next of its arm if both belong to one unit (towards-natural §3.3: closer than `UNIT_GAP_S` and
in the same phrase), or if there is no time to rest in between. Where singletons are asked for (towards-natural §4.1)
there are no units, and a rest takes no longer than hands at their fastest need for the way there and back.
"""

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from math import inf

import numpy as np

from ...model import Hand, Interval, Level
from ...model.figure import Wait
from ...model.limits import SLOWEST_STROKE_M_S, equal_transition_s
from ..arms.rest_poses import waiting_pose
from ..arms.wrist_paths import distance_m, relax_m, stroke_start_m
from ..body.movement_style import PLAIN, MovementStyle
from ..gestures.gesture_plan import PlacedGesture, drawn
from .rests import (
    SHORTEST_REST_S,
    posture_pose,
    preparation_s,
    rest_pose_for_gap,
    rest_way_m,
    retraction_s,
    shortest_way_s,
)

UNIT_GAP_S = 1.5

_WAIT = 2
"""What is drawn for the way in which hands wait, beside a gesture's hands and its stroke."""


@dataclass(frozen=True, slots=True)
class TransitionContext:
    """The parts of a schedule that affect transitions: its phrases, the rest poses of its postures, its end, and
    whether gestures are to be single; and how the body moves, by style, level of agitation, seed and leading hand."""

    phrases: tuple[Interval, ...] = ()
    postures: tuple[tuple[float, str | None], ...] = ()
    end_s: float = inf
    singletons: bool = False
    style: MovementStyle = PLAIN
    level: Level = Level.MEDIUM
    seed: int = 0
    leading: Hand = Hand.RIGHT

    def phrase_of(self, time_s: float) -> int | None:
        """The index of the last phrase that has begun; None if there are no phrases."""
        begun = [number for number, phrase in enumerate(self.phrases) if phrase.start_s <= time_s]
        return max(begun, default=0) if self.phrases else None

    def pose_in_gap(self, first: PlacedGesture, gap_s: float) -> str:
        """The rest pose in a gap after this gesture, if it is the last of its unit."""
        return posture_pose(self.postures, first.relax_s) or self.gap_pose(gap_s, self.waits([first])[0])

    def gap_pose(self, gap_s: float, wait: Wait, *, together: bool = True) -> str:
        """The rest pose in a gap in which nobody asks for another: in one that is not too long the hands wait."""
        lap_s = self.style.lap.longest_gap_s[self._number]
        waiting = waiting_pose(wait, self.level, self.leading)
        return rest_pose_for_gap(gap_s, together=together, waiting=waiting, waiting_s=lap_s)

    def waits(self, gestures: Sequence[PlacedGesture]) -> tuple[Wait, ...]:
        """How hands wait beside each of the gestures: drawn by the seed and the gesture, another way than the one that
        was drawn just before."""
        weights = self.style.waits.weights(self._number)
        last: Wait | None = None
        found = []
        for gesture in gestures:
            rng = drawn(self.seed, gesture, _WAIT)
            wait = _drawn_wait(rng, weights)
            if wait is last and len(weights) > 1:
                wait = _drawn_wait(rng, {each: weight for each, weight in weights.items() if each is not last})
            last = wait
            found.append(wait)
        return tuple(found)

    @property
    def _number(self) -> int:
        return list(Level).index(self.level)

    def retraction_s(self, gesture: PlacedGesture, way_m: float) -> float:
        """The time of a gesture's way to rest: each has a pace of its own."""
        retractions = self.style.retractions
        pace = float(drawn(self.seed, gesture).uniform(*retractions.variety))
        return retraction_s(way_m, retractions.speed_m_s[self._number], pace=pace)


def _drawn_wait(rng: np.random.Generator, weights: Mapping[Wait, float]) -> Wait:
    """One of them, by their weights."""
    waits, sums = list(weights), list(accumulate(weights.values()))
    return waits[bisect_right(sums, float(rng.random()) * sums[-1])]


def gap_s(first: PlacedGesture, second: PlacedGesture) -> float:
    """The time from the desired relax time of the first to the stroke start of the second: t_ss of k+1 - t_grl of k."""
    return second.stroke_start_s - first.relax_s


def in_same_unit(first: PlacedGesture, second: PlacedGesture, setting: TransitionContext) -> bool:
    """Whether two neighbours are close enough for one unit and in the same phrase, and nobody asks for a rest."""
    if setting.singletons or _rest_is_asked(first, second):
        return False
    same = setting.phrase_of(first.request.stroke_s) == setting.phrase_of(second.request.stroke_s)
    return same and gap_s(first, second) < UNIT_GAP_S


def blends(first: PlacedGesture, second: PlacedGesture, side: Hand, setting: TransitionContext) -> bool:
    """Whether an arm goes from the first to the second without rest."""
    return in_same_unit(first, second, setting) or gap_s(first, second) < _rest_between_s(first, second, side, setting)


def _rest_between_s(first: PlacedGesture, second: PlacedGesture, side: Hand, setting: TransitionContext) -> float:
    """The time needed to return to rest and come back."""
    pose = setting.pose_in_gap(first, gap_s(first, second))
    there_m, back_m = (rest_way_m(pose, side, at_m) for at_m in (relax_m(first, side), stroke_start_m(second, side)))
    if setting.singletons or _rest_is_asked(first, second):
        return shortest_way_s(there_m) + shortest_way_s(back_m)
    return setting.retraction_s(first, there_m) + SHORTEST_REST_S + preparation_s(back_m, natural_preparation_s(second))


def _rest_is_asked(first: PlacedGesture, second: PlacedGesture) -> bool:
    ends_s, begins_s = first.request.asked.end_s, second.request.asked.start_s
    return ends_s is not None and begins_s is not None and ends_s <= begins_s


def natural_preparation_s(placed: PlacedGesture) -> float:
    """The duration of the preparation in the clip."""
    return placed.clip.markers.ready - placed.clip.markers.start


def way_m(first: PlacedGesture, second: PlacedGesture, side: Hand) -> float:
    """The distance between the hand's positions at the relax time of the first and the stroke start of the second."""
    return distance_m(relax_m(first, side), stroke_start_m(second, side))


def prolonged_relax_s(first: PlacedGesture, second: PlacedGesture, side: Hand) -> float:
    """t_grl*: the end of the first one's hold, such that the transition is as fast as the next stroke (paper §3.8, Fig.
    4).

    From d / (gap - t_h) = v follows t_h = gap - d / v; a transition that is too fast already gets no hold. At least
    `EASY_TRANSITION_S` of the gap remains, which is our addition: orientation and shape must change even if the hand is
    in place.
    """
    return first.relax_s + max(gap_s(first, second) - transition_s(first, second, side), 0.0)


def transition_s(first: PlacedGesture, second: PlacedGesture, side: Hand) -> float:
    """The natural duration of a transition to `second`: as fast as its stroke, and at least `EASY_TRANSITION_S`."""
    return equal_transition_s(way_m(first, second, side), stroke_speed_m_s(second))


def stroke_speed_m_s(placed: PlacedGesture) -> float:
    """The paper's v of a gesture. Strokes of the wrist or the fingers alone have none and count as slow."""
    return max(placed.clip.stroke_speed_m_s * placed.size, SLOWEST_STROKE_M_S)
