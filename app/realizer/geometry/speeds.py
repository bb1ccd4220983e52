"""Keeps rotations within a greatest speed.

Conventions: rotations are quaternions (T, 4), a frame each; radians and seconds.
"""

import numpy as np

from ...model import FloatArray
from .rotations import angle_between, nearest_sign, slerp


def within_speed(rotations: FloatArray, frame_s: float, fastest_rad_s: float) -> FloatArray:
    """The same rotations where none is farther from the one before than the speed allows; where one is, those that
    follow go after it at that speed until they have caught up."""
    most = fastest_rad_s * frame_s
    cosines = np.abs(np.einsum("tk,tk->t", rotations[1:], rotations[:-1]))
    too_far = np.flatnonzero(cosines < np.cos(most / 2)) + 1
    if not len(too_far):
        return rotations
    kept = rotations.copy()
    frame = int(too_far[0])
    while frame < len(kept):
        away = float(angle_between(kept[frame], kept[frame - 1]))
        if away > most:
            reached = slerp(kept[frame - 1], kept[frame], np.array(most / away))
            kept[frame] = nearest_sign(reached, rotations[frame])
            frame += 1
        else:
            later = too_far[too_far > frame]
            frame = int(later[0]) if len(later) else len(kept)
    return kept
