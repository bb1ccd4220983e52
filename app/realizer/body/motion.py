"""The realizer's output: motion, frame by frame.

Conventions: frame k is at `start_s + k / frame_rate_hz` seconds of the performance, whose audio starts at `lead_in_s`.
Rotations are local to the joint's parent, quaternions in the order x y z w (`understudy.realizer.geometry.rotations`),
joints in the skeleton's order.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from ...model import FloatArray, Notice, SyncPoints

SHAPES: tuple[str, ...] = (
    "browDownLeft",
    "browDownRight",
    "browInnerUp",
    "browOuterUpLeft",
    "browOuterUpRight",
    "cheekPuff",
    "cheekSquintLeft",
    "cheekSquintRight",
    "eyeBlinkLeft",
    "eyeBlinkRight",
    "eyeLookDownLeft",
    "eyeLookDownRight",
    "eyeLookInLeft",
    "eyeLookInRight",
    "eyeLookOutLeft",
    "eyeLookOutRight",
    "eyeLookUpLeft",
    "eyeLookUpRight",
    "eyeSquintLeft",
    "eyeSquintRight",
    "eyeWideLeft",
    "eyeWideRight",
    "jawForward",
    "jawLeft",
    "jawOpen",
    "jawRight",
    "mouthClose",
    "mouthDimpleLeft",
    "mouthDimpleRight",
    "mouthFrownLeft",
    "mouthFrownRight",
    "mouthFunnel",
    "mouthLeft",
    "mouthLowerDownLeft",
    "mouthLowerDownRight",
    "mouthPressLeft",
    "mouthPressRight",
    "mouthPucker",
    "mouthRight",
    "mouthRollLower",
    "mouthRollUpper",
    "mouthShrugLower",
    "mouthShrugUpper",
    "mouthSmileLeft",
    "mouthSmileRight",
    "mouthStretchLeft",
    "mouthStretchRight",
    "mouthUpperUpLeft",
    "mouthUpperUpRight",
    "noseSneerLeft",
    "noseSneerRight",
    "tongueOut",
)
"""The 52 blendshapes of ARKit; Left and Right are the character's own."""


@dataclass(frozen=True, slots=True)
class Event:
    """A realized sync point: BML id of the behaviour, name of the point (`stroke`), time in the performance."""

    behavior: str
    point: str
    time_s: float


@dataclass(frozen=True, slots=True)
class Decision:
    """How and why the realization of a behaviour differs from the schedule.

    `action` is one word, such as `dropped`, `replaced`, `held`, `blended`, `repeated`, `shortened`, `timed` or `late`.
    """

    behavior: str
    action: str
    reason: str


@dataclass(frozen=True, slots=True, eq=False)
class BodyMotion:
    """The joints over time: `times_s` (T,), local `rotations` (T, J, 4), position of the hips `hips_m` (T, 3)."""

    times_s: FloatArray
    rotations: FloatArray
    hips_m: FloatArray

    def copy(self) -> "BodyMotion":
        """The same motion with rotations and hips of its own, which can be changed in place."""
        return BodyMotion(self.times_s, self.rotations.copy(), self.hips_m.copy())


@dataclass(frozen=True, slots=True, eq=False)
class Motion:
    """A realized schedule. `shapes` (T, 52) are the face's blendshape weights in [0, 1], in the order of `SHAPES`.

    `realized` has the actual sync points of each behaviour, by BML id.
    """

    frame_rate_hz: int
    body: BodyMotion
    shapes: FloatArray
    realized: Mapping[str, SyncPoints]
    decisions: tuple[Decision, ...] = ()
    notices: tuple[Notice, ...] = ()
    lead_in_s: float = 0.0

    @property
    def duration_s(self) -> float:
        """The time from the first frame to the last."""
        return float(self.body.times_s[-1] - self.body.times_s[0])

    def events(self) -> tuple[Event, ...]:
        """All sync points of all behaviours, in order of time."""
        found = [
            Event(behavior, point, time_s)
            for behavior, sync in self.realized.items()
            for point, time_s in sync.in_order()
        ]
        return tuple(sorted(found, key=lambda event: (event.time_s, event.behavior)))
