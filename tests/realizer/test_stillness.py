"""A still body: the less it is to move, the less it does; at 1 it breathes, blinks and speaks, and that is all."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from understudy.model import FloatArray, Line, Schedule
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import realize, schedule_of
from understudy.realizer.body.motion import SHAPES, Motion
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.geometry.rotations import angle_between

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
BREATHING = ("spine", "chest", "upperChest", "leftShoulder", "rightShoulder", "neck", "head", "leftEye", "rightEye")
STILL_RAD = 2e-4
"""Arms that hang are kept straight down while the breath moves the shoulders: by less than a hundredth of a degree."""
"""What breath moves: the trunk and the collarbones, and neck, head and eyes against it, so that the head is level."""
SPEAKING = ("jaw", "mouth", "tongue", "eyeBlink")


@pytest.fixture(scope="module")
def schedules(understudy: Understudy) -> dict[float, Schedule]:
    audio = (AUDIO_FOLDER / "figure8.flac").read_bytes()
    line = Line(audio, (AUDIO_FOLDER / "figure8.txt").read_text(encoding="utf-8"))
    options = Options(character="expansive", seed=3)
    shares = (0.0, 0.5, 1.0)
    return {share: schedule_of(perform(understudy, line, replace(options, stillness=share))) for share in shares}


@pytest.fixture(scope="module")
def motions(understudy: Understudy, schedules: dict[float, Schedule]) -> dict[float, Motion]:
    return {share: realize(understudy.realizer, each, frame_rate_hz=30, seed=3) for share, each in schedules.items()}


def _turned(motion: Motion) -> FloatArray:
    """How far (J,) each joint is ever turned from where it is in the first frame, radians."""
    rotations = motion.body.rotations
    return np.asarray(angle_between(rotations[:1], rotations).max(axis=0))


def _joints(skeleton: Skeleton) -> list[int]:
    return [joint for joint, name in enumerate(skeleton.names) if name not in BREATHING]


def test_at_one_no_joint_moves_but_those_that_breathe(motions: dict[float, Motion], understudy: Understudy) -> None:
    skeleton = understudy.realizer.skeleton
    turned = _turned(motions[1.0])
    assert turned[_joints(skeleton)].max() < STILL_RAD
    assert np.ptp(motions[1.0].body.hips_m, axis=0).max() < 1e-6
    assert 0.005 < turned[skeleton.index["chest"]] < np.radians(2)
    assert turned[skeleton.chain("neck", "head")].max() < np.radians(2)
    assert turned[skeleton.chain("leftEye", "rightEye")].max() < np.radians(2)


def test_at_one_no_face_moves_but_lips_and_lids(motions: dict[float, Motion]) -> None:
    moved = {name for name, by in zip(SHAPES, np.ptp(motions[1.0].shapes, axis=0), strict=True) if by > 0.01}
    assert {name for name in moved if not name.startswith(SPEAKING)} == set()
    assert {"jawOpen", "eyeBlinkLeft", "mouthClose"} <= moved


def test_lips_speak_as_they_do_otherwise(schedules: dict[float, Schedule]) -> None:
    assert schedules[1.0].visemes == schedules[0.0].visemes


def test_in_between_the_body_does_less(motions: dict[float, Motion], understudy: Understudy) -> None:
    index = understudy.realizer.skeleton.index
    for joint in ("hips", "head", "neck", "leftEye"):
        lively, half, still = (_turned(motions[share])[index[joint]] for share in (0.0, 0.5, 1.0))
        assert lively > half > still


@pytest.mark.parametrize("seed", [0, 7])
def test_a_body_with_nothing_to_do_is_as_still(understudy: Understudy, seed: int) -> None:
    """A listener's schedule has no words; at 1 nothing is left of his either."""
    motion = realize(understudy.realizer, Schedule((), 4.0, stillness=1.0), frame_rate_hz=30, seed=seed)
    assert _turned(motion)[_joints(understudy.realizer.skeleton)].max() < STILL_RAD
    assert np.ptp(motion.shapes, axis=0).max() < 0.01
