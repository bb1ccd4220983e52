"""How far the neck reaches forward: it is inclined in standing, nods along with strokes, and is never quite still.

The head keeps its orientation, so gaze and head movements remain what they are: only its place changes. Conventions:
radians, forward positive.
"""

from dataclasses import replace

import numpy as np

from ...model import FloatArray, Schedule
from ..body.motion import BodyMotion
from ..body.movement_style import IdleLife
from ..body.skeleton import Skeleton
from ..geometry.noise import perlin
from ..geometry.rotations import from_axis_angle, inverse, multiply
from .idle_activity import idle_activity

_NECK_HZ = 0.4


def with_neck_reaching(
    skeleton: Skeleton, body: BodyMotion, schedule: Schedule, strokes: FloatArray, *, seed: int, life: IdleLife
) -> BodyMotion:
    """The body with its neck inclined, by itself and by `strokes` (T,). Deterministic for a seed."""
    noise = perlin(body.times_s, frequency_hz=_NECK_HZ, seed=seed + 4)[:, 0]
    forward = np.radians(life.neck_forward_deg + life.neck_deg * idle_activity(schedule) * noise) + strokes
    neck, head = skeleton.chain("neck", "head")
    rotations = body.rotations.copy()
    before = body.rotations[:, neck]
    rotations[:, neck] = multiply(from_axis_angle((1.0, 0.0, 0.0), forward), before)
    rotations[:, head] = multiply(inverse(rotations[:, neck]), multiply(before, body.rotations[:, head]))
    return replace(body, rotations=rotations)
