"""The face of a schedule: 52 weights a frame (paper §3.8, "Lip Syncing" and "Emotion, Facial Expression …").

In order: what the speech makes of the mouth; what brows, cheeks, nose and mouth show; what is never still in a face;
the eyes' looks, and the lids. Speech comes first at the lips: an expression gets of the mouth's corners what the
visemes leave (a smile goes on, smaller, through an "oo"), of lips and jaw only what silence leaves, so that no smile
opens an M.
"""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ...model import FloatArray, Schedule
from ..body.motion import SHAPES, BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.noise import perlin
from .diphthongs import with_glides
from .expressions import expressions
from .face_tables import COLUMNS, FaceTables
from .lids import looks, with_lids
from .lips import Speech, speak

CORNERS = ("mouthSmile", "mouthFrown", "mouthDimple", "mouthStretch", "mouthLeft", "mouthRight")
"""The shapes at the corners of the mouth, which speech leaves in part."""

LIPS = tuple(name for name in SHAPES if name.startswith(("jaw", "mouth", "tongue")) and not name.startswith(CORNERS))
"""The other shapes of mouth and jaw, which speech needs for itself."""

ASYMMETRY = 0.08
"""Up to this much of an expression is missing on a side of the face, now more and now less: held faces live too."""

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
"""How far the shapes wander when nothing is asked of them: too little to mean anything, enough not to freeze."""

MICRO_MOVEMENT_HZ, ASYMMETRY_HZ = 0.7, 0.4

_FRAMES_AT_ONCE = 2048
"""A face is a function of time, so ten minutes take little more room than half a minute."""


def face(tables: FaceTables, schedule: Schedule, body: BodyMotion, skeleton: Skeleton, *, seed: int) -> FloatArray:
    """The weights (T, 52) in [0, 1], in the order of `SHAPES`, at the frames of `body`, whose eye joints are looked at.

    Faces whose word the tables do not know are left out: `expressions.unknown_faces` tells which.
    """
    times_s = body.times_s
    frame_s = float(times_s[1] - times_s[0]) if len(times_s) > 1 else 0.0
    spoken = with_glides(schedule.visemes, schedule.words)
    shapes = np.empty((len(times_s), len(SHAPES)))
    for first in range(0, len(times_s), _FRAMES_AT_ONCE):
        frames = slice(first, first + _FRAMES_AT_ONCE)
        part = BodyMotion(times_s[frames], body.rotations[frames], body.hips_m[frames])
        at_rest = _together(
            looks(tables.eyes, part, skeleton), (1 - schedule.stillness) * micro_movement(part.times_s, seed)
        )
        shown = expressions(tables.words, schedule.behaviors, part.times_s, frame_s) * _sides(part.times_s, seed)
        speech = speak(tables.visemes, spoken, part.times_s)
        beside = _beside_speech(_together(shown, at_rest), speech)
        shapes[frames] = with_lids(tables.eyes, _together(speech.shapes, beside))
    return shapes


def micro_movement(times_s: FloatArray, seed: int) -> FloatArray:
    """What the face does when it does nothing (T, 52); each side by itself."""
    moving = [(column, size) for name, size in MICRO_MOVEMENT.items() for column in COLUMNS[name]]
    noise = perlin(times_s, frequency_hz=MICRO_MOVEMENT_HZ, seed=seed, channels=len(moving))
    shapes = np.zeros((len(times_s), len(SHAPES)))
    for channel, (column, size) in enumerate(moving):
        shapes[:, column] = size * (1 + noise[:, channel]) / 2
    return shapes


def _beside_speech(shown: FloatArray, speech: Speech) -> FloatArray:
    """Expressions as far as the speech leaves the mouth to them."""
    shown = shown.copy()
    for left, names in ((speech.corners, CORNERS), (speech.lips, LIPS)):
        columns = [column for name in names for column in COLUMNS[name]]
        shown[:, columns] *= left[:, None]
    return shown


def _sides(times_s: FloatArray, seed: int) -> FloatArray:
    """How much of an expression each side of the face makes, and its middle (T, 52). Eyelids close wholly on both."""
    side = [(name.endswith("Left"), name.endswith("Right")) for name in SHAPES]
    channel = [1 if left else 2 if right else 0 for left, right in side]
    missing = ASYMMETRY * (1 + perlin(times_s, frequency_hz=ASYMMETRY_HZ, seed=seed + 1, channels=3)) / 2
    made = 1 - missing[:, channel]
    made[:, COLUMNS["eyeBlink"]] = 1
    return np.asarray(made)


def _together(a: FloatArray, b: FloatArray) -> FloatArray:
    """Both at once, between 0 and 1 as they are."""
    return np.asarray(1 - (1 - a) * (1 - b))
