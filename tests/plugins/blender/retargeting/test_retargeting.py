"""A clip on armatures that are ours turned, sized, lowered to an A-pose, and with other axes: in every one the joints
must be where ours are, so turned and sized."""

import numpy as np
import pytest

from plugins.blender.motion.rotations import Array
from plugins.blender.retargeting.armature import Armature, character_axes, metre
from plugins.blender.retargeting.bone_tables import FOLDER, BoneTable, read_table
from plugins.blender.retargeting.retargeting import retarget
from plugins.blender.retargeting.skeleton import JOINTS
from tests.plugins.blender.clips import X, Y, Z, about, armature, clip, places_of, posed_places

TABLE = read_table(FOLDER / "vrm.toml")
RANDOM = np.random.default_rng(7)


def gesturing() -> dict[str, list[list[float]]]:
    """A pose in which every joint is turned somewhere."""
    turns = RANDOM.normal(size=(len(JOINTS), 4)) * [0.3, 0.3, 0.3, 0.3] + [0, 0, 0, 1]
    return {
        joint: [turn.tolist()]
        for joint, turn in zip(JOINTS, turns / np.linalg.norm(turns, axis=1)[:, None], strict=True)
    }


POSE = gesturing()
Z_UP = about(X, np.pi / 2)
"""As Blender has it: up is Z, and the character faces −Y."""


def ours_m(pose: dict[str, list[list[float]]]) -> dict[str, Array]:
    """Our joints in the pose, by our own skeleton."""
    rotations = {joint: np.array([w, x, y, z]) for joint, [[x, y, z, w]] in pose.items()}
    return places_of(armature(), rotations, np.zeros(3))


def played(on: Armature, pose: dict[str, list[list[float]]], table: BoneTable = TABLE) -> dict[str, Array]:
    poses = retarget(clip(pose), on, table)
    return places_of(on, {bone: track[0] for bone, track in poses.rotations.items()}, poses.locations[0])


@pytest.mark.parametrize("turn", [np.eye(3), Z_UP, about(Y, np.pi) @ Z_UP, about(Z, 0.8) @ Z_UP])
@pytest.mark.parametrize("size", [1.0, 100.0])
def test_turned_and_sized(turn: Array, size: float) -> None:
    found = played(armature(turn=turn, size=size), POSE)
    for joint, place in ours_m(POSE).items():
        assert np.allclose(found[joint], size * turn @ place, atol=1e-3 * size), joint


def test_axes_of_bones_do_not_matter() -> None:
    axes = {joint: about(RANDOM.normal(size=3), 2.0) for joint in JOINTS}
    found = played(armature(turn=Z_UP, axes=axes), POSE)
    assert all(np.allclose(found[joint], Z_UP @ place, atol=1e-3) for joint, place in ours_m(POSE).items())


def test_an_a_pose_is_raised_first() -> None:
    found = played(armature(turn=Z_UP, arms_down_rad=0.8), POSE)
    assert all(np.allclose(found[joint], Z_UP @ place, atol=1e-3) for joint, place in ours_m(POSE).items())


def test_palms_that_face_forward_at_rest_face_down_in_the_t_pose() -> None:
    """Hands turned about the forearm by a quarter: only a frame of the whole hand, not its direction, tells."""
    at_rest = armature()
    turned = {"left": about(X, -np.pi / 2), "right": about(X, -np.pi / 2)}
    bones = dict(at_rest.bones)
    for joint, bone in at_rest.bones.items():
        side = next((each for each in turned if joint.startswith(each)), "")
        if side and any(part in joint for part in ("Hand", "Thumb", "Index", "Middle", "Ring", "Little")):
            wrist = at_rest.bones[f"{side}Hand"].head
            head = wrist + turned[side] @ (bone.head - wrist)
            bones[joint] = type(bone)(bone.name, bone.parent, head, turned[side] @ bone.rotation)
    found = played(Armature(bones, at_rest.joints), {})
    for joint, place in posed_places(0.0).items():
        assert np.allclose(found[joint], place, atol=1e-3), joint


def test_feet_stay_on_the_floor_of_a_rig_that_stands_with_legs_apart() -> None:
    apart = armature()
    bones = dict(apart.bones)
    for side, sign in (("left", 1), ("right", -1)):
        for part, moved in (("LowerLeg", 0.15), ("Foot", 0.3), ("Toes", 0.3)):
            bone = bones[side + part]
            bones[side + part] = type(bone)(bone.name, bone.parent, bone.head + sign * moved * X, bone.rotation)
    found = played(Armature(bones, apart.joints), {})
    assert found["leftFoot"][1] == pytest.approx(bones["leftFoot"].head[1], abs=1e-6)


def test_axes_are_read_from_the_body() -> None:
    turn = about(Z, 0.5) @ Z_UP
    assert np.allclose(character_axes(armature(turn=turn)), turn, atol=0.02)
    assert np.allclose(character_axes(armature(turn=about(Z, 0.1) @ Z_UP)), Z_UP)


def test_a_metre_goes_by_the_legs() -> None:
    assert metre(armature(size=100.0)) == pytest.approx(100, rel=1e-3)


def test_what_carries_a_bone_can_be_said_by_the_table() -> None:
    """A hand under another branch of the armature, which constraints carry with the forearm."""
    detached = armature()
    bones = dict(detached.bones)
    hand = bones["leftHand"]
    bones["leftHand"] = type(hand)("leftHand", "hips", hand.head, hand.rotation)
    table = BoneTable("mine", "Mine", TABLE.names, follows={"leftHand": "leftLowerArm"})
    found = retarget(clip(POSE), Armature(bones, detached.joints), table)
    whole = retarget(clip(POSE), detached, TABLE)
    assert np.allclose(found.rotations["leftHand"], whole.rotations["leftHand"])
