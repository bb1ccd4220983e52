"""What the gazes of a schedule aim at: where eyes, head and trunk are to be turned, and from when.

A `SHIFT` turns to a target for good, a `LOOK` turns head and eyes to it and back, a `GLANCE` is the eyes' alone and is
laid over the others, as the paper has saccades (§3.8). A direction goes `amount` × 60° to that side, as our BML writes
it. Conventions: radians and metres; directions are pitch and yaw as seen from where the eyes are in the T-pose, left
and right are the character's own.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from app.model import Behavior, Channel, FloatArray, Schedule
from app.realizer.angles import aim

Position = tuple[float, float, float]

LISTENER_M: Position = (0.0, 1.60, 1.25)
"""Who listens, or speaks to a listener: straight ahead at eye height, 1.2 m from the eyes."""

RANGE_DEGREES = 60.0

_DIAGONAL = float(np.sqrt(0.5))
DIRECTIONS: Mapping[str, tuple[float, float]] = MappingProxyType(
    {
        "LEFT": (0.0, 1.0),
        "RIGHT": (0.0, -1.0),
        "UP": (-1.0, 0.0),
        "DOWN": (1.0, 0.0),
        "UPLEFT": (-_DIAGONAL, _DIAGONAL),
        "UPRIGHT": (-_DIAGONAL, -_DIAGONAL),
        "DOWNLEFT": (_DIAGONAL, _DIAGONAL),
        "DOWNRIGHT": (_DIAGONAL, -_DIAGONAL),
    }
)
"""Pitch and yaw of BML's `offsetDirection`."""

HEAD_SHARE: Mapping[str, float] = MappingProxyType({"SHIFT": 0.9, "LOOK": 0.7})
"""How much of the angle the head turns: nearly all for who stays there, less for a look that comes back."""

TRUNK_SHARE: Mapping[str, float] = MappingProxyType({"SHIFT": 0.25, "LOOK": 0.12})
"""How much of the yaw the trunk turns."""

AT_EASE = np.radians([18.0, 24.0])
"""How far eyes turn up or down and to the side before the head helps them."""


@dataclass(frozen=True, slots=True)
class Aim:
    """What is turned where: the eyes' pitch, yaw and nearness (1/m), the head's pitch and yaw, the trunk's yaw."""

    eyes: FloatArray
    head: FloatArray
    trunk: float


@dataclass(frozen=True, slots=True)
class Turned:
    """From `start_s` the aim is another; a slow head takes `within_s`."""

    start_s: float
    within_s: float
    aim: Aim


def looks(schedule: Schedule, from_m: FloatArray, targets_m: Mapping[str, Position]) -> tuple[Aim, tuple[Turned, ...]]:
    """The aim before the first gaze, at the listener, and every change of it in order of time."""
    at_listener = _aim(_at(None, from_m, targets_m), "SHIFT", np.zeros(3))
    return at_listener, tuple(_turned(schedule, from_m, targets_m))


def _turned(schedule: Schedule, from_m: FloatArray, targets_m: Mapping[str, Position]) -> Iterator[Turned]:
    """The latest gaze that is not over yet has the aim, among glances and among the others."""
    base = _at(None, from_m, targets_m)
    running: list[Behavior] = []
    for at_s, within_s, gaze, begins in _moments(schedule):
        if not begins:
            running.remove(gaze)
        elif gaze.lexeme == "SHIFT":
            base = _at(gaze.target, from_m, targets_m) + _aside(gaze)
        else:
            running.append(gaze)
        aside = [each for each in running if each.lexeme != "GLANCE"]
        line = _at(aside[-1].target, from_m, targets_m) + _aside(aside[-1]) if aside else base
        glances = [each for each in running if each.lexeme == "GLANCE"]
        glance = np.zeros(3)
        if glances:
            directed = glances[-1].direction in DIRECTIONS
            glance = _aside(glances[-1]) if directed else _at(glances[-1].target, from_m, targets_m) - line
        yield Turned(at_s, within_s, _aim(line, "LOOK" if aside else "SHIFT", glance))


def _moments(schedule: Schedule) -> list[tuple[float, float, Behavior, bool]]:
    """When a gaze begins (True) or leaves its target, and within which time, in order."""
    found = []
    for gaze in schedule.behaviors:
        if not gaze.kept or gaze.kind is not Channel.GAZE:
            continue
        sync = gaze.sync
        ready_s = sync.end if sync.ready is None else sync.ready
        found.append((sync.start, ready_s - sync.start, gaze, True))
        if gaze.lexeme != "SHIFT":
            leaves_s = max(sync.end if sync.relax is None else sync.relax, sync.start)
            found.append((leaves_s, sync.end - leaves_s, gaze, False))
    return sorted(found, key=lambda moment: (moment[0], moment[2].sync.start, moment[2].id, not moment[3]))


def _aim(line: FloatArray, lexeme: str, glance: FloatArray) -> Aim:
    """Head and trunk take their shares of the line of sight; the head helps where eyes alone would be strained."""
    head = HEAD_SHARE[lexeme] * line[:2]
    in_head = (line + glance)[:2] - head
    return Aim(
        line + glance, head + in_head - np.clip(in_head, -AT_EASE, AT_EASE), TRUNK_SHARE[lexeme] * float(line[1])
    )


def _aside(gaze: Behavior) -> FloatArray:
    pitch, yaw = DIRECTIONS.get(gaze.direction or "", (0.0, 0.0))
    return np.asarray(np.radians(RANGE_DEGREES) * (gaze.amount or 0.0) * np.array([pitch, yaw, 0.0]))


def _at(target: str | None, from_m: FloatArray, targets_m: Mapping[str, Position]) -> FloatArray:
    way_m = np.array(targets_m.get(target or "listener", LISTENER_M)) - from_m
    return np.array([*aim(way_m), 1.0 / np.linalg.norm(way_m)])
