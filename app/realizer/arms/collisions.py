"""Post-processing: keeps hands and forearms out of the body and each other, and joints within their limits.

Conventions: metres in the world, time in frames. Where a limb penetrates something, its wrist and elbow are displaced
along the shortest way out. The displacement is blended in and out over the surrounding frames so that velocity stays
continuous, and the arm is solved again for its new wrist. The hand keeps its orientation as far as joint limits allow.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ..body.contacts import BUILD, PAIRS, Point, PosedBody, depths_m
from ..body.limits import clamp
from ..body.motion import BodyMotion, Decision
from ..body.skeleton import SIDES, Skeleton
from .clearing import Aside, ClearingMode, cleared
from .displacements import around, frames_in, stretches, taper

_SWELLS_S = (0.18, 0.27, 0.36)
"""Over how long a displacement is blended in; longer only where something stays inside."""
_LOOK_S, _NEAR_M = 0.067, 0.012
_FASTEST_RAD_S = (19.0, 28.0)
"""How fast joints may turn to get limbs out; faster only where something stays inside: it can be calmed after."""
_TOLERATED_M = 0.001
_ATTEMPTS = 3
_ASIDE_M, _ASIDE_ROUNDS = (0.05, 0.1, 0.18), 4
_ASIDE: tuple[Point, ...] = (
    (1.0, 0.0, 0.0),
    (0.0, 1.0, 0.0),
    (0.0, 0.0, 1.0),
    (0.7, 0.7, 0.0),
    (0.7, 0.0, 0.7),
    (0.0, 0.7, 0.7),
    (0.0, -1.0, 0.0),
    (0.7, -0.7, 0.0),
    (0.0, 0.0, -1.0),
)
"""Where an arm may be led aside: outward, up and ahead of its own way."""
_FRAMES_AT_ONCE = 2048
"""Frames that are brought within limits at a time, so that long takes need little more memory."""


@dataclass(frozen=True, slots=True)
class Intrusion:
    """A stretch of time in which a limb of that side would have been inside something, and how deep."""

    side: str
    limb: str
    other: str
    deepest_m: float
    start_s: float
    end_s: float

    def overlaps(self, other: "Intrusion") -> bool:
        return self.side == other.side and self.start_s <= other.end_s and other.start_s <= self.end_s

    @property
    def decision(self) -> Decision:
        when = f"from {self.start_s:.2f} s to {self.end_s:.2f} s"
        inside = f"{100 * self.deepest_m:.1f} cm inside the {self.other}"
        return Decision("", "moved", f"the {self.side} {self.limb} would have been {inside} {when}")


@dataclass(frozen=True, slots=True)
class Collisions:
    """What limbs were moved out of, and the decisions about those that stay inside something."""

    moved: tuple[Intrusion, ...] = ()
    kept: tuple[Decision, ...] = ()

    def and_then(self, later: "Collisions") -> "Collisions":
        """With what was found in the resulting motion when it was looked at again: what was moved then again is told
        once, and what stays inside is what stays at last."""
        new = tuple(each for each in later.moved if not any(each.overlaps(known) for known in self.moved))
        return Collisions((*self.moved, *new), later.kept)

    @property
    def decisions(self) -> tuple[Decision, ...]:
        return (*(each.decision for each in self.moved), *self.kept)


def resolve_collisions(skeleton: Skeleton, body: BodyMotion) -> Collisions:
    """Move hands and forearms out of torso, head, upper legs and each other, and bring trunk, neck and arms within
    limits, in place.

    Returns the stretches of time in which a hand was displaced, or could not be without making a joint jump.
    """
    return kept_apart(skeleton, body)[0]


def kept_apart(skeleton: Skeleton, body: BodyMotion) -> tuple[Collisions, PosedBody]:
    """`resolve_collisions`, and where the joints of the body are then.

    Where something stays inside, as when both arms fold at once, displacements are blended in over a longer time, and
    then limbs leave on another side; what is left after the best of these is left again, from there.
    """
    for first in range(0, len(body.rotations), _FRAMES_AT_ONCE):
        clamp(skeleton, body.rotations[first : first + _FRAMES_AT_ONCE])
    posed = PosedBody.carrying(skeleton, body.rotations, body.hips_m)
    depth_m = depths_where_near_m(skeleton, body, posed)
    moved = tuple(_intrusions(depth_m, body.times_s))
    unsolved: tuple[_Clearance, ...] = ()
    for _attempt in range(_ATTEMPTS):
        inside = depth_m.max(axis=1) > 0
        if not inside.any():
            break
        unsolved = _left_inside(skeleton, body, posed, inside)
        if not unsolved:
            break
        depth_m = depths_where_near_m(skeleton, body, posed)
    return Collisions(moved, tuple(_unsolved(body.times_s[each.there], each.left_m) for each in unsolved)), posed


@dataclass(frozen=True, slots=True, eq=False)
class _Clearance:
    """A stretch of frames, its local rotations with the arms displaced, and what is left of the penetration."""

    there: slice
    rotations: FloatArray
    left_m: float


def _left_inside(
    skeleton: Skeleton, body: BodyMotion, posed: PosedBody, inside: NDArray[np.bool_]
) -> tuple[_Clearance, ...]:
    """Clear the stretches around the frames that are `inside` something, in place, each in the first way that does; the
    stretches for which none does, cleared in the one that does best. `posed` is where the joints are, then too."""
    left_m: dict[ClearingMode, float] = {}
    for way in _ways(body.times_s):
        found = _cleared(skeleton, body, posed, inside, way=way)
        left_m[way] = max(each.left_m for each in found)
        if left_m[way] <= _TOLERATED_M:
            return ()
    return _cleared(skeleton, body, posed, inside, way=min(left_m, key=left_m.__getitem__), at_most_m=np.inf)


def _ways(times_s: FloatArray) -> Iterator[ClearingMode]:
    """How limbs may leave what they are in, what changes least first: led aside, little before far, only where nothing
    else does, as where one arm passes through the other too quickly for either to give way."""
    step_s = _SWELLS_S[0] / frames_in(times_s, _SWELLS_S[0])
    for fastest_rad_s, swell_s, as_it_ends in product(_FASTEST_RAD_S, _SWELLS_S, (False, True)):
        yield ClearingMode(frames_in(times_s, swell_s), fastest_rad_s * step_s, as_it_ends)
    swell = frames_in(times_s, _SWELLS_S[1])
    for fastest_rad_s, far_m, side, (outward, up, ahead) in product(_FASTEST_RAD_S, _ASIDE_M, SIDES, _ASIDE):
        by_m = far_m * (outward if side is SIDES[0] else -outward), far_m * up, far_m * ahead
        yield ClearingMode(swell, fastest_rad_s * step_s, aside=Aside(side, by_m), rounds=_ASIDE_ROUNDS)


def _cleared(
    skeleton: Skeleton,
    body: BodyMotion,
    posed: PosedBody,
    inside: NDArray[np.bool_],
    *,
    way: ClearingMode,
    at_most_m: float = _TOLERATED_M,
) -> tuple[_Clearance, ...]:
    """The stretches around the frames that are `inside` something; those of which no more than `at_most_m` is left are
    cleared, in place, and inside no more."""
    found = tuple(_clearances(skeleton, posed, body.hips_m, inside, way))
    moved = np.zeros(len(inside), dtype=bool)
    for each in found:
        if each.left_m <= at_most_m:
            body.rotations[each.there] = each.rotations  # a copy already, and stretches do not overlap
            inside[each.there], moved[each.there] = False, True
    posed.update(skeleton, body.hips_m, np.flatnonzero(moved))
    return found


def _clearances(
    skeleton: Skeleton, posed: PosedBody, hips_m: FloatArray, inside: NDArray[np.bool_], way: ClearingMode
) -> Iterator[_Clearance]:
    """The stretches around the frames with a limb `inside` something."""
    for first, past in stretches(around(inside, 2 * way.swell)):
        there, ends = slice(first, past), (first > 0, past < len(inside))
        weights = taper(past - first, way.swell, ends)
        yield _Clearance(there, *cleared(skeleton, posed.part(skeleton, hips_m, there), way, weights))


def depths_where_near_m(skeleton: Skeleton, body: BodyMotion, posed: PosedBody | None = None) -> FloatArray:
    """The depths (T, P) in all frames in which a limb may be inside something; the others', -1, are not looked at.
    `posed`, where the joints of the body are, need not be given.

    One frame every `_LOOK_S` is, and if one has a limb within `_NEAR_M` of something, or would have between it and the
    next as fast as limbs come before and go after, the frames around it: how far limbs accelerate towards something
    from one of these frames to the next is less.
    """
    frames, stride = len(body.rotations), frames_in(body.times_s, _LOOK_S)
    looked_at = np.zeros(frames, dtype=bool)
    looked_at[::stride] = looked_at[-1] = True
    found = np.full((len(PAIRS), frames), -1.0).T  # in memory pair by pair, over which a maximum is found much faster
    first = np.flatnonzero(looked_at)
    found[first] = depth_m = depths_m(skeleton, body.rotations, body.hips_m, first, posed)
    found_near = np.zeros(frames, dtype=bool)
    found_near[first] = depth_m.max(axis=1) > -_NEAR_M
    found_near[first[:-1][_deepest_between_m(depth_m) > -_NEAR_M]] = True
    near = np.flatnonzero(around(found_near, stride) & ~looked_at)
    if len(near):
        found[near] = depths_m(skeleton, body.rotations, body.hips_m, near, posed)
    return found


def _deepest_between_m(depth_m: FloatArray) -> FloatArray:
    """How deep (F - 1,) any limb is between each of the frames (F, P) that are looked at and the next, if it comes as
    fast as before the first of the two and goes as fast as after the second: hands in a stroke may be in each other for
    two frames."""
    steps_m = np.diff(depth_m, axis=0)
    still = np.zeros((1, depth_m.shape[1]))
    comes_m = np.maximum(np.concatenate([still, steps_m[:-1]]), 0.0)
    goes_m = np.maximum(np.concatenate([-steps_m[1:], still]), 0.0)
    both_m = np.maximum(comes_m + goes_m, 1e-9)
    between_m = (depth_m[:-1] * goes_m + depth_m[1:] * comes_m + comes_m * goes_m) / both_m
    moving = (comes_m > 0) & (goes_m > 0)
    return np.asarray(np.where(moving, between_m, -1.0).max(axis=1))


def _intrusions(depths: FloatArray, times_s: FloatArray) -> Iterator[Intrusion]:
    """The stretches of frames in which a limb is inside something, of each side."""
    if depths.max() <= 0:
        return
    for side in SIDES:
        own = [column for column, (limb, _other) in enumerate(PAIRS) if BUILD[limb].joint.startswith(side)]
        depth_m = depths[:, own]
        for first, past in stretches(depth_m.max(axis=1) > 0):
            deepest_m = depth_m[first:past].max(axis=0)
            limb, other = (BUILD[number].part for number in PAIRS[own[int(np.argmax(deepest_m))]])
            start_s, end_s = float(times_s[first]), float(times_s[past - 1])
            yield Intrusion(side, limb, other, float(deepest_m.max()), start_s, end_s)


def _unsolved(times_s: FloatArray, left_m: float) -> Decision:
    when = f"between {times_s[0]:.2f} s and {times_s[-1]:.2f} s"
    return Decision("", "kept", f"a hand or forearm stays {100 * left_m:.1f} cm inside something {when}")
