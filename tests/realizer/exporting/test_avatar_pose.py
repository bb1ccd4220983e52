"""Poses taken from avatars: whoever wears a pose, and however it is written, the joints have our angles again."""

import json
import struct
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.realizer.exporting.test_avatar import RIGS, a_posed, along_bones, avatar, t_posed
from tests.support.motion.hand_made_motion import BODY, waving
from understudy.errors import InputError, UndecodableError
from understudy.model import FloatArray, Hand
from understudy.realizer.avatars.avatar import to_avatar_glb
from understudy.realizer.avatars.pose import angles_deg, read_pose
from understudy.realizer.body.limits import MIRROR
from understudy.realizer.body.skeleton import arm_joints
from understudy.realizer.exporting.glb import to_glb
from understudy.realizer.geometry.rotations import angle_between, from_rotation_vector, multiply

MOTION = waving(1.0)
AT_S = 0.5
FRAME = int(np.searchsorted(MOTION.body.times_s, AT_S))


def from_angles(degrees: tuple[float, float, float]) -> FloatArray:
    """What `JOINT` does with three angles (docs/gesture-language.md): about x, then y, then z of the parent."""
    x, y, z = (from_rotation_vector(angle) for angle in np.radians(np.diag(degrees)))
    return multiply(z, multiply(y, x))


def off_deg(content: bytes) -> float:
    """The largest angle between a joint of the arms as taken from the file and as it was in the motion."""
    pose = read_pose(content, BODY, RIGS, time_s=AT_S)
    worst = 0.0
    for side in (Hand.LEFT, Hand.RIGHT):
        for name in arm_joints(side):
            ours = MOTION.body.rotations[FRAME, BODY.index[name]]
            ours = ours if side is Hand.LEFT else ours * MIRROR
            taken = from_angles(pose.arms[side].get(name.removeprefix(side), (0.0, 0.0, 0.0)))
            worst = max(worst, float(np.degrees(angle_between(ours, taken))))
    return worst


@pytest.mark.parametrize("nodes", [t_posed, along_bones])
def test_a_pose_is_taken_back_from_any_avatar_that_wears_it(nodes: Callable[[], list[Any]]) -> None:
    assert off_deg(to_avatar_glb(MOTION, BODY, avatar(nodes()), RIGS)) < 0.2


def test_a_pose_is_taken_back_from_our_own_body() -> None:
    """Its skin has a bind pose, which is the T-pose."""
    assert off_deg(to_glb(MOTION, BODY)) < 0.2


def test_an_avatar_that_rests_with_arms_down_has_them_down_unless_it_is_turned() -> None:
    """45° below the horizontal, where the T-pose has 0."""
    pose = read_pose(avatar(a_posed()), BODY, RIGS)
    assert pose.animation is None
    for side in (Hand.LEFT, Hand.RIGHT):
        assert pose.arms[side]["UpperArm"] == pytest.approx((0, 0, -45), abs=0.1)


def test_a_pose_of_the_nodes_is_how_they_are_turned_from_the_skin() -> None:
    """Blender writes a posed character so: nodes in the pose, the skin's inverse bind matrices at rest."""
    tree, content = _parts(to_glb(MOTION, BODY))
    tree.pop("animations")
    turn = from_angles((0.0, -80.0, 0.0))
    named = {node.get("name"): node for node in tree["nodes"]}
    named["leftLowerArm"]["rotation"] = turn.tolist()
    assert read_pose(_glb(tree, content), BODY, RIGS).arms == {
        Hand.LEFT: {"LowerArm": (0.0, -80.0, 0.0)},
        Hand.RIGHT: {},
    }


def test_a_pose_is_the_same_where_the_mesh_is_bound_with_z_up() -> None:
    """As FBX files are: the armature turns it upright."""
    tree, content = _parts(to_glb(MOTION, BODY))
    quarter = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1.0]])
    accessor = tree["accessors"][tree["skins"][0]["inverseBindMatrices"]]
    start = tree["bufferViews"][accessor["bufferView"]].get("byteOffset", 0) + accessor.get("byteOffset", 0)
    matrices = np.frombuffer(content, "<f4", 16 * accessor["count"], start).reshape(-1, 4, 4).transpose(0, 2, 1)
    turned = (matrices @ np.linalg.inv(quarter)).transpose(0, 2, 1).astype("<f4").tobytes()
    assert off_deg(_glb(tree, content[:start] + turned + content[start + len(turned) :])) < 0.2


def test_an_animation_is_found_by_its_name() -> None:
    content = to_glb(MOTION, BODY)
    assert read_pose(content, BODY, RIGS, animation="performance").animations == ("performance",)
    with pytest.raises(InputError, match="no animation 'dance'; it has 'performance'") as caught:
        read_pose(content, BODY, RIGS, animation="dance")
    assert caught.value.code == "unknown_name"


@pytest.mark.parametrize(
    "spoil",
    [
        lambda tree: tree["animations"][0]["channels"][3].update(sampler=10_000),
        lambda tree: tree["animations"][0]["samplers"][3].update(output=10_000),
        lambda tree: tree["animations"][0].update(samplers="x"),
        lambda tree: tree["accessors"][tree["animations"][0]["samplers"][3]["output"]].update(count=10_000),
        lambda tree: tree["accessors"][tree["animations"][0]["samplers"][3]["output"]].update(type="SCALAR"),
        lambda tree: tree["skins"][0].update(inverseBindMatrices=0),
    ],
)
def test_a_file_that_cannot_be_right_is_told(spoil: Callable[[Any], object]) -> None:
    tree, content = _parts(to_glb(MOTION, BODY))
    spoil(tree)
    with pytest.raises(UndecodableError) as caught:
        read_pose(_glb(tree, content), BODY, RIGS)
    assert caught.value.code == "avatar_undecodable"


@given(st.tuples(*[st.floats(-180, 180)] * 3))
def test_angles_make_the_rotation_again(degrees: tuple[float, float, float]) -> None:
    """Within what rounding to a tenth leaves, also where two axes fall together."""
    turn = from_angles(degrees)
    assert np.degrees(angle_between(turn, from_angles(angles_deg(turn)))) < 0.2


def test_the_axes_that_fall_together_lose_nothing() -> None:
    for y in (90.0, -90.0):
        turn = from_angles((30.0, y, 10.0))
        assert np.degrees(angle_between(turn, from_angles(angles_deg(turn)))) < 0.2


def _parts(glb: bytes) -> tuple[dict[str, Any], bytes]:
    size = struct.unpack_from("<I", glb, 12)[0]
    return json.loads(glb[20 : 20 + size]), glb[28 + size :]


def _glb(tree: dict[str, Any], content: bytes) -> bytes:
    described = json.dumps(tree).encode()
    described += b" " * (-len(described) % 4)
    head = struct.pack("<4sII", b"glTF", 2, 28 + len(described) + len(content))
    return (
        head
        + struct.pack("<I4s", len(described), b"JSON")
        + described
        + struct.pack("<I4s", len(content), b"BIN\0")
        + content
    )
