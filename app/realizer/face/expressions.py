"""Facial expressions other than speech: brows, cheeks, lids, nose and mouth by FACS units and lexemes (paper §3.8).

A behaviour rises from `start` to its full amount at `ready`, holds it until `relax` and has decayed at `end`, with
minimum-jerk transitions (Flash & Hogan 1985). Nobody's face is even: the right side comes a little later than the left,
but both eyes blink at once. Behaviours on the same shape combine as 1 - Π(1 - weight), which is
independent of order, smooth, and at most 1.
"""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ...model import Behavior, Channel, FloatArray, SyncPoints
from ..body.motion import SHAPES, Decision
from ..geometry.curves import minimum_jerk
from .face_tables import FaceSide, sided

FACIAL = frozenset({Channel.FACE, Channel.EYES})

_SIDES: Mapping[str, FaceSide] = MappingProxyType({side.value: side for side in FaceSide})

USUAL_AMOUNT = 0.5
"""The amount of a face without one, as in BML 1.0; a blink without an amount is complete."""

LEAST_RISE_S = 0.05
LEAST_FALL_S = 0.07
"""The fastest rise and decay of any shape, whatever the sync points say: the quickest blinks close in 50 ms."""

LATER_S = 0.035
"""How much later the right side of a face moves; smiles and brows begin some 20 to 60 ms apart (Schmidt, Liu & Cohn
2006)."""

_LATER = np.array([name.endswith("Right") and name != "eyeBlinkRight" for name in SHAPES])
_BY_LATENESS = ((0.0, np.flatnonzero(~_LATER)), (LATER_S, np.flatnonzero(_LATER)))
"""How much later shapes move, and their columns."""

USUAL_RISE_S = 0.15
USUAL_FALL_S = 0.3
"""For a face with only start and end; at most a third of it each."""


def expressions(
    words: Mapping[str, FloatArray], behaviors: tuple[Behavior, ...], times_s: FloatArray, frame_s: float
) -> FloatArray:
    """The weights (T, 52) of all kept faces whose lexeme is in `words`; for the others see `unknown_faces`."""
    left = np.ones((len(times_s), len(SHAPES)))
    for behavior in behaviors:
        side = _side(behavior)
        if _is_facial(behavior) and behavior.lexeme in words and side:
            points_s = envelope_points(behavior.sync, frame_s)
            weights = _amount(behavior) * sided(words[behavior.lexeme], side)
            for later_s, columns in _BY_LATENESS:
                moved = columns[weights[columns] != 0]
                if not len(moved):
                    continue
                first, last = np.searchsorted(times_s, (points_s[0] + later_s, points_s[-1] + later_s))
                if first < last:
                    height = envelope(times_s[first:last] - later_s, points_s)
                    left[first:last, moved] *= 1 - height[:, None] * weights[moved]
    return 1 - left


def unknown_faces(words: Mapping[str, FloatArray], behaviors: tuple[Behavior, ...]) -> tuple[Decision, ...]:
    """A decision for each face that is not shown because its lexeme is unknown or its side does not exist."""
    found = []
    for behavior in behaviors:
        if _is_facial(behavior) and behavior.lexeme not in words:
            reason = f"lexicon/face.yaml has no face {behavior.lexeme!r}"
            found.append(Decision(behavior.id, "dropped", reason))
        elif _is_facial(behavior) and _side(behavior) is None:
            reason = f"a face is LEFT, RIGHT or BOTH, not {behavior.direction!r}"
            found.append(Decision(behavior.id, "dropped", reason))
    return tuple(found)


def realized_faces(behaviors: tuple[Behavior, ...], frame_s: float) -> dict[str, SyncPoints]:
    """The actual sync points of each kept face, by its id."""
    found = {}
    for behavior in behaviors:
        if _is_facial(behavior):
            start_s, ready_s, relax_s, end_s = envelope_points(behavior.sync, frame_s)
            found[behavior.id] = SyncPoints(start=start_s, ready=ready_s, relax=relax_s, end=end_s)
    return found


def envelope(times_s: FloatArray, points_s: tuple[float, float, float, float]) -> FloatArray:
    """The curve that is 0 at the first point, 1 from the second to the third, and 0 at the fourth."""
    start_s, ready_s, relax_s, end_s = points_s
    rise = minimum_jerk((times_s - start_s) / (ready_s - start_s))
    return np.maximum(rise - minimum_jerk((times_s - relax_s) / (end_s - relax_s)), 0.0)  # never below by rounding


def envelope_points(sync: SyncPoints, frame_s: float) -> tuple[float, float, float, float]:
    """Start, ready, relax and end, with defaults for missing points. The full amount lasts at least a frame, so that it
    shows at every frame rate, and transitions are no faster than the limits: the face then starts earlier or ends
    later."""
    third_s = (sync.end - sync.start) / 3
    ready_s = sync.start + min(USUAL_RISE_S, third_s) if sync.ready is None else sync.ready
    relax_s = max(sync.end - min(USUAL_FALL_S, third_s), ready_s) if sync.relax is None else sync.relax
    relax_s = max(relax_s, ready_s + frame_s)
    return min(sync.start, ready_s - LEAST_RISE_S), ready_s, relax_s, max(sync.end, relax_s + LEAST_FALL_S)


def _is_facial(behavior: Behavior) -> bool:
    return behavior.kept and behavior.kind in FACIAL


def _side(behavior: Behavior) -> FaceSide | None:
    """The side of a face, from its `direction`; None if there is no such side."""
    return _SIDES.get((behavior.direction or FaceSide.BOTH).lower())


def _amount(behavior: Behavior) -> float:
    if behavior.amount is not None:
        return min(max(behavior.amount, 0.0), 1.0)
    return 1.0 if behavior.kind is Channel.EYES else USUAL_AMOUNT
