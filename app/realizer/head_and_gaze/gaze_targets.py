"""Finds the targets over time of eyes, head and trunk, from a schedule's gaze behaviours, and those of pointing
gestures.

A `SHIFT` moves the gaze for good, a `LOOK` turns head and eyes to a target and back, a `GLANCE` moves the eyes only and
is added to the others, as saccades are in the paper (§3.8). A direction is an offset of `amount` × 60° to that side, as
in our BML. Hands point at the same positions, but lower than eyes look at a listener.

Conventions: radians, metres in the world (`understudy.realizer.body.skeleton`); directions are pitch and yaw as seen
from the eyes' position in the T-pose, left and right are the character's own.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from ...model import Behavior, Channel, FloatArray, Schedule
from ..body.motion import Decision
from ..geometry.curves import clipped
from ..geometry.rotations import pitch_and_yaw
from ..gestures.gesture_plan import PlacedGesture, Position

LISTENER = "listener"
LISTENER_M: Position = (0.0, 1.60, 1.25)
"""The other person in the conversation: straight ahead at eye height, 1.2 m from the eyes."""

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

HEAD_SHARE: Mapping[str, float] = MappingProxyType({"SHIFT": 0.9, "LOOK": 0.7, "WATCH": 0.5})
"""The share of the angle that the head contributes: nearly all when it stays, less for a look that returns, least for
one at the own hand."""

TRUNK_SHARE: Mapping[str, float] = MappingProxyType({"SHIFT": 0.35, "LOOK": 0.2, "WATCH": 0.1})
"""The share that the trunk contributes of the yaw beyond `TRUNK_AT_EASE`."""

TRUNK_AT_EASE = np.radians(10.0)
"""A turn for which no trunk is needed. People's begin to show at 40° (McCluskey & Cullen 2007; Sidenmark & Gellersen
2019): earlier here, for those who watch from some way off."""
TRUNK_LIMIT = np.radians(30.0)

OPENING_S = 0.5
"""A turn to the listener that begins within this time opens the line."""

AT_EASE = np.radians([18.0, 24.0])
"""How far eyes rotate vertically and horizontally before the head assists."""

LOWEST_HEAD: Mapping[str, float] = MappingProxyType(
    {"SHIFT": np.radians(45.0), "LOOK": np.radians(45.0), "WATCH": np.radians(25.0)}
)
"""How far down a look takes the head: nobody puts the chin on the chest to see the ground, and for a moment's look at
the own hand the face stays with the listener; the eyes do the rest."""

_NOWHERE: FloatArray = np.zeros(3)


@dataclass(frozen=True, slots=True, eq=False)
class GazeTargets:
    """Target angles: the first row applies before any gaze, the others from `starts_s` (K,) on, in order; head
    movements take at least `within_s`. Pitch, yaw and inverse distance (1 / m) of the eyes (K + 1, 3), pitch and yaw of
    the head (K + 1, 2), yaw of the trunk (K + 1, 1)."""

    starts_s: FloatArray
    within_s: FloatArray
    eyes: FloatArray
    head: FloatArray
    trunk: FloatArray


class _GazeLine(NamedTuple):
    """The gaze direction from `at_s` on, what a glance adds to it, and the lexeme that determines the shares of head
    and trunk."""

    at_s: float
    within_s: float
    line: FloatArray
    glance: FloatArray
    lexeme: str


def gaze_targets(
    schedule: Schedule, from_m: FloatArray, targets_m: Mapping[str, Position], *, before: FloatArray = _NOWHERE[:2]
) -> GazeTargets:
    """The targets of a schedule's gazes, beginning with the listener, or, where the line opens with a turn to him, as
    much beside him as `before` (2,) says, pitch and yaw. Head and trunk take their shares of the direction; the head
    assists where the eyes alone would rotate too far."""
    names = {each.target for each in schedule.behaviors if each.kind is Channel.GAZE and each.kept}
    at = {name: _at(name, from_m, targets_m) for name in {None, *names}}
    aside = np.append(before, 0.0) if _opens_with_a_turn(schedule) else _NOWHERE
    lines = [_GazeLine(0.0, 0.0, at[None] + aside, _NOWHERE, "SHIFT"), *_lines(schedule, at)]
    line, glance = np.array([each.line for each in lines]), np.array([each.glance for each in lines])
    shares = np.array([[HEAD_SHARE[each.lexeme], TRUNK_SHARE[each.lexeme]] for each in lines])
    head = shares[:, :1] * line[:, :2]
    beyond = line[:, 1:2] - clipped(line[:, 1:2], -TRUNK_AT_EASE, TRUNK_AT_EASE)
    in_head = (line + glance)[:, :2] - head
    head += in_head - clipped(in_head, -AT_EASE, AT_EASE)
    head[:, 0] = np.minimum(head[:, 0], [LOWEST_HEAD[each.lexeme] for each in lines])
    return GazeTargets(
        starts_s=np.array([each.at_s for each in lines[1:]]),
        within_s=np.array([each.within_s for each in lines[1:]]),
        eyes=line + glance,
        head=head,
        trunk=clipped(shares[:, 1:] * beyond, -TRUNK_LIMIT, TRUNK_LIMIT),
    )


def _opens_with_a_turn(schedule: Schedule) -> bool:
    """Whether the first of all looks is a turn that stays, straight at its target."""
    gazes = (each for each in schedule.behaviors if each.kept and each.kind is Channel.GAZE)
    first = min(gazes, key=lambda gaze: gaze.sync.start, default=None)
    return first is not None and (first.lexeme, first.direction) == ("SHIFT", None) and first.sync.start <= OPENING_S


def _lines(schedule: Schedule, at: Mapping[str | None, FloatArray]) -> Iterator[_GazeLine]:
    """The latest active gaze determines the direction, separately for glances and for the others."""
    base = at[None]
    running: list[Behavior] = []
    for at_s, within_s, gaze, begins in _moments(schedule):
        if not begins:
            running.remove(gaze)
        elif gaze.lexeme == "SHIFT":
            base = at[gaze.target] + _aside(gaze)
        else:
            running.append(gaze)
        aside = [each for each in running if each.lexeme != "GLANCE"]
        line = at[aside[-1].target] + _aside(aside[-1]) if aside else base
        glances = [each for each in running if each.lexeme == "GLANCE"]
        glance = _NOWHERE
        if glances:
            glance = _aside(glances[-1]) if glances[-1].direction in DIRECTIONS else at[glances[-1].target] - line
        kind = (aside[-1].lexeme if aside[-1].lexeme in HEAD_SHARE else "LOOK") if aside else "SHIFT"
        yield _GazeLine(at_s, within_s, line, glance, kind)


def _moments(schedule: Schedule) -> list[tuple[float, float, Behavior, bool]]:
    """Each start (True) and departure of a gaze: time, duration, behaviour, in order."""
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


def _aside(gaze: Behavior) -> FloatArray:
    pitch, yaw = DIRECTIONS.get(gaze.direction or "", (0.0, 0.0))
    angle = np.radians(RANGE_DEGREES) * (gaze.amount or 0.0)
    return np.array([angle * pitch, angle * yaw, 0.0])


def _at(target: str | None, from_m: FloatArray, targets_m: Mapping[str, Position]) -> FloatArray:
    other_m = targets_m.get(LISTENER, LISTENER_M)
    way_m = np.array(targets_m.get(target or LISTENER, other_m)) - from_m
    return np.array([*pitch_and_yaw(way_m), 1.0 / np.linalg.norm(way_m)])


BELOW_THE_EYES_M = 0.35
"""Pointing at a person aims at the chest."""
AT_THE_LISTENER = "YOU"
"""The category that points at the listener, with or without a named target."""


def with_target(placed: PlacedGesture, targets_m: Mapping[str, Position]) -> PlacedGesture:
    """The gesture with its target position; if the target's position is unknown, the gesture as defined."""
    at_a_person = placed.clip.category == AT_THE_LISTENER
    target = placed.request.target or (LISTENER if at_a_person else None)
    if target is None or not placed.clip.aimed:
        return placed
    aim_m = targets_m.get(target, LISTENER_M if target == LISTENER else None)
    if aim_m is not None and (at_a_person or target == LISTENER):
        x, y, z = aim_m
        aim_m = (x, y - BELOW_THE_EYES_M, z)
    return replace(placed, aim_m=aim_m)


def unknown_target(placed: PlacedGesture) -> Iterator[Decision]:
    """A decision for a pointing gesture whose target has no known position."""
    if placed.clip.aimed and placed.request.target and placed.aim_m is None:
        where = f"{placed.request.target!r} has no position"
        yield Decision(placed.request.behavior, "replaced", f"{where}: it points as {placed.clip.name} is defined")
