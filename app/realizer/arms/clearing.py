"""Moves hands and forearms out of the body and of each other in a stretch of frames, in rounds (`collisions`).

Conventions: metres in the world, time in frames. Penetration that is left after a round is added to the displacement
and the arms are solved again from the original motion, so the displacement stays smooth however many rounds are needed.
"""

from dataclasses import dataclass, replace

import numpy as np

from ...model import FloatArray
from ..body.contacts import BUILD, LIMBS, PAIRS, Contacts, Point, PosedBody, contacts, radii_m
from ..body.skeleton import SIDES, Skeleton
from ..geometry.curves import clipped
from ..geometry.rotations import angle_between, length
from .displacements import Displacement, displaced, stretches

_CLEARANCE_M = 0.004
_ROUNDS = 16
_LEAST_SHARE = 0.25
"""Of the wrist in what moves a forearm: an elbow in the belly, turned about the line from shoulder to wrist alone, may
slide along the belly and never come out."""

_ELBOW_WITH_WRIST = 0.5
"""How far an elbow is led aside with its wrist."""


def _together() -> tuple[list[int], ...]:
    """Columns of contacts that are resolved on the same side: each limb's with trunk and legs, and all of arm with
    arm."""
    whose = ["arms" if BUILD[other].part in LIMBS else BUILD[limb].joint for limb, other in PAIRS]
    return tuple([column for column, name in enumerate(whose) if name == each] for each in dict.fromkeys(whose))


_TOGETHER = _together()


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
    found = contacts(skeleton, start)
    pushes = {side: _to_begin_with(way, side, len(start.rotations)) for side in SIDES}
    way_out = np.zeros_like(found.out)
    arms = skeleton.chain(*(side + name for side in SIDES for name in ("UpperArm", "LowerArm", "Hand")))
    least_m, rotations = float(found.depth_m.max()), start.rotations
    most_rad = max(way.most_rad, _farthest_turn_rad(rotations.take(arms, axis=1)))
    for number in range(way.rounds):
        if number or not way.aside:
            way_out = _way_out(found, way_out, way)
            one_way = _one_way(found, way_out, radii_m(skeleton))
            pushes = {side: push.and_then(_push(one_way, side)) for side, push in pushes.items()}
        swelling = {side: push.swelling(way.swell, weights) for side, push in pushes.items()}
        body = start.with_arms(skeleton, displaced(skeleton, start, swelling))
        found = contacts(skeleton, body)
        if found.depth_m.max() < least_m and _farthest_turn_rad(body.rotations.take(arms, axis=1)) <= most_rad:
            least_m, rotations = float(found.depth_m.max()), body.rotations
        if found.depth_m.max() <= 0:
            break
    return rotations, least_m


def _to_begin_with(way: ClearingMode, side: str, frames: int) -> Displacement:
    """How an arm is displaced (F, 3) before anything is found in its way."""
    by_m = way.aside.by_m if way.aside and way.aside.side == side else (0.0, 0.0, 0.0)
    wrist_m = np.tile(by_m, (frames, 1))
    return Displacement(wrist_m, _ELBOW_WITH_WRIST * wrist_m)


def _farthest_turn_rad(rotations: FloatArray) -> float:
    """How far any joint of (F, J, 4) turns from one frame to the next, at most."""
    return float(angle_between(rotations[1:], rotations[:-1]).max(initial=0.0))


def _way_out(found: Contacts, known: FloatArray, way: ClearingMode) -> FloatArray:
    """The direction (T, P, 3) in which each contact is left.

    It is the same for a whole stretch of frames and for all parts of trunk and legs, that of its deepest frames or its
    last, and the same in every round. Otherwise a limb that passes through the body would be pushed back and, from the
    middle on, forward, and one between belly and leg to and fro.
    """
    way_out = known.copy()
    deep_m = np.maximum(found.depth_m, 0.0)
    for columns in _TOGETHER:
        for first, past in stretches(deep_m[:, columns].max(axis=1) > 0):
            there, before = (slice(first, past), columns), known[first:past, columns].sum(axis=(0, 1))
            told = slice(max(first, past - max(1, way.swell // 3)) if way.as_it_ends else first, past), columns
            way_out[there] = before if before.any() else np.einsum("tp,tpk->k", deep_m[told], found.out[told])
    return way_out


def _one_way(found: Contacts, way_out: FloatArray, touching_m: FloatArray) -> Contacts:
    """The contacts, with those that are nearer to the opposite side redirected through to this one; `touching_m` (P,)
    is the distance at which each begins."""
    wrong = (found.depth_m > 0) & (np.einsum("...k,...k->...", found.out, way_out) < 0)
    through_m = found.depth_m + 2 * (touching_m - found.depth_m)
    return replace(
        found, depth_m=np.where(wrong, through_m, found.depth_m), out=np.where(wrong[..., None], -found.out, found.out)
    )


def _push(found: Contacts, side: str) -> Displacement:
    """The sum of the displacements that the contacts of an arm require, each reduced by what the others already
    achieve.

    A hand is moved by its wrist; a forearm by wrist and elbow, in proportion to where the contact lies between them,
    though always by the wrist too.
    Where both arms are in a contact, each moves by half.
    """
    wrist_m, elbow_m = np.zeros((2, len(found.depth_m), 3))
    deep_m = np.where(found.depth_m > 0, found.depth_m + _CLEARANCE_M, 0.0)
    for column in np.nonzero(deep_m.any(axis=0))[0]:
        ends = (BUILD[PAIRS[column][0]], found.on_limb, 1.0), (BUILD[PAIRS[column][1]], found.on_other, -1.0)
        both = all(capsule.part in LIMBS for capsule, _place, _sign in ends)
        for capsule, place, sign in ends:
            if capsule.part in LIMBS and capsule.joint.startswith(side):
                out = found.out[:, column] * (sign * deep_m[:, column] * (0.5 if both else 1.0))[:, None]
                share = np.maximum(place[:, column, None], _LEAST_SHARE if capsule.part == "forearm" else 1.0)
                even = share**2 + (1 - share) ** 2
                wrist_m += _beyond(out * share / even, wrist_m)
                elbow_m += _beyond(out * (1 - share) / even, elbow_m)
    return Displacement(wrist_m, elbow_m)


def _beyond(asked_m: FloatArray, given_m: FloatArray) -> FloatArray:
    """The part of `asked_m` that `given_m` does not already cover in its direction."""
    size_m = np.maximum(length(asked_m), 1e-12)
    done = np.sum(asked_m * given_m, axis=-1, keepdims=True) / size_m**2
    return np.asarray(asked_m * clipped(1 - done, 0.0, 1.0))
