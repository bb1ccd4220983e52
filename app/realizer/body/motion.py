"""What the realizer makes: a motion, frame by frame.

Conventions: frame k is at `start_s + k / frame_rate_hz` seconds of the performance, whose audio starts at `lead_in_s`.
Rotations are local to the joint's parent, quaternions x y z w (`understudy.realizer.geometry.rotations`), joints in the
skeleton's order.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from ...model import FloatArray, Notice, SyncPoints

FRAME_RATES_HZ = (30, 60)
"""The rates at which motion is made."""

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
"""The 52 face shapes of ARKit; Left and Right are the character's own."""


@dataclass(frozen=True, slots=True)
class Event:
    """A sync point of a behaviour as it was realized: BML id, point (`stroke`), time."""

    behavior: str
    point: str
    time_s: float


@dataclass(frozen=True, slots=True)
class Decision:
    """What the realizer did with a behaviour that could not be played as it was asked for, and why.

    `action` is one word, as `dropped`, `replaced`, `held`, `blended`, `repeated`, `shortened`, `late`."""

    behavior: str
    action: str
    reason: str


@dataclass(frozen=True, slots=True, eq=False)
class BodyMotion:
    """The joints in time: `times_s` (T,), local `rotations` (T, J, 4), place of the hips `hips_m` (T, 3)."""

    times_s: FloatArray
    rotations: FloatArray
    hips_m: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Motion:
    """A realized schedule. `shapes` (T, 52) are the face's weights in [0, 1], in the order of `SHAPES`.

    `realized` tells when each behaviour's sync points really fall, by its BML id."""

    frame_rate_hz: int
    body: BodyMotion
    shapes: FloatArray
    realized: Mapping[str, SyncPoints]
    decisions: tuple[Decision, ...] = ()
    notices: tuple[Notice, ...] = ()
    lead_in_s: float = 0.0

    @property
    def duration_s(self) -> float:
        """From the first frame to the last."""
        return float(self.body.times_s[-1] - self.body.times_s[0])

    def events(self) -> tuple[Event, ...]:
        """Every sync point of every behaviour, in order of time."""
        found = [
            Event(behavior, point, time_s)
            for behavior, sync in self.realized.items()
            for point, time_s in sync.in_order()
        ]
        return tuple(sorted(found, key=lambda event: (event.time_s, event.behavior)))
