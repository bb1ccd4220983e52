"""Postures: shifts of trunk and weight at the times that the schedule gives them (BML `postureShift`, `posture`).

A shift stays until another takes its place, so each one says all that it changes: leaning forward and back leave the
weight where it is, a leg that takes the weight and `STRAIGHTEN` end every lean. A `posture` with a way back comes back
to the latest shift. Where the hands rest (`HANDS_FOLDED` …) is the gestures' matter and changes nothing here.

Conventions: angles are radians, the weight is 1 on the left leg, -1 on the right; seconds.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from ...model import Behavior, Channel, FloatArray
from ..geometry.easing import changes

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
    base = np.array([0.0, 0.0, weight])
    states, starts_s, durations_s = [base], [], []
    for start_s, duration_s, shift, begins in _moments(behaviors):
        states.append(_after(base, shift) if begins else base)
        base = states[-1] if _lasts(shift) else base
        starts_s.append(start_s)
        durations_s.append(max(duration_s, SHORTEST_SHIFT_S))
    by = np.diff(np.array(states), axis=0)
    course = states[0] + changes(times_s, np.array(starts_s), np.array(durations_s), by)
    return Held(np.radians(course[:, 0]), np.radians(course[:, 1]), course[:, 2])


def reached_s(shift: Behavior) -> float:
    """When the posture is to be there."""
    return shift.sync.end if shift.sync.ready is None else shift.sync.ready


def _lasts(shift: Behavior) -> bool:
    """Whether it is a `postureShift`, which is over when it is reached, or a `posture`, which ends in coming back."""
    return shift.sync.end <= reached_s(shift)


def _moments(behaviors: Iterable[Behavior]) -> list[tuple[float, float, Behavior, bool]]:
    """When the trunk goes into a posture (True) or comes back from one, and within which time, in order."""
    found = []
    for shift in behaviors:
        if not shift.kept or shift.kind is not Channel.POSTURE or shift.lexeme not in POSTURES:
            continue
        sync = shift.sync
        found.append((sync.start, reached_s(shift) - sync.start, shift, True))
        if not _lasts(shift):
            relax_s = max(reached_s(shift), sync.end - SHORTEST_SHIFT_S) if sync.relax is None else sync.relax
            found.append((relax_s, sync.end - relax_s, shift, False))
    return sorted(found, key=lambda moment: (moment[0], moment[2].id))


def _after(before: FloatArray, shift: Behavior) -> FloatArray:
    posture = POSTURES[shift.lexeme]
    amount = 1.0 if shift.amount is None else shift.amount
    wanted = (posture.forward_degrees, posture.left_degrees, posture.weight)
    return np.array([old if new is None else amount * new for old, new in zip(before, wanted, strict=True)])
