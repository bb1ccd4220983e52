"""Displacements of wrists and elbows over time, and arms solved again for them.

Conventions: metres in the world, time in frames. A displacement is blended in and out over the surrounding frames so
that velocity stays continuous. The hand keeps its orientation as far as joint limits allow.

Stretches of frames: runs of those in which something is true, and what is near them.

Conventions: booleans (T,) for each frame; a stretch is its first frame and the frame past its last.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ..body.contacts import PosedBody
from ..body.limits import MIRROR
from ..body.skeleton import SIDES, Skeleton
from ..geometry.curves import minimum_jerk
from ..geometry.rotations import dot, inverse, length, multiply, nearest_sign, rotate
from ..gestures.wrist_angles import preserving_wrist_angles
from .arm_reach import ArmBones, reach_by_elbow, towards_elbow

_ELBOW_AT_LEAST_M = 0.12
_FARTHEST_M = 0.22
_TWIST: FloatArray = np.array([1.0, 0.0, 0.0, 1.0])
_MIRRORS: FloatArray = np.stack((np.ones(4), MIRROR))
_MIRRORED: FloatArray = np.array([[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0]])
"""What makes rotations and places of either side those of the left."""


@dataclass(frozen=True, slots=True, eq=False)
class Displacement:
    """The displacements (T, 3) of a wrist and an elbow."""

    wrist_m: FloatArray
    elbow_m: FloatArray

    def and_then(self, other: "Displacement") -> "Displacement":
        wrist_m, elbow_m = self.wrist_m + other.wrist_m, self.elbow_m + other.elbow_m
        return Displacement(_at_most(wrist_m, _FARTHEST_M), _at_most(elbow_m, _FARTHEST_M))

    def swelling(self, swell: int, weights: FloatArray) -> "Displacement":
        return Displacement(*(weights * _swelling(push_m, swell) for push_m in (self.wrist_m, self.elbow_m)))


def taper(frames: int, swell: int, ends: tuple[bool, bool]) -> FloatArray:
    """Weights (F, 1) that rise from 0 at the ends of the stretch, beyond which nothing is moved, to 1 after `swell`
    frames."""
    number = np.arange(frames)
    from_start = number if ends[0] else np.full(frames, swell)
    from_end = number[::-1] if ends[1] else np.full(frames, swell)
    return minimum_jerk(np.minimum(from_start, from_end) / swell)[:, None]


def displaced(skeleton: Skeleton, body: PosedBody, pushes: Mapping[str, Displacement]) -> FloatArray:
    """The local rotations with both arms displaced, in the frames concerned."""
    rotations = body.rotations.copy()
    moved = [np.flatnonzero(length(push.wrist_m) + length(push.elbow_m) > 1e-6) for push in pushes.values()]
    frames = np.concatenate(moved)
    if len(frames):
        arms = np.repeat([SIDES.index(side) for side in pushes], [len(each) for each in moved])
        pushed = zip(moved, pushes.values(), strict=True)
        ways_m = [(push.wrist_m[there], push.elbow_m[there]) for there, push in pushed]
        push = Displacement(*(np.concatenate(each) for each in zip(*ways_m, strict=True)))
        joints = _arm_joints(skeleton)[arms]
        rotations[frames[:, None], joints[:, 1:]] = _solved_again(skeleton, body, frames, arms, push)
    return rotations


def _solved_again(
    skeleton: Skeleton, body: PosedBody, frames: NDArray[np.intp], arms: NDArray[np.intp], push: Displacement
) -> FloatArray:
    """Upper arm, lower arm and hand (M, 3, 4) of these arms (M,), 0 for the left one, in these frames (M,), solved for
    the displaced wrists and elbows (M, 3): both arms at once, since calls are what this costs."""
    joints, chest = _arm_joints(skeleton)[arms], skeleton.index["upperChest"]
    bones = ArmBones.of(skeleton)
    hand_m, chest_m = body.positions_m[frames, joints[:, -1]], body.positions_m[frames, chest]
    hand, back = body.orientations[frames, joints[:, -1]], inverse(body.orientations[frames, chest])
    mirror, across = _MIRRORS[arms], _MIRRORED[arms]
    root_m = bones.root_m - skeleton.offsets_m[skeleton.index["leftShoulder"]]
    wrist_m, elbow_push_m = rotate(back, np.stack((hand_m + push.wrist_m - chest_m, push.elbow_m))) * across
    before = body.rotations[frames[:, None], joints]
    collarbone, upper_arm, lower_arm = (before[:, joint] * mirror for joint in range(3))
    elbow = towards_elbow(multiply(collarbone, upper_arm), _without_twist(lower_arm), bones)
    elbow = elbow + (elbow_push_m - dot(elbow_push_m, elbow) * elbow) / _ELBOW_AT_LEAST_M
    arm = reach_by_elbow(bones, collarbone, wrist_m + root_m, elbow)
    turn = preserving_wrist_angles(arm.forearm, multiply(back, hand) * mirror).clamped()
    after = np.stack((arm.upper_arm, multiply(arm.elbow, turn.forearm), turn.hand), axis=1)
    return nearest_sign(after * mirror[:, None], before[:, 1:])


@lru_cache(maxsize=64)
def _arm_joints(skeleton: Skeleton) -> NDArray[np.intp]:
    """Collarbone, upper arm, lower arm and hand (2, 4) of the left and of the right arm. Cached; never mutated."""
    names = ("Shoulder", "UpperArm", "LowerArm", "Hand")
    return np.array([skeleton.chain(*(side + name for name in names)) for side in SIDES], dtype=np.intp)


def _without_twist(lower_arm: FloatArray) -> FloatArray:
    """The rotations (F, 4) without their twist about the bone, which is what x and w are of."""
    twist = lower_arm * _TWIST
    return multiply(lower_arm, inverse(twist / np.maximum(length(twist), 1e-12)))


def _at_most(push_m: FloatArray, farthest_m: float) -> FloatArray:
    return np.asarray(push_m * np.minimum(1.0, farthest_m / np.maximum(length(push_m), 1e-12)))


def _swelling(push_m: FloatArray, swell: int) -> FloatArray:
    """A displacement (T, 3) spread smoothly over neighbouring frames, hardly smaller than required.

    The maximum size within the window, averaged over the window, covers every frame's own; directions are averaged over
    twice the window, and where they disagree the displacement shrinks.
    """
    size_m = length(push_m)[:, 0]
    if not size_m.any():
        return push_m
    bell, wide = _bells(swell)
    nothing = np.zeros(swell)
    padded = np.concatenate([nothing, size_m, nothing])
    largest = np.lib.stride_tricks.sliding_window_view(padded, 2 * swell + 1).max(axis=1)
    before, after = largest[:1].repeat(swell), largest[-1:].repeat(swell)
    swollen_m = np.convolve(np.concatenate([before, largest, after]), bell, mode="valid")
    middle = slice(2 * swell, 2 * swell + len(push_m))
    towards = np.stack([np.convolve(part, wide)[middle] for part in push_m.T], axis=-1)
    agreed = np.convolve(size_m, wide)[middle]
    return np.asarray(towards * (swollen_m / np.maximum(agreed, 1e-12))[:, None])


@lru_cache(maxsize=16)
def _bells(swell: int) -> tuple[FloatArray, FloatArray]:
    """Weights of the frames in a window, whose sum is 1, and in one twice as wide. Cached; never mutated."""
    bell = np.hanning(2 * swell + 3)[1:-1]
    return bell / bell.sum(), np.hanning(4 * swell + 3)[1:-1]


def frames_in(times_s: FloatArray, time_s: float) -> int:
    """The number of frames in a time, at least one."""
    rate_hz = (len(times_s) - 1) / max(times_s[-1] - times_s[0], 1e-9)
    return max(1, round(time_s * float(rate_hz)))


def around(inside: NDArray[np.bool_], frames: int) -> NDArray[np.bool_]:
    """Frames within `frames` of one that is inside."""
    return np.convolve(inside, np.ones(2 * frames + 1), mode="full")[frames : frames + len(inside)] > 0


def stretches(inside: NDArray[np.bool_]) -> NDArray[np.intp]:
    """The first frame and the frame past the last of each run of true values: (n, 2)."""
    padded = np.concatenate([[False], inside, [False]])
    return np.nonzero(padded[1:] != padded[:-1])[0].reshape(-1, 2)
