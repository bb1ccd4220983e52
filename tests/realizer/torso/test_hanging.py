"""Arms that hang do not follow the ribs to the side; others do."""

import numpy as np

from tests.support.motion.movements import BODY, TIMES_S, behavior, schedule
from understudy.model import Channel, FloatArray
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import from_axis_angle
from understudy.realizer.torso.hanging import with_hanging_arms
from understudy.realizer.torso.idle import idle_motion

LEANING = idle_motion(BODY, TIMES_S, schedule(behavior(Channel.POSTURE, "LEAN_LEFT", 1.0, 2.0)), seed=4)


def aside_deg(body: BodyMotion, side: str) -> FloatArray:
    """Of the upper arm from straight down, in the frontal plane (T,)."""
    places_m = forward(BODY, body.rotations, body.hips_m)[0]
    arm, elbow = BODY.chain(f"{side}UpperArm", f"{side}LowerArm")
    way = places_m[:, elbow] - places_m[:, arm]
    return np.degrees(np.arctan2(way[:, 0], -way[:, 1]))


def test_hanging_arms_stay_as_they_hang_while_the_trunk_leans() -> None:
    straight = with_hanging_arms(BODY, LEANING)
    before, after = TIMES_S < 0.9, TIMES_S > 2.2
    for side in ("left", "right"):
        swings = [
            abs(aside_deg(body, side)[after].mean() - aside_deg(body, side)[before].mean())
            for body in (LEANING, straight)
        ]
        assert swings[0] > 3
        assert swings[1] < 0.5 * swings[0]


def test_a_raised_arm_goes_with_the_ribs() -> None:
    rotations = LEANING.rotations.copy()
    rotations[:, BODY.index["leftUpperArm"]] = from_axis_angle((0.0, 0.0, 1.0), np.array(0.2))
    raised = BodyMotion(TIMES_S, rotations, LEANING.hips_m)
    arm = BODY.index["leftUpperArm"]
    assert np.allclose(with_hanging_arms(BODY, raised).rotations[:, arm], rotations[:, arm], atol=1e-9)
