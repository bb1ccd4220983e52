"""Unit selection: recorded motion units for a path of states, by joint, duration and affect cost (RTS §2.4, AHG §3.7).

A unit is a clip of motion in one state. Dynamic programming over the segments of a path finds the sequence of
units with the lowest total cost; units are stretched to their segments, and the discontinuities at the joints go
gently: both sources smooth exponentially, by which an arm starts to go over with twelve times its way a second.

Costs, for segment l of state g_i and unit ε of that state:

- RTS eq. 2.6 to 2.8: α ‖ω_end(previous) - ω_begin(ε)‖ + (1 - α) ‖κ_l - κ(ε)‖. As printed the recursion's cost does not
  depend on the previous unit j, over which it is minimised; by eq. 2.7 it must. The first unit has only a duration
  cost; the printed joint cost has no predecessor.
- AHG eq. 16: β1 D_ω + (β2 + β3 (1 - α)) D_κ + β3 α D_a, with mean squared differences of angles and of affect, and the
  difference of durations. So with α = 0 what affect does not weigh, duration does.

Durations are seconds, angles radians, affects in [-1, 1]: the sources do not say, and the weights depend on it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import InputError
from ..model import FloatArray
from ..prosody_gestures.semi_markov import FRAME_S, IntArray, Segment
from ..realizer.geometry.curves import minimum_jerk
from ..realizer.geometry.rotations import (
    from_rotation_vector,
    inverse,
    multiply,
    nearest_sign,
    normalized,
    to_rotation_vector,
    with_continuous_signs,
)

LEAD_OVER_S = 0.5
"""The time in which a discontinuity is gone."""


@dataclass(frozen=True, slots=True, eq=False)
class MotionUnit:
    """A motion clip in one state: local `rotations` (frames × joints × 4), the `angles` by which it is joined, of its
    first and its last frame (2 × angles), and its mean activation, valence and dominance."""

    state: int
    rotations: FloatArray
    angles: FloatArray
    affect: FloatArray

    @property
    def duration_s(self) -> float:
        return len(self.rotations) * FRAME_S


@dataclass(frozen=True, slots=True)
class Weights:
    """The weights of the joint, duration and affect costs. With `joint_norm` the joint cost is the norm (RTS) instead
    of the mean square (AHG)."""

    joint: float
    duration: float
    affect: float
    joint_norm: bool = False


def thesis_weights(alpha: float) -> Weights:
    """RTS eq. 2.8."""
    return Weights(joint=alpha, duration=1 - alpha, affect=0.0, joint_norm=True)


def paper_weights(alpha: float, betas: tuple[float, float, float] = (0.30, 0.35, 0.35)) -> Weights:
    """AHG eq. 16 with its β1, β2, β3; α is the influence of affect."""
    joint, duration, affect = betas
    return Weights(joint, duration + affect * (1 - alpha), affect * alpha)


@dataclass(frozen=True, slots=True, eq=False)
class UnitPool:
    """The units of each state."""

    units: Mapping[int, Sequence[MotionUnit]]

    @classmethod
    def of(cls, units: Sequence[MotionUnit]) -> "UnitPool":
        by_state: dict[int, list[MotionUnit]] = {}
        for unit in units:
            by_state.setdefault(unit.state, []).append(unit)
        return cls(by_state)


def select(path: Sequence[Segment], affects: FloatArray, pool: UnitPool, weights: Weights) -> list[MotionUnit]:
    """The units with the lowest total cost for a path; `affects` are those of its segments (segments × 3).

    Raises InputError `no_units` if a state of the path has none.
    """
    missing = {segment.state for segment in path} - set(pool.units)
    if missing:
        raise InputError("no_units", f"no unit of state {min(missing)} is in the pool")
    if not path:
        return []
    offered = [pool.units[segment.state] for segment in path]
    costs = _fitting(path[0], affects[0], offered[0], weights)
    origins: list[IntArray] = []
    for place in range(1, len(path)):
        joined = costs[:, None] + weights.joint * _joints(offered[place - 1], offered[place], weights)
        origins.append(joined.argmin(axis=0))
        costs = joined.min(axis=0) + _fitting(path[place], affects[place], offered[place], weights)
    chosen = [int(costs.argmin())]
    for origin in reversed(origins):
        chosen.append(int(origin[chosen[-1]]))
    return [units[place] for units, place in zip(offered, reversed(chosen), strict=True)]


def _fitting(segment: Segment, affect: FloatArray, units: Sequence[MotionUnit], weights: Weights) -> FloatArray:
    """The duration and affect cost of each unit in a segment."""
    durations_s = np.array([unit.duration_s for unit in units])
    affects = np.stack([unit.affect for unit in units])
    lasting, feeling = np.abs(durations_s - segment.frames * FRAME_S), ((affects - affect) ** 2).mean(axis=1)
    costs: FloatArray = weights.duration * lasting + weights.affect * feeling
    return costs


def _joints(before: Sequence[MotionUnit], after: Sequence[MotionUnit], weights: Weights) -> FloatArray:
    """The unweighted cost of joining each unit (column) to each predecessor (row)."""
    ends, begins = (np.stack([unit.angles[place] for unit in units]) for units, place in ((before, -1), (after, 0)))
    squares = (ends**2).sum(axis=1)[:, None] + (begins**2).sum(axis=1) - 2 * ends @ begins.T
    squares = np.maximum(squares, 0)
    joints: FloatArray = np.sqrt(squares) if weights.joint_norm else squares / ends.shape[1]
    return joints


def motion_of(path: Sequence[Segment], units: Sequence[MotionUnit]) -> FloatArray:
    """The rotations of a path (frames × joints × 4): units stretched to their segments; the discontinuity at each joint
    is removed by a turn that goes within `LEAD_OVER_S`."""
    parts: list[FloatArray] = []
    for segment, unit in zip(path, units, strict=True):
        rotations = stretched(unit.rotations, segment.frames)
        parts.append(led_over(parts[-1][-1], rotations) if parts else rotations)
    return with_continuous_signs(np.concatenate(parts))


def led_over(before: FloatArray, rotations: FloatArray) -> FloatArray:
    """The rotations (frames × joints × 4), turned so that they begin at `before` (joints × 4); the turn goes with as
    little jerk as it can."""
    apart = to_rotation_vector(multiply(before, inverse(rotations[0])))
    times_s = FRAME_S * np.arange(1, len(rotations) + 1)
    left = 1.0 - minimum_jerk(times_s / LEAD_OVER_S)
    return multiply(from_rotation_vector(left[:, None, None] * apart), rotations)


def stretched(rotations: FloatArray, frames: int) -> FloatArray:
    """The rotations resampled to another number of frames, between neighbours by normalized linear interpolation."""
    places = np.linspace(0, len(rotations) - 1, frames)
    first = np.minimum(places.astype(np.intp), max(len(rotations) - 2, 0))
    after = np.minimum(first + 1, len(rotations) - 1)
    share = (places - first)[:, None, None]
    one, other = rotations[first], nearest_sign(rotations[after], rotations[first])
    return normalized(one + share * (other - one))
