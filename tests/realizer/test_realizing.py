"""The whole realizer on a real line: what must hold of every motion."""

from dataclasses import replace
from math import ceil
from pathlib import Path

import numpy as np
import pytest

from understudy.errors import InputError
from understudy.model import Channel, Line
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import RealizedSchedule, realize, schedule_of
from understudy.realizer.body.contacts import penetrations_m
from understudy.realizer.body.limits import violations
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.realizing import frame_times_s

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
FRAME_S = 1 / 60


@pytest.fixture(scope="module")
def realized(understudy: Understudy) -> RealizedSchedule:
    audio = (AUDIO_FOLDER / "figure8.flac").read_bytes()
    text = (AUDIO_FOLDER / "figure8.txt").read_text(encoding="utf-8")
    schedule = schedule_of(perform(understudy, Line(audio, text), Options(character="expansive")))
    return RealizedSchedule(schedule, realize(understudy.realizer, schedule))


def test_frames_last_until_all_is_over_two_at_least() -> None:
    assert list(frame_times_s(0.1, 30)) == pytest.approx([0, 1 / 30, 2 / 30])
    assert list(frame_times_s(0.101, 30)) == pytest.approx([0, 1 / 30, 2 / 30, 3 / 30])
    assert len(frame_times_s(0.0, 60)) == 2


def test_every_gesture_is_played_on_its_stroke_or_has_a_decision(realized: RealizedSchedule) -> None:
    decided = {decision.behavior for decision in realized.motion.decisions}
    for behavior in realized.schedule.behaviors:
        played = realized.motion.realized.get(behavior.id)
        if behavior.kind is Channel.GESTURE and played is None:
            assert behavior.id in decided
        elif behavior.kind is Channel.GESTURE and played is not None:
            late = any(each.behavior == behavior.id and each.action == "late" for each in realized.motion.decisions)
            assert late or played.stroke == pytest.approx(behavior.sync.stroke, abs=FRAME_S)


def test_rotations_are_unit_and_weights_are_shares(realized: RealizedSchedule) -> None:
    motion = realized.motion
    assert np.allclose(np.linalg.norm(motion.body.rotations, axis=-1), 1)
    assert motion.shapes.min() >= 0
    assert motion.shapes.max() <= 1
    assert len(motion.body.times_s) == len(motion.shapes) == len(motion.body.hips_m)


def test_nothing_ever_freezes_and_nothing_jumps(realized: RealizedSchedule, understudy: Understudy) -> None:
    """Shared/motion.md: no jump of a joint above 20 rad/s; eyes in saccades are left out."""
    skeleton = understudy.realizer.skeleton
    joints = [joint for joint, name in enumerate(skeleton.names) if not name.endswith("Eye")]
    rotations = realized.motion.body.rotations
    assert angle_between(rotations[:-1], rotations[1:]).max(axis=-1).min() > 0
    speeds = angle_between(rotations[:-1, joints], rotations[1:, joints]) / FRAME_S
    assert np.abs(np.diff(speeds, axis=0)).max() < 20


def test_joints_keep_their_limits_and_hands_stay_outside(realized: RealizedSchedule, understudy: Understudy) -> None:
    skeleton, body = understudy.realizer.performer("expansive").skeleton, realized.motion.body
    assert np.count_nonzero(violations(skeleton, body.rotations)) == 0
    assert np.max(penetrations_m(skeleton, body.rotations, body.hips_m)) < 0.01


def test_the_motion_has_as_many_frames_as_its_recording(realized: RealizedSchedule, understudy: Understudy) -> None:
    for rate_hz in (30, 60):
        motion = realize(understudy.realizer, realized.schedule, frame_rate_hz=rate_hz)
        assert len(motion.body.times_s) == ceil(realized.schedule.duration_s * rate_hz)
        assert max(event.time_s for event in motion.events()) <= motion.body.times_s[-1]


def test_a_tail_gives_hands_the_time_to_rest_and_a_cut_is_told(
    realized: RealizedSchedule, understudy: Understudy
) -> None:
    """A line that ends when its last gesture's hold does; a calm hand may take most of the tail to come to rest."""
    gestures = [each.sync for each in realized.schedule.behaviors if each.kind is Channel.GESTURE]
    short = replace(realized.schedule, duration_s=max(sync.relax or 0.0 for sync in gestures))
    cut = realize(understudy.realizer, short)
    assert "cut" in {each.action for each in cut.decisions}
    whole = realize(understudy.realizer, short, tail_s=2.0)
    assert "cut" not in {each.action for each in whole.decisions}
    assert len(whole.body.times_s) - len(cut.body.times_s) == 120
    elbow = understudy.realizer.skeleton.index["rightLowerArm"]
    assert angle_between(whole.body.rotations[-10:-1, elbow], whole.body.rotations[-9:, elbow]).max() * 60 < 0.3


@pytest.mark.parametrize("tail_s", [-0.1, 10.1, float("nan")])
def test_a_tail_is_within_its_limits(realized: RealizedSchedule, understudy: Understudy, tail_s: float) -> None:
    with pytest.raises(InputError, match="tail"):
        realize(understudy.realizer, realized.schedule, tail_s=tail_s)


@pytest.mark.parametrize("seed", [-3, 5 - 2**70, 2**63 - 1])
def test_any_integer_is_a_seed(realized: RealizedSchedule, understudy: Understudy, seed: int) -> None:
    one, other = (realize(understudy.realizer, realized.schedule, seed=each) for each in (seed, seed + 2**64))
    assert np.array_equal(one.body.rotations, other.body.rotations)
    assert np.array_equal(one.shapes, other.shapes)
