"""Where positive body parameters move the body, as docs/motion-formats.md says beside the standard's descriptions."""

import re
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.support.motion.hand_made_motion import BODY
from understudy.model import FloatArray
from understudy.realizer.mpeg4.bap import UNIT_RAD
from understudy.realizer.mpeg4.bap_reading import from_bap
from understudy.realizer.mpeg4.layout import ReadParameters

PAGE = Path(__file__).resolve().parents[3] / "docs" / "motion-formats.md"
ROWS = re.findall(
    r"^\| `(\w+)` \| [^|]+ \| (\w+) \| (\w+) \| (\w*) ?\|$", PAGE.read_text(encoding="utf-8"), re.MULTILINE
)
MOVED = {"shoulder": "UpperArm", "hand": "Hand", "fingertips": "IndexDistal", "foot": "Foot", "toes": "Toes"}
AXES = (("left", "right"), ("up", "down"), ("forward", "backward"))
CASES = [
    case
    for name, what, left, right in ROWS
    for case in (
        [(f"l_{name}", f"left{MOVED[what]}", left), (f"r_{name}", f"right{MOVED[what]}", right)]
        if right
        else [(name, {"head": "head", "eyes": "leftEye"}[what], left)]
    )
]


def test_the_table_is_read() -> None:
    assert len(CASES) == 14 * 2 + 7


@pytest.mark.parametrize(("parameter", "joint", "way"), CASES)
def test_a_positive_angle_goes_where_the_page_says(parameter: str, joint: str, way: str) -> None:
    moved = _position(joint, {parameter: 0.3}) - _position(joint, {})
    axis = int(np.abs(moved).argmax())
    assert AXES[axis][0 if moved[axis] > 0 else 1] == way


def _position(joint: str, angles: dict[str, float]) -> FloatArray:
    numbers = {name: np.array([angle / UNIT_RAD]) for name, angle in angles.items()}
    body = from_bap(ReadParameters("3.1", 30, 1, numbers), BODY)
    chain = [BODY.index[joint]]
    while BODY.parents[chain[0]] >= 0:
        chain.insert(0, BODY.parents[chain[0]])
    at, turn = body.hips_m[0], Rotation.from_quat(body.rotations[0, chain[0]])
    for place in chain[1:]:
        at = at + turn.apply(np.array(BODY.offsets_m[place]))
        turn = turn * Rotation.from_quat(body.rotations[0, place])
    return np.asarray(at)
