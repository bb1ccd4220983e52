"""Draws characters as they stand, side by side and to one scale. Needs matplotlib, the extra `understudy[plot]`."""

from collections.abc import Mapping

import numpy as np

from ...model import FloatArray, Hand
from ...model.figure import Looks
from ..arms.rest_poses import rest_pose
from ..body.skeleton import Skeleton
from ..geometry.rotations import IDENTITY
from ..gestures.arm_joints import arm_joints
from ..mannequin.mannequin import Mannequin
from .contact_sheet import Still, cell, draw_cells
from .rasterizer import Camera

_WHOLE = (Camera((0.0, 1.0, 0.0), 2.12), Camera((0.0, 1.0, 0.0), 2.12, azimuth=np.radians(48)))
AT_SIDE = "at_side"


def draw_characters(bodies: Mapping[str, tuple[Skeleton, Looks]]) -> bytes:
    """Each body, by the name of its character, from the front, three quarters and in close-up, as PNG."""
    stills = [Still(name, _standing(skeleton)) for name, (skeleton, _looks) in bodies.items()]
    cells = [
        cell(Mannequin.around(skeleton, looks), still, faces=True, cameras=_WHOLE)
        for still, (skeleton, looks) in zip(stills, bodies.values(), strict=True)
    ]
    return draw_cells(cells, stills)


def _standing(skeleton: Skeleton) -> FloatArray:
    """The rotations (J, 4) of a body with its arms at its sides."""
    rotations = np.tile(IDENTITY, (len(skeleton.names), 1))
    for side in (Hand.LEFT, Hand.RIGHT):
        rotations[skeleton.chain(*arm_joints(side))] = rest_pose(skeleton, side, AT_SIDE).rotations
    return rotations
