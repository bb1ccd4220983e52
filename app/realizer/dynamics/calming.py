"""Limits the speed of arms and head: where a wrist moves or a joint turns faster than human arms do, the motion is
smoothed around the fast frames; a head that would turn too fast comes later.

Arms are smoothed twice: alone, before the trunk follows them; and in the world, after all other sources of speed have
been added: trunk, steps, follow-through of the hands, collision avoidance. The head's share is what the trunk leaves
it, so that the sum of all layers, and of the clock that eases in and out, respects the limit.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache, reduce
from math import ceil, radians

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray, Hand
from ..arms.posing import ARM_ROWS, wrists_of
from ..body.motion import BodyMotion
from ..body.skeleton import Skeleton, arm_joints, forward
from ..geometry.curves import smoothed
from ..geometry.rotations import angle_between, dot, inverse, keep_signs, multiply, normalized, rotate, within_speed

Wrists = Callable[[Sequence[FloatArray], slice], FloatArray]
"""Computes the positions (2, F, 3) of the wrists of a left and a right arm (F, 19, 4) in these frames."""


@dataclass(frozen=True, slots=True)
class FastestArms:
    """The maximum speed of a wrist, and the maximum angular speed, about any axis, of the joints in these rows of an
    arm."""

    wrist_m_s: float
    joint_rad_s: float
    rows: slice


BY_THEMSELVES = FastestArms(2.5, 16.0, ARM_ROWS)
"""The limits for the arms alone; the trunk adds its own speed."""
IN_THE_WORLD = FastestArms(2.9, 18.5, slice(0, 4))
"""The limits in the world, such that in the result no wrist is faster than 3 m/s, and no hand or arm turns faster than
20 rad/s."""

FASTEST_HEAD_RAD_S = radians(245.0)
"""The limit of the head in the world, somewhat below the 250°/s that no frame may exceed."""
_OWN_SHARE = 0.25
"""The part of it that the head keeps for itself when the trunk turns that fast."""

_ROUNDS, _CALMER_S, _AROUND_S = 8, 0.045, 0.08
_NEAR = 0.15
"""The share of fast frames in the neighbourhood of a frame from which on it is smoothed fully."""
_BESIDE_S = 0.6
"""Frames farther than this from every fast frame are beyond the reach of both smoothings and are skipped."""
_TRUNK, _NECK = ("hips", "spine", "chest", "upperChest"), ("neck", "head")


def calm(skeleton: Skeleton, arms: Sequence[FloatArray], times_s: FloatArray) -> FloatArray:
    """Smooth the left and the right arm (T, 19, 4), in place, around frames above the limits for arms alone. Returns
    the resulting positions of the wrists (2, T, 3). The first and the last pose are unchanged."""
    return _calmed(arms, times_s, lambda some, _frames: wrists_of(skeleton, *some), BY_THEMSELVES)


def calm_arms(skeleton: Skeleton, body: BodyMotion) -> bool:
    """Smooth the body's arms, in place, around frames above the limits in the world. Returns whether there are any."""
    arms = [body.rotations[:, skeleton.rows(*arm_joints(side))] for side in (Hand.LEFT, Hand.RIGHT)]
    wrists = _carried(skeleton, body)
    if not _fast(wrists(arms, slice(None)), arms, _step_s(body.times_s), IN_THE_WORLD).any():
        return False
    for arm in arms:
        keep_signs(arm)
    _calmed(arms, body.times_s, wrists, IN_THE_WORLD)
    return True


def calm_head(skeleton: Skeleton, body: BodyMotion) -> bool:
    """Keep the body's head within the limit in the world, in place. Returns whether it was above it."""
    step_s = _step_s(body.times_s)
    chest, over_chest = (_product(skeleton, body, names) for names in (_TRUNK, _NECK))
    turned = multiply(chest, over_chest)
    if (np.abs(dot(turned[1:], turned[:-1])) >= np.cos(FASTEST_HEAD_RAD_S * step_s / 2)).all():
        return False
    left = FASTEST_HEAD_RAD_S - angle_between(chest[1:], chest[:-1]) / step_s
    calm = within_speed(over_chest, step_s, np.maximum(left, _OWN_SHARE * FASTEST_HEAD_RAD_S))
    neck, head = skeleton.chain(*_NECK)
    body.rotations[:, head] = multiply(inverse(body.rotations[:, neck]), calm)
    return True


def _product(skeleton: Skeleton, body: BodyMotion, names: Sequence[str]) -> FloatArray:
    """The rotation (T, 4) that a chain of joints adds up to."""
    first, *others = (body.rotations[:, joint] for joint in skeleton.chain(*names))
    return reduce(multiply, others, first)


def _carried(skeleton: Skeleton, body: BodyMotion) -> Wrists:
    """The positions of the wrists in the world, for arms attached to this body's chest."""
    at_m, turned = forward(skeleton, body.rotations, body.hips_m, _trunk(skeleton))
    chest = skeleton.index["upperChest"]
    upright_m = np.sum(skeleton.offsets_m[skeleton.chain(*_TRUNK[1:])], axis=0)
    across = np.array([[[1.0, 1.0, 1.0]], [[-1.0, 1.0, 1.0]]])

    def wrists(arms: Sequence[FloatArray], frames: slice) -> FloatArray:
        out_m = wrists_of(skeleton, *arms) * across - upright_m
        return np.asarray(at_m[frames, chest] + rotate(turned[frames, chest], out_m))

    return wrists


@lru_cache(maxsize=64)
def _trunk(skeleton: Skeleton) -> frozenset[int]:
    return frozenset(skeleton.chain(*_TRUNK))


def _calmed(arms: Sequence[FloatArray], times_s: FloatArray, wrists: Wrists, fastest: FastestArms) -> FloatArray:
    """Smooth both arms in place; returns the resulting positions of the wrists."""
    step_s = _step_s(times_s)
    wrists_m = wrists(arms, slice(None))
    for _round in range(_ROUNDS):
        fast = _fast(wrists_m, arms, step_s, fastest)
        if not fast.any():
            break
        free = _free(times_s, fast[0] | fast[1])[:, None, None]
        for part in _stretches(fast[0] | fast[1], ceil(_BESIDE_S / step_s)):
            for arm, quick in zip(arms, fast[:, part], strict=True):
                near = smoothed(quick.astype(float)[:, None], _AROUND_S / step_s)
                weight = np.clip(near / _NEAR, 0.0, 1.0)[:, :, None]
                calmer = smoothed(arm[part], _CALMER_S / step_s)
                arm[part] = normalized(arm[part] + free[part] * weight * (calmer - arm[part]))
            wrists_m[:, part] = wrists([arm[part] for arm in arms], part)
    return wrists_m


def _free(times_s: FloatArray, fast: NDArray[np.bool_]) -> FloatArray:
    """How far each frame may be changed (T,): not at an end, unless arms are fast there, which could not be calmed
    otherwise."""
    free = np.ones(len(times_s))
    for from_end_s in (times_s - times_s[0], times_s[-1] - times_s):
        if not fast[from_end_s < 2 * _AROUND_S].any():
            free *= np.clip(from_end_s / _AROUND_S - 1.0, 0.0, 1.0)
    return free


def _step_s(times_s: FloatArray) -> float:
    return float(times_s[1] - times_s[0]) if len(times_s) > 1 else 1.0


def _fast(wrists_m: FloatArray, arms: Sequence[FloatArray], step_s: float, fastest: FastestArms) -> NDArray[np.bool_]:
    """Whether each arm is too fast between a frame and the next (2, T)."""
    found = np.zeros(wrists_m.shape[:2], dtype=bool)
    steps_m = wrists_m[:, 1:] - wrists_m[:, :-1]
    found[:, :-1] = dot(steps_m, steps_m)[..., 0] > (fastest.wrist_m_s * step_s) ** 2
    least = np.cos(fastest.joint_rad_s * step_s / 2)
    for arm, fast in zip(arms, found, strict=True):
        rows = arm[:, fastest.rows]
        cosines = np.einsum("tjq,tjq->jt", rows[1:], rows[:-1])
        fast[:-1] |= (np.abs(cosines, out=cosines) < least).any(axis=0)
    return found


def _stretches(marked: NDArray[np.bool_], margin: int) -> list[slice]:
    """The intervals of frames around marked frames, with a margin before and after."""
    [frames] = np.nonzero(marked)
    parts = np.split(frames, np.flatnonzero(np.diff(frames) > 2 * margin) + 1)
    return [slice(max(int(part[0]) - margin, 0), int(part[-1]) + margin + 1) for part in parts]
