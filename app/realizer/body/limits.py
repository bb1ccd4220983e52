"""Joint limits (docs/references.md): measuring violations and clamping rotations to them.

Conventions: a joint's rotation is decomposed into a twist about its bone and a swing, whose rotation vector gives the
other two angles; the three angles are about the axes x, y, z of the left side's joint, in degrees, and the right side's
are those of its mirror image. The upper arm is measured in the upper chest's space, from an arm that hangs with the
elbow crease forward, because there flexion (-x), abduction (z) and rotation (y, inwards negative) have their anatomical
meaning.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from math import acos, degrees

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ..geometry.curves import clipped
from ..geometry.rotations import from_axis_angle, from_rotation_vector, inverse, multiply, nearest_sign
from .skeleton import FINGERS, SIDES, Skeleton

Degrees = tuple[float, float, float]

_HANGING = from_axis_angle((0.0, 0.0, 1.0), np.array(-np.pi / 2))
_AFTER_HANGING = multiply(np.eye(4), inverse(_HANGING))
"""The rotation from hanging as a matrix, by which an orientation, a row of four, is multiplied: for a rotation that
never changes, in a fraction of the time of `multiply`."""
_AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_TOLERATED_DEG = 1e-3
_NEAR_ZERO = 1e-12
MIRROR: FloatArray = np.array([1.0, -1.0, -1.0, 1.0])
"""Multiplied with a quaternion, gives its mirror image on the body's other side."""


@dataclass(frozen=True, slots=True)
class JointLimit:
    """The range of a chain of joints (their rotations multiplied) or of a single joint; `bone` is the twist axis, 0 to
    2."""

    joints: tuple[str, ...]
    bone: int
    lowest_deg: Degrees
    highest_deg: Degrees
    from_hanging: bool = False

    @property
    def free_deg(self) -> float:
        """The angle up to which any rotation is within the range: none of an arm that is measured from hanging."""
        return 0.0 if self.from_hanging else max(0.0, min(*(-angle for angle in self.lowest_deg), *self.highest_deg))


_TRUNK = (
    JointLimit(("spine", "chest", "upperChest"), 1, (-30.0, -45.0, -35.0), (70.0, 45.0, 35.0)),
    JointLimit(("neck", "head"), 1, (-45.0, -60.0, -45.0), (45.0, 60.0, 45.0)),
)
_SHOULDER = JointLimit(("Shoulder", "UpperArm"), 1, (-180.0, -70.0, -80.0), (60.0, 90.0, 180.0), from_hanging=True)
_ARM = (
    JointLimit(("Shoulder",), 0, (-10.0, -30.0, -12.0), (10.0, 20.0, 45.0)),
    _SHOULDER,
    JointLimit(("LowerArm",), 0, (-80.0, -150.0, 0.0), (80.0, 0.0, 0.0)),
    JointLimit(("Hand",), 0, (0.0, -20.0, -80.0), (0.0, 30.0, 70.0)),
)
_PHALANGES = tuple(
    JointLimit((finger + phalanx,), 0, lowest, highest)
    for finger in FINGERS[1:]
    for phalanx, lowest, highest in (
        ("Proximal", (-25.0, -30.0, -95.0), (25.0, 30.0, 30.0)),
        ("Intermediate", (-5.0, -5.0, -115.0), (5.0, 5.0, 5.0)),
        ("Distal", (-5.0, -5.0, -90.0), (5.0, 5.0, 10.0)),
    )
)


def _sided(side: str, limit: JointLimit) -> JointLimit:
    joints = tuple(side + joint for joint in limit.joints)
    return JointLimit(joints, limit.bone, limit.lowest_deg, limit.highest_deg, limit.from_hanging)


_SHOULDER_DEG, _NECK_DEG = (
    (np.array(limit.lowest_deg), np.array(limit.highest_deg)) for limit in (_SHOULDER, _TRUNK[1])
)
"""The lowest and the highest angles, as arrays, which NumPy needs no time to make."""

LIMITS: tuple[JointLimit, ...] = (*_TRUNK, *(_sided(side, limit) for side in SIDES for limit in (*_ARM, *_PHALANGES)))


_CLAMPED = (*_TRUNK, *(_sided(side, limit) for side in SIDES for limit in _ARM))


def violations(skeleton: Skeleton, rotations: FloatArray) -> FloatArray:
    """By how many degrees each of `LIMITS` is exceeded (…, limits) by local rotations (…, J, 4); 0 where it is
    respected."""
    passed = np.zeros((*rotations.shape[:-2], len(LIMITS)))
    for alike in _alike(LIMITS):
        angles = alike.measured(_turned(skeleton, alike, rotations))
        over = np.maximum(angles - alike.highest_deg, alike.lowest_deg - angles).max(axis=-1)
        passed[..., alike.columns] = np.where(over > _TOLERATED_DEG, over, 0.0)
    return passed


def clamp(skeleton: Skeleton, rotations: FloatArray) -> None:
    """Bring trunk, neck and arms within their limits, in place, in local rotations (…, J, 4). Where a limit applies to
    a chain, its last joint is corrected. Fingers are not touched: their tables respect the limits."""
    for alike in _alike(_CLAMPED):
        if _turn_less(skeleton, alike, rotations):
            continue
        turned = _turned(skeleton, alike, rotations)
        if _turns_less(turned, alike.free_deg):
            continue
        angles = alike.measured(turned.transpose(-2, *range(turned.ndim - 2), -1))
        each = (-1, *(1,) * (angles.ndim - 2), 3)
        within = clipped(angles, alike.lowest_deg.reshape(each), alike.highest_deg.reshape(each))
        limit, *frame = there = np.nonzero((np.abs(angles - within) > _TOLERATED_DEG).any(axis=-1))
        if len(limit):
            joints = _chains(skeleton, alike)[:, limit]
            chain = [rotations[*frame, joint] for joint in joints]
            rotations[*frame, joints[-1]] = _brought_back(alike, chain, within[there], alike.mirrors[limit])


def _turn_less(skeleton: Skeleton, alike: "_Alike", rotations: FloatArray) -> bool:
    """Whether the joints of each of these chains, all turned the same way as far as they ever are, would still be
    within any limit: what most trunks and necks are, and the cheapest to find out."""
    if not alike.free_deg:
        return False
    widest_deg = [
        2 * degrees(acos(min(1.0, float(np.abs(rotations[..., joint, 3]).min(initial=1.0)))))
        for joint in _chains(skeleton, alike).ravel().tolist()
    ]
    number = len(alike.limits)
    return max(sum(widest_deg[chain::number]) for chain in range(number)) < alike.free_deg


def _turns_less(rotation: FloatArray, degrees: float) -> bool:
    """Whether all rotations (…, 4) are smaller than this, and with them their twists and swings. Much cheaper than to
    measure those."""
    return bool(np.abs(rotation[..., 3]).min(initial=1.0) > np.cos(np.radians(degrees / 2)))


def _brought_back(
    alike: "_Alike", chain: Sequence[FloatArray], within_deg: FloatArray, mirrors: FloatArray
) -> FloatArray:
    """The rotations (M, 4) of the last joints of chains (M, 4) with which their angles (M, 3) are those within the
    limits; `mirrors` (M, 4) makes them those of the left side."""
    within: FloatArray = _joined(alike.limits[0], within_deg) * mirrors
    *above, last = chain
    for rotation in above:
        within = multiply(inverse(rotation), within)
    return nearest_sign(within, last)


def swing_twist_deg(rotation: FloatArray, bone: int) -> FloatArray:
    """Swing-twist decomposition: rotations (…, 4) as three angles in degrees, the twist on the axis `bone`, the swing's
    rotation vector on the others."""
    one, other = (bone + 1) % 3, (bone + 2) % 3
    parts = rotation.transpose(-1, *range(rotation.ndim - 1)).copy()  # NumPy is faster with each of them by itself
    w, along, a, b = parts[3], parts[bone], parts[one], parts[other]
    size, bent = np.sqrt(w * w + along * along), np.sqrt(a * a + b * b)
    scale = np.where(bent > _NEAR_ZERO, 2 * np.arctan2(bent, size) / np.maximum(bent, _NEAR_ZERO), 2.0)
    scale /= np.maximum(size, _NEAR_ZERO)
    angles = np.empty((3, *rotation.shape[:-1]))
    angles[bone] = 2 * np.arctan2(np.where(w < 0, -along, along), np.abs(w))
    angles[one] = scale * (a * w - b * along)
    angles[other] = scale * (b * w + a * along)
    if size.min(initial=1.0) <= _NEAR_ZERO:
        turned_over = size <= _NEAR_ZERO
        angles[one, turned_over], angles[other, turned_over] = np.pi * a[turned_over], np.pi * b[turned_over]
    return np.degrees(angles, out=angles).transpose(*range(1, angles.ndim), 0)


def shoulder_deg(orientation: FloatArray) -> FloatArray:
    """The angles of the left upper arm, given its orientation (…, 4) in the upper chest's space."""
    return swing_twist_deg(orientation @ _AFTER_HANGING, 1)


def shoulder_turned(angles_deg: FloatArray) -> FloatArray:
    """The orientation (…, 4) of the left upper arm with these angles (…, 3); the inverse of `shoulder_deg`."""
    return _joined(_SHOULDER, angles_deg)


def within_shoulder_limits(orientation: FloatArray) -> FloatArray:
    """The orientation (…, 4) of the left upper arm in the upper chest's space, clamped to the shoulder's limits."""
    angles = shoulder_deg(orientation)
    within = clipped(angles, *_SHOULDER_DEG)
    passed = (within != angles).any(axis=-1, keepdims=True)
    return np.asarray(np.where(passed, _joined(_SHOULDER, within), orientation)) if passed.any() else orientation


def within_neck_limits(turned: FloatArray) -> FloatArray:
    """The head's rotation (…, 4) relative to the upper chest, clamped to the limits of neck and head together."""
    neck = _TRUNK[1]
    if _turns_less(turned, neck.free_deg):
        return turned
    angles = swing_twist_deg(turned, 1)
    within = clipped(angles, *_NECK_DEG)
    passed = (within != angles).any(axis=-1, keepdims=True)
    return np.asarray(np.where(passed, _joined(neck, within), turned)) if passed.any() else turned


@dataclass(frozen=True, slots=True, eq=False)
class _Alike:
    """Limits that are measured in the same way, at once for speed: their columns, what makes their chains the left
    side's (n, 4), their bounds (n, 3), and the angle `free_deg` up to which any rotation is within all of them."""

    limits: tuple[JointLimit, ...]
    columns: list[int]
    mirrors: FloatArray
    lowest_deg: FloatArray
    highest_deg: FloatArray
    free_deg: float

    def measured(self, rotation: FloatArray) -> FloatArray:
        """The angles (…, n, 3) of rotations (…, n, 4) of these chains."""
        kind = self.limits[0]
        return shoulder_deg(rotation) if kind.from_hanging else swing_twist_deg(rotation, kind.bone)


@cache
def _alike(limits: tuple[JointLimit, ...]) -> tuple[_Alike, ...]:
    """The limits in groups. Cached; never mutated."""
    kinds = [(limit.bone, limit.from_hanging, len(limit.joints)) for limit in limits]
    groups = [[column for column, other in enumerate(kinds) if other == kind] for kind in dict.fromkeys(kinds)]
    return tuple(_group(tuple(limits[column] for column in columns), columns) for columns in groups)


def _group(limits: tuple[JointLimit, ...], columns: list[int]) -> _Alike:
    mirrors = np.array([MIRROR if limit.joints[0].startswith("right") else np.ones(4) for limit in limits])
    lowest, highest = ([getattr(limit, end) for limit in limits] for end in ("lowest_deg", "highest_deg"))
    free_deg = min(limit.free_deg for limit in limits)
    return _Alike(limits, columns, mirrors, np.array(lowest), np.array(highest), free_deg)


def _turned(skeleton: Skeleton, alike: _Alike, rotations: FloatArray) -> FloatArray:
    """The rotations (…, n, 4) of the chains of limits that are measured in the same way, on the left or as on the
    left."""
    first, *others = _chains(skeleton, alike)
    rotation = rotations.take(first, axis=-2)
    for joints in others:
        rotation = multiply(rotation, rotations.take(joints, axis=-2))
    return np.asarray(rotation * alike.mirrors)


@lru_cache(maxsize=64)
def _chains(skeleton: Skeleton, alike: _Alike) -> NDArray[np.intp]:
    """The joints (length, n) of the chains. Cached; never mutated."""
    return np.array([skeleton.chain(*limit.joints) for limit in alike.limits], dtype=np.intp).T


def _joined(limit: JointLimit, angles_deg: FloatArray) -> FloatArray:
    """The rotation with these three angles; the inverse of `swing_twist_deg`."""
    angles = np.radians(angles_deg)
    twist = from_axis_angle(_AXES[limit.bone], angles[..., limit.bone])
    bend = angles.copy()
    bend[..., limit.bone] = 0.0
    rotation = multiply(from_rotation_vector(bend), twist)
    return multiply(rotation, _HANGING) if limit.from_hanging else rotation
