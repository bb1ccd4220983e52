"""Computes the face of a schedule: 52 blendshape weights per frame (paper §3.8, lip sync and facial expression).

In order: lip sync; expressions of brows, cheeks, nose and mouth; micro-movement; eye looks and eyelids. Speech has
priority at the mouth: expressions keep the share of the mouth's corners that the visemes leave (a smile continues,
smaller, through an "oo"), but move lips and jaw only in silence, so that no smile opens an M.

Eye look shapes from the rotation of the eye joints, and eyelids that follow them.

Conventions: an eye looks along its joint's +Z; up and to the character's left (+X) are positive. ARKit's look shapes
move the lids along with the gaze; the eyeballs rotate with the eye joints. Faces without eye joints rotate them by the
look shapes.
"""

from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Schedule
from ..body.motion import SHAPES, BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.curves import clipped
from ..geometry.noise import perlin
from ..geometry.rotations import rotate
from .expressions import expressions
from .face_tables import COLUMNS, INDEX, EyeTable, FaceTables
from .lips import LipSync, lip_sync, with_glides

CORNERS = ("mouthSmile", "mouthFrown", "mouthDimple", "mouthStretch", "mouthPress", "mouthLeft", "mouthRight")
"""The shapes at the corners of the mouth, which speech uses only in part; lips that are pressed stay tense between the
words."""

LIPS = tuple(name for name in SHAPES if name.startswith(("jaw", "mouth", "tongue")) and not name.startswith(CORNERS))
"""The other shapes of mouth and jaw, which speech needs entirely."""

ASYMMETRY = 0.08
"""Up to this share of an expression is missing on one side of the face, varying over time: held faces are never quite
still or symmetric."""

WEAKER_SIDE = 0.05
"""As much is always missing on the right side: most people's left shows more (Sackeim, Gur & Saucy 1978)."""

MICRO_MOVEMENT: Mapping[str, float] = MappingProxyType(
    {
        "browInnerUp": 0.03,
        "browOuterUp": 0.025,
        "browDown": 0.025,
        "cheekSquint": 0.015,
        "eyeSquint": 0.03,
        "eyeWide": 0.02,
        "mouthSmile": 0.025,
        "mouthDimple": 0.02,
        "mouthPress": 0.02,
        "jawOpen": 0.012,
        "noseSneer": 0.01,
    }
)
"""How far shapes wander without any behaviour: too little to mean anything, enough not to look frozen."""

MICRO_MOVEMENT_HZ, ASYMMETRY_HZ = 0.7, 0.4

_SIDE = tuple(1 if name.endswith("Left") else 2 if name.endswith("Right") else 0 for name in SHAPES)
"""Of each shape: the middle of the face, its left side, its right."""

_FRAMES_AT_ONCE = 2048
"""Frames computed at a time, so that ten minutes need little more memory than half a minute."""


def face_weights(
    tables: FaceTables, schedule: Schedule, body: BodyMotion, skeleton: Skeleton, *, seed: int
) -> FloatArray:
    """The weights (T, 52) in [0, 1], in the order of `SHAPES`, at the frames of `body`, whose eye joints determine the
    eye look shapes. Faces with unknown lexemes are left out; `expressions.unknown_faces` reports them."""
    times_s = body.times_s
    frame_s = float(times_s[1] - times_s[0]) if len(times_s) > 1 else 0.0
    spoken = with_glides(schedule.visemes, schedule.words)
    shapes = np.empty((len(times_s), len(SHAPES)))
    for first in range(0, len(times_s), _FRAMES_AT_ONCE):
        frames = slice(first, first + _FRAMES_AT_ONCE)
        part = BodyMotion(times_s[frames], body.rotations[frames], body.hips_m[frames])
        micro_movements = (1 - schedule.stillness) * micro_movement(part.times_s, seed)
        at_rest = _together(eye_look_weights(tables.eyes, part, skeleton), micro_movements)
        shown = expressions(tables.lexemes, schedule.behaviors, part.times_s, frame_s) * _sides(part.times_s, seed)
        speech = lip_sync(tables.visemes, spoken, part.times_s)
        beside = _together(shown, at_rest)
        _leave_to_speech(beside, speech)
        shapes[frames] = with_lids(tables.eyes, _together(speech.shapes, beside))
    return shapes


def micro_movement(times_s: FloatArray, seed: int) -> FloatArray:
    """Idle noise of the face (T, 52), independent for each side."""
    moving = [(column, size) for name, size in MICRO_MOVEMENT.items() for column in COLUMNS[name]]
    noise = perlin(times_s, frequency_hz=MICRO_MOVEMENT_HZ, seed=seed, channels=len(moving))
    columns, sizes = zip(*moving, strict=True)
    shapes = np.zeros((len(times_s), len(SHAPES)))
    noise += 1
    shapes[:, columns] = noise * (np.array(sizes) / 2)
    return shapes


def _leave_to_speech(shown: FloatArray, speech: LipSync) -> None:
    """Reduce the expressions (T, 52) to what speech leaves of the mouth."""
    for names, left in ((CORNERS, speech.corners), (LIPS, speech.lips)):
        shown[:, _columns(names)] *= left[:, None]


@cache
def _columns(names: tuple[str, ...]) -> list[int]:
    """Of the shapes of these names. Never mutated."""
    return sorted({column for name in names for column in COLUMNS[name]})


def _sides(times_s: FloatArray, seed: int) -> FloatArray:
    """The share of an expression on each side of the face and in its middle (T, 52). Eyelids close completely on
    both."""
    missing = ASYMMETRY * (1 + perlin(times_s, frequency_hz=ASYMMETRY_HZ, seed=seed + 1, channels=3)) / 2
    missing[:, 2] += WEAKER_SIDE
    made = (1 - missing).take(_SIDE, axis=1)
    made[:, COLUMNS["eyeBlink"]] = 1
    return made


def _together(a: FloatArray, b: FloatArray) -> FloatArray:
    """Both combined, within [0, 1] if they are."""
    left = 1 - a
    left *= 1 - b
    return np.subtract(1, left, out=left)


SIDES = ("Left", "Right")

_OF_LIDS = ("eyeBlink{}", "eyeWide{}", "eyeSquint{}", "eyeLookDown{}")
_AHEAD: FloatArray = np.array([0.0, 0.0, 1.0])
_AHEAD.setflags(write=False)


def eye_look_weights(table: EyeTable, body: BodyMotion, skeleton: Skeleton) -> FloatArray:
    """The weights (T, 52) of the eight eye look shapes."""
    shapes = np.zeros((len(body.times_s), len(SHAPES)))
    gaze = rotate(body.rotations.take(skeleton.chain("leftEye", "rightEye"), axis=1), _AHEAD)
    out_deg = np.degrees(np.arctan2(gaze[..., 0], gaze[..., 2])) * [1.0, -1.0]
    up_deg = np.degrees(np.arcsin(clipped(gaze[..., 1], -1.0, 1.0)))
    turns = {"Out": out_deg / table.out_deg, "In": -out_deg / table.in_deg}
    turns |= {"Up": up_deg / table.up_deg, "Down": -up_deg / table.down_deg}
    for way, share in turns.items():
        shapes[:, [INDEX[f"eyeLook{way}{side}"] for side in SIDES]] = clipped(share, 0.0, 1.0)
    return shapes


def with_lids(table: EyeTable, shapes: FloatArray) -> FloatArray:
    """The weights with lids that follow the looks. A closing lid loses its wide and squint weights, and its look down,
    which would push it beyond closed."""
    shapes = shapes.copy()
    for side in SIDES:
        blink, wide, squint, look_down = (shapes[:, INDEX[name.format(side)]] for name in _OF_LIDS)
        look_down *= 1 - blink
        blink += (1 - blink) * table.lids_down * look_down
        wide += (1 - wide) * table.lids_up * shapes[:, INDEX["eyeLookUp" + side]]
        wide *= (1 - blink) * (1 - 0.5 * squint)
        squint *= 1 - 0.5 * blink
    return shapes
