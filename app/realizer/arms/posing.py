"""Converts symbolic arm keys (`ArmKey`) into joint rotations (Gesture Engine §5.2).

Conventions: joints in the skeleton's order, local rotations. Wrist positions are in the hips' space of the upright
body, seen from the arm's own side as in `gesture_space` (x outwards, y up, z away). Everything is computed for the left
arm; the right arm is its mirror image. A `PartialPose` has a row for each independently moving part, so that parts
which a key leaves open can be interpolated between keys that define them.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray, Hand
from ...model.figure import PLAIN_MANNER, GestureManner
from ..body.body_space import on_body_m
from ..body.limits import MIRROR, swing_twist_deg
from ..body.skeleton import PARTS, Skeleton
from ..geometry.rotations import from_axis_angle, from_rotation_vector, inverse, length, multiply, rotate, x_axis
from ..gestures.gesture import ArmKey, Depth, HandForm, HandShape, HeightSector, SectorPlace, Sideways, Wrist
from ..gestures.gesture_space import DIRECTIONS, sector_m
from ..gestures.hand_shapes import finger_rows, hand_shape
from ..gestures.wrist_angles import WristAngles, wrist_angles
from .arm_reach import ArmBones, Reach, collarbone_for, reach

ARM_ROWS, WRIST_ROWS, HAND_ROWS = slice(0, 3), slice(3, 5), slice(5, 20)
"""The rows of the formational units: arm with collarbone, wrist, hand shape."""

CENTRE = SectorPlace(Sideways.C, HeightSector.CC, Depth.MIDDLE)

_SWIVELS: FloatArray = np.radians(np.arange(-60.0, 76.0, 7.5))
_ASKED_WITHIN_DEG = 8.0
_AT_EASE_DEG: FloatArray = np.array([55.0, 14.0, 45.0])
_ALONG_FOREARM: FloatArray = np.array([0.0, 0.35, 0.7])
_HALF_WAIST_M, _WAIST_M, _FROM_WAIST_M = 0.06, 0.10, 0.15
_OUTWARDS: FloatArray = np.array([1.0, -1.0])[:, None, None]
_ACROSS: FloatArray = np.array([[[1.0, 1.0, 1.0]], [[-1.0, 1.0, 1.0]]])
"""What makes directions outwards and places of the left side those of either side."""
_POINTING_PALM: FloatArray = np.array([-0.4, -1.0, 0.0])


@dataclass(frozen=True, slots=True, eq=False)
class PartialPose:
    """Local rotations `parts` (20, 4) in the order of `PARTS`, NaN where the key leaves them open, and the wrist's
    position if the whole arm is defined."""

    parts: FloatArray
    wrist_m: FloatArray | None = None

    @property
    def defined(self) -> FloatArray:
        """Which of `PARTS` are defined: booleans (20,)."""
        return np.asarray(~np.isnan(self.parts[:, 3]))

    def over(self, below: "PartialPose") -> "PartialPose":
        """This pose, completed from `below` where it leaves parts open."""
        parts = np.where(self.defined[:, None], self.parts, below.parts)
        return PartialPose(parts, below.wrist_m if self.wrist_m is None else self.wrist_m)


@dataclass(frozen=True, slots=True, eq=False)
class ArmPose:
    """A complete arm: local rotations (19, 4) of `arm_joints`, and the wrist's position."""

    rotations: FloatArray
    wrist_m: FloatArray

    def as_partial(self) -> PartialPose:
        """The same pose as a key that defines every part."""
        return PartialPose(parts_of(self.rotations), self.wrist_m)


def pose_arm(
    skeleton: Skeleton,
    side: Hand,
    key: ArmKey,
    *,
    amplitude: float = 1.0,
    aim_m: FloatArray | None = None,
    manner: GestureManner = PLAIN_MANNER,
) -> PartialPose:
    """The pose of one key for the arm `side`; see `pose_arms`."""
    return pose_arms(skeleton, side, [key], amplitude=amplitude, aim_m=aim_m, manner=manner)[0]


def pose_arms(
    skeleton: Skeleton,
    side: Hand,
    keys: Sequence[ArmKey],
    *,
    amplitude: float = 1.0,
    aim_m: FloatArray | None = None,
    manner: GestureManner = PLAIN_MANNER,
) -> tuple[PartialPose, ...]:
    """The pose of each key for the arm `side`; several keys cost hardly more than one.

    `amplitude` scales places about the centre of gesture space. `aim_m` is a target in the hips' space of the upright
    body (x to the character's left): if a key has a place, the wrist is put on the line from the shoulder to the
    target, as far out as the place is, and the fingers point along that line. A wrist without a place is oriented as if
    the arm were in front of the body's middle. Where joint limits do not allow a wrist orientation, even with another
    elbow swivel, the nearest possible one is taken. Elbow and wrist of `manner` are what they tend to.
    """
    bones = ArmBones.of(skeleton)
    aim_m = None if aim_m is None else np.asarray(aim_m) * _seen_from(side)
    parts = np.full((len(keys), len(PARTS), 4), np.nan)
    solving = [number for number, key in enumerate(keys) if key.place is not None or key.wrist is not None]
    if solving:
        asked = [_asked(skeleton, keys[number], amplitude, aim_m) for number in solving]
        for number, solved in zip(solving, _solved(skeleton, asked, manner), strict=True):
            _add_arm(parts[number], keys[number], solved, aimed=aim_m is not None)
    for row, key in zip(parts, keys, strict=True):
        if key.place is None and key.shoulder is not None:
            row[0] = collarbone_for(bones, _hanging_m(bones), np.array(key.shoulder))
        _add_hand(row, key)
        _add_joints(row, key)
    wrists_m = _wrist_of_left(bones, parts)
    mirrored = parts if side is Hand.LEFT else parts * MIRROR
    return tuple(
        PartialPose(part, None if np.isnan(wrist_m).any() else wrist_m)
        for part, wrist_m in zip(mirrored, wrists_m, strict=True)
    )


def elbow_swivel_deg(skeleton: Skeleton, key: ArmKey, *, amplitude: float, manner: GestureManner) -> float:
    """How far out the elbow of a key with a place is, as `pose_arms` has it, in degrees."""
    _arms, _turns, swivels = _searched(skeleton, [_asked(skeleton, key, amplitude, None)], manner)
    return float(np.degrees(_SWIVELS[swivels[0]]))


def solve_arm(
    bones: ArmBones, wrist_m: FloatArray, finger_base: FloatArray, palm: FloatArray, swivel_deg: float
) -> FloatArray:
    """The first five parts of a left arm with the wrist at a position, the hand in an orientation, and the elbow at a
    swivel."""
    arm = reach(bones, wrist_m, swivel_rad=np.radians(swivel_deg))
    turn = wrist_angles(arm.forearm, finger_base, palm).clamped()
    return np.stack([arm.collarbone, arm.upper_arm, arm.elbow, turn.forearm, turn.hand])


def arm_rotations(parts: FloatArray) -> FloatArray:
    """Parts (…, 20, 4) as rotations (…, 19, 4) of `arm_joints`; elbow hinge and forearm twist combine into the lower
    arm."""
    lower_arm = multiply(parts[..., 2, :], parts[..., 3, :])
    return np.concatenate([parts[..., :2, :], lower_arm[..., None, :], parts[..., 4:, :]], axis=-2)


def parts_of(rotations: FloatArray) -> FloatArray:
    """The inverse of `arm_rotations`: (…, 19, 4) as parts (…, 20, 4)."""
    lower_arm = rotations[..., 2, :]
    twist = from_axis_angle((1.0, 0.0, 0.0), np.radians(swing_twist_deg(lower_arm, 0)[..., 0]))
    hinge = multiply(lower_arm, inverse(twist))
    return np.concatenate(
        [rotations[..., :2, :], hinge[..., None, :], twist[..., None, :], rotations[..., 3:, :]], axis=-2
    )


def wrist_of(skeleton: Skeleton, side: Hand, rotations: FloatArray) -> FloatArray:
    """The wrist's position (…, 3) for an arm's rotations (…, 19, 4) on an upright body."""
    arm = rotations[..., ARM_ROWS, :]
    return _wrist_of_left(ArmBones.of(skeleton), arm if side is Hand.LEFT else arm * MIRROR)


def wrists_of(skeleton: Skeleton, arms: FloatArray) -> FloatArray:
    """The wrists (2, T, 3) of a left and a right arm (T, 2, 19, 4) on an upright body, x to the character's left."""
    bones = ArmBones.of(skeleton)
    collarbone, upper_arm, elbow = (arms[:, :, row].swapaxes(0, 1) for row in range(3))
    upper = multiply(collarbone, upper_arm)
    wrists_m = rotate(collarbone, bones.collarbone_m * _ACROSS)
    wrists_m += bones.root_m * _ACROSS
    wrists_m += (bones.upper_m * _OUTWARDS) * x_axis(upper)
    wrists_m += (bones.lower_m * _OUTWARDS) * x_axis(multiply(upper, elbow))
    return wrists_m


def _seen_from(side: Hand) -> FloatArray:
    return np.array([1.0 if side is Hand.LEFT else -1.0, 1.0, 1.0])


def _hanging_m(bones: ArmBones) -> FloatArray:
    return np.asarray(bones.shoulder_m - [0.0, bones.length_m, 0.0])


def _wrist_of_left(bones: ArmBones, parts: FloatArray) -> FloatArray:
    """From collarbone, upper arm and elbow; a twist of the elbow's rotation does not matter."""
    collarbone, upper_arm, elbow = (parts[..., row, :] for row in range(3))
    upper = multiply(collarbone, upper_arm)
    shoulder_m = bones.root_m + rotate(collarbone, bones.collarbone_m)
    elbow_m = shoulder_m + bones.upper_m * x_axis(upper)
    return np.asarray(elbow_m + bones.lower_m * x_axis(multiply(upper, elbow)))


@dataclass(frozen=True, slots=True, eq=False)
class _ArmTarget:
    """The targets of a key: wrist position, directions of fingers and palm, raising of the collarbone, and the swivel
    of the elbow if one is asked for."""

    wrist_m: FloatArray
    finger_base: FloatArray | None
    palm: FloatArray | None
    raised: float
    elbow_deg: float | None = None


def _asked(skeleton: Skeleton, key: ArmKey, amplitude: float, aim_m: FloatArray | None) -> _ArmTarget:
    wrist_m = on_body_m(skeleton, sector_m(key.place or CENTRE, amplitude))
    finger_base, palm = _directions(key.wrist or Wrist())
    if aim_m is not None and key.place is not None:
        wrist_m, finger_base = _on_the_line(ArmBones.of(skeleton), aim_m, wrist_m)
        palm = _POINTING_PALM if palm is None else palm
    return _ArmTarget(wrist_m, finger_base, palm, key.shoulder or 0.0, key.elbow_deg)


def _solved(skeleton: Skeleton, asked: Sequence[_ArmTarget], manner: GestureManner) -> FloatArray:
    """The first five parts (K, 5, 4) of each arm, at the elbow swivel that suits the wrist and the manner best."""
    arms, turns, swivels = _searched(skeleton, asked, manner)
    best = np.arange(len(asked)), swivels
    turn = WristAngles(turns.angles[best] + [0.0, 0.0, np.radians(manner.wrist_deg)]).clamped()
    return np.stack(
        (*(part[best] for part in (arms.collarbone, arms.upper_arm, arms.elbow)), turn.forearm, turn.hand), 1
    )


def _searched(
    skeleton: Skeleton, asked: Sequence[_ArmTarget], manner: GestureManner
) -> tuple[Reach, WristAngles, NDArray[np.intp]]:
    """The arms and wrists (K, swivels) of all swivels, and which of them is the best (K)."""
    wrists_m = np.stack([each.wrist_m for each in asked])[:, None]
    raised = np.array([each.raised for each in asked])[:, None]
    repeated_m = np.repeat(wrists_m, len(_SWIVELS), axis=1)
    arms = reach(ArmBones.of(skeleton), repeated_m, swivel_rad=_SWIVELS, raised=raised)
    turns = _turned(arms.forearm, asked)
    crowded_m = _inside_trunk_m(skeleton, arms)
    off = np.stack([_off_deg(each, manner) for each in asked])
    return arms, turns, np.argmin(_discomfort(arms, turns, wrists_m, crowded_m) + off**2, axis=1)


def _turned(forearm: FloatArray, asked: Sequence[_ArmTarget]) -> WristAngles:
    """The wrist angles (K, swivels), computed in groups of keys that define the same directions."""
    angles = np.zeros((*forearm.shape[:-1], 3))
    said = [(each.finger_base is not None, each.palm is not None) for each in asked]
    for kind in set(said):
        rows = [row for row, other in enumerate(said) if other == kind]
        finger_base, palm = (
            np.array([getattr(asked[row], name) for row in rows])[:, None] if known else None
            for name, known in zip(("finger_base", "palm"), kind, strict=True)
        )
        angles[rows] = wrist_angles(forearm[rows], finger_base, palm).angles
    return WristAngles(angles)


def _off_deg(asked: _ArmTarget, manner: GestureManner) -> FloatArray:
    """How far each swivel is from the one that is asked for, or else from what the manner tends to, so that the elbow
    is there unless there is a reason; in units that weigh what is asked for more."""
    if asked.elbow_deg is not None:
        return np.asarray((_SWIVELS - np.radians(asked.elbow_deg)) / np.radians(_ASKED_WITHIN_DEG))
    return np.asarray((_SWIVELS - np.radians(manner.elbow_deg)) / np.radians(40.0))


def _discomfort(arms: Reach, turns: WristAngles, wrists_m: FloatArray, crowded_m: FloatArray) -> FloatArray:
    """The cost of each swivel: wrist and forearm near or beyond their limits, wrist targets out of the shoulder's
    range, a forearm too near to the trunk."""
    strained = np.maximum(np.abs(np.degrees(turns.angles)) - _AT_EASE_DEG, 0.0) / 30.0
    impossible = np.degrees(turns.excess) / 10.0
    missed = length(arms.wrist_m - wrists_m)[..., 0] / 0.01
    missed = missed - missed.min(axis=-1, keepdims=True)
    return np.asarray(
        np.sum(strained**2 + impossible**2, axis=-1) + missed**2 + np.sum((crowded_m / 0.02) ** 2, axis=-1)
    )


def _inside_trunk_m(skeleton: Skeleton, arms: Reach) -> FloatArray:
    """How far elbow, forearm and its middle are within a hand's breadth of the trunk's line from flank to flank."""
    half_waist_m, _up, from_waist_m = on_body_m(skeleton, np.array([_HALF_WAIST_M, _WAIST_M, _FROM_WAIST_M]))
    along = arms.wrist_m - arms.elbow_m
    points = arms.elbow_m[..., None, :] + _ALONG_FOREARM[:, None] * along[..., None, :]
    aside = np.maximum(np.abs(points[..., 0]) - half_waist_m, 0.0)
    return np.asarray(np.maximum(from_waist_m - np.hypot(aside, points[..., 2]), 0.0))


def _add_arm(parts: FloatArray, key: ArmKey, solved: FloatArray, *, aimed: bool) -> None:
    if key.place is not None:
        parts[ARM_ROWS] = solved[ARM_ROWS]
    if key.wrist is not None or (aimed and key.place is not None):
        parts[WRIST_ROWS] = solved[WRIST_ROWS]


def _directions(wrist: Wrist) -> tuple[FloatArray | None, FloatArray | None]:
    sums = (np.sum([DIRECTIONS[direction] for direction in part], axis=0) for part in (wrist.finger_base, wrist.palm))
    finger_base, palm = (total if np.any(total) else None for total in sums)
    return finger_base, palm


def _on_the_line(bones: ArmBones, aim_m: FloatArray, wrist_m: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The wrist on the line from shoulder to target, at the same distance as its place, and the line's direction."""
    way = aim_m - bones.shoulder_m
    way = way / max(float(np.linalg.norm(way)), 1e-6)
    return bones.shoulder_m + float(np.linalg.norm(wrist_m - bones.shoulder_m)) * way, way


def _add_hand(parts: FloatArray, key: ArmKey) -> None:
    if key.hand is None and not key.fingers:
        return
    rotations = hand_shape(key.hand or HandShape(HandForm.DEFAULT), key.fingers)
    if key.hand is not None:
        parts[HAND_ROWS] = rotations
    for finger, _bend in key.fingers:
        parts[HAND_ROWS][finger_rows(finger)] = rotations[finger_rows(finger)]


def _add_joints(parts: FloatArray, key: ArmKey) -> None:
    """Joints given by explicit angles: rotated about x, then y, then z of the parent joint."""
    for joint, degrees in key.joints:
        x, y, z = (from_rotation_vector(angle) for angle in np.radians(np.diag(degrees)))
        rotation = multiply(z, multiply(y, x))
        if joint == "LowerArm":
            twist = from_axis_angle((1.0, 0.0, 0.0), np.radians(swing_twist_deg(rotation, 0)[0]))
            parts[2:4] = multiply(rotation, inverse(twist)), twist
        else:
            parts[PARTS.index(joint)] = rotation
