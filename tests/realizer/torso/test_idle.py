"""The idle body stands firm, breathes, and is never frozen."""

import numpy as np
import pytest

from tests.support.motion.movements import BODY, TIMES_S, behavior, schedule
from understudy.model import Channel, Level, Schedule
from understudy.realizer.body.limits import violations
from understudy.realizer.body.skeleton import SIDES, forward
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.torso.balance import LEG_JOINTS
from understudy.realizer.torso.idle import idle_motion

SHIFTS = schedule(
    behavior(Channel.POSTURE, "WEIGHT_ON_LEFT_LEG", 0.5, 1.2),
    behavior(Channel.POSTURE, "LEAN_FORWARD", 2.0, 2.6),
    behavior(Channel.POSTURE, "LEAN_RIGHT", 4.0, 4.6),
)


@pytest.mark.parametrize("planned", [schedule(), SHIFTS], ids=["nothing asked", "postures"])
def test_feet_do_not_slide_and_no_two_frames_are_the_same(planned: object) -> None:
    body = idle_motion(BODY, TIMES_S, planned, seed=4)  # type: ignore[arg-type]
    places_m = forward(BODY, body.rotations, body.hips_m)[0]
    feet = places_m[:, BODY.chain("leftFoot", "rightFoot", "leftToes", "rightToes")]
    assert np.abs(feet - feet[0]).max() < 1e-6
    moved_m = np.abs(np.diff(places_m, axis=0)).max(axis=(1, 2))
    assert moved_m.min() > 1e-6
    speed = angle_between(body.rotations[1:], body.rotations[:-1]) * 60
    assert speed.max() < 3.0
    assert np.linalg.norm(body.rotations, axis=-1) == pytest.approx(1)
    assert violations(BODY, body.rotations).max() == 0


def test_without_limbs_only_legs_and_arms_below_the_collarbone_differ() -> None:
    whole, without = (idle_motion(BODY, TIMES_S, SHIFTS, seed=4, with_limbs=each) for each in (True, False))
    turned = np.abs(whole.rotations - without.rotations).max(axis=(0, 2)) > 0
    arms = (side + joint for side in SIDES for joint in ("UpperArm", "LowerArm"))
    assert set(np.flatnonzero(turned)) == set(BODY.chain(*LEG_JOINTS, *arms))
    assert np.array_equal(whole.hips_m, without.hips_m)


def test_arms_hang_and_knees_are_soft() -> None:
    body = idle_motion(BODY, TIMES_S, schedule(), seed=1)
    places_m = forward(BODY, body.rotations, body.hips_m)[0]
    for side, sign in (("left", 1), ("right", -1)):
        hand, shoulder = places_m[:, BODY.index[f"{side}Hand"]], places_m[:, BODY.index[f"{side}UpperArm"]]
        assert np.all(shoulder[:, 1] - hand[:, 1] > 0.45)
        assert np.all(sign * hand[:, 0] > 0.18)
    assert np.all((body.hips_m[:, 1] > 0.90) & (body.hips_m[:, 1] < 0.95))


def test_leaning_forward_brings_the_head_forward_and_the_hips_back() -> None:
    body = idle_motion(BODY, TIMES_S, schedule(behavior(Channel.POSTURE, "LEAN_FORWARD", 1.0, 2.0)), seed=4)
    head_m = forward(BODY, body.rotations, body.hips_m)[0][:, BODY.index["head"]]
    before, after = TIMES_S < 1.0, TIMES_S > 2.0
    assert head_m[after, 2].mean() - head_m[before, 2].mean() > 0.03
    assert body.hips_m[after, 2].mean() < body.hips_m[before, 2].mean() - 0.02


def test_weight_on_a_leg_brings_the_hips_over_it_and_the_head_stays_between_the_feet() -> None:
    for lexeme, sign in (("WEIGHT_ON_LEFT_LEG", 1), ("WEIGHT_ON_RIGHT_LEG", -1)):
        body = idle_motion(BODY, TIMES_S, schedule(behavior(Channel.POSTURE, lexeme, 0.0, 1.0)), seed=4)
        assert sign * body.hips_m[TIMES_S > 1.2, 0].mean() > 0.03
        assert np.abs(forward(BODY, body.rotations, body.hips_m)[0][:, BODY.index["head"], 0]).max() < 0.1


def test_who_is_agitated_sways_more_and_who_is_lax_less() -> None:
    spread = []
    for level in Level:
        body = idle_motion(BODY, TIMES_S, Schedule((), 6.0, agitation=level), seed=4)
        spread.append(float(np.linalg.norm(np.diff(body.hips_m, axis=0), axis=1).sum()))
    assert spread == sorted(spread)
    assert spread[-1] > 1.2 * spread[0]


def test_the_same_seed_gives_the_same_motion_and_another_one_another() -> None:
    one, same, other = (idle_motion(BODY, TIMES_S, SHIFTS, seed=seed) for seed in (1, 1, 2))
    assert np.array_equal(one.rotations, same.rotations)
    assert np.array_equal(one.hips_m, same.hips_m)
    assert not np.allclose(one.rotations, other.rotations, atol=1e-3)
