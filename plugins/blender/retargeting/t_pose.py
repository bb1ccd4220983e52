"""The turn of each joint from an armature's rest pose to our T-pose.

Limbs and fingers are turned by the smallest rotation to where ours point, each after the turn of what carries it; a
hand also about itself, so that its palm faces the floor as ours does, whatever way it faces at rest. Trunk and head
are taken to stand upright, feet to stand flat.
"""

from collections.abc import Mapping, Sequence

import numpy as np

from ..motion.rotations import Array, frame, shortest
from .armature import Armature
from .skeleton import FINGERS, SIDES

_POINTED = {
    "UpperArm": "LowerArm",
    "LowerArm": "Hand",
    "UpperLeg": "LowerLeg",
    "LowerLeg": "Foot",
    **{f"{finger}Proximal": f"{finger}Intermediate" for finger in FINGERS[1:]},
    **{f"{finger}Intermediate": f"{finger}Distal" for finger in FINGERS[1:]},
}
"""Joints and the joint that they point to."""

_KNUCKLES = ("MiddleProximal", "IndexProximal", "LittleProximal")


def turns_to_t_pose(
    armature: Armature, axes: Array, ours_m: Mapping[str, Array], parents: Mapping[str, str]
) -> dict[str, Array]:
    """The turn (3, 3) of each joint, in the armature's space; `ours_m` are the places of our joints in the T-pose,
    `parents` their parents (empty: none), parents first."""
    turns: dict[str, Array] = {}
    theirs = {joint: armature.head_of(joint) for joint in armature.joints}
    ours = {joint: axes @ place for joint, place in ours_m.items()}
    for joint, parent in parents.items():
        above = turns[parent] if parent else np.eye(3)
        turns[joint] = _further(joint, theirs, ours, above) @ above
    return turns


def _further(joint: str, theirs: Mapping[str, Array], ours: Mapping[str, Array], above: Array) -> Array:
    """What is left to turn once the joint has been carried by `above`; joints by their places at rest."""
    side = next((word for word in SIDES if joint.startswith(word)), "")
    part = joint.removeprefix(side)
    if part == "Hand":
        knuckles = [side + knuckle for knuckle in _KNUCKLES]
        found = all(each in theirs for each in (joint, *knuckles))
        return _axes(ours, joint, knuckles) @ _axes(theirs, joint, knuckles).T @ above.T if found else np.eye(3)
    towards = side + _POINTED.get(part, "")
    if part not in _POINTED or joint not in theirs or towards not in theirs:
        return np.eye(3)
    if np.linalg.norm(theirs[towards] - theirs[joint]) == 0:
        return np.eye(3)
    return shortest(above @ (theirs[towards] - theirs[joint]), ours[towards] - ours[joint])


def _axes(places: Mapping[str, Array], hand: str, knuckles: Sequence[str]) -> Array:
    """The direction of a hand, and that of its row of knuckles."""
    middle, index, little = (places[each] for each in knuckles)
    return frame(middle - places[hand], index - little)
