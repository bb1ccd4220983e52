"""Postures: lasting shifts of trunk and weight at the times that the schedule gives them (BML `postureShift`).

A posture stays until another takes its place, so each one says all that it changes: leaning forward and back leave the
weight where it is, a leg that takes the weight and `STRAIGHTEN` end every lean. Where the hands rest (`HANDS_FOLDED` …)
is the gestures' matter and changes nothing here. Angles are radians, the weight is 1 on the left leg, -1 on the right.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from app.model import Behavior, Channel, FloatArray
from app.realizer.easing import changes

SHORTEST_SHIFT_S = 0.6
"""Half the body's weight is not moved faster; a shift that is given less time ends later."""


@dataclass(frozen=True, slots=True)
class Posture:
    """How the trunk is held; None leaves it as it was."""

    forward_degrees: float | None = None
    left_degrees: float | None = None
    weight: float | None = None


POSTURES: Mapping[str, Posture] = MappingProxyType(
    {
        "LEAN_FORWARD": Posture(9.0, 0.0),
        "LEAN_BACK": Posture(-6.0, 0.0),
        "LEAN_LEFT": Posture(0.0, 6.0, 0.5),
        "LEAN_RIGHT": Posture(0.0, -6.0, -0.5),
        "STRAIGHTEN": Posture(0.0, 0.0, 0.0),
        "WEIGHT_ON_LEFT_LEG": Posture(0.0, 0.0, 1.0),
        "WEIGHT_ON_RIGHT_LEG": Posture(0.0, 0.0, -1.0),
    }
)
"""Leans that the feet can bear without a step, and that still show from the side; the angles are ours."""


@dataclass(frozen=True, slots=True, eq=False)
class Held:
    """How the trunk is held in time, each (T,): leaning forward and to the left (radians), the weight's side."""

    forward: FloatArray
    left: FloatArray
    weight: FloatArray


def postures(times_s: FloatArray, behaviors: Iterable[Behavior], *, weight: float) -> Held:
    """The trunk through the kept posture behaviours, from upright with `weight` on; each moves by minimum jerk."""
    shifts = sorted(
        (each for each in behaviors if each.kept and each.kind is Channel.POSTURE and each.lexeme in POSTURES),
        key=lambda each: each.sync.start,
    )
    states = np.array([[0.0, 0.0, weight]])
    for shift in shifts:
        states = np.concatenate([states, _after(states[-1], shift)[None]])
    starts_s = np.array([shift.sync.start for shift in shifts])
    durations_s = np.array([max(shift.sync.end - shift.sync.start, SHORTEST_SHIFT_S) for shift in shifts])
    course = states[0] + changes(times_s, starts_s, durations_s, np.diff(states, axis=0))
    return Held(np.radians(course[:, 0]), np.radians(course[:, 1]), course[:, 2])


def _after(before: FloatArray, shift: Behavior) -> FloatArray:
    posture = POSTURES[shift.lexeme]
    amount = 1.0 if shift.amount is None else shift.amount
    wanted = (posture.forward_degrees, posture.left_degrees, posture.weight)
    return np.array([old if new is None else amount * new for old, new in zip(before, wanted, strict=True)])
