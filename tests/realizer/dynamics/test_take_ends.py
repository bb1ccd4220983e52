"""No take begins or ends in mid-movement: the clocks at its ends, and wrists in the first and the last frames."""

from collections.abc import Sequence
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from understudy.model import Behavior, Channel, FloatArray, Hand, Interval, Level, Schedule, SyncPoints
from understudy.models import load_realizer
from understudy.realization import BmlInput, prepare_schedule
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton, arm_joints, forward
from understudy.realizer.dynamics.take_ends import ease_ends, eased_at_the_ends
from understudy.realizer.geometry.rotations import IDENTITY, angle_between, from_axis_angle, multiply
from understudy.realizer.realizing import Realizer, realize

RATE_HZ = 60
AT_REST_M_S = 0.1
OVER_S = 0.3
CHARACTERS = ("default", "expansive", "formal_elder", "reserved")


@pytest.fixture(scope="module")
def realizer() -> Realizer:
    return load_realizer()


@pytest.mark.parametrize("stands_s", [0.02, 1 / 24])
def test_a_clock_stands_at_the_ends_and_is_right_between(stands_s: float) -> None:
    times_s = np.arange(0.0, 4.0, 1 / RATE_HZ)
    eased_s = eased_at_the_ends(times_s, OVER_S, stands_s)
    inner = (times_s > OVER_S) & (times_s < times_s[-1] - OVER_S)
    assert np.allclose(eased_s[inner], times_s[inner])
    assert eased_s[[0, -1]] == pytest.approx(times_s[[0, -1]])
    steps = np.diff(eased_s) * RATE_HZ
    assert steps[[0, -1]].max() < 0.2
    assert 0 <= steps.min() <= steps.max() < 2.0
    assert np.abs(np.diff(steps)).max() < 0.35


def swaying(skeleton: Skeleton) -> BodyMotion:
    """A body that swings its arms by 30° to both sides, a second each, and is in the middle at both ends."""
    times_s = np.arange(0.0, 2.0 + 1e-6, 1 / RATE_HZ)
    rotations = np.tile(IDENTITY, (len(times_s), len(skeleton.names), 1))
    swings = from_axis_angle((1.0, 0.0, 0.0), np.radians(30) * np.sin(2 * np.pi * times_s))
    for side in (Hand.LEFT, Hand.RIGHT):
        rows = skeleton.rows(*arm_joints(side))
        rotations[:, rows] = rest_pose(skeleton, side, "at_side").rotations
        rotations[:, rows.start + 1] = multiply(swings, rotations[:, rows.start + 1])
    return BodyMotion(times_s, rotations, np.tile(skeleton.offsets_m[0], (len(times_s), 1)))


def wrist_speeds_m_s(skeleton: Skeleton, body: BodyMotion) -> FloatArray:
    at_m, _turned = forward(skeleton, body.rotations, body.hips_m)
    wrists_m = at_m[:, skeleton.chain("leftHand", "rightHand")]
    return np.asarray(np.linalg.norm(np.diff(wrists_m, axis=0), axis=2).max(axis=1) * RATE_HZ)


def test_a_body_that_moves_at_its_ends_comes_to_rest_there_and_is_else_as_it_was() -> None:
    skeleton = Skeleton.standing()
    body = swaying(skeleton)
    assert wrist_speeds_m_s(skeleton, body)[[0, -1]].min() > 1.0
    still = body.copy()
    assert ease_ends(skeleton, still, OVER_S)
    speeds = wrist_speeds_m_s(skeleton, still)
    assert speeds[[0, 1, -2, -1]].max() < AT_REST_M_S
    assert angle_between(still.rotations[[0, -1]], body.rotations[[0, -1]]).max() < 1e-6
    inner = (body.times_s > OVER_S) & (body.times_s < body.times_s[-1] - OVER_S)
    assert np.array_equal(still.rotations[inner], body.rotations[inner])
    assert not ease_ends(skeleton, still, OVER_S)
    assert not ease_ends(skeleton, body, 0.0)
    assert np.array_equal(body.rotations, swaying(skeleton).rotations)


def gesture(lexeme: str, stroke_s: float, hand: Hand) -> Behavior:
    sync = SyncPoints(max(0.0, stroke_s - 0.7), stroke=stroke_s, relax=stroke_s + 0.3, end=stroke_s + 0.8)
    return Behavior(f"{lexeme}{stroke_s}", Channel.GESTURE, lexeme, sync, 0, 0, 5.0, hand=hand)


def line(first_s: float, last_s: float, level: Level, character: str) -> Schedule:
    """A line whose first and last words have gestures, of both hands and of one."""
    gestures = (
        gesture("QUESTION", first_s, Hand.BOTH),
        gesture("POINT_LEFT", 1.6, Hand.RIGHT),
        gesture("SWEEP_NEGATION", last_s, Hand.BOTH),
    )
    phrases = (Interval(0.0, 1.4), Interval(1.6, 3.0))
    return Schedule(gestures, 3.0, phrases=phrases, agitation=level, character=character)


def fastest_at_the_ends_m_s(wrists_m: FloatArray, rates_hz: Sequence[int]) -> float:
    """Of the steps between the first two frames and between the last two of films with these rates."""
    found = []
    for rate_hz in rates_hz:
        step = RATE_HZ // rate_hz
        first_m, last_m = wrists_m[step] - wrists_m[0], wrists_m[-1] - wrists_m[-1 - step]
        found += [float(np.linalg.norm(way_m, axis=1).max()) * rate_hz for way_m in (first_m, last_m)]
    return max(found)


@pytest.mark.parametrize("character", CHARACTERS)
@pytest.mark.parametrize(("first_s", "last_s"), [(0.0, 2.98), (0.1, 2.7), (0.35, 2.4)])
def test_wrists_are_at_rest_at_the_ends_of_lines_whose_first_and_last_words_have_gestures(
    realizer: Realizer, first_s: float, last_s: float, character: str
) -> None:
    skeleton = realizer.performer(character).skeleton
    for level, seed in product(Level, range(3)):
        motion = realize(realizer, line(first_s, last_s, level, character), seed=seed)
        at_m, _turned = forward(skeleton, motion.body.rotations, motion.body.hips_m)
        wrists_m = at_m[:, skeleton.chain("leftHand", "rightHand")]
        assert fastest_at_the_ends_m_s(wrists_m, (60, 30)) < AT_REST_M_S, (level, seed)


BML = """<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" characterId="{character}" id="bml1">
  <gesture id="g1" lexeme="GREETING" mode="RIGHT_HAND" start="0" stroke="{first_s}"/>
  <gesture id="g2" lexeme="OPEN_HAND" mode="BOTH_HANDS" stroke="{last_s}" end="{end_s}"/>
</bml>"""


@pytest.mark.parametrize(("first_s", "last_s", "end_s"), [(0.05, 2.0, 2.05), (0.3, 2.4, 2.6), (0.6, 1.5, 1.6)])
@pytest.mark.parametrize("level", list(Level))
def test_wrists_are_at_rest_at_the_ends_of_bml_that_begins_and_ends_with_a_gesture(
    realizer: Realizer, first_s: float, last_s: float, end_s: float, level: Level
) -> None:
    for character in CHARACTERS[:2]:
        text = BML.format(character=character, first_s=first_s, last_s=last_s, end_s=end_s)
        prepared = prepare_schedule(None, BmlInput(text.encode(), Path("a.bml")), agitation=level)
        skeleton = realizer.performer(character).skeleton
        motion = realize(realizer, prepared.schedule)
        at_m, _turned = forward(skeleton, motion.body.rotations, motion.body.hips_m)
        assert fastest_at_the_ends_m_s(at_m[:, skeleton.chain("leftHand", "rightHand")], (60, 30)) < AT_REST_M_S
