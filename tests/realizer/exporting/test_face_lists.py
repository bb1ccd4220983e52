"""The CSV of the face has Live Link Face's columns, and the turns of head and eyes."""

import csv
import io

import numpy as np
import pytest

from tests.support.motion.hand_made_motion import BODY, X, Y, Z, turned, waving
from understudy.model import Interval, Viseme
from understudy.realizer.body.motion import SHAPES, Motion
from understudy.realizer.exporting.face_lists import COLUMNS, to_arkit_csv, to_viseme_text
from understudy.realizer.geometry.rotations import from_axis_angle


def rows(motion: Motion) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(to_arkit_csv(motion, BODY).decode())))


def test_columns_are_arkits_52_shapes_with_capitals() -> None:
    assert sorted(COLUMNS) == sorted(shape[0].upper() + shape[1:] for shape in SHAPES)
    first = rows(waving())[0]
    assert list(first)[:3] == ["Timecode", "BlendShapeCount", "EyeBlinkLeft"]
    assert list(first)[-9:-6] == ["HeadYaw", "HeadPitch", "HeadRoll"]
    assert first["BlendShapeCount"] == str(len(first) - 2) == "61"


def test_each_shape_stands_in_its_own_column() -> None:
    motion = waving()
    motion.shapes[5] = np.arange(len(SHAPES)) / 100
    row = rows(motion)[5]
    for number, shape in enumerate(SHAPES):
        assert float(row[shape[0].upper() + shape[1:]]) == pytest.approx(number / 100)


def test_timecodes_count_frames() -> None:
    codes = [row["Timecode"] for row in rows(waving(3.0, 60))]
    assert codes[0] == "00:00:00:00.000"
    assert codes[59] == "00:00:00:59.000"
    assert codes[121] == "00:00:02:01.000"


@pytest.mark.parametrize(("axis", "angle", "turn"), [(Y, 0.3, "Yaw"), (X, -0.3, "Pitch"), (Z, -0.3, "Roll")])
@pytest.mark.parametrize(("joint", "part"), [("neck", "Head"), ("leftEye", "LeftEye")])
def test_turns_to_the_left_up_and_to_the_left_shoulder_are_positive(
    axis: tuple[float, float, float], angle: float, turn: str, joint: str, part: str
) -> None:
    row = rows(turned(joint, from_axis_angle(axis, np.array(angle))))[0]
    expected = {f"{part}{each}": 0.3 if each == turn else 0.0 for each in ("Yaw", "Pitch", "Roll")}
    assert {name: float(row[name]) for name in expected} == pytest.approx(expected, abs=1e-6)


def viseme(label: str, start_s: float, end_s: float) -> Viseme:
    return Viseme(label, Interval(start_s, end_s), 0.8, 0.4)


@pytest.mark.parametrize(
    ("visemes", "lines"),
    [
        (
            (viseme("PP", 0.1, 0.2), viseme("aa", 0.2, 0.5)),
            ["0.000 sil", "0.100 PP", "0.200 aa", "0.500 sil", "1.000 sil"],
        ),
        ((viseme("PP", 0.0, 0.2), viseme("aa", 0.4, 1.0)), ["0.000 PP", "0.200 sil", "0.400 aa", "1.000 sil"]),
        ((viseme("nn", 0.0, 0.2), viseme("nn", 0.2, 1.0)), ["0.000 nn", "1.000 sil"]),
        ((viseme("sil", 0.0, 1.0),), ["0.000 sil"]),
        ((), ["0.000 sil", "1.000 sil"]),
    ],
)
def test_text_has_a_line_for_each_change(visemes: tuple[Viseme, ...], lines: list[str]) -> None:
    found = to_viseme_text(visemes, 1.0).decode()
    assert found.replace("\t", " ").splitlines() == lines
