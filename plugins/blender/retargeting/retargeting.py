"""Carries a clip's motion over to an armature: each bone is turned in the world as our joint is, from a rest pose that
is first turned to our T-pose; the hips' way is scaled to the length of the legs.

Bones without a joint keep their rest pose on their parents. What comes out is what Blender keys: rotations and
locations of pose bones relative to their rest.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from ..motion.clip import Clip
from ..motion.rotations import Array, quaternions
from .armature import AVERAGE_LEG_M, Armature, RestBone, character_axes, leg_length, metre
from .bone_tables import BoneTable
from .t_pose import turns_to_t_pose


@dataclass(frozen=True, slots=True, eq=False)
class BonePoses:
    """Rotations (T, 4; w x y z) of pose bones by name, and the place (T, 3) of the bone that carries them all."""

    rotations: Mapping[str, Array]
    root: str
    locations: Array


def retarget(clip: Clip, armature: Armature, table: BoneTable) -> BonePoses:
    """The clip on an armature whose bones go by the table, one pose a frame of the clip."""
    axes = character_axes(armature)
    ours = {joint: axes @ turn @ axes.T for joint, turn in clip.world_rotations().items()}
    to_t_pose = turns_to_t_pose(armature, axes, clip.t_pose_m(), clip.parents)
    joints = _joints_of_bones(armature, table)
    world = {bone: ours[joint] @ to_t_pose[joint] @ armature.bones[bone].rotation for bone, joint in joints.items()}
    rotations = {
        bone: quaternions(_carrier(armature.bones[bone], armature, world, table).swapaxes(-1, -2) @ world[bone])
        for bone in world
    }
    root = armature.joints["hips"]
    return BonePoses(rotations, root, _locations(clip, armature, axes, to_t_pose))


def _joints_of_bones(armature: Armature, table: BoneTable) -> dict[str, str]:
    also = {bone: joint for bone, joint in table.also.items() if bone in armature.bones}
    return {bone: joint for joint, bone in armature.joints.items()} | also


def _carrier(bone: RestBone, armature: Armature, world: Mapping[str, Array], table: BoneTable) -> Array:
    """The bone's rotation in the world (…, 3, 3) without its own rotation, which is that of its parents."""
    at = bone
    while at.inherits_rotation:
        carrier = table.follows.get(at.name, at.parent)
        if carrier not in armature.bones:
            break
        if carrier in world:
            return world[carrier] @ armature.bones[carrier].rotation.T @ bone.rotation
        at = armature.bones[carrier]
    return bone.rotation[None]


def _locations(clip: Clip, armature: Armature, axes: Array, to_t_pose: Mapping[str, Array]) -> Array:
    """How far the hips are from their rest (T, 3), in the axes that Blender keys them in."""
    rest_m = clip.t_pose_m()
    size = metre(armature) * AVERAGE_LEG_M / (leg_length(rest_m) or AVERAGE_LEG_M)
    moved = size * (clip.hips_m - rest_m["hips"]) @ axes.T + axes[:, 1] * _lift(armature, axes, to_t_pose)
    root = armature.bones[armature.joints["hips"]]
    return moved @ root.rotation if root.local_location else moved


def _lift(armature: Armature, axes: Array, to_t_pose: Mapping[str, Array]) -> float:
    """How much higher the hips stand when the legs are straight under them as in our T-pose, and the feet stay."""
    if not armature.has("leftUpperLeg", "leftLowerLeg", "leftFoot"):
        return 0.0
    hip, knee, ankle = (armature.head_of(f"left{part}") for part in ("UpperLeg", "LowerLeg", "Foot"))
    straight = to_t_pose["leftUpperLeg"] @ (knee - hip) + to_t_pose["leftLowerLeg"] @ (ankle - knee)
    return float(((ankle - hip) - straight) @ axes[:, 1])
