"""Penetration depths of forearms and hands into the body or each other, in every frame: the body's volume is capsules
around its bones, which are compared with each other.

A forearm or hand is compared with the trunk, the head, the upper legs and the other arm's forearm and hand. Depths are
in metres, positive inside; arrays (T, P) have a column for each of `PAIRS`.

A capsule contains all points within `radius_m` of the segment from `start_m` to `end_m`, in metres in the space of its
joint. Sided parts are the left's; the right's are their mirror images. Sizes fit the skeleton's adult of 1.73 m: chest
33 cm wide and 21 cm deep, head 18 cm wide.
"""

from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import product

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from ..geometry.curves import clipped
from ..geometry.rotations import cross, dot, images, multiply
from .proportions import Proportions
from .skeleton import HANDS, SIDES, Skeleton, forward

Point = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Capsule:
    """A part of the body: its name, the joint that carries it, its segment and its radius."""

    part: str
    joint: str
    start_m: Point
    end_m: Point
    radius_m: float

    def proportioned(self, to: Proportions) -> "Capsule":
        """The part in a body: its radius is the depth, its segment makes up the width."""
        radius_m = self.radius_m * to.depth(self.joint)
        if self.start_m[0] < 0 < self.end_m[0]:
            half_m = max(0.0, (self.end_m[0] + self.radius_m) * to.width(self.joint) - radius_m)
            ends = ((-half_m, *self._lengthened(self.start_m, to)[1:]), (half_m, *self._lengthened(self.end_m, to)[1:]))
        else:
            ends = (self._lengthened(self.start_m, to), self._lengthened(self.end_m, to))
        return replace(self, start_m=ends[0], end_m=ends[1], radius_m=radius_m)

    def _lengthened(self, point_m: Point, to: Proportions) -> Point:
        x, y, z = point_m
        scale = to.head if self.joint == "head" else to.scale
        return scale * x, scale * y, scale * z

    def mirrored(self) -> "Capsule":
        """The corresponding part of the right side."""
        return replace(
            self,
            joint="right" + self.joint.removeprefix("left"),
            start_m=(-self.start_m[0], *self.start_m[1:]),
            end_m=(-self.end_m[0], *self.end_m[1:]),
        )


TRUNK: tuple[Capsule, ...] = (
    Capsule("pelvis", "hips", (-0.070, -0.010, -0.005), (0.070, -0.010, -0.005), 0.105),
    Capsule("belly", "spine", (-0.050, 0.050, 0.000), (0.050, 0.050, 0.000), 0.100),
    Capsule("chest", "chest", (-0.065, 0.080, -0.005), (0.065, 0.080, -0.005), 0.105),
    Capsule("upper chest", "upperChest", (-0.080, 0.030, 0.000), (0.080, 0.030, 0.000), 0.085),
    Capsule("neck", "neck", (0.000, 0.000, 0.000), (0.000, 0.090, 0.010), 0.055),
    Capsule("head", "head", (0.000, 0.060, 0.015), (0.000, 0.110, 0.010), 0.092),
)
"""The parts in the middle, from the pelvis up."""

LEFT: tuple[Capsule, ...] = (
    Capsule("upper leg", "leftUpperLeg", (0.000, -0.020, 0.000), (0.000, -0.400, 0.010), 0.078),
    Capsule("lower leg", "leftLowerLeg", (0.000, 0.000, 0.000), (0.000, -0.400, -0.030), 0.050),
    Capsule("upper arm", "leftUpperArm", (0.000, 0.000, 0.000), (0.280, 0.000, 0.000), 0.045),
    Capsule("forearm", "leftLowerArm", (0.000, 0.000, 0.000), (0.235, 0.000, 0.000), 0.035),
    Capsule("hand", "leftHand", (0.025, 0.000, 0.000), (0.120, -0.005, 0.000), 0.032),
)
"""The parts of the left side; the hand's capsule contains the fingers of a loose fist."""

BUILD: tuple[Capsule, ...] = (*TRUNK, *LEFT, *(capsule.mirrored() for capsule in LEFT))
"""The average body's; every body has the same parts in the same order."""


@lru_cache(maxsize=64)
def build_of(proportions: Proportions) -> tuple[Capsule, ...]:
    """The parts of a body, in the order of `BUILD`."""
    return tuple(capsule.proportioned(proportions) for capsule in BUILD)


LIMBS = frozenset({"forearm", "hand"})
"""The parts that are kept out of the others."""

_IN_THE_WAY = frozenset(capsule.part for capsule in TRUNK) | {"upper leg"}


def _pairs() -> tuple[tuple[int, int], ...]:
    limbs = [number for number, capsule in enumerate(BUILD) if capsule.part in LIMBS]
    body = [number for number, capsule in enumerate(BUILD) if capsule.part in _IN_THE_WAY]
    left, right = ([limb for limb in limbs if BUILD[limb].joint.startswith(side)] for side in SIDES)
    return (*product(limbs, body), *product(left, right))


PAIRS: tuple[tuple[int, int], ...] = _pairs()
"""Indices into `BUILD` of the parts that are compared: a limb, and what it may collide with."""

_USED = sorted({number for pair in PAIRS for number in pair}, key=lambda number: (BUILD[number].part in LIMBS, number))
_FIRST_LIMB = sum(BUILD[number].part not in LIMBS for number in _USED)
"""Limbs are the last of the parts: forearm and hand of the left arm, then of the right one."""
_LIMB_COLUMN, _OTHER_COLUMN = (np.array([_USED.index(pair[end]) for pair in PAIRS]) for end in (0, 1))

_CROSSING = np.array([float(BUILD[other].part in LIMBS) for _limb, other in PAIRS])
_CENTRAL_M = 0.01
_CARRYING = ("upperChest", "head", *HANDS)
_BLOCK = 1_200
"""Frames compared at a time, to limit memory in long motions."""


@lru_cache(maxsize=64)
def radii_m(skeleton: Skeleton) -> FloatArray:
    """The distance (P,) at which each pair touches. Cached; never mutated."""
    build = build_of(skeleton.proportions)
    return np.array([build[limb].radius_m + build[other].radius_m for limb, other in PAIRS])


@dataclass(frozen=True, slots=True, eq=False)
class Contacts:
    """For each pair the depth `depth_m` (T, P); and where it penetrates, else zero: the direction `out` (T, P, 3) in
    which the limb is freed, in the world, and the contact points on both parts as shares of their lengths (T, P).

    The direction is the shortest way out. Where the two segments intersect and there is none, it points back to where
    the limb begins, except for crossing arms, whose left one passes over the right.
    """

    depth_m: FloatArray
    out: FloatArray
    on_limb: FloatArray
    on_other: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class PosedBody:
    """Frames of a body: local rotations (T, J, 4), and positions and orientations in the world of the joints that carry
    compared parts."""

    rotations: FloatArray
    positions_m: FloatArray
    orientations: FloatArray

    @classmethod
    def of(cls, skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray) -> "PosedBody":
        """The frames of a motion; runs forward kinematics on the joints needed."""
        return cls(rotations, *forward(skeleton, rotations, hips_m, _compared_joints(skeleton)))

    @classmethod
    def carrying(cls, skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray) -> "PosedBody":
        """The same; but of a long motion only chest, head and hands, and all others at zero, to save memory."""
        if len(rotations) <= _BLOCK:
            return cls.of(skeleton, rotations, hips_m)
        places_m, turned = (np.zeros((len(skeleton.names), len(rotations), size)) for size in (3, 4))
        for first in range(0, len(rotations), _BLOCK):
            block = slice(first, first + _BLOCK)
            posed = cls.of(skeleton, rotations[block], hips_m[block])
            for joint in skeleton.chain(*_CARRYING):
                places_m[joint, block], turned[joint, block] = posed.positions_m[:, joint], posed.orientations[:, joint]
        return cls(rotations, places_m.swapaxes(0, 1), turned.swapaxes(0, 1))

    def part(self, skeleton: Skeleton, hips_m: FloatArray, there: slice) -> "PosedBody":
        """These frames of it, in which all that is compared is placed."""
        if len(self.rotations) > _BLOCK:
            return PosedBody.of(skeleton, self.rotations[there], hips_m[there])
        return PosedBody(self.rotations[there], self.positions_m[there], self.orientations[there])

    def update(self, skeleton: Skeleton, hips_m: FloatArray, frames: NDArray[np.intp]) -> None:
        """Place the joints again, in place, in those frames (F,) whose local rotations have changed meanwhile; of a
        long motion those that `carrying` places."""
        placed = _compared_joints(skeleton) if len(self.rotations) <= _BLOCK else skeleton.chain(*_CARRYING)
        joints = np.array(sorted(placed), dtype=np.intp)
        for first in range(0, len(frames), _BLOCK):
            block = frames[first : first + _BLOCK]
            now = PosedBody.of(skeleton, self.rotations.take(block, axis=0), hips_m.take(block, axis=0))
            for here, there in ((self.positions_m, now.positions_m), (self.orientations, now.orientations)):
                here.swapaxes(0, 1)[joints[:, None], block] = there.swapaxes(0, 1)[joints]


def contacts(skeleton: Skeleton, body: PosedBody) -> Contacts:
    """The contacts of every pair in every frame."""
    return _contacts(skeleton, _nearest(skeleton, *_lines(skeleton, body, None)))


def _contacts(skeleton: Skeleton, near: "_Nearest") -> Contacts:
    out, inside = np.zeros_like(near.apart_m), np.flatnonzero(near.depth_m > 0)
    if len(inside):
        vectors = (near.apart_m, near.along_m, near.other_m, near.between_m)
        apart_m, along, other, between_m = (each.reshape(3, -1).take(inside, axis=1).T for each in vectors)
        pairs = inside // near.depth_m.shape[1]
        aside = _aside(along, other, between_m - other / 2, _CROSSING.take(pairs))
        distance_m = (radii_m(skeleton).take(pairs) - near.depth_m.take(inside))[:, None]
        out.reshape(3, -1)[:, inside] = _of_length_1(
            apart_m + aside * (_CENTRAL_M * np.exp(distance_m / -_CENTRAL_M))
        ).T
    return Contacts(near.depth_m.T, out.T, near.on_limb.T, near.on_other.T)


@dataclass(frozen=True, slots=True, eq=False)
class ArmsOfBody:
    """Frames of a body in which only upper arms, lower arms and hands are turned otherwise: orientations (2, F, 4) of
    both collarbones and places (2, F, 3) of both shoulders, and the segments of the parts, as of `_lines`, in which
    those of the limbs are changed in place."""

    skeleton: Skeleton
    collarbones: FloatArray
    shoulders_m: FloatArray
    starts_m: FloatArray
    lines_m: FloatArray

    @classmethod
    def of(cls, skeleton: Skeleton, body: PosedBody) -> "ArmsOfBody":
        """The arms of a body whose other joints stay as they are."""
        collarbones, upper_arms = (
            skeleton.chain(*(side + name for side in SIDES)) for name in ("Shoulder", "UpperArm")
        )
        turned, at_m = body.orientations.swapaxes(0, 1), body.positions_m.swapaxes(0, 1)
        return cls(skeleton, turned[collarbones], at_m[upper_arms], *_lines(skeleton, body, None))

    @property
    def as_it_is(self) -> Contacts:
        """The contacts with the arms as they have been set last."""
        return _contacts(self.skeleton, _nearest(self.skeleton, self.starts_m, self.lines_m))

    def contacts(self, arms: FloatArray) -> Contacts:
        """The contacts with these local rotations (F, 2, 3, 4) of upper arms, lower arms and hands."""
        upper, lower, hand = arms.transpose(2, 1, 0, 3)
        turned = np.empty((3, *upper.shape))
        turned[0] = multiply(self.collarbones, upper)
        turned[1] = multiply(turned[0], lower)
        turned[2] = multiply(turned[1], hand)
        ways_m = images(turned.take(_CARRIED_BY, axis=0), _arm_ways_m(self.skeleton))
        ways_m[0] += self.shoulders_m.swapaxes(1, 2)
        ways_m[1] += ways_m[0]
        ways_m[2:4] += ways_m[:2]
        starts_m, lines_m = ways_m[2:].reshape(2, 2, *ways_m.shape[1:]).transpose(0, 3, 2, 1, 4)
        for all_m, limbs_m in ((self.starts_m, starts_m), (self.lines_m, lines_m)):
            all_m[:, _FIRST_LIMB:] = limbs_m.reshape(3, -1, len(arms))
        return self.as_it_is


_CARRIED_BY = np.array([0, 1, 1, 2, 1, 2])
"""Of upper arm, lower arm and hand, which carries each of `_arm_ways_m`."""


@lru_cache(maxsize=64)
def _arm_ways_m(skeleton: Skeleton) -> FloatArray:
    """The ways (6, 2, 1, 3) from shoulders to elbows and on to wrists, from there to where forearms and hands begin as
    parts, and to where these end. Cached; never mutated."""
    bones = [skeleton.offsets_m[skeleton.chain(*(side + name for side in SIDES))] for name in ("LowerArm", "Hand")]
    _joints, (starts_m, lines_m) = _carried(skeleton)
    parts = [each[_FIRST_LIMB + limb :: len(LIMBS), 0] for each in (starts_m, lines_m) for limb in range(len(LIMBS))]
    return np.stack([*bones, *parts])[:, :, None]


def depths_m(
    skeleton: Skeleton,
    rotations: FloatArray,
    hips_m: FloatArray,
    frames: NDArray[np.intp] | None = None,
    posed: PosedBody | None = None,
) -> FloatArray:
    """The depth of every pair (F, P), positive inside, in the frames with these numbers (F,), or in every one. `posed`,
    where the joints that carry the parts are, need not be given, and is not looked at in a long motion."""
    frames = np.arange(len(rotations)) if frames is None else frames
    if posed is not None and len(rotations) <= _BLOCK:
        return _nearest(skeleton, *_lines(skeleton, posed, frames)).depth_m.T
    found = np.empty((len(frames), len(PAIRS)))
    for first in range(0, len(frames), _BLOCK):
        block = frames[first : first + _BLOCK]
        part = PosedBody.of(skeleton, rotations.take(block, axis=0), hips_m.take(block, axis=0))
        found[first : first + _BLOCK] = _nearest(skeleton, *_lines(skeleton, part, None)).depth_m.T
    return found


def penetrations_m(skeleton: Skeleton, rotations: FloatArray, hips_m: FloatArray) -> FloatArray:
    """The greatest depth of any forearm or hand in the body or the other arm in each frame: (T,), 0 where there is
    none."""
    return np.asarray(np.maximum(depths_m(skeleton, rotations, hips_m).max(axis=1), 0.0))


def _lines(skeleton: Skeleton, body: PosedBody, frames: NDArray[np.intp] | None) -> tuple[FloatArray, FloatArray]:
    """Where the segments of the compared parts begin, and from there to their ends: each (3, parts, F), in the
    world."""
    joints, segments_m = _carried(skeleton)
    chosen = joints if frames is None else (joints[:, None], frames)
    at_m, turned = body.positions_m.swapaxes(0, 1)[chosen], body.orientations.swapaxes(0, 1)[chosen]
    starts_m, lines_m = np.ascontiguousarray(images(turned, segments_m).swapaxes(1, 2))
    starts_m += at_m.transpose(2, 0, 1)
    return starts_m, lines_m


@lru_cache(maxsize=64)
def _carried(skeleton: Skeleton) -> tuple[NDArray[np.intp], FloatArray]:
    """The joints that carry the compared parts; where the segments of these begin, and from there to their ends
    (2, parts, 1, 3). Cached; never mutated."""
    build = build_of(skeleton.proportions)
    starts_m, ends_m = (np.array([getattr(build[part], end) for part in _USED]) for end in ("start_m", "end_m"))
    joints = np.array([skeleton.index[build[part].joint] for part in _USED], dtype=np.intp)
    return joints, np.stack((starts_m, ends_m - starts_m))[:, :, None]


@lru_cache(maxsize=64)
def _squared_lengths(skeleton: Skeleton) -> tuple[FloatArray, FloatArray]:
    """Those of the segments (P, 1) of each pair. Cached; never mutated."""
    _joints, (_starts_m, lines_m) = _carried(skeleton)
    squared = _dot(lines_m, lines_m)
    return squared[_LIMB_COLUMN], squared[_OTHER_COLUMN]


@lru_cache(maxsize=64)
def _compared_joints(skeleton: Skeleton) -> frozenset[int]:
    """The joints that carry compared parts, with their parents."""
    found: set[int] = set()
    for number in _USED:
        above = skeleton.index[BUILD[number].joint]
        while above >= 0 and above not in found:
            found.add(above)
            above = skeleton.parents[above]
    return frozenset(found)


@dataclass(frozen=True, slots=True, eq=False)
class _Nearest:
    """Where the segments of the pairs are nearest: `depth_m` there (P, F), the points as shares of both (P, F), and
    from the other's to the limb's `apart_m`; with the directions of limb and other, and from where the other begins to
    where the limb does, all (3, P, F), since NumPy is faster with each of x, y and z by itself."""

    depth_m: FloatArray
    on_limb: FloatArray
    on_other: FloatArray
    apart_m: FloatArray
    along_m: FloatArray
    other_m: FloatArray
    between_m: FloatArray


def _nearest(skeleton: Skeleton, starts_m: FloatArray, lines_m: FloatArray) -> _Nearest:
    """The nearest points of each pair (Ericson, Real-Time Collision Detection, §5.1.9); the segments of the parts are
    those of `_lines`."""
    between_m = starts_m.take(_LIMB_COLUMN, axis=1) - starts_m.take(_OTHER_COLUMN, axis=1)
    along_m, other_m = lines_m.take(_LIMB_COLUMN, axis=1), lines_m.take(_OTHER_COLUMN, axis=1)
    (a, e), b = _squared_lengths(skeleton), _products(along_m, other_m)
    c, f = _products(along_m, between_m), _products(other_m, between_m)
    on_limb = clipped((b * f - c * e) / np.maximum(a * e - b * b, 1e-12), 0.0, 1.0)
    on_other = clipped((b * on_limb + f) / e, 0.0, 1.0)
    on_limb = clipped((b * on_other - c) / a, 0.0, 1.0)
    apart_m = on_limb * along_m
    apart_m -= on_other * other_m
    apart_m += between_m
    depth_m = radii_m(skeleton)[:, None] - np.sqrt(_products(apart_m, apart_m))
    return _Nearest(depth_m, on_limb, on_other, apart_m, along_m, other_m, between_m)


def _products(a: FloatArray, b: FloatArray) -> FloatArray:
    """The dot products (P, F) of vectors (3, P, F) that lie together in memory: of these, sooner than by `dot`."""
    return np.asarray(np.einsum("kpf,kpf->pf", a, b))


def _aside(along: FloatArray, other: FloatArray, back: FloatArray, arms: FloatArray) -> FloatArray:
    """The way out (…, 3) for limbs whose segment intersects the other's; `arms` (…) is 1 where both are arms, else
    0."""
    if not arms.any():
        return _of_length_1(back)
    over = cross(_of_length_1(along), _of_length_1(other)) * arms[..., None]
    over = over * np.where(_dot(over, np.array([0.0, 1.0, 1.0])) < 0, -1.0, 1.0)[..., None]
    crossing = np.sqrt(_dot(over, over))[..., None]
    return np.asarray(over + (1 - crossing) * _of_length_1(back))


def _of_length_1(vector: FloatArray) -> FloatArray:
    return np.asarray(vector / np.maximum(np.sqrt(_dot(vector, vector)), 1e-9)[..., None])


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    return dot(a, b)[..., 0]
