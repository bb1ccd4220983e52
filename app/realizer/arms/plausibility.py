"""Finds gesture poses that the body cannot reach (Gesture Engine §4.3): places out of reach, overtwisted wrists.

The realizer gets as near as joint limits allow, so these are warnings, not errors; but the gesture does not look as
written. Poses are tested at the gesture's largest amplitude.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import reduce

import numpy as np

from ...model import FloatArray, Hand, Level
from ..body.skeleton import Skeleton
from ..geometry.rotations import multiply, rotate
from ..gestures.gesture import ArmKey, Definition, HandDirection
from ..gestures.gesture_space import DIRECTIONS, sector_m
from .posing import PartialPose, pose_arm

SHORT_M = 0.03
OFF_DEG = 25.0

_FINGERS, _PALM = np.array([1.0, 0.0, 0.0]), np.array([0.0, -1.0, 0.0])
"""Where the left hand's fingers point and its palm faces in the T-pose."""


@dataclass(frozen=True, slots=True)
class Doubt:
    """A pose out of reach: the definition, the relative time of its frame, the level of agitation, and what is
    wrong."""

    definition: Definition
    time: float
    level: Level
    message: str


def doubts(skeleton: Skeleton, definition: Definition) -> Iterator[Doubt]:
    """The poses that the body misses by more than `SHORT_M` or `OFF_DEG`."""
    level = max(definition.levels, key=lambda one: definition.levels[one].amplitude)
    amplitude = definition.levels[level].amplitude
    for frame in definition.frames:
        for key in dict.fromkeys((frame.leading, frame.other or frame.leading)):
            if key.place is not None and not key.joints:
                for message in _shortcomings(skeleton, key, amplitude):
                    yield Doubt(definition, frame.time, level, message)


def _shortcomings(skeleton: Skeleton, key: ArmKey, amplitude: float) -> Iterator[str]:
    pose = pose_arm(skeleton, Hand.LEFT, key, amplitude=amplitude)
    if pose.wrist_m is None or key.place is None:
        return
    short_m = float(np.linalg.norm(pose.wrist_m - sector_m(key.place, amplitude)))
    if short_m > SHORT_M:
        yield f"the wrist stays {100 * short_m:.0f} cm from its place"
    if key.wrist is not None:
        for what, wanted, axis in (("finger base", key.wrist.finger_base, _FINGERS), ("palm", key.wrist.palm, _PALM)):
            off_deg = _off_deg(pose, wanted, axis)
            if off_deg > OFF_DEG:
                yield f"the {what} stays {off_deg:.0f}° from where it should point"


def _off_deg(pose: PartialPose, wanted: Iterable[HandDirection], axis: FloatArray) -> float:
    """The angle in degrees between the sum of the wanted directions and the actual axis of the hand; 0 if none is
    wanted."""
    total = np.sum([DIRECTIONS[direction] for direction in wanted], axis=0)
    if not np.any(total):
        return 0.0
    hand = reduce(multiply, pose.parts[:5])
    return float(np.degrees(np.arccos(np.clip(rotate(hand, axis) @ total / np.linalg.norm(total), -1, 1))))
