"""Displacements of wrists and elbows over time, and arms solved again for them.

Conventions: metres in the world, time in frames. A displacement is blended in and out over the surrounding frames so
that velocity stays continuous. The hand keeps its orientation as far as joint limits allow.

Stretches of frames: runs of those in which something is true, and what is near them.

Conventions: booleans (T,) for each frame; a stretch is its first frame and the frame past its last.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ..body.contacts import PosedBody
from ..body.limits import MIRROR
from ..body.skeleton import HANDS, Skeleton
from ..geometry.curves import minimum_jerk
from ..geometry.rotations import dot, inverse, length, multiply, nearest_sign, rotate
from ..gestures.wrist_angles import preserving_wrist_angles
from .arm_reach import ArmBones, reach_by_elbow, shoulder_of, towards_elbow

_ELBOW_AT_LEAST_M = 0.12
_FARTHEST_M = 0.22
_LEAST_M = 1e-6
_TWIST: FloatArray = np.array([1.0, 0.0, 0.0, 1.0])
_MIRRORS: FloatArray = np.stack((np.ones(4), MIRROR))
_MIRRORED: FloatArray = np.array([[[1.0, 1.0, 1.0]], [[-1.0, 1.0, 1.0]]])
"""What makes rotations and places of either side those of the left."""


@dataclass(frozen=True, slots=True, eq=False)
class Displacement:
    """The displacements `by_m` (2, 2, T, 3) of the left and the right arm: of each the wrist's, then the elbow's. Both
    arms are one array, since calls are what they cost."""

    by_m: FloatArray

    @classmethod
    def of_wrists(cls, by_m: FloatArray) -> "Displacement":
        """That of a left and a right wrist (2, T, 3); no elbow is displaced."""
        return cls(np.stack((by_m, np.zeros_like(by_m)), axis=1))

    def and_then(self, other: "Displacement") -> "Displacement":
        by_m = self.by_m + other.by_m
        return Displacement(by_m * np.minimum(1.0, _FARTHEST_M / np.maximum(length(by_m), 1e-12)))

    def swelling(self, swell: int, weights: FloatArray) -> "Displacement":
        by_m, moved = np.zeros_like(self.by_m), self.by_m.any(axis=(2, 3))
        if moved.any():
            by_m[moved] = weights * _swelling(self.by_m[moved], swell)
        return Displacement(by_m)

    @property
    def moved(self) -> NDArray[np.bool_]:
        """Whether each arm is displaced in each frame (2, T)."""
        return np.asarray(length(self.by_m)[..., 0].sum(axis=1) > _LEAST_M)


def taper(frames: int, swell: int, ends: tuple[bool, bool]) -> FloatArray:
    """Weights (F, 1) that rise from 0 at the ends of the stretch, beyond which nothing is moved, to 1 after `swell`
    frames."""
    number = np.arange(frames)
    from_start = number if ends[0] else np.full(frames, swell)
    from_end = number[::-1] if ends[1] else np.full(frames, swell)
    return minimum_jerk(np.minimum(from_start, from_end) / swell)[:, None]


@dataclass(frozen=True, slots=True, eq=False)
class PosedArms:
    """The local `rotations` (T, 2, 3, 4) of upper arm, lower arm and hand of a body's left and right arm, and what
    solving them again needs to know: the way `back` (T, 4) into the space of the chest, and there, of both as left
    arms, the rotations of the collarbone (2, T, 4) and of the other three, `before` (2, T, 3, 4), the way from shoulder
    to wrist, the direction of the elbow, and the orientation of the hand."""

    bones: ArmBones
    rotations: FloatArray
    back: FloatArray
    collarbone: FloatArray
    before: FloatArray
    to_wrist_m: FloatArray
    elbow: FloatArray
    hand: FloatArray

    @classmethod
    def of(cls, skeleton: Skeleton, body: PosedBody) -> "PosedArms":
        """The arms of these frames."""
        bones, chest = ArmBones.of(skeleton), skeleton.index["upperChest"]
        hands = skeleton.chain(*HANDS)
        places_m, turned = body.positions_m.swapaxes(0, 1), body.orientations.swapaxes(0, 1)
        back = inverse(turned[chest])
        arms = skeleton.arms(body.rotations)[:, :, :4]
        local = arms.swapaxes(0, 1) * _MIRRORS[:, None, None]
        collarbone, upper_arm, lower_arm = local[:, :, 0], local[:, :, 1], local[:, :, 2]
        root_m = bones.root_m - skeleton.offsets_m[skeleton.index["leftShoulder"]]
        return cls(
            bones,
            arms[:, :, 1:],
            back,
            collarbone,
            local[:, :, 1:],
            rotate(back, places_m[hands] - places_m[chest]) * _MIRRORED + root_m - shoulder_of(bones, collarbone),
            towards_elbow(multiply(collarbone, upper_arm), _without_twist(lower_arm), bones),
            multiply(back, turned[hands]) * _MIRRORS[:, None],
        )

    def displaced(self, push: Displacement) -> FloatArray:
        """The local rotations (T, 2, 3, 4) with both arms displaced, in the frames concerned."""
        turned, moved = self.rotations.copy(), push.moved
        which = np.flatnonzero(moved.any(axis=1))
        if len(which):
            arms = slice(int(which[0]), int(which[-1]) + 1)
            solved = self._solved_again(arms, push.by_m[arms])
            np.copyto(turned[:, arms], solved.swapaxes(0, 1), where=moved[arms].T[:, :, None, None])
        return turned

    def _solved_again(self, arms: slice, by_m: FloatArray) -> FloatArray:
        """Upper arm, lower arm and hand (A, T, 3, 4) of these arms, solved for displaced wrists and elbows (A, 2, T,
        3)."""
        elbow, mirrors = self.elbow[arms], _MIRRORS[arms, None, None]
        push_m = rotate(self.back, by_m) * _MIRRORED[arms, None]
        to_wrist_m, elbow_m = self.to_wrist_m[arms] + push_m[:, 0], push_m[:, 1]
        elbow = elbow + (elbow_m - dot(elbow_m, elbow) * elbow) / _ELBOW_AT_LEAST_M
        arm = reach_by_elbow(self.bones, self.collarbone[arms], to_wrist_m, elbow)
        turn = preserving_wrist_angles(arm.forearm, self.hand[arms]).clamped()
        after = np.empty((*elbow.shape[:2], 3, 4))
        after[:, :, 0], after[:, :, 1], after[:, :, 2] = arm.upper_arm, multiply(arm.elbow, turn.forearm), turn.hand
        return nearest_sign(after, self.before[arms]) * mirrors


def _without_twist(lower_arm: FloatArray) -> FloatArray:
    """The rotations (F, 4) without their twist about the bone, which is what x and w are of."""
    twist = lower_arm * _TWIST
    return multiply(lower_arm, inverse(twist / np.maximum(length(twist), 1e-12)))


def _swelling(pushes_m: FloatArray, swell: int) -> FloatArray:
    """Displacements (N, T, 3) spread smoothly over neighbouring frames, hardly smaller than required.

    The maximum size within the window, averaged over the window, covers every frame's own; directions are averaged over
    twice the window, and where they disagree the displacement shrinks.
    """
    frames, size_m = pushes_m.shape[1], length(pushes_m)
    bell, wide = _bells(swell)
    largest = _largest_within(size_m[..., 0], swell)
    swollen_m = _averaged(
        np.concatenate([largest[:, :1].repeat(swell, 1), largest, largest[:, -1:].repeat(swell, 1)], axis=1), bell
    )
    ways_m = np.zeros((len(pushes_m), 4, frames + 2 * swell))
    ways_m[:, :3, :frames], ways_m[:, 3, :frames] = pushes_m.swapaxes(1, 2), size_m[..., 0]
    ways_m = _averaged(ways_m, wide)[:, :, :frames]
    ways_m[:, :3] *= (swollen_m[:, swell:-swell] / np.maximum(ways_m[:, 3], 1e-12))[:, None]
    return ways_m[:, :3].swapaxes(1, 2)


def _largest_within(values: FloatArray, reach: int) -> FloatArray:
    """The largest of the values (N, T), none of them negative, from `reach` frames before each to `reach` after: of
    windows that double in size, then of the two that the whole one consists of."""
    found = np.zeros((len(values), values.shape[1] + 2 * reach))
    found[:, reach:-reach] = values
    width = 1
    while 2 * width <= 2 * reach + 1:
        found, width = np.maximum(found[:, :-width], found[:, width:]), 2 * width
    beyond = 2 * reach + 1 - width
    return np.maximum(found[:, : -beyond or None], found[:, beyond:])


def _averaged(curves: FloatArray, weights: FloatArray) -> FloatArray:
    """The curves (…, T), each frame the sum of its neighbours times the weights: one after the other in one array, so
    that in frames nearer to an end than half of the weights are, neighbours are those of the curve beside it."""
    return np.convolve(curves.ravel(), weights, mode="same").reshape(curves.shape)


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
