"""Eye look shapes from the rotation of the eye joints, and eyelids that follow them.

Conventions: an eye looks along its joint's +Z; up and to the character's left (+X) are positive. ARKit's look shapes
move the lids along with the gaze; the eyeballs rotate with the eye joints. Faces without eye joints rotate them by the
look shapes.
"""

import numpy as np

from ...model import FloatArray
from ..body.motion import SHAPES, BodyMotion
from ..body.skeleton import Skeleton
from ..geometry.rotations import rotate
from .face_tables import INDEX, EyeTable

SIDES = ("Left", "Right")

_OF_LIDS = ("eyeBlink{}", "eyeWide{}", "eyeSquint{}", "eyeLookDown{}")
_AHEAD: FloatArray = np.array([0.0, 0.0, 1.0])
_AHEAD.setflags(write=False)


def eye_look_weights(table: EyeTable, body: BodyMotion, skeleton: Skeleton) -> FloatArray:
    """The weights (T, 52) of the eight eye look shapes."""
    shapes = np.zeros((len(body.times_s), len(SHAPES)))
    gaze = rotate(body.rotations.take(skeleton.chain("leftEye", "rightEye"), axis=1), _AHEAD)
    out_deg = np.degrees(np.arctan2(gaze[..., 0], gaze[..., 2])) * [1.0, -1.0]
    up_deg = np.degrees(np.arcsin(np.clip(gaze[..., 1], -1.0, 1.0)))
    turns = {"Out": out_deg / table.out_deg, "In": -out_deg / table.in_deg}
    turns |= {"Up": up_deg / table.up_deg, "Down": -up_deg / table.down_deg}
    for way, share in turns.items():
        shapes[:, [INDEX[f"eyeLook{way}{side}"] for side in SIDES]] = np.clip(share, 0.0, 1.0)
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
