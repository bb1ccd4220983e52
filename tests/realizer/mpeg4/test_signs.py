"""Where positive body parameters move the body, as docs/motion-formats.md says beside the standard's descriptions, and
about which axis, as in Visage's `BAPRotationAxis` (docs/references.md)."""

import re
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.support.motion.hand_made_motion import BODY
from understudy.model import FloatArray
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.mpeg4.bap import UNIT_RAD
from understudy.realizer.mpeg4.bap_reading import from_bap
from understudy.realizer.mpeg4.layout import SIDES, ReadParameters

PAGE = Path(__file__).resolve().parents[3] / "docs" / "motion-formats.md"
ROWS = re.findall(
    r"^\| `(\w+)` \| [^|]+ \| (\w+) \| (\w+) \| (\w*) ?\|$", PAGE.read_text(encoding="utf-8"), re.MULTILINE
)
MOVED = {"shoulder": "UpperArm", "hand": "Hand", "fingertips": "IndexDistal", "foot": "Foot", "toes": "Toes"}
JOINTS = {
    name: part
    for part, names in (
        ("UpperLeg", ("hip_flexion", "hip_abduct", "hip_twisting")),
        ("LowerLeg", ("knee_flexion", "knee_twisting")),
        ("Foot", ("ankle_flexion", "subtalar_flexion", "ankle_twisting")),
        ("Toes", ("metatarsal_flexion",)),
        ("Shoulder", ("sternoclavicular_abduct", "sternoclavicular_rotate")),
        ("UpperArm", ("shoulder_flexion", "shoulder_abduct", "shoulder_twisting")),
        ("LowerArm", ("elbow_flexion", "elbow_twisting")),
        ("Hand", ("wrist_flexion", "wrist_pivot", "wrist_twisting")),
    )
    for name in names
}
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

VISAGE = (
    dict.fromkeys(("hip_flexion", "knee_flexion", "ankle_flexion", "metatarsal_flexion"), -1)
    | dict.fromkeys(("shoulder_flexion", "elbow_flexion", "wrist_pivot"), -1)
    | dict.fromkeys(("hip_twisting", "knee_twisting", "ankle_twisting", "shoulder_twisting", "elbow_twisting"), -2)
    | {"wrist_twisting": -2, "wrist_flexion": -3, "sternoclavicular_rotate": 2}
    | dict.fromkeys(("hip_abduct", "subtalar_flexion", "sternoclavicular_abduct", "shoulder_abduct"), 3)
)
"""The axis about which Visage turns both sides' parameters, against it if negative: 1 is X, 2 is Y, 3 is Z. Fingers are
not among them: there the palms face forward."""
VISAGE_TRUNK = {"skullbase": "head", "vc4": "neck", "vt6": "upperChest", "vt10": "chest", "vl3": "spine"}
VISAGE_CASES = [
    *((f"{short}_{name}", side + JOINTS[name], axis) for name, axis in VISAGE.items() for short, side in SIDES),
    *((f"{bone}_tilt", joint, -1) for bone, joint in VISAGE_TRUNK.items()),
    *((f"{bone}_torsion", joint, 2) for bone, joint in VISAGE_TRUNK.items()),
    *((f"{bone}_roll", joint, 3) for bone, joint in VISAGE_TRUNK.items()),
    *((f"HumanoidRoot_rt_body_{turn}", "hips", axis) for turn, axis in (("tilt", 1), ("turn", 2), ("roll", 3))),
]


@pytest.mark.parametrize(("parameter", "joint", "axis"), VISAGE_CASES)
def test_parameters_turn_about_the_axes_that_visage_has(parameter: str, joint: str, axis: int) -> None:
    turn = _turned(joint, {parameter: 0.3}) * _turned(joint, {}).inv()
    expected = np.zeros(3)
    expected[abs(axis) - 1] = 0.3 * np.sign(axis)
    assert turn.as_rotvec() == pytest.approx(expected, abs=1e-6)


def test_the_table_is_read() -> None:
    assert len(CASES) == 14 * 2 + 7


@pytest.mark.parametrize(("parameter", "joint", "way"), CASES)
def test_a_positive_angle_goes_where_the_page_says(parameter: str, joint: str, way: str) -> None:
    moved = _position(joint, {parameter: 0.3}) - _position(joint, {})
    axis = int(np.abs(moved).argmax())
    assert AXES[axis][0 if moved[axis] > 0 else 1] == way


def _posed(joint: str, angles: dict[str, float]) -> tuple[BodyMotion, list[int]]:
    """A body with these angles, and the places of the joints from its root to this one."""
    numbers = {name: np.array([angle / UNIT_RAD]) for name, angle in angles.items()}
    chain = [BODY.index[joint]]
    while BODY.parents[chain[0]] >= 0:
        chain.insert(0, BODY.parents[chain[0]])
    return from_bap(ReadParameters("3.1", 30, 1, numbers), BODY), chain


def _turned(joint: str, angles: dict[str, float]) -> Rotation:
    body, chain = _posed(joint, angles)
    turn = Rotation.identity()
    for place in chain:
        turn = turn * Rotation.from_quat(body.rotations[0, place])
    return turn


def _position(joint: str, angles: dict[str, float]) -> FloatArray:
    body, chain = _posed(joint, angles)
    at, turn = body.hips_m[0], Rotation.from_quat(body.rotations[0, chain[0]])
    for place in chain[1:]:
        at = at + turn.apply(np.array(BODY.offsets_m[place]))
        turn = turn * Rotation.from_quat(body.rotations[0, place])
    return np.asarray(at)
