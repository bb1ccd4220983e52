"""Moves hands and forearms out of the body and of each other in a stretch of frames, in rounds (`collisions`).

Conventions: metres in the world, time in frames. Penetration that is left after a round is added to the displacement
and the arms are solved again from the original motion, so the displacement stays smooth however many rounds are needed.
"""

from dataclasses import dataclass
from math import acos

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ..body.contacts import BUILD, LIMBS, PAIRS, ArmsOfBody, Contacts, Point, PosedBody, radii_m
from ..body.skeleton import SIDES, Skeleton
from ..geometry.curves import clipped
from ..geometry.rotations import dot
from .displacements import Displacement, PosedArms, stretches

_CLEARANCE_M = 0.004
_ROUNDS = 16
_HOPELESS = ((3, 0.9), (5, 0.3))
"""A way is given up that has left more than such a share of the first depth after so many rounds. In 1,260 performances
that ends 124 ways of 657; six of the 466 that did would have been among them."""

_LEAST_SHARE = 0.25
"""Of the wrist in what moves a forearm: an elbow in the belly, turned about the line from shoulder to wrist alone, may
slide along the belly and never come out."""

_ELBOW_WITH_WRIST = 0.5
"""How far an elbow is led aside with its wrist."""
_LEAST_SQUARED = 1e-24


def _together() -> tuple[list[int], ...]:
    """Columns of contacts that are resolved on the same side: each limb's with trunk and legs, and all of arm with
    arm."""
    whose = ["arms" if BUILD[other].part in LIMBS else BUILD[limb].joint for limb, other in PAIRS]
    return tuple([column for column, name in enumerate(whose) if name == each] for each in dict.fromkeys(whose))


_TOGETHER = _together()


@dataclass(frozen=True, slots=True)
class _End:
    """An arm in a contact: whether its limb is the other one of the pair, the amount, against the way out where
    negative, by which it is moved, and the least share of the wrist in that."""

    arm: int
    of_other: bool
    amount: float
    least_share: float


def _ends(pair: tuple[int, int]) -> tuple[_End, ...]:
    limbs = [(BUILD[part], part == pair[1]) for part in pair if BUILD[part].part in LIMBS]
    return tuple(
        _End(
            arm=next(arm for arm, side in enumerate(SIDES) if limb.joint.startswith(side)),
            of_other=of_other,
            amount=(-1.0 if of_other else 1.0) / len(limbs),
            least_share=_LEAST_SHARE if limb.part == "forearm" else 1.0,
        )
        for limb, of_other in limbs
    )


_ENDS = tuple(_ends(pair) for pair in PAIRS)
"""The arms that are moved out of each contact."""


@dataclass(frozen=True, slots=True)
class Aside:
    """How far the wrist of an arm is led beside its own way, in metres in the world."""

    side: str
    by_m: Point


@dataclass(frozen=True, slots=True)
class ClearingMode:
    """How a stretch is cleared: displacements are blended over `swell` frames, no joint turns by more than `most_rad`
    from frame to frame unless it did before, and limbs leave what they are in on the side on which they are on the
    whole, or, where that does not do, `as_it_ends`: on that on which they come out last, as hands that fold on their
    way to rest must. Last of all an arm goes by another way from the beginning: `aside` of its own throughout."""

    swell: int
    most_rad: float
    as_it_ends: bool = False
    aside: Aside | None = None
    rounds: int = _ROUNDS


def cleared(skeleton: Skeleton, start: PosedBody, way: ClearingMode, weights: FloatArray) -> tuple[FloatArray, float]:
    """The local rotations of a stretch of frames after the round with the least penetration, and its depth in metres;
    displacements are times `weights` (F, 1)."""
    arms, among = PosedArms.of(skeleton, start), ArmsOfBody.of(skeleton, start)
    found, push = among.as_it_is, _to_begin_with(way, len(start.rotations))
    way_out, best = np.zeros_like(found.out), arms.rotations
    first_m = reached_m = least_m = float(found.depth_m.max())
    most_rad = max(way.most_rad, _farthest_turn_rad(arms.rotations))
    for number in range(way.rounds):
        if number or not way.aside:
            _decide_ways_out(way_out, found, way)
            push = push.and_then(_push(skeleton, found, way_out))
        turned = arms.displaced(push.swelling(way.swell, weights))
        found = among.contacts(turned)
        deepest_m = float(found.depth_m.max())
        if deepest_m < least_m and _farthest_turn_rad(turned) <= most_rad:
            least_m, best = deepest_m, turned
        reached_m = min(reached_m, deepest_m)
        if deepest_m <= 0 or _is_hopeless(number + 1, reached_m, first_m):
            break
    return start.rotations if best is arms.rotations else _with_arms(skeleton, start.rotations, best), least_m


def _is_hopeless(rounds: int, left_m: float, first_m: float) -> bool:
    """Whether a way will hardly do that has left so much of the first depth after so many rounds."""
    return any(rounds >= enough and left_m > share * first_m for enough, share in _HOPELESS)


def _with_arms(skeleton: Skeleton, rotations: FloatArray, arms: FloatArray) -> FloatArray:
    """A copy of the local rotations (F, J, 4) with these (F, 2, 3, 4) of upper arms, lower arms and hands."""
    rotations = rotations.copy()
    skeleton.arms(rotations)[:, :, 1:4] = arms
    return rotations


def _to_begin_with(way: ClearingMode, frames: int) -> Displacement:
    """How the arms are displaced before anything is found in their way."""
    by_m = np.zeros((len(SIDES), 2, frames, 3))
    if way.aside:
        wrist_m = np.array(way.aside.by_m)
        by_m[SIDES.index(way.aside.side)] = np.stack((wrist_m, _ELBOW_WITH_WRIST * wrist_m))[:, None]
    return Displacement(by_m)


def _farthest_turn_rad(arms: FloatArray) -> float:
    """How far any joint of arms (F, 2, 3, 4) turns from one frame to the next, at most."""
    return 2 * acos(min(float(np.abs(dot(arms[1:], arms[:-1])).min(initial=1.0)), 1.0))


def _decide_ways_out(way_out: FloatArray, found: Contacts, way: ClearingMode) -> None:
    """Set the direction (T, P, 3) in which each contact is left, in place.

    It is the same for a whole stretch of frames and for all parts of trunk and legs, that of its deepest frames or its
    last, and the same in every round. Otherwise a limb that passes through the body would be pushed back and, from the
    middle on, forward, and one between belly and leg to and fro.
    """
    deep_m = np.maximum(found.depth_m, 0.0)
    touching = set(np.flatnonzero(deep_m.any(axis=0)).tolist())
    for columns in (each for each in _TOGETHER if not touching.isdisjoint(each)):
        for first, past in stretches(deep_m[:, columns].max(axis=1) > 0):
            there, before = (slice(first, past), columns), way_out[first:past, columns].sum(axis=(0, 1))
            told = slice(max(first, past - max(1, way.swell // 3)) if way.as_it_ends else first, past), columns
            way_out[there] = before if before.any() else np.einsum("tp,tpk->k", deep_m[told], found.out[told])


def _push(skeleton: Skeleton, found: Contacts, way_out: FloatArray) -> Displacement:
    """The sum of the displacements that the contacts require, each reduced by what the others already achieve; those
    that are nearer to the side opposite to their `way_out` are redirected through to that.

    A hand is moved by its wrist; a forearm by wrist and elbow, in proportion to where the contact lies between them,
    though always by the wrist too.
    Where both arms are in a contact, each moves by half.
    """
    by_m = np.zeros((len(SIDES), 2, len(found.depth_m), 3))
    touching = np.flatnonzero((found.depth_m > 0).any(axis=0))
    ends = [(row, end) for row, pair in enumerate(touching.tolist()) for end in _ENDS[pair]]
    if not ends:
        return Displacement(by_m)
    rows = np.array([row for row, _end in ends])
    of_limb, of_other = (each.T[touching][rows] for each in (found.on_limb, found.on_other))
    whose, amounts, least = np.array([(end.of_other, end.amount, end.least_share) for _row, end in ends]).T[:, :, None]
    share = np.maximum(np.where(whose, of_other, of_limb), least)
    shares = np.stack((share, 1 - share), axis=1)
    shares *= (amounts / (share * share + shares[:, 1] * shares[:, 1]))[:, None]
    asked_m = _ways_m(skeleton, found, way_out, touching)[rows][:, None] * shares[..., None]
    squared = np.maximum(dot(asked_m, asked_m), _LEAST_SQUARED)
    for (_row, end), each_m, size in zip(ends, asked_m, squared, strict=True):
        beyond = 1 - dot(each_m, by_m[end.arm]) / size
        by_m[end.arm] += each_m * clipped(beyond, 0.0, 1.0)  # what is not covered already in that direction
    return Displacement(by_m)


def _ways_m(skeleton: Skeleton, found: Contacts, way_out: FloatArray, pairs: NDArray[np.intp]) -> FloatArray:
    """How far, and where, each of these pairs is to be moved apart (pairs, T, 3)."""
    depth_m, out = found.depth_m.T[pairs, :, None], found.out.swapaxes(0, 1)[pairs]
    wrong = dot(out, way_out.swapaxes(0, 1)[pairs]) < 0
    asked_m = np.where(wrong, 2 * radii_m(skeleton)[pairs, None, None] - depth_m, depth_m) + _CLEARANCE_M
    return np.asarray(out * np.where(depth_m > 0, np.where(wrong, -asked_m, asked_m), 0.0))
