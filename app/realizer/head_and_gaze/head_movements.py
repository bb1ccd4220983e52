"""What each head movement does: phase-shifted sine waves (paper §3.8), and tilts and turns that are held.

A nod is a wave that starts and ends at its crest, so that it goes down from where the head is and comes back there; a
shake swings to both sides, its first and last quarter softened. Both run through their phase at the pace that puts an
extreme on `stroke`, the one nearest to where it would be at an even pace. Tilts, turns and the like are reached at
`stroke` and held until `relax`.

Conventions: degrees in the table, else radians; pitch down, yaw left, roll to the right shoulder; seconds.
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
    """What a lexeme does at amount 1: `nods` and comes back, `swings` to both sides, is `held`; each may be nothing."""

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
"""The sizes are ours: a big nod (amount .9) of 18°, a small one of 6°, well within what the neck can do."""

DEFAULT_AMOUNT = 0.5

PHASE_SHIFT = np.radians(35.0)
"""How far the neck is ahead of the head in the middle of a movement."""

DECAY = 0.65
"""How large each nod is by the one before."""

SHORTEST_WAVE_S = 0.2
FASTEST_RAD_S = 3.5
"""Nods and shakes of no more than 5 Hz, and no joint faster than 200° a second, whatever the schedule says."""


def moved(times_s: FloatArray, behavior: Behavior, *, ahead: float) -> FloatArray:
    """Pitch, yaw and roll (T, 3) of one of the two joints, neck and head, at frames within the movement; `ahead` by
    that part of `PHASE_SHIFT` in the middle."""
    movement, waves = MOVEMENTS[behavior.lexeme], waves_of(behavior)
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


def waves_of(behavior: Behavior) -> int:
    """How often a nod or shake goes: as often as it is asked to, and there is time for."""
    time_for = int((behavior.sync.end - behavior.sync.start) / SHORTEST_WAVE_S)
    return max(1, min(behavior.repetitions or 1, time_for))


def unhurried(turned: FloatArray, frame_s: float) -> FloatArray:
    """The same course (T, 3), smaller where it would be too fast for a neck."""
    speed = np.linalg.norm(np.diff(turned, axis=0, prepend=0.0, append=0.0), axis=-1).max() / frame_s
    return np.asarray(turned * (FASTEST_RAD_S / max(speed, FASTEST_RAD_S)))


def _phase(times_s: FloatArray, behavior: Behavior, waves: int, first_extreme: float, ahead: float) -> FloatArray:
    """From 0 at the start to 2π × `waves` at the end, through an extreme at the stroke; `ahead` by a part of
    `PHASE_SHIFT` in the middle. Extremes follow `first_extreme` at every half of a swing and every nod (2π)."""
    sync, last = behavior.sync, 2 * np.pi * waves
    stroke_s = _stroke_s(behavior)
    between = np.pi if first_extreme < np.pi else 2 * np.pi
    even = last * (stroke_s - sync.start) / max(sync.end - sync.start, SHORTEST_S)
    extreme = first_extreme + between * min(max(round((even - first_extreme) / between), 0), round(last / between) - 1)
    phase = np.interp(times_s, [sync.start, stroke_s, sync.end], [0.0, extreme, last])
    return np.asarray(phase + ahead * PHASE_SHIFT * np.sin(np.pi * phase / last) ** 2)


def _stroke_s(behavior: Behavior) -> float:
    """The moment of the extreme, inside the movement; the middle where none is given."""
    sync = behavior.sync
    stroke_s = (sync.start + sync.end) / 2 if sync.stroke is None else sync.stroke
    return min(max(stroke_s, sync.start + SHORTEST_S), sync.end - SHORTEST_S)


def _nodding(phase: FloatArray, waves: int) -> FloatArray:
    """0 at each whole wave, 1 and less and less between them."""
    sizes = DECAY ** np.arange(waves)
    return np.asarray((1 - np.cos(phase)) / 2 * sizes[np.clip(phase / (2 * np.pi), 0, waves - 1).astype(int)])


def _swinging(phase: FloatArray, waves: int) -> FloatArray:
    """A sine whose first and last quarter are sines squared, so that it starts and ends at rest."""
    left, quarter = 2 * np.pi * waves - phase, np.pi / 2
    return np.asarray(np.sin(phase) * np.sin(np.clip(phase, 0, quarter)) * np.sin(np.clip(left, 0, quarter)))


def _holding(times_s: FloatArray, behavior: Behavior) -> FloatArray:
    sync, stroke_s = behavior.sync, _stroke_s(behavior)
    relax_s = stroke_s if sync.relax is None else max(sync.relax, stroke_s)
    return plateau(times_s, sync.start, stroke_s, min(relax_s, sync.end - SHORTEST_S), sync.end)
