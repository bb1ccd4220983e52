"""Before each phrase the weight goes to the other leg, and the ribs bend and turn against the pelvis."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.support.motion.movements import BODY, behavior, schedule
from understudy.model import Channel, FloatArray, Interval, Level, Schedule
from understudy.realizer.body.limits import violations
from understudy.realizer.body.movement_style import MovementStyle
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import inverse, multiply, rotate
from understudy.realizer.torso.idle import idle_motion
from understudy.realizer.torso.stance import BEFORE_S, beside, stances

LIFE = MovementStyle.load(Path(__file__).resolve().parents[3] / "lexicon" / "movement.yaml").idle
PHRASES = tuple(Interval(start_s, start_s + 2.0) for start_s in (1.0, 3.5, 6.0, 8.5, 11.0, 13.5))
TIMES_S: FloatArray = np.arange(0, 16, 1 / 30)
SPOKEN = Schedule((), 16.0, phrases=PHRASES)


def test_the_weight_changes_legs_before_each_phrase() -> None:
    weight = stances(TIMES_S, SPOKEN, LIFE, seed=1).weight
    moving = np.abs(np.diff(weight)) > 1e-6
    starts_s = TIMES_S[1:][moving & ~np.r_[False, moving[:-1]]]
    for phrase in PHRASES:
        assert abs(starts_s - (phrase.start_s - BEFORE_S)).min() < 0.1
    held = [weight[np.searchsorted(TIMES_S, phrase.end_s - 0.4)] for phrase in PHRASES]
    assert np.all(np.sign(held[1:]) == -np.sign(held[:-1]))
    assert np.abs(held).min() > 0.2


@pytest.mark.parametrize("seed", range(3))
def test_ribs_bend_and_turn_against_the_pelvis_and_the_trunk_goes_from_side_to_side(seed: int) -> None:
    body = idle_motion(BODY, TIMES_S, SPOKEN, seed=seed, life=LIFE)
    places_m, turned = forward(BODY, body.rotations, body.hips_m)
    hips, chest = BODY.chain("hips", "upperChest")
    bent = multiply(inverse(turned[:, hips]), turned[:, chest])
    side = np.degrees(np.arcsin(rotate(bent, np.array([[0.0, 1.0, 0.0]]))[:, 0]))
    twist = np.degrees(np.arcsin(rotate(bent, np.array([[0.0, 0.0, 1.0]]))[:, 0]))
    assert 8 < np.ptp(side) < 24
    assert 7 < np.ptp(twist) < 24
    assert 0.011 < places_m[:, chest, 0].std() < 0.035
    assert violations(BODY, body.rotations).max() == 0


@pytest.mark.parametrize("seed", range(3))
def test_the_pelvis_turns_against_the_ribs_and_takes_that_part_from_the_chest(seed: int) -> None:
    still_pelvis, turning = (
        stances(TIMES_S, SPOKEN, replace(LIFE, pelvis_share=share), seed=seed) for share in (0.0, LIFE.pelvis_share)
    )
    assert np.array_equal(turning.ribs, still_pelvis.ribs)
    assert not still_pelvis.pelvis.any()
    assert np.ptp(turning.pelvis) > np.radians(2.0)
    chest = turning.ribs[:, 1] + turning.pelvis
    assert np.allclose(chest, (1 - LIFE.pelvis_share) * turning.ribs[:, 1])


def test_what_a_posture_asks_for_is_kept() -> None:
    asked = behavior(Channel.POSTURE, "WEIGHT_ON_LEFT_LEG", 0.0, 0.8)
    body = idle_motion(BODY, TIMES_S, replace(SPOKEN, behaviors=(asked,)), seed=2, life=LIFE)
    assert body.hips_m[TIMES_S > 1.5, 0].min() > 0.015
    assert np.array_equal(beside(np.zeros(3), np.array([0.5, -0.5, 0.0]), uneven=0.4), [0.5, -0.5, 0.0])


def test_a_still_body_stays_as_it_stands_and_an_agitated_one_shifts_farther() -> None:
    ranges = [
        np.ptp(stances(TIMES_S, each, LIFE, seed=1).weight)
        for each in (
            replace(SPOKEN, stillness=1.0),
            *(replace(SPOKEN, agitation=level) for level in (Level.LOW, Level.HIGH)),
        )
    ]
    assert ranges[0] == 0
    assert ranges[2] > 1.4 * ranges[1]


def test_who_is_agitated_leans_forward_with_the_chest_up_and_who_is_lax_slumps() -> None:
    bows, leans = [], []
    for level in (Level.LOW, Level.HIGH):
        body = idle_motion(BODY, TIMES_S, replace(schedule(), agitation=level), seed=4)
        places_m, turned = forward(BODY, body.rotations, body.hips_m)
        hips, chest = BODY.chain("hips", "upperChest")
        bent = rotate(multiply(inverse(turned[:, hips]), turned[:, chest]), np.array([[0.0, 1.0, 0.0]]))
        bows.append(np.degrees(np.arcsin(bent[:, 2])).mean())
        leans.append((places_m[:, chest, 2] - places_m[:, hips, 2]).mean())
    assert bows[0] - bows[1] > 5
    assert leans[1] > leans[0]
