"""Limits the speed of arms and head: where a wrist moves or a joint turns faster than human arms do, the motion is
smoothed around the fast frames; a head that would turn too fast comes later.

Arms are smoothed twice: alone, before the trunk follows them; and in the world, after all other sources of speed have
been added: trunk, steps, follow-through of the hands, collision avoidance. The head's share is what the trunk leaves
it, so that the sum of all layers, and of the clock that eases in and out, respects the limit.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil, radians

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ..arms.posing import ARM_ROWS, wrists_of
from ..body.contacts import PosedBody
from ..body.motion import BodyMotion
from ..body.skeleton import HANDS, Skeleton
from ..geometry.curves import clipped, smoothed
from ..geometry.rotations import angle_between, dot, inverse, keep_signs, multiply, normalized, rotate, within_speed

Wrists = Callable[[FloatArray, slice], FloatArray]
"""Computes the positions (2, F, 3) of the wrists of a left and a right arm (F, 2, 19, 4) in these frames."""


@dataclass(frozen=True, slots=True)
class FastestArms:
    """The maximum speed of a wrist, and the maximum angular speed, about any axis, of the joints in these rows of an
    arm."""

    wrist_m_s: float
    joint_rad_s: float
    rows: slice


BY_THEMSELVES = FastestArms(2.62, 16.0, ARM_ROWS)
"""The limits for the arms alone; the trunk adds its own speed."""
IN_THE_WORLD = FastestArms(2.9, 18.5, slice(0, 4))
"""The limits in the world, such that in the result no wrist is faster than 3 m/s, and no hand or arm turns faster than
20 rad/s."""
FINGERS = FastestArms(np.inf, 18.5, slice(None))
"""The limit of thumbs and fingers in all."""
_FINGER_ROWS = slice(4, 19)

FASTEST_HEAD_RAD_S = radians(245.0)
"""The limit of the head in the world, somewhat below the 250°/s that no frame may exceed."""
_OWN_SHARE = 0.25
"""The part of it that the head keeps for itself when the trunk turns that fast."""

_ROUNDS, _CALMER_S, _AROUND_S = 8, 0.045, 0.08
_NEAR = 0.15
"""The share of fast frames in the neighbourhood of a frame from which on it is smoothed fully."""
_BESIDE_S = 0.6
"""Frames farther than this from every fast frame are beyond the reach of both smoothings and are skipped."""


def calm(skeleton: Skeleton, arms: FloatArray, times_s: FloatArray) -> FloatArray:
    """Smooth the left and the right arm (T, 2, 19, 4), in place, around frames above the limits for arms alone. Returns
    the resulting positions of the wrists (2, T, 3) from their own sides. The first and the last pose are unchanged."""
    wrists_m = _calmed(arms, times_s, lambda some, _frames: wrists_of(skeleton, some), BY_THEMSELVES)
    wrists_m[1, :, 0] *= -1.0
    return wrists_m


def calm_arms(skeleton: Skeleton, body: BodyMotion, posed: PosedBody | None = None) -> bool:
    """Smooth the body's arms, in place, around frames above the limits in the world. Returns whether there are any.
    `posed`, where its joints are, need not be given."""
    posed = posed or PosedBody.carrying(skeleton, body.rotations, body.hips_m)
    arms, wrists_m = skeleton.arms(body.rotations), posed.positions_m.swapaxes(0, 1)[skeleton.chain(*HANDS)]
    if not _fast(wrists_m, arms, _step_s(body.times_s), IN_THE_WORLD).any():
        return False
    keep_signs(arms)
    _calmed(arms, body.times_s, _carried(skeleton, posed), IN_THE_WORLD)
    return True


def calm_fingers(skeleton: Skeleton, body: BodyMotion) -> bool:
    """Smooth thumbs and fingers, in place, around frames in which they turn too fast: shapes may change quickly, and
    what drags behind a wrist is added to that. Returns whether there are any."""
    fingers = skeleton.arms(body.rotations)[:, :, _FINGER_ROWS]
    nowhere_m = np.zeros((2, len(fingers), 3))
    if not _fast(nowhere_m, fingers, _step_s(body.times_s), FINGERS).any():
        return False
    keep_signs(fingers)
    _calmed(fingers, body.times_s, lambda _some, frames: nowhere_m[:, frames], FINGERS)
    return True


def calm_head(skeleton: Skeleton, body: BodyMotion, posed: PosedBody | None = None) -> bool:
    """Keep the body's head within the limit in the world, in place. Returns whether it was above it. `posed`, where its
    joints are, need not be given."""
    step_s = _step_s(body.times_s)
    posed = posed or PosedBody.carrying(skeleton, body.rotations, body.hips_m)
    chest, turned = (posed.orientations[:, joint] for joint in skeleton.chain("upperChest", "head"))
    if (np.abs(dot(turned[1:], turned[:-1])) >= np.cos(FASTEST_HEAD_RAD_S * step_s / 2)).all():
        return False
    left = FASTEST_HEAD_RAD_S - angle_between(chest[1:], chest[:-1]) / step_s
    neck, head = skeleton.chain("neck", "head")
    over_chest = multiply(body.rotations[:, neck], body.rotations[:, head])
    calm = within_speed(over_chest, step_s, np.maximum(left, _OWN_SHARE * FASTEST_HEAD_RAD_S))
    body.rotations[:, head] = multiply(inverse(body.rotations[:, neck]), calm)
    return True


def _carried(skeleton: Skeleton, posed: PosedBody) -> Wrists:
    """The positions of the wrists in the world, for arms attached to this body's chest."""
    chest = skeleton.index["upperChest"]
    upright_m = np.sum(skeleton.offsets_m[skeleton.chain("spine", "chest", "upperChest")], axis=0)

    def wrists(arms: FloatArray, frames: slice) -> FloatArray:
        out_m = wrists_of(skeleton, arms) - upright_m
        return np.asarray(posed.positions_m[frames, chest] + rotate(posed.orientations[frames, chest], out_m))

    return wrists


def _calmed(arms: FloatArray, times_s: FloatArray, wrists: Wrists, fastest: FastestArms) -> FloatArray:
    """Smooth both arms in place; returns the resulting positions of the wrists."""
    step_s = _step_s(times_s)
    wrists_m = wrists(arms, slice(None))
    for _round in range(_ROUNDS):
        fast = _fast(wrists_m, arms, step_s, fastest)
        if not fast.any():
            break
        free = _free(times_s, fast[0] | fast[1])[:, None, None]
        for part in _stretches(fast[0] | fast[1], ceil(_BESIDE_S / step_s)):
            for side, quick in enumerate(fast[:, part]):
                arm = arms[part, side]
                near = smoothed(quick.astype(float)[:, None], _AROUND_S / step_s)
                weight = clipped(near / _NEAR, 0.0, 1.0)[:, :, None]
                calmer = smoothed(arm, _CALMER_S / step_s)
                arm[...] = normalized(arm + free[part] * weight * (calmer - arm))
            wrists_m[:, part] = wrists(arms[part], part)
    return wrists_m


def _free(times_s: FloatArray, fast: NDArray[np.bool_]) -> FloatArray:
    """How far each frame may be changed (T,): not at an end, unless arms are fast there, which could not be calmed
    otherwise."""
    free = np.ones(len(times_s))
    for from_end_s in (times_s - times_s[0], times_s[-1] - times_s):
        if not fast[from_end_s < 2 * _AROUND_S].any():
            free *= clipped(from_end_s / _AROUND_S - 1.0, 0.0, 1.0)
    return free


def _step_s(times_s: FloatArray) -> float:
    return float(times_s[1] - times_s[0]) if len(times_s) > 1 else 1.0


def _fast(wrists_m: FloatArray, arms: FloatArray, step_s: float, fastest: FastestArms) -> NDArray[np.bool_]:
    """Whether each arm is too fast between a frame and the next (2, T)."""
    found = np.zeros(wrists_m.shape[:2], dtype=bool)
    steps_m = wrists_m[:, 1:] - wrists_m[:, :-1]
    found[:, :-1] = dot(steps_m, steps_m)[..., 0] > (fastest.wrist_m_s * step_s) ** 2
    least = np.cos(fastest.joint_rad_s * step_s / 2)
    rows = arms[:, :, fastest.rows]
    near = np.abs(np.einsum("tajk,tajk->taj", rows[1:], rows[:-1])) < least
    if near.any():
        for joint in near.transpose(2, 1, 0):
            found[:, :-1] |= joint
    return found


def _stretches(marked: NDArray[np.bool_], margin: int) -> list[slice]:
    """The intervals of frames around marked frames, with a margin before and after."""
    [frames] = np.nonzero(marked)
    parts = np.split(frames, np.flatnonzero(np.diff(frames) > 2 * margin) + 1)
    return [slice(max(int(part[0]) - margin, 0), int(part[-1]) + margin + 1) for part in parts]
