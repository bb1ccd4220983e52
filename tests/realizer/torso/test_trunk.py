"""The trunk goes along with the hands, a little, and the feet do not."""

import numpy as np
import pytest

from understudy.model import FloatArray, Schedule
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.torso.idle import idle_motion
from understudy.realizer.torso.trunk import follow_with_trunk

SKELETON = Skeleton.standing()
TIMES_S: FloatArray = np.arange(241) / 60
AT_EASE_M: FloatArray = np.tile([0.15, 0.05, 0.20], (241, 1))


def moved(left_m: FloatArray, right_m: FloatArray) -> BodyMotion:
    body = _idle()
    follow_with_trunk(SKELETON, body, np.stack((left_m, right_m)))
    return body


def _idle() -> BodyMotion:
    return idle_motion(SKELETON, TIMES_S, Schedule((), 4.0), seed=0)


def out_and_back(x_m: float, y_m: float, z_m: float) -> FloatArray:
    """The wrist away from ease between 1 s and 3 s."""
    during = ((TIMES_S > 1) & (TIMES_S < 3))[:, None]
    return np.asarray(AT_EASE_M + during * np.array([x_m, y_m, z_m]))


def chest_facing(body: BodyMotion) -> FloatArray:
    """Where the chest faces (T, 2), left and down, less the idle body's."""
    facing = []
    for each in (body, _idle()):
        _, turned = forward(SKELETON, each.rotations, each.hips_m)
        x, y, z, w = turned[:, SKELETON.index["upperChest"]].T
        facing.append(np.stack([2 * (x * z + w * y), -2 * (y * z - w * x)], axis=-1))
    return np.asarray(facing[0] - facing[1])


def test_hands_at_ease_leave_the_trunk_where_it_is() -> None:
    body = moved(AT_EASE_M, AT_EASE_M)
    np.testing.assert_allclose(body.rotations, _idle().rotations, atol=1e-9)
    np.testing.assert_allclose(body.hips_m, _idle().hips_m, atol=1e-9)


@pytest.mark.parametrize(("side", "sign"), [("left", 1.0), ("right", -1.0)])
def test_the_trunk_turns_and_the_weight_goes_to_a_hand_far_aside(side: str, sign: float) -> None:
    aside = out_and_back(0.4, 0.0, 0.0)
    body = moved(aside, AT_EASE_M) if side == "left" else moved(AT_EASE_M, aside)
    left = sign * chest_facing(body)[:, 0]
    assert 0.05 < left[120] < 0.15
    assert abs(left[[0, 240]]).max() < 0.01
    assert sign * (body.hips_m - _idle().hips_m)[120, 0] == pytest.approx(0.4 * 0.05, rel=0.1)


def test_the_trunk_leans_after_a_hand_that_reaches_out() -> None:
    assert 0.02 < chest_facing(moved(out_and_back(0.0, 0.0, 0.2), AT_EASE_M))[120, 1] < 0.08


def test_the_feet_stay() -> None:
    body = moved(out_and_back(0.4, 0.3, 0.2), AT_EASE_M)
    soles = SKELETON.chain("leftFoot", "rightFoot")
    before, after = (forward(SKELETON, each.rotations, each.hips_m)[0][:, soles] for each in (_idle(), body))
    np.testing.assert_allclose(after, before, atol=1e-6)


def test_the_trunk_moves_ahead_of_the_hand() -> None:
    left = chest_facing(moved(out_and_back(0.4, 0.0, 0.0), AT_EASE_M))[:, 0]
    halfway_s = TIMES_S[np.argmax(left > left[120] / 2)]
    assert 0.85 < halfway_s < 1.0


def test_hips_go_back_and_feet_stay_while_hands_reach_away() -> None:
    reaching, idle, there = moved(*[out_and_back(0.0, 0.2, 0.3)] * 2), _idle(), slice(110, 130)
    assert (reaching.hips_m[there, 2] < idle.hips_m[there, 2] - 0.03).all()
    np.testing.assert_allclose(reaching.hips_m[0], idle.hips_m[0], atol=1e-3)  # the curve's tail
    feet = SKELETON.chain("leftFoot", "rightFoot")
    places, still = (forward(SKELETON, each.rotations, each.hips_m)[0][:, feet] for each in (reaching, idle))
    np.testing.assert_allclose(places, still, atol=1e-6)
