"""Eyes as shapes, and the lids that go with them: looks from the turn of the body's eye joints, lids that follow
them.

Conventions: an eye looks along its joint's +Z; up and to the character's left (+X) count as positive. The looks repeat
what the eye joints do already, for faces that have no eye joints; whoever plays both turns the eyes twice.
"""

import numpy as np

from app.model import FloatArray
from app.realizer.face_tables import INDEX, EyeTable
from app.realizer.motion import SHAPES, BodyMotion
from app.realizer.rotations import rotate
from app.realizer.skeleton import Skeleton

_AHEAD: FloatArray = np.array([0.0, 0.0, 1.0])
_AHEAD.setflags(write=False)


def looks(table: EyeTable, body: BodyMotion, skeleton: Skeleton) -> FloatArray:
    """The weights (T, 52) of the eight looks."""
    shapes = np.zeros((len(body.times_s), len(SHAPES)))
    for side, outwards in (("Left", 1.0), ("Right", -1.0)):
        gaze = rotate(body.rotations[:, skeleton.index[side.lower() + "Eye"]], _AHEAD)
        out_deg = outwards * np.rad2deg(np.arctan2(gaze[:, 0], gaze[:, 2]))
        up_deg = np.rad2deg(np.arcsin(np.clip(gaze[:, 1], -1, 1)))
        turns = {"Out": out_deg / table.out_deg, "In": -out_deg / table.in_deg}
        turns |= {"Up": up_deg / table.up_deg, "Down": -up_deg / table.down_deg}
        for way, share in turns.items():
            shapes[:, INDEX[f"eyeLook{way}{side}"]] = np.clip(share, 0, 1)
    return shapes


def with_lids(table: EyeTable, shapes: FloatArray) -> FloatArray:
    """The weights with lids that follow the looks; as a lid closes it is no longer wide, and squints less."""
    shapes = shapes.copy()
    for side in ("Left", "Right"):
        blink, wide, squint = (INDEX[name + side] for name in ("eyeBlink", "eyeWide", "eyeSquint"))
        down = table.lids_down * shapes[:, INDEX["eyeLookDown" + side]]
        up = table.lids_up * shapes[:, INDEX["eyeLookUp" + side]]
        shapes[:, blink] = 1 - (1 - shapes[:, blink]) * (1 - down)
        is_open = 1 - shapes[:, blink]
        shapes[:, wide] = (1 - (1 - shapes[:, wide]) * (1 - up)) * is_open * (1 - 0.5 * shapes[:, squint])
        shapes[:, squint] *= 0.5 + 0.5 * is_open
    return shapes
