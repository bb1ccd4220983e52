"""Frames while the schedule changes: they follow it, and nothing jumps."""

from itertools import pairwise

import numpy as np
import pytest

from tests.live.kept import kept
from understudy.live.body import (
    BEFORE_S,
    FACE_S,
    LONGEST_S,
    SPEED,
    TAKE_S,
    BodyFrame,
    BodyRequest,
    LiveBody,
    LiveBodyOptions,
    Offset,
    Pose,
)
from understudy.live.mouth import MouthShape
from understudy.model import Behavior, Channel, FloatArray, Hand, Schedule, SyncPoints
from understudy.models import Understudy
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.geometry.noise import _lattice
from understudy.realizer.geometry.rotations import angle_between, from_axis_angle
from understudy.realizer.realizing import realize

RATE_HZ = 30


def beat(at_s: float) -> Behavior:
    sync = SyncPoints(
        start=at_s, ready=at_s + 0.4, stroke_start=at_s + 0.4, stroke=at_s + 0.6, stroke_end=at_s + 0.65,
        relax=at_s + 1.0, end=at_s + 1.5,
    )  # fmt: skip
    return Behavior(f"beat{at_s}", Channel.GESTURE, "BEAT", sync, 0, 0, 1.0, hand=Hand.RIGHT)


def steps(frames: list[BodyFrame]) -> FloatArray:
    """How far each joint turns from a frame to the next, radians."""
    poses = np.stack([frame.rotations for frame in frames])
    return np.asarray(angle_between(poses[1:], poses[:-1]))


@pytest.fixture
def body(understudy: Understudy) -> LiveBody:
    return LiveBody(understudy.realizer, LiveBodyOptions("default", 3, RATE_HZ))


def test_a_schedule_that_does_not_change_is_realized_as_ever(understudy: Understudy, body: LiveBody) -> None:
    """The arms, for what the rest does by itself is another's luck, and on the first clock, for the pace of a gesture
    is drawn by its time and the seed (17.4° on a clock that begins with the stream). The end, which comes early here,
    is no matter: 1.7°, and 17.7° from a take that is not open-ended."""
    body.ask(BodyRequest((beat(1.0),)))
    frames = body.frames_until(3.0, ())
    schedule = Schedule((beat(BEFORE_S + 1.0),), duration_s=BEFORE_S + 3.2)
    whole = realize(understudy.realizer, schedule, frame_rate_hz=RATE_HZ, seed=3 + 1, open_ended=True)
    arm = understudy.realizer.skeleton.names.index("rightUpperArm")
    ours = np.stack([frame.rotations[arm] for frame in frames])
    theirs = whole.body.rotations[round(BEFORE_S * RATE_HZ) :, arm][: len(ours)]
    raised = angle_between(theirs, theirs[0])
    assert raised.max() > np.radians(20)
    assert np.degrees(np.abs(angle_between(ours, ours[0]) - raised)).max() < 6


def test_changes_and_new_clocks_make_no_jump(understudy: Understudy, body: LiveBody) -> None:
    """A beat every two seconds, asked for as it begins, for three takes: no joint goes faster than in the same
    schedule realized at once."""
    beats: list[Behavior] = []
    frames: list[BodyFrame] = []
    for begin_s in np.arange(0.0, 3 * TAKE_S, 2.0).tolist():
        frames += body.frames_until(begin_s, ())
        beats.append(beat(begin_s))
        body.ask(BodyRequest(tuple(beats[-3:])))
    whole = realize(understudy.realizer, Schedule(tuple(beats), duration_s=3 * TAKE_S), frame_rate_hz=RATE_HZ, seed=3)
    fastest = angle_between(whole.body.rotations[1:], whole.body.rotations[:-1]).max()
    assert steps(frames).max() < 1.2 * fastest
    hips_m = np.stack([frame.hips_m for frame in frames])
    assert np.abs(np.diff(hips_m, axis=0)).max() < 0.01
    assert all(other.at_s > one.at_s for one, other in pairwise(frames))


def test_a_gesture_taken_back_half_way_goes_to_rest_smoothly(body: LiveBody) -> None:
    body.ask(BodyRequest((beat(1.0),)))
    frames = [*body.frames_until(1.5, ())]
    moving = steps(frames).max()
    body.ask(BodyRequest(()))
    after = [frames[-1], *body.frames_until(3.0, ())]
    assert steps(after).max() < 1.2 * moving
    assert steps(after)[-10:].max() < np.radians(1)


def test_lips_follow_the_voice(body: LiveBody) -> None:
    shapes = [MouthShape(0.0, "sil", 1.0, 0.0), MouthShape(1.0, "aa", 1.0, 1.0), MouthShape(1.5, "sil", 1.0, 0.0)]
    jaw = [frame.shapes[SHAPES.index("jawOpen")] for frame in body.frames_until(2.0, shapes)]
    assert max(jaw[:29]) < 0.05
    assert max(jaw[40:45]) > 0.3
    assert max(jaw[-5:]) < 0.05


def test_poses_are_taken_apart_and_together() -> None:
    frames = [Pose(np.full((2, 4), k), np.full(3, k), np.full(52, k)) for k in range(3)]
    assert Pose.of(frames).at(1).hips_m.tolist() == [1, 1, 1]


def test_what_comes_later_is_realized_later_and_what_is_over_not_again(
    body: LiveBody, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Takes are counted, for each costs as much as seconds of anything else."""
    takes = []

    def counted(*arguments: object, **keywords: object) -> object:
        takes.append(body._next)
        return realize(*arguments, **keywords)  # type: ignore[arg-type]

    monkeypatch.setattr("understudy.live.body.realize", counted)
    body.ask(BodyRequest((beat(0.0),)))
    body.frames_until(1.7, ())
    body.ask(BodyRequest((beat(0.0), beat(3.0))))
    body.frames_until(2.5, ())
    assert len(takes) == 1
    body.frames_until(3.5, ())
    body.ask(BodyRequest((beat(3.0),)))
    body.frames_until(4.0, ())
    assert len(takes) == 2


def test_what_it_keeps_after_ten_minutes_is_what_it_kept_after_two(body: LiveBody) -> None:
    """Each clock has noise of another seed, which is not kept for ever either."""

    def after(minutes: int) -> tuple[dict[str, int], int]:
        for second in range(round(body._next / RATE_HZ), 60 * minutes + 1):
            body.frames_until(second, ())
        return kept(body), _lattice.cache_info().currsize

    assert after(2) == after(10)


FRAME_S = 1 / 60
X = (1.0, 0.0, 0.0)


def poses(angles: list[float], hips: list[float]) -> Pose:
    rotations = from_axis_angle(X, np.array(angles))[:, None]
    return Pose(rotations, np.array(hips)[:, None] * np.ones(3), np.zeros((len(angles), 52)))


def still(count: int) -> Pose:
    return poses([0.0] * count, [0.0] * count)


def test_it_begins_where_the_old_motion_was_as_fast_as_that_and_ends_on_the_new() -> None:
    shown = poses([0.98, 1.0], [0.09, 0.1])
    offset = Offset.between(shown, still(2), at_s=0.0, frame_s=FRAME_S)
    times_s = np.arange(1, round(LONGEST_S / FRAME_S) + 3) * FRAME_S
    blended = offset.added(still(len(times_s)), times_s)
    angles = angle_between(blended.rotations[:, 0], still(len(times_s)).rotations[:, 0])
    assert angles[0] == pytest.approx(1.02, abs=0.005)
    assert blended.hips_m[0] == pytest.approx(0.11, abs=0.002)
    assert angles[-1] == pytest.approx(0, abs=1e-6)
    assert blended.hips_m[-1] == pytest.approx(0, abs=1e-9)
    assert np.abs(np.diff(angles)).max() < (SPEED + 0.02 / FRAME_S) * FRAME_S


def test_later_the_new_motion_is_not_touched() -> None:
    offset = Offset.between(poses([0.0, 1.0], [0.0, 1.0]), still(2), at_s=0.0, frame_s=FRAME_S)
    motion = still(3)
    assert offset.added(motion, LONGEST_S + np.arange(3.0)) is motion


def test_weights_of_the_face_stay_within_their_bounds() -> None:
    shown, new = still(2), still(2)
    shown = Pose(shown.rotations, shown.hips_m, np.ones((2, 52)))
    offset = Offset.between(shown, new, at_s=0.0, frame_s=FRAME_S)
    times_s = np.arange(0.0, 2 * FACE_S, FRAME_S)
    full = still(len(times_s))
    blended = offset.added(Pose(full.rotations, full.hips_m, np.ones((len(times_s), 52))), times_s)
    assert blended.shapes.max() == 1.0
