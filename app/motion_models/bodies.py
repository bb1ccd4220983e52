"""Other skeletons' motion on our body: rotations of BVH files, or arms out of tracked points.

World orientations are taken over, so that joints which ours lacks (a fourth vertebra) count in those above them. A bone
of an arm points in another direction where the file's rest pose is not a T-pose: the shortest rotation between the two
directions is added. Which way a skeleton faces is told by its rest pose, where the left arm and the neck are. Hips and
legs stay as they are in our own motion; what is learnt is how trunk, head, arms and fingers move above them.

Tracked points are those of MediaPipe: x to the right and y down as shares of the picture's width and height, z away
from the camera as a share of its width. They have no rotations: arms are turned to where the points are, seen from the
middle position of the trunk, and their elbows bend about the normal of both bones.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..bvh import Bvh
from ..errors import InputError
from ..model import FloatArray
from ..realizer.body.skeleton import SIDES, Skeleton
from ..realizer.exporting.retargeting import Rig
from ..realizer.geometry.rotations import (
    cross,
    from_axes,
    inverse,
    length,
    multiply,
    normalized,
    rotate,
    shortest_rotation,
    with_continuous_signs,
)

ARMS = ("leftUpperArm", "leftLowerArm", "rightUpperArm", "rightLowerArm")
"""The joints by which phrases are found and units joined (AHG §3.1)."""

_STAYING = ("hips", "UpperLeg", "LowerLeg", "Foot", "Toes", "Eye")
_POINTS = ("SHOULDER", "ELBOW", "WRIST", "HIP")
WIDTH_TO_HEIGHT = 16 / 9
"""Of pictures that do not say otherwise."""

_SETTLED_S = 0.1
"""Tracked points are averaged over this time."""

_HINGE_SHARE = 0.3
"""The weight of the elbow's usual axis, which decides where an arm is nearly straight."""


@dataclass(frozen=True, slots=True, eq=False)
class BodyTrack:
    """Local `rotations` (T, joints, 4) of these `joints` of ours at `times_s` (T,)."""

    joints: tuple[str, ...]
    rotations: FloatArray
    times_s: FloatArray


def body_of_bvh(bvh: Bvh, name: str, skeleton: Skeleton, rigs: Mapping[str, Rig]) -> BodyTrack:
    """The motion of a file called `name`, whose joints have the names of one of the rigs. Raises InputError
    `bvh_wrong`."""
    places = _places(bvh, name, rigs)
    rest_m = _rest_positions(bvh)
    basis = _basis(rest_m, places, name)
    turns = from_axes(*(np.asarray(basis[:, axis]) for axis in range(3)))
    world: dict[str, FloatArray] = {}
    matrices = _world_matrices(bvh)
    leaning = np.array([0.0, 0.0, 0.0, 1.0])
    leanings: dict[str, FloatArray] = {}
    for place, joint in enumerate(skeleton.names):
        parent = skeleton.parents[place]
        above = skeleton.names[parent] if parent >= 0 else ""
        leanings[joint] = leanings.get(above, leaning)
        if joint not in places:
            world[joint] = world[above]
            continue
        if _is_of_arm(joint):
            leanings[joint] = _leaning(joint, skeleton, rest_m @ basis.T, places, leanings[joint])
        there = _from_matrices(matrices[places[joint]])
        world[joint] = multiply(multiply(multiply(turns, there), inverse(turns)), leanings[joint])
    joints = tuple(joint for joint in skeleton.names if joint in places and not _stays(joint))
    local = [multiply(inverse(world[_parent(skeleton, joint)]), world[joint]) for joint in joints]
    times_s = np.arange(len(bvh.values)) * bvh.frame_s
    return BodyTrack(joints, with_continuous_signs(np.stack(local, axis=1)), times_s)


def _parent(skeleton: Skeleton, joint: str) -> str:
    return skeleton.names[skeleton.parents[skeleton.index[joint]]]


def _stays(joint: str) -> bool:
    return joint.removeprefix("left").removeprefix("right") in _STAYING


def _is_of_arm(joint: str) -> bool:
    return joint.removeprefix("left").removeprefix("right") in ("Shoulder", "UpperArm", "LowerArm", "Hand")


def _places(bvh: Bvh, name: str, rigs: Mapping[str, Rig]) -> dict[str, int]:
    """The file's joint for each of ours that it has; the names are those of the rig that fits best."""
    numbers = {_plain(joint.name): place for place, joint in reversed(list(enumerate(bvh.joints)))}
    found = [
        {ours: numbers[_plain(theirs)] for ours, theirs in rig.names.items() if _plain(theirs) in numbers}
        for rig in rigs.values()
    ]
    best = max(found, key=len)
    missing = [joint for joint in ("hips", *ARMS) if joint not in best]
    if missing:
        has = ", ".join(joint.name for joint in bvh.joints[:12])
        raise InputError(
            "bvh_wrong",
            f"{name}: no joint for {', '.join(missing)} under the names of any rig ({', '.join(rigs)}); it has {has}, "
            "…; add your rig's names as retarget/NAME.yaml to a folder for --lexicon",
        )
    top = bvh.joints[best.get("leftShoulder", best["leftUpperArm"])].parent
    return best | ({"upperChest": top} if top > best["hips"] else {})


def _plain(name: str) -> str:
    return name.rpartition(":")[2].lower().replace("_", "").removeprefix("mixamorig")


def _rest_positions(bvh: Bvh) -> FloatArray:
    """The joints' positions (joints, 3) without rotations, in the file's unit."""
    positions = np.zeros((len(bvh.joints), 3))
    for place, joint in enumerate(bvh.joints):
        if joint.parent >= 0:
            positions[place] = positions[joint.parent] + joint.offset
    return positions


def _basis(rest: FloatArray, places: Mapping[str, int], name: str) -> FloatArray:
    """The matrix (3, 3) from the file's axes to ours: left is +X, up +Y, forward +Z."""
    left = _axis(rest[places["leftUpperArm"]] - rest[places["rightUpperArm"]])
    middle = (rest[places["leftUpperArm"]] + rest[places["rightUpperArm"]]) / 2
    up = _axis(middle - rest[places["hips"]])
    if abs(left @ up) > 0.5 or not (left.any() and up.any()):
        raise InputError(
            "bvh_wrong", f"{name}: its pose without rotations is not a standing body: shoulders side by side"
        )
    return np.stack([left, up, np.cross(left, up)])


def _axis(direction: FloatArray) -> FloatArray:
    """The nearest of the six axes."""
    axis = np.zeros(3)
    largest = int(np.abs(direction).argmax())
    axis[largest] = np.sign(direction[largest])
    return axis


def _leaning(
    joint: str, skeleton: Skeleton, rest: FloatArray, places: Mapping[str, int], otherwise: FloatArray
) -> FloatArray:
    """The rotation from the direction of our bone in the T-pose to that of theirs in their rest pose."""
    after = {"Shoulder": "UpperArm", "UpperArm": "LowerArm", "LowerArm": "Hand", "Hand": "MiddleProximal"}
    side = next(side for side in SIDES if joint.startswith(side))
    child = side + after[joint.removeprefix(side)]
    if child not in places:
        return otherwise
    bone = rest[places[child]] - rest[places[joint]]
    if not bone.any():
        return otherwise
    return shortest_rotation(skeleton.offsets_m[skeleton.index[child]], bone)


def _world_matrices(bvh: Bvh) -> list[FloatArray]:
    found: list[FloatArray] = []
    for place, joint in enumerate(bvh.joints):
        local = bvh.rotations(place)
        found.append(local if joint.parent < 0 else found[joint.parent] @ local)
    return found


def _from_matrices(matrices: FloatArray) -> FloatArray:
    return from_axes(matrices[..., 0], matrices[..., 1], matrices[..., 2])


_LEAST_BODY = 1e-6
"""A body is larger than that in any unit, upwards and across."""


def body_of_points(
    points: FloatArray, joints: Sequence[str], times_s: FloatArray, width_to_height: float, name: str
) -> BodyTrack:
    """The arms of tracked points (T, joints, 3 or more). Raises InputError `pairs_wrong` for missing points."""
    wanted = [f"{side.upper()}_{point}" for point in _POINTS for side in SIDES]
    missing = [point for point in wanted if point not in joints]
    if missing:
        raise InputError("pairs_wrong", f"{name}: `joints` lacks {', '.join(missing)}")
    places_m = points[..., :3] * np.array([1.0, -1.0 / width_to_height, -1.0])
    at = {point: _settled(places_m[:, list(joints).index(point)], times_s) for point in wanted}
    if any(np.ptp([each[0] for each in at.values()], axis=0)[:2] < _LEAST_BODY):
        raise InputError("pairs_wrong", f"{name}: all points of `body` are in one place, or on one line")
    trunk = _trunk(at)
    found = [
        rotations
        for side in SIDES
        for rotations in _arm(
            side,
            rotate(inverse(trunk), at[f"{side.upper()}_ELBOW"] - at[f"{side.upper()}_SHOULDER"]),
            rotate(inverse(trunk), at[f"{side.upper()}_WRIST"] - at[f"{side.upper()}_ELBOW"]),
        )
    ]
    return BodyTrack(ARMS, with_continuous_signs(np.stack(found, axis=1)), times_s)


def _settled(track: FloatArray, times_s: FloatArray) -> FloatArray:
    frames = max(1, round(_SETTLED_S / float(np.median(np.diff(times_s)))))
    kernel = np.ones(frames) / frames
    padded = np.pad(track, ((frames // 2, frames - 1 - frames // 2), (0, 0)), mode="edge")
    return np.stack([np.convolve(column, kernel, mode="valid") for column in padded.T], axis=1)


def _trunk(at: Mapping[str, FloatArray]) -> FloatArray:
    """The orientation of the trunk, the same all the time: its middle over the recording."""
    shoulders = (at["LEFT_SHOULDER"] + at["RIGHT_SHOULDER"]) / 2
    up = np.median(shoulders - (at["LEFT_HIP"] + at["RIGHT_HIP"]) / 2, axis=0)
    across = np.median(at["LEFT_SHOULDER"] - at["RIGHT_SHOULDER"], axis=0)
    up = up / np.linalg.norm(up)
    left = across - up * (across @ up)
    left = left / np.linalg.norm(left)
    return from_axes(left, up, np.cross(left, up))


def _arm(side: str, upper: FloatArray, lower: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The rotations of upper arm and forearm that point in these directions (T, 3)."""
    along = np.array([1.0 if side == "left" else -1.0, 0.0, 0.0])
    hinge = np.array([0.0, -along[0], 0.0])
    upper, lower = normalized(upper), normalized(lower)
    swung = shortest_rotation(np.broadcast_to(along, upper.shape), upper)
    bent = cross(upper, lower) + _HINGE_SHARE * rotate(swung, np.broadcast_to(hinge, upper.shape))
    bent = normalized(bent - upper * (bent * upper).sum(axis=-1, keepdims=True))
    x, y = upper * along[0], bent * hinge[1]
    turned = from_axes(x, y, cross(x, y))
    return turned, shortest_rotation(np.broadcast_to(along, upper.shape), rotate(inverse(turned), lower))


def resampled(track: BodyTrack, at_s: FloatArray) -> FloatArray:
    """The rotations (frames, joints, 4) at other times."""
    flat = track.rotations.reshape(len(track.times_s), -1)
    between = np.stack([np.interp(at_s, track.times_s, column) for column in flat.T], axis=1)
    found: FloatArray = between.reshape(len(at_s), len(track.joints), 4)
    return found / length(found)
