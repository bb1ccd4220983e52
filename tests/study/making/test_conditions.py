"""U and S of a line: the same gestures, joined or each back at rest."""

import numpy as np
import pytest
from numpy.typing import NDArray

from understudy.errors import InputError
from understudy.files import resource_folder
from understudy.model import Channel, Line, Performance
from understudy.models import Understudy
from understudy.options import Options
from understudy.realization import PreparedSchedule, RealizedSchedule
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.body.skeleton import forward
from understudy.study.making.conditions import UnitVersions, in_modes, in_units_and_singly
from understudy.study.making.lines import StudyLine
from understudy.study.making.site import realized

EXAMPLES = resource_folder("examples")

STILL_SHAPES = [number for number, name in enumerate(SHAPES) if not name.startswith("eye")]
"""All but those of the eyes, which look where the head, on another body, does not point."""
LINE = Line((EXAMPLES / "example.flac").read_bytes(), (EXAMPLES / "example.txt").read_text())


@pytest.fixture(scope="module")
def versions(understudy: Understudy) -> UnitVersions:
    return in_units_and_singly(understudy, StudyLine("l", LINE, Options(profile="sweeping")))


def _strokes_s(found: RealizedSchedule) -> dict[str, float | None]:
    return {name: sync.stroke for name, sync in found.motion.realized.items() if name.startswith("script.")}


def test_both_versions_have_the_same_strokes(versions: UnitVersions) -> None:
    units, singletons = (_strokes_s(versions.motions[name]) for name in ("U", "S"))
    assert len(units) == versions.gestures > 1
    assert units == pytest.approx(singletons)


def test_single_gestures_go_back_to_rest_and_units_do_not(versions: UnitVersions) -> None:
    blended = {
        name: [each for each in found.motion.decisions if each.action == "blended"]
        for name, found in versions.motions.items()
    }
    assert len(blended["U"]) == versions.rests > 0
    assert blended["S"] == []


def test_hands_hang_at_the_side_before_and_after_and_in_s_between(
    understudy: Understudy, versions: UnitVersions
) -> None:
    """A hanging wrist is at the height of the hips' joints or below, a gesture's stroke above it."""
    low = {name: _lows(understudy, found) for name, found in versions.motions.items()}
    assert all(each[-1] for each in low.values())
    assert _times(low["S"]) - _times(low["U"]) == versions.rests


def test_face_and_head_are_the_same(versions: UnitVersions) -> None:
    faces = [versions.motions[name].motion.shapes[:, STILL_SHAPES] for name in ("U", "S")]
    assert np.allclose(faces[0], faces[1])


def test_units_need_a_profile(understudy: Understudy) -> None:
    with pytest.raises(InputError, match="profile"):
        in_units_and_singly(understudy, StudyLine("l", LINE, Options()))


def _lows(understudy: Understudy, found: RealizedSchedule) -> NDArray[np.bool_]:
    """Whether both wrists hang, frame by frame."""
    skeleton = understudy.realizer.performer(found.schedule.character).skeleton
    body = found.motion.body
    places, _turns = forward(skeleton, body.rotations, body.hips_m)
    left, right, hips = (places[:, skeleton.index[name], 1] for name in ("leftHand", "rightHand", "leftUpperLeg"))
    return np.asarray(np.maximum(left, right) < hips + 0.05)


def _times(lows: NDArray[np.bool_]) -> int:
    """How often hands come down."""
    return int(np.sum(~lows[:-1] & lows[1:]))


def _others(performance: Performance) -> list[tuple[str, str, float]]:
    return [
        (each.kind.value, each.lexeme, each.sync.start)
        for each in performance.behaviors
        if each.kept and each.kind is not Channel.GESTURE
    ]


def _gestures(performance: Performance) -> list[str]:
    return [each.lexeme for each in performance.behaviors if each.kept and each.kind is Channel.GESTURE]


def test_head_face_and_eyes_are_the_same_and_gestures_are_not(understudy: Understudy) -> None:
    found = in_modes(understudy, StudyLine("l", LINE, Options(seed=1)))
    assert list(found) == ["semantic", "prosody", "random"]
    assert _others(found["semantic"]) == _others(found["prosody"]) == _others(found["random"])
    assert set(_gestures(found["prosody"])) <= {"BEAT"}
    assert len({tuple(_gestures(each)) for each in found.values()}) == 3
    names = [[each.id for each in performance.behaviors] for performance in found.values()]
    assert all(len(set(each)) == len(each) for each in names)


def test_faces_move_alike_in_every_mode(understudy: Understudy) -> None:
    found = in_modes(understudy, StudyLine("l", LINE, Options(seed=1)))
    mouth = [number for number, name in enumerate(SHAPES) if not name.startswith("eye")]
    motions = [realized(understudy, PreparedSchedule.of(each)).motion for each in found.values()]
    faces = [motion.shapes[:, mouth] for motion in motions]
    assert np.allclose(faces[0], faces[1])
    assert np.allclose(faces[0], faces[2])
