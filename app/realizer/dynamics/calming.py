"""Arms that are nowhere faster than arms are: where a wrist would be, or a joint would turn faster, the arm takes its
turn less sharply, a little longer before and after it.
"""

from collections.abc import Sequence
from math import ceil

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ..arms.posing import ARM_ROWS, wrists_of
from ..body.skeleton import Skeleton
from ..geometry.rotations import normalized
from ..geometry.smoothing import smoothed

_FASTEST_M_S = 2.5
"""Of a wrist beside the trunk, which adds its own speed: none is faster than 3 m/s on the whole."""
_FASTEST_RAD_S = 16.0
"""Of collarbone, shoulder and elbow, about any axis."""
_ROUNDS, _CALMER_S, _AROUND_S = 8, 0.045, 0.08
_NEAR = 0.15
"""The share of fast frames around one of which it is calmed wholly."""
_BESIDE_S = 0.6
"""What is farther from a fast frame than both smoothings reach is not calmed."""


def calm(skeleton: Skeleton, arms: Sequence[FloatArray], times_s: FloatArray) -> FloatArray:
    """Smooth the left and the right arm (T, 19, 4), in place, around what is faster than `_FASTEST_M_S` or
    `_FASTEST_RAD_S`; the places of the wrists (2, T, 3) afterwards. The first and the last pose stay."""
    step_s = float(times_s[1] - times_s[0]) if len(times_s) > 1 else 1.0
    wrists_m = wrists_of(skeleton, *arms)
    from_end_s = np.minimum(times_s - times_s[0], times_s[-1] - times_s)
    free = np.clip(from_end_s / _AROUND_S - 1.0, 0.0, 1.0)[:, None, None]
    for _round in range(_ROUNDS):
        speeds = np.linalg.norm(np.diff(wrists_m, axis=1, append=wrists_m[:, -1:]), axis=2) / step_s
        fast = (speeds > _FASTEST_M_S) | np.stack([_turns_fast(arm, step_s) for arm in arms])
        if not fast.any():
            return wrists_m
        for part in _stretches(fast.any(axis=0), ceil(_BESIDE_S / step_s)):
            for arm, quick in zip(arms, fast[:, part], strict=True):
                near = smoothed(quick.astype(float)[:, None], _AROUND_S / step_s)
                weight = np.clip(near / _NEAR, 0.0, 1.0)[:, :, None]
                calmer = smoothed(arm[part], _CALMER_S / step_s)
                arm[part] = normalized(arm[part] + free[part] * weight * (calmer - arm[part]))
            wrists_m[:, part] = wrists_of(skeleton, *(arm[part] for arm in arms))
    return wrists_m


def _turns_fast(arm: FloatArray, step_s: float) -> NDArray[np.bool_]:
    """Whether a joint turns too fast from a frame (T,) to the next. Between two unit quaternions that are close it is
    twice their distance, whichever sign they have."""
    rows = arm[:, ARM_ROWS]
    following = np.concatenate([rows[1:], rows[-1:]])
    apart = np.minimum(np.linalg.norm(following - rows, axis=-1), np.linalg.norm(following + rows, axis=-1))
    return np.asarray((2 * apart > _FASTEST_RAD_S * step_s).any(axis=-1))


def _stretches(marked: NDArray[np.bool_], margin: int) -> list[slice]:
    """The frames around each that is marked, so many before and after it."""
    [frames] = np.nonzero(marked)
    parts = np.split(frames, np.flatnonzero(np.diff(frames) > 2 * margin) + 1)
    return [slice(max(int(part[0]) - margin, 0), int(part[-1]) + margin + 1) for part in parts]
