"""Postures: trunk leans and weight shifts over time (BML `postureShift`, `posture`).

A shift lasts until the next one. Leaning forward or back keeps the weight where it is; shifting the weight or
`STRAIGHTEN` ends every lean. A `posture` that ends returns to the latest shift. Hand postures (`HANDS_FOLDED` …) belong
to the gestures and have no effect here.

Conventions: angles in radians; the weight is 1 on the left leg, -1 on the right; seconds.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from ...model import Behavior, Channel, FloatArray
from ..geometry.curves import superposed_movements

SHORTEST_SHIFT_S = 0.6
"""The minimum duration of a shift; one that is scheduled shorter ends later."""


@dataclass(frozen=True, slots=True)
class Posture:
    """The target of a posture; None leaves a component unchanged."""

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
"""Leans that need no step but are visible from the side; the angles are ours."""


@dataclass(frozen=True, slots=True, eq=False)
class TrunkPosture:
    """The trunk over time, each (T,): lean forward and to the left in radians, and the side of the weight."""

    forward: FloatArray
    left: FloatArray
    weight: FloatArray


def trunk_postures(times_s: FloatArray, behaviors: Iterable[Behavior], *, weight: float) -> TrunkPosture:
    """The trunk through the kept posture behaviours, starting upright with `weight`; all transitions are minimum
    jerk."""
    base = np.array([0.0, 0.0, weight])
    states, starts_s, durations_s = [base], [], []
    for start_s, duration_s, shift, begins in _moments(behaviors):
        states.append(_after(base, shift) if begins else base)
        base = states[-1] if _lasts(shift) else base
        starts_s.append(start_s)
        durations_s.append(max(duration_s, SHORTEST_SHIFT_S))
    by = np.diff(np.array(states), axis=0)
    course = states[0] + superposed_movements(times_s, np.array(starts_s), np.array(durations_s), by)
    return TrunkPosture(np.radians(course[:, 0]), np.radians(course[:, 1]), course[:, 2])


def reached_s(shift: Behavior) -> float:
    """The time at which the posture is to be reached."""
    return shift.sync.end if shift.sync.ready is None else shift.sync.ready


def _lasts(shift: Behavior) -> bool:
    """Whether a behaviour is a `postureShift`, which ends when it is reached, and not a `posture`, which ends with the
    return."""
    return shift.sync.end <= reached_s(shift)


def _moments(behaviors: Iterable[Behavior]) -> list[tuple[float, float, Behavior, bool]]:
    """Each start (True) and end of a posture: time, duration, behaviour, in order."""
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
