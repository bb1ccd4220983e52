"""The three modes of a line differ in their gestures alone."""

import numpy as np

from understudy.model import Channel, Line, Performance
from understudy.models import Understudy
from understudy.options import Options
from understudy.realization import PreparedSchedule
from understudy.realizer.body.motion import SHAPES
from understudy.resources import resource_folder
from understudy.study.making.clips import realized
from understudy.study.making.lines import StudyLine
from understudy.study.making.modes import in_modes

EXAMPLES = resource_folder("examples")
LINE = Line((EXAMPLES / "example.flac").read_bytes(), (EXAMPLES / "example.txt").read_text())


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
