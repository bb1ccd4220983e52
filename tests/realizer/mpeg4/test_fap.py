"""Face parameters, decoded by a reader of their own."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.support.motion.hand_made_motion import BODY, X, Y, Z, turned, waving
from tests.support.motion.mpeg4_reading import read_parameters
from understudy.errors import AuthoringError, InputError
from understudy.files import resource_folder
from understudy.model.formats import BapVersion
from understudy.realizer.body.motion import SHAPES, Motion
from understudy.realizer.face.face_tables import VISEMES
from understudy.realizer.geometry.rotations import from_axis_angle
from understudy.realizer.mpeg4.fap import TABLE, FapTable, from_fap, named_shapes, to_fap
from understudy.realizer.mpeg4.layout import FAPS, ReadParameters, read_parameter_file

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


def test_for_greta_neither_viseme_nor_expression_nor_head_is_set() -> None:
    mask = read_parameters(to_fap(waving(0.1, 30), BODY, FACE, version=BapVersion.GRETA)).masks[0]
    assert not mask[[0, 1, 47, 48, 49]].any()


def test_two_visemes_are_named_with_their_blend() -> None:
    """By MPEG-4's table p is 1 and k is 5; a blend of 63 is the first alone. Where nothing is said there is none."""
    motion = waving(0.1, 30)
    weights = np.zeros((len(motion.shapes), 15))
    weights[:, VISEMES.index("PP")], weights[1:, VISEMES.index("kk")] = 0.6, 0.3
    told = read_parameters(to_fap(motion, BODY, FACE, weights)).several
    assert told[0][0] == [1, 0, 63, 1]
    assert told[1][0] == [1, 5, 42, 1]
    assert read_parameters(to_fap(motion, BODY, FACE)).several[0][0] == [0, 0, 63, 1]


def test_expressions_are_named_with_their_intensities() -> None:
    """Joy is 1 and surprise 6, each as strong as its weakest action unit, of 63."""
    motion = waving(0.1, 30)
    shapes = np.zeros_like(motion.shapes)
    for name, weight in (("mouthSmileLeft", 1.0), ("mouthSmileRight", 0.5), ("browInnerUp", 0.9)):
        shapes[:, SHAPES.index(name)] = weight
    for name in ("browOuterUpLeft", "browOuterUpRight", "eyeWideLeft", "eyeWideRight"):
        shapes[:, SHAPES.index(name)] = 0.4
    assert read_parameters(to_fap(replace(motion, shapes=shapes), BODY, FACE)).several[0][1] == [1, 32, 6, 25, 0, 1]


@pytest.mark.parametrize(("axis", "column"), [(X, 48), (Y, 49), (Z, 50)])
def test_the_head_pitches_down_yaws_left_and_rolls_right_by_positive_angles(
    axis: tuple[float, float, float], column: int
) -> None:
    """About the axis to its left the head goes down, about the one upwards to its left, about the one forward it tilts
    to its right."""
    motion = turned("head", from_axis_angle(axis, np.array(0.2)))
    values = read_parameters(to_fap(motion, BODY, FACE)).values[0]
    assert [values[place - 1] for place in (48, 49, 50)] == [20_000 if place == column else 0 for place in (48, 49, 50)]
    read, _ = from_fap(read_parameter_file(to_fap(motion, BODY, FACE), FAPS, "x.fap"), BODY, FACE)
    assert read.rotations[0, BODY.index["head"]] == pytest.approx(
        motion.body.rotations[0, BODY.index["head"]], abs=1e-5
    )


def test_a_face_that_is_read_back_is_written_again_within_a_unit() -> None:
    motion = waving(0.5, 30)
    drawn = np.random.default_rng(3)
    shapes = drawn.random(motion.shapes.shape) * (drawn.random(motion.shapes.shape) < 0.3)
    motion = replace(turned_eye(motion), shapes=shapes)
    written = to_fap(motion, BODY, FACE, version=BapVersion.GRETA)
    body, weights = from_fap(read_parameter_file(written, FAPS, "x.fap"), BODY, FACE)
    again = to_fap(replace(motion, body=body, shapes=weights), BODY, FACE, version=BapVersion.GRETA)
    assert np.abs(read_parameters(again).values - read_parameters(written).values).max() <= 1


def test_a_file_of_names_alone_shows_them() -> None:
    numbers = {
        "viseme_select1": [1.0],
        "viseme_blend": [63.0],
        "expression_select1": [1.0],
        "expression_intensity1": [63.0],
    }
    visemes = np.zeros((15, len(SHAPES)))
    visemes[1, SHAPES.index("mouthClose")] = 0.8
    file = ReadParameters("2.1", 30, 1, {name: np.array(value) for name, value in numbers.items()})
    (shown,) = named_shapes(file, visemes)
    weights = {name: weight for name, weight in zip(SHAPES, shown, strict=True) if weight}
    assert weights == {"mouthClose": 0.8, "mouthSmileLeft": 1.0, "mouthSmileRight": 1.0}


def turned_eye(motion: Motion) -> Motion:
    rotations = motion.body.rotations.copy()
    rotations[:, BODY.index["leftEye"]] = from_axis_angle(Y, np.array(0.3))
    return replace(motion, body=replace(motion.body, rotations=rotations))


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (b"", "x.fap:1: the first line is"),
        (b"2.1 x.fap 30 2\n" + b"0 " * 68 + b"\n0\n", "the file ends"),
        (b"2.1 x.fap 0 1\n", "0 frames a second"),
        (b"2.1 x.fap 30 1\n1 0 1\n0 4 5\n", "x.fap:2: a mask of 68 columns"),
        (b"2.1 x.fap 30 1\n" + b"1 " + b"0 " * 67 + b"\n0 4 5\n", "2 numbers follow the mask, which asks for 4"),
        (b"2.1 x.fap 30 1\n" + b"0 0 1 " + b"0 " * 65 + b"\n0 inf\n", "1 numbers follow"),
    ],
)
def test_a_file_that_cannot_be_read_says_where(content: bytes, told: str) -> None:
    with pytest.raises(InputError) as caught:
        read_parameter_file(content, FAPS, "x.fap")
    assert (caught.value.code, told in caught.value.message) == ("mpeg4_wrong", True), caught.value.message


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
