"""Head movements: phase-shifted sine waves on neck and head, added to where the gaze has turned them (paper §3.8).

A nod is a wave that starts and ends at its crest, so that it goes down from where the head is and comes back there; a
shake swings to both sides and fades in and out in a quarter of a wave. Both run through their phase at the pace that
puts an extreme on `stroke`, the one nearest to where it would be at an even pace. Tilts, turns and the like are reached
at `stroke` and held until `relax`. The neck goes ahead of the head by a part of the phase. The eyes stay where they
looked.

Conventions: degrees in the tables, else radians; pitch down, yaw left, roll to the right shoulder; seconds.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from app.model import Behavior, Channel, FloatArray, Schedule
from app.realizer.angles import turn
from app.realizer.easing import SHORTEST_S, plateau
from app.realizer.limits import within_neck_limits
from app.realizer.motion import BodyMotion
from app.realizer.noise import perlin
from app.realizer.rotations import inverse, multiply
from app.realizer.sight import EYES, aimed, chest, face, seen_m
from app.realizer.skeleton import Skeleton

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

_IDLE_DEGREES, _IDLE_HZ = (3.0, 4.0, 2.6), 0.5
_TREMBLE_DEGREES, _TREMBLE_HZ = 0.25, 2.3
"""Noise of the head between its movements; the usual distance from the middle is a quarter of it."""

_CALMED = 0.75
"""How much of it is left out in the middle of a movement."""

_EMPHASIS_DEGREES, _EMPHASIS_S = 1.6, 0.18
"""Stress shows in the head a little even where nothing is scheduled: down with it, this long there and back."""


def head(skeleton: Skeleton, body: BodyMotion, schedule: Schedule, *, seed: int) -> BodyMotion:
    """`body` with the schedule's head movements, and a little life between them, on neck and head."""
    times_s = body.times_s
    movements = [
        each for each in schedule.behaviors if each.kept and each.kind is Channel.HEAD and each.lexeme in MOVEMENTS
    ]
    neck_turn, head_turn = _still_moving(times_s, schedule, seed)
    calm = _calm(times_s, movements)[:, None]
    neck_turn *= calm
    head_turn *= calm
    for movement in movements:
        _add(times_s, movement, neck_turn, head_turn)
    neck, skull = (body.rotations[:, joint] for joint in skeleton.chain("neck", "head"))
    eyes = skeleton.chain(*EYES)
    carrying = chest(skeleton, body.rotations, body.hips_m)
    at_m = seen_m(face(skeleton, carrying, neck, skull), body.rotations[:, eyes])
    neck, skull = multiply(neck, turn(*neck_turn.T)), multiply(skull, turn(*head_turn.T))
    skull = multiply(inverse(neck), within_neck_limits(multiply(neck, skull)))
    rotations = body.rotations.copy()
    rotations[:, skeleton.index["neck"]], rotations[:, skeleton.index["head"]] = neck, skull
    rotations[:, eyes] = aimed(face(skeleton, carrying, neck, skull), at_m)
    return BodyMotion(times_s, rotations, body.hips_m)


def _add(times_s: FloatArray, behavior: Behavior, neck_turn: FloatArray, head_turn: FloatArray) -> None:
    """Adds the movement to pitch, yaw and roll (T, 3) of neck and head, half of it to each."""
    sync, movement = behavior.sync, MOVEMENTS[behavior.lexeme]
    during = slice(*np.searchsorted(times_s, [sync.start, sync.end]))
    times_s = times_s[during]
    amount = DEFAULT_AMOUNT if behavior.amount is None else behavior.amount
    nods, swings, held = (np.radians(amount * np.array(each) / 2) for each in _parts(movement))
    waves = max(behavior.repetitions or 1, 1)
    for turned, ahead in ((neck_turn, 0.5), (head_turn, -0.5)):
        if nods.any():
            turned[during] += _nodding(_phase(times_s, behavior, waves, np.pi, ahead), waves)[:, None] * nods
        if swings.any():
            turned[during] += _swinging(_phase(times_s, behavior, waves, np.pi / 2, ahead), waves)[:, None] * swings
        if held.any():
            turned[during] += _holding(times_s, behavior)[:, None] * held


def _parts(movement: HeadMovement) -> tuple[Degrees, Degrees, Degrees]:
    return movement.nods, movement.swings, movement.held


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


def _calm(times_s: FloatArray, movements: Sequence[Behavior]) -> FloatArray:
    """How much (T,) the head does by itself: less while it nods or shakes, so that its extremes are in time."""
    busy = np.zeros(len(times_s))
    for movement in movements:
        sync, kind = movement.sync, MOVEMENTS[movement.lexeme]
        if not any((*kind.nods, *kind.swings)):
            continue
        during = slice(*np.searchsorted(times_s, [sync.start, sync.end]))
        edge_s = (sync.end - sync.start) / 4
        around = plateau(times_s[during], sync.start, sync.start + edge_s, sync.end - edge_s, sync.end)
        busy[during] = np.maximum(busy[during], around)
    return np.asarray(1.0 - _CALMED * busy)


def _still_moving(times_s: FloatArray, schedule: Schedule, seed: int) -> tuple[FloatArray, FloatArray]:
    """Pitch, yaw and roll (T, 3) of neck and head where no movement is asked for: noise, and a dip at each emphasis."""
    slow = perlin(times_s, frequency_hz=_IDLE_HZ, seed=seed, channels=3, in_step=False)
    slow *= np.radians(_IDLE_DEGREES) / 2
    tremble = perlin(times_s, frequency_hz=_TREMBLE_HZ, seed=seed + 1, channels=6, in_step=False)
    tremble *= np.radians(_TREMBLE_DEGREES)
    for emphasis_s in schedule.emphases_s:
        dip = plateau(times_s, emphasis_s - _EMPHASIS_S, emphasis_s, emphasis_s, emphasis_s + 2 * _EMPHASIS_S)
        slow[:, 0] += np.radians(_EMPHASIS_DEGREES / 2) * dip
    return slow + tremble[:, :3], slow + tremble[:, 3:]
