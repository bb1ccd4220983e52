"""The body's volume as capsules around its bones, for collision tests.

Conventions: a capsule contains all points within `radius_m` of the segment from `start_m` to `end_m`, in metres in the
space of its joint. Sided parts are the left's; the right's are their mirror images. Sizes fit the skeleton's adult of
1.73 m: chest 33 cm wide and 21 cm deep, head 18 cm wide.
"""

from dataclasses import dataclass, replace
from functools import lru_cache

from .proportions import Proportions

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
