"""How far joints turn (shared/motion.md): measured and kept to.

Conventions: a joint's rotation is parted into a twist about its bone and a bend without twist, whose rotation vector
gives the other two angles; so the three angles stand on the axes x, y, z of the left side's joint, degrees, and the
right's are those of its mirror image. The upper arm is measured in the upper chest's space from an arm that hangs with
its elbow crease forward, because there flexion (-x), abduction (z) and rotation (y, inwards negative) mean what
anatomy says.
"""

from dataclasses import dataclass

import numpy as np

from app.model import FloatArray
from app.realizer.rotations import about, from_rotation_vector, inverse, multiply, to_rotation_vector
from app.realizer.skeleton import FINGERS, SIDES, Skeleton

Degrees = tuple[float, float, float]

_HANGING = about((0.0, 0.0, 1.0), np.array(-np.pi / 2))
MIRROR: FloatArray = np.array([1.0, -1.0, -1.0, 1.0])
"""Times a rotation: its mirror image on the body's other side."""


@dataclass(frozen=True, slots=True)
class Limit:
    """Angles of a chain of joints (their rotations multiplied), or of one: `bone` is the axis, 0 to 2, of the twist."""

    joints: tuple[str, ...]
    bone: int
    lowest_deg: Degrees
    highest_deg: Degrees
    from_hanging: bool = False


_TRUNK = (
    Limit(("spine", "chest", "upperChest"), 1, (-30.0, -45.0, -35.0), (70.0, 45.0, 35.0)),
    Limit(("neck", "head"), 1, (-45.0, -60.0, -45.0), (45.0, 60.0, 45.0)),
)
_SHOULDER = Limit(("Shoulder", "UpperArm"), 1, (-180.0, -70.0, -80.0), (60.0, 90.0, 180.0), from_hanging=True)
_ARM = (
    Limit(("Shoulder",), 0, (-10.0, -30.0, -12.0), (10.0, 20.0, 45.0)),
    _SHOULDER,
    Limit(("LowerArm",), 0, (-80.0, -150.0, 0.0), (80.0, 0.0, 0.0)),
    Limit(("Hand",), 0, (0.0, -20.0, -80.0), (0.0, 30.0, 70.0)),
)
_PHALANGES = tuple(
    Limit((finger + phalanx,), 0, lowest, highest)
    for finger in FINGERS[1:]
    for phalanx, lowest, highest in (
        ("Proximal", (-25.0, -30.0, -95.0), (25.0, 30.0, 30.0)),
        ("Intermediate", (-5.0, -5.0, -115.0), (5.0, 5.0, 5.0)),
        ("Distal", (-5.0, -5.0, -90.0), (5.0, 5.0, 10.0)),
    )
)


def _sided(side: str, limit: Limit) -> Limit:
    joints = tuple(side + joint for joint in limit.joints)
    return Limit(joints, limit.bone, limit.lowest_deg, limit.highest_deg, limit.from_hanging)


LIMITS: tuple[Limit, ...] = (*_TRUNK, *(_sided(side, limit) for side in SIDES for limit in (*_ARM, *_PHALANGES)))


def violations(skeleton: Skeleton, rotations: FloatArray) -> FloatArray:
    """How many degrees each of `LIMITS` is passed by (…, limits) in local rotations (…, J, 4); 0 where it is kept."""
    return np.stack([_passed_by(limit, _measured(skeleton, limit, rotations)) for limit in LIMITS], axis=-1)


def clamped(skeleton: Skeleton, rotations: FloatArray) -> FloatArray:
    """The same local rotations (…, J, 4) with every joint that passes a limit brought back to it; where a limit is on
    a chain, its last joint."""
    kept = rotations.copy()
    for limit in LIMITS:
        angles = _measured(skeleton, limit, kept)
        over = _passed_by(limit, angles) > 0
        if not np.any(over):
            continue
        within = _joined(limit, np.clip(angles, limit.lowest_deg, limit.highest_deg))
        *above, last = skeleton.chain(*limit.joints)
        if limit.joints[0].startswith("right"):
            within = within * MIRROR
        for joint in above:
            within = multiply(inverse(kept[..., joint, :]), within)
        kept[..., last, :] = np.where(over[..., None], within, kept[..., last, :])
    return kept


def parted_deg(rotation: FloatArray, bone: int) -> FloatArray:
    """Rotations (…, 4) as three angles in degrees: the twist on the axis `bone`, the bend's rotation vector on the
    others."""
    twist = 2 * np.arctan2(rotation[..., bone], rotation[..., 3])
    twist = np.where(np.abs(twist) > np.pi, twist - 2 * np.pi * np.sign(twist), twist)
    angles = to_rotation_vector(multiply(rotation, _about_bone(bone, -twist)))
    angles[..., bone] = twist
    return np.asarray(np.degrees(angles))


def shoulder_deg(orientation: FloatArray) -> FloatArray:
    """The left upper arm's angles, its orientation (…, 4) being in the upper chest's space."""
    return parted_deg(multiply(orientation, inverse(_HANGING)), 1)


def within_shoulder_limits(orientation: FloatArray) -> FloatArray:
    """The left upper arm's orientation (…, 4) in the upper chest's space, brought back to what a shoulder allows."""
    angles = shoulder_deg(orientation)
    passed = _passed_by(_SHOULDER, angles) > 0
    if not np.any(passed):
        return orientation
    kept = _joined(_SHOULDER, np.clip(angles, _SHOULDER.lowest_deg, _SHOULDER.highest_deg))
    return np.asarray(np.where(passed[..., None], kept, orientation))


def _about_bone(bone: int, angle: FloatArray) -> FloatArray:
    axis = np.zeros(3)
    axis[bone] = 1.0
    return from_rotation_vector(angle[..., None] * axis)


def _measured(skeleton: Skeleton, limit: Limit, rotations: FloatArray) -> FloatArray:
    first, *below = skeleton.chain(*limit.joints)
    rotation = rotations[..., first, :]
    for joint in below:
        rotation = multiply(rotation, rotations[..., joint, :])
    if limit.joints[0].startswith("right"):
        rotation = rotation * MIRROR
    return shoulder_deg(rotation) if limit.from_hanging else parted_deg(rotation, limit.bone)


def _joined(limit: Limit, angles_deg: FloatArray) -> FloatArray:
    """Back from three angles to the rotation."""
    angles = np.radians(angles_deg)
    twist = _about_bone(limit.bone, angles[..., limit.bone])
    bend = angles.copy()
    bend[..., limit.bone] = 0.0
    rotation = multiply(from_rotation_vector(bend), twist)
    return multiply(rotation, _HANGING) if limit.from_hanging else rotation


def _passed_by(limit: Limit, angles_deg: FloatArray) -> FloatArray:
    over = np.maximum(angles_deg - limit.highest_deg, np.asarray(limit.lowest_deg) - angles_deg)
    return np.asarray(np.where(over > 1e-3, over, 0.0).max(axis=-1))
