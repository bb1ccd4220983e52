"""Head movements by lexeme: phase-shifted sine waves (paper §3.8), and held tilts and turns.

A nod is a wave that starts and ends at its crest, so that it goes down from the current position and returns to it; a
shake swings to both sides, its first and last quarter smoothed. Their phase advances such that the extreme nearest to
`stroke` falls on it. Tilts, turns and the like are reached at `stroke` and held until `relax`.

Conventions: degrees in the table, else radians; positive pitch is down, yaw left, roll to the right shoulder; seconds.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from ...model import Behavior, FloatArray
from ..geometry.easing import SHORTEST_S, plateau

Degrees = tuple[float, float, float]
"""Pitch, yaw and roll."""


@dataclass(frozen=True, slots=True)
class HeadMovement:
    """The components of a lexeme at amount 1: `nods` return to the start, `swings` go to both sides, `held` is kept."""

    nods: Degrees = (0.0, 0.0, 0.0)
    swings: Degrees = (0.0, 0.0, 0.0)
    held: Degrees = (0.0, 0.0, 0.0)


MOVEMENTS: Mapping[str, HeadMovement] = MappingProxyType(
    {
        "NOD": HeadMovement(nods=(20.0, 0.0, 0.0)),
        "TOSS": HeadMovement(nods=(-18.0, 3.0, 4.0)),
        "CHIN_RAISE": HeadMovement(nods=(-18.0, 0.0, 0.0)),
        "SHAKE": HeadMovement(swings=(0.0, 22.0, 0.0)),
        "SWAY": HeadMovement(swings=(0.0, 3.0, -15.0)),
        "TILT_LEFT": HeadMovement(held=(0.0, 0.0, -20.0)),
        "TILT_RIGHT": HeadMovement(held=(0.0, 0.0, 20.0)),
        "TILT_LEFT_NOD": HeadMovement(nods=(18.0, 0.0, 0.0), held=(0.0, 0.0, -14.0)),
        "TILT_RIGHT_NOD": HeadMovement(nods=(18.0, 0.0, 0.0), held=(0.0, 0.0, 14.0)),
        "BOW": HeadMovement(held=(30.0, 0.0, 0.0)),
        "RAISE": HeadMovement(held=(-18.0, 0.0, 0.0)),
        "LOWER": HeadMovement(held=(18.0, 0.0, 0.0)),
        "TURN_LEFT": HeadMovement(held=(0.0, 25.0, 0.0)),
        "TURN_RIGHT": HeadMovement(held=(0.0, -25.0, 0.0)),
    }
)
"""The amplitudes are ours: a big nod (amount .9) of 18°, a small one of 6°, well within the neck's range."""

DEFAULT_AMOUNT = 0.5

PHASE_SHIFT = np.radians(35.0)
"""How far the neck leads the head in the middle of a movement."""

DECAY = 0.65
"""The size of each nod relative to the one before."""

SHORTEST_WAVE_S = 0.2
FASTEST_RAD_S = 3.5
"""Nods and shakes are limited to 5 Hz, and joints to 200°/s, whatever the schedule says."""


def movement_angles(times_s: FloatArray, behavior: Behavior, *, ahead: float) -> FloatArray:
    """Pitch, yaw and roll (T, 3) of either neck or head, at frames within the movement. Its phase leads by the share
    `ahead` of `PHASE_SHIFT` in the middle."""
    movement, waves = MOVEMENTS[behavior.lexeme], cycle_count(behavior)
    amount = DEFAULT_AMOUNT if behavior.amount is None else behavior.amount
    nods, swings, held = (
        np.radians(amount * np.array(degrees) / 2) for degrees in (movement.nods, movement.swings, movement.held)
    )
    turned = np.zeros((len(times_s), 3))
    if nods.any():
        turned += _nodding(_phase(times_s, behavior, waves, np.pi, ahead), waves)[:, None] * nods
    if swings.any():
        turned += _swinging(_phase(times_s, behavior, waves, np.pi / 2, ahead), waves)[:, None] * swings
    if held.any():
        turned += _holding(times_s, behavior)[:, None] * held
    return turned


def cycle_count(behavior: Behavior) -> int:
    """The number of nods or shakes: as many as requested, if there is time for them."""
    time_for = int((behavior.sync.end - behavior.sync.start) / SHORTEST_WAVE_S)
    return max(1, min(behavior.repetitions or 1, time_for))


def limited_speed(turned: FloatArray, frame_s: float) -> FloatArray:
    """The same curve (T, 3), reduced in size where it would exceed the neck's maximum speed."""
    speed = np.linalg.norm(np.diff(turned, axis=0, prepend=0.0, append=0.0), axis=-1).max() / frame_s
    return np.asarray(turned * (FASTEST_RAD_S / max(speed, FASTEST_RAD_S)))


def _phase(times_s: FloatArray, behavior: Behavior, waves: int, first_extreme: float, ahead: float) -> FloatArray:
    """The phase from 0 at the start to 2π × `waves` at the end, with an extreme at the stroke; it leads by the share
    `ahead` of `PHASE_SHIFT` in the middle. After `first_extreme`, extremes are π apart in swings and 2π in nods."""
    sync, last = behavior.sync, 2 * np.pi * waves
    stroke_s = _stroke_s(behavior)
    between = np.pi if first_extreme < np.pi else 2 * np.pi
    even = last * (stroke_s - sync.start) / max(sync.end - sync.start, SHORTEST_S)
    extreme = first_extreme + between * min(max(round((even - first_extreme) / between), 0), round(last / between) - 1)
    phase = np.interp(times_s, [sync.start, stroke_s, sync.end], [0.0, extreme, last])
    return np.asarray(phase + ahead * PHASE_SHIFT * np.sin(np.pi * phase / last) ** 2)


def _stroke_s(behavior: Behavior) -> float:
    """The time of the extreme, within the movement; the middle if none is given."""
    sync = behavior.sync
    stroke_s = (sync.start + sync.end) / 2 if sync.stroke is None else sync.stroke
    return min(max(stroke_s, sync.start + SHORTEST_S), sync.end - SHORTEST_S)


def _nodding(phase: FloatArray, waves: int) -> FloatArray:
    """0 at each full wave, with peaks of decreasing height between."""
    sizes = DECAY ** np.arange(waves)
    return np.asarray((1 - np.cos(phase)) / 2 * sizes[np.clip(phase / (2 * np.pi), 0, waves - 1).astype(int)])


def _swinging(phase: FloatArray, waves: int) -> FloatArray:
    """A sine whose first and last quarter are squared, so that it starts and ends with zero velocity."""
    left, quarter = 2 * np.pi * waves - phase, np.pi / 2
    return np.asarray(np.sin(phase) * np.sin(np.clip(phase, 0, quarter)) * np.sin(np.clip(left, 0, quarter)))


def _holding(times_s: FloatArray, behavior: Behavior) -> FloatArray:
    sync, stroke_s = behavior.sync, _stroke_s(behavior)
    relax_s = stroke_s if sync.relax is None else max(sync.relax, stroke_s)
    return plateau(times_s, sync.start, stroke_s, min(relax_s, sync.end - SHORTEST_S), sync.end)
