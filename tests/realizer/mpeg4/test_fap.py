"""Face parameters, decoded by a reader of their own."""

from pathlib import Path

import numpy as np
import pytest

from tests.support.motion.hand_made_motion import BODY, X, Y, turned, waving
from tests.support.motion.mpeg4_reading import read_parameters
from understudy.errors import AuthoringError
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.geometry.rotations import from_axis_angle
from understudy.realizer.mpeg4.fap import TABLE, FapTable, to_fap
from understudy.realizer.mpeg4.layout import FAPS
from understudy.resources import resource_folder

FACE = FapTable.load(resource_folder("lexicon") / TABLE)
JAW, LEFT_YAW, LEFT_PITCH = 3, 23, 25


def test_the_mouth_opens_as_the_weights_say() -> None:
    motion = waving(0.5, 30)
    file = read_parameters(to_fap(motion, BODY, FACE))
    assert (file.version, file.name, file.rate_hz) == ("2.1", "understudy.fap", 30)
    assert file.masks.shape == (len(motion.shapes), 68)
    opened = motion.shapes[:, SHAPES.index("jawOpen")] * FACE.amounts["open_jaw"]["jawOpen"]
    assert np.abs(file.values[:, JAW - 1] - opened).max() <= 0.5
    assert file.values[:, JAW - 1].max() > 0


def test_neither_viseme_nor_expression_nor_head_is_set() -> None:
    mask = read_parameters(to_fap(waving(0.1, 30), BODY, FACE)).masks[0]
    assert not mask[[0, 1, 47, 48, 49]].any()


def test_the_outer_lips_go_with_the_inner_ones() -> None:
    """FAP 51 to 60 are, in the same order, the outer points of 4 to 13 but the lips' ends, which come last."""
    values = read_parameters(to_fap(waving(0.5, 30), BODY, FACE)).values
    inner, outer = FAPS.index("raise_b_midlip"), FAPS.index("raise_b_midlip_o")
    assert outer == 51
    opened = values[:, inner]
    assert opened.min() < 0
    assert values[:, outer] == pytest.approx(0.9 * opened, abs=12)
    assert {f"{name.removesuffix('_o')}_o" for name in FACE.amounts if "lip" in name and "push" not in name} <= set(
        FACE.amounts
    )


@pytest.mark.parametrize(("axis", "column"), [(Y, LEFT_YAW), (X, LEFT_PITCH)])
def test_eyes_turn_left_and_down_by_positive_angles(axis: tuple[float, float, float], column: int) -> None:
    motion = turned("leftEye", from_axis_angle(axis, np.array(0.2)))
    values = read_parameters(to_fap(motion, BODY, FACE)).values[0]
    assert values[column - 1] == 20_000
    assert values[LEFT_YAW] == values[LEFT_PITCH] == 0, "the right eye looks ahead"


def test_every_shape_that_moves_has_a_parameter_but_those_of_the_gaze() -> None:
    shown = {shape for shapes in FACE.amounts.values() for shape in shapes}
    assert {name for name in SHAPES if name not in shown} <= {
        *(f"eyeLook{way}{side}" for way in ("Up", "In", "Out") for side in ("Left", "Right")),
        *("mouthPressLeft", "mouthPressRight"),
    }
    assert FACE.amounts.keys() <= set(FAPS)


@pytest.mark.parametrize(
    ("written", "told"), [("open_jow: {jawOpen: 1}", "open_jaw"), ("open_jaw: {jawOpened: 1}", "jawOpen")]
)
def test_wrong_names_are_told(tmp_path: Path, written: str, told: str) -> None:
    (tmp_path / TABLE).write_text(f"open_jaw: {{jawOpen: 900}}\n{written}\n" if "jow" in written else written)
    with pytest.raises(AuthoringError) as caught:
        FapTable.load(tmp_path / TABLE)
    assert told in caught.value.mistakes[0].message
