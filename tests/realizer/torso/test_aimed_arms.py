"""A pointing arm is on the line to its target, also where the trunk leans."""

import numpy as np
import pytest

from tests.support.motion.movements import behavior
from understudy.model import Channel, FloatArray, Hand, Schedule, Target
from understudy.models import load_realizer
from understudy.realizer.body.motion import Motion
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.realizing import realize

LAMP = Target("lamp", (1.0, 1.5, 1.9))
POINTING = behavior(Channel.GESTURE, "POINT_LEFT", 1.2, 1.7, 1.7, 2.0, 2.1, 3.2, 3.8, hand=Hand.LEFT, target="lamp")


def off_line_deg(skeleton: Skeleton, motion: Motion, at_s: float) -> float:
    """The angle at the shoulder between the left wrist and the lamp."""
    frame = round(at_s * motion.frame_rate_hz)
    places_m, _turned = forward(skeleton, motion.body.rotations[frame], motion.body.hips_m[frame])
    shoulder_m, wrist_m = (places_m[joint] for joint in skeleton.chain("leftUpperArm", "leftHand"))
    hand, way = wrist_m - shoulder_m, np.array(LAMP.position_m) - shoulder_m
    return float(np.degrees(np.arccos(unit(hand) @ unit(way))))


def unit(vector: FloatArray) -> FloatArray:
    return np.asarray(vector / np.linalg.norm(vector))


@pytest.mark.parametrize("lean", ["LEAN_LEFT", "LEAN_RIGHT", "LEAN_BACK"])
def test_an_arm_points_at_its_target_while_the_body_leans(lean: str) -> None:
    realizer = load_realizer()
    leaning = behavior(Channel.POSTURE, lean, 0.3, 1.0, 4.0, 4.8)
    motion = realize(realizer, Schedule((POINTING, leaning), 6.0, targets=(LAMP,)))
    stroke_end_s = motion.realized[POINTING.id].stroke_end
    assert stroke_end_s is not None
    assert off_line_deg(realizer.skeleton, motion, stroke_end_s) < 13
