"""The pose in which somebody left an avatar, as angles of our arms' joints: for gestures whose poses the language
cannot say otherwise (Gesture Engine §4.2, the override by joint angles).

A pose is how far the avatar is from its bind pose, which is that of its skin, or its nodes' own where it has none. It
is read from an animation at a time, or, in a file without animations, from the nodes as they are. It undoes what
`avatar.to_avatar_glb` does. Angles are for the left arm, as in the gesture language; the right arm's are mirrored.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from pydantic import ValidationError

from ...errors import InputError, UndecodableError
from ...model import FloatArray, Hand
from ..body.limits import MIRROR
from ..body.skeleton import SIDES, Skeleton, arm_joints
from ..exporting.gltf_reading import animation_names, bind_matrices, rotations_at
from ..exporting.retargeting import Rig
from ..geometry.rotations import IDENTITY, inverse, multiply, normalized
from .avatar import at_front, to_t_pose
from .reading import Avatar, local_matrix, read_avatar, turn_and_scale

_DECIMALS = 1
"""To a tenth of a degree, which nobody sees."""

_STILL_DEG = 0.05

Degrees = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class AvatarPose:
    """The angles of each arm's joints that the avatar has, by the names of the gesture language, where it was read, and
    the joints that it lacks."""

    arms: Mapping[Hand, Mapping[str, Degrees]]
    animation: str | None
    animations: tuple[str, ...]
    missing: tuple[str, ...]


def read_pose(
    content: bytes, skeleton: Skeleton, rigs: Mapping[str, Rig], *, animation: str | None = None, time_s: float = 0.0
) -> AvatarPose:
    """The pose at `time_s` of an animation, the first unless it is named.

    Raises as `read_avatar` does, and InputError `unknown_name` for an animation that is not there.
    """
    avatar = read_avatar(content, rigs)
    try:
        names = animation_names(avatar.tree)
        if animation is not None and animation not in names:
            known = ", ".join(map(repr, names)) or "none"
            message = f"the file has no animation {animation[:80]!r}; it has {known}"
            raise InputError("unknown_name", message, field="animation")
        number = (names.index(animation) if animation is not None else 0) if names else None
        turned = {} if number is None else rotations_at(avatar.tree, avatar.content, number, time_s)
        world = _posed(avatar, turned)
        bound = _in_bind_pose(avatar)
    except (ValueError, ValidationError) as error:
        message = f"the pose of the avatar cannot be read: {str(error)[:300]}"
        raise UndecodableError("avatar_undecodable", message, field="avatar") from None
    local = _local(bound, world, skeleton)
    wanted = [name for side in SIDES for name in arm_joints(Hand(side))]
    return AvatarPose(
        arms={Hand(side): _arm(local, Hand(side)) for side in SIDES},
        animation=names[number] if number is not None else None,
        animations=names,
        missing=tuple(name for name in wanted if name not in avatar.nodes),
    )


def _posed(avatar: Avatar, turned: Mapping[int, FloatArray]) -> FloatArray:
    """The orientations (N, 4) of the nodes in the world, with these local rotations instead of their own."""
    found = np.tile(IDENTITY, (len(avatar.parents), 1))
    for number in avatar.in_order():
        node, parent = avatar.file.nodes[number], avatar.parents[number]
        own = turned.get(number)
        if own is None:
            own = turn_and_scale(local_matrix(node, number))[0] if node.matrix else normalized(np.array(node.rotation))
        found[number] = multiply(found[parent] if parent >= 0 else IDENTITY, own)
    return found


def _in_bind_pose(avatar: Avatar) -> Avatar:
    """The avatar as its skin binds it, upright; as its nodes are where the skin does not hold all the joints that are
    turned."""
    bound = bind_matrices(avatar.tree, avatar.content)
    needed = {node for joint, node in avatar.nodes.items() if joint in {"hips", "head"} or joint.endswith("Arm")}
    if not needed <= bound.keys():
        return avatar
    matrices, orientations = avatar.matrices.copy(), avatar.orientations.copy()
    upright = _upright(avatar, bound)
    for node in set(avatar.nodes.values()) & bound.keys():
        turn = turn_and_scale(bound[node])[0]
        matrices[node] = upright @ bound[node]
        orientations[node] = multiply(turn_and_scale(upright)[0], turn)
    return replace(avatar, matrices=matrices, orientations=orientations)


def _upright(avatar: Avatar, bound: Mapping[int, FloatArray]) -> FloatArray:
    """The turn (4, 4) by whole quarters after which the head is above the hips and the left is at +X: meshes are bound
    in spaces of their own, many with Z up."""
    places = {joint: bound[node][:3, 3] for joint, node in avatar.nodes.items() if node in bound}
    up, across = places["head"] - places["hips"], places["leftUpperArm"] - places["rightUpperArm"]
    axes = np.zeros((3, 3))
    for row, direction in ((1, up), (0, across)):
        axes[row, np.argmax(np.abs(direction))] = np.sign(direction[np.argmax(np.abs(direction))])
    axes[2] = np.cross(axes[0], axes[1])
    turn = np.eye(4)
    if np.linalg.det(axes) > 0.5:
        turn[:3, :3] = axes
    return turn


def _local(avatar: Avatar, world: FloatArray, skeleton: Skeleton) -> dict[str, FloatArray]:
    """The rotation (4,) of each of our joints in its parent that puts it where the avatar's is; a joint that the avatar
    does not have is not turned."""
    front, t_pose = at_front(avatar), to_t_pose(avatar, skeleton)
    ours: dict[str, FloatArray] = {}
    local: dict[str, FloatArray] = {}
    for joint, parent in zip(skeleton.names, skeleton.parents, strict=True):
        above = ours[skeleton.names[parent]] if parent >= 0 else np.array(IDENTITY)
        node = avatar.nodes.get(joint)
        if node is None:
            ours[joint] = above
            continue
        here = multiply(world[node], inverse(multiply(t_pose[joint], avatar.orientations[node])))
        ours[joint] = multiply(multiply(inverse(front), here), front)
        local[joint] = multiply(inverse(above), ours[joint])
    return local


def _arm(local: Mapping[str, FloatArray], side: Hand) -> dict[str, Degrees]:
    """The angles of the joints that are turned."""
    found: dict[str, Degrees] = {}
    for name in arm_joints(side):
        if name in local:
            turn = local[name] if side is Hand.LEFT else local[name] * MIRROR
            degrees = angles_deg(turn)
            if max(map(abs, degrees)) > _STILL_DEG:
                found[name.removeprefix(side)] = degrees
    return found


def angles_deg(turn: FloatArray) -> Degrees:
    """The angles about x, then y, then z of the parent that make up a rotation (4,), as `JOINT` has them."""
    x, y, z, w = turn
    about_y = np.arcsin(np.clip(2 * (w * y - x * z), -1.0, 1.0))
    if abs(about_y) > np.pi / 2 - 1e-6:
        about_x, about_z = 2 * np.arctan2(x, w), 0.0
    else:
        about_x = np.arctan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
        about_z = np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    first, second, third = (round(float(np.degrees(angle)), _DECIMALS) + 0.0 for angle in (about_x, about_y, about_z))
    return first, second, third
