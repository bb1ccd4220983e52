"""Blends from one motion to another without a jump: their difference in pose and velocity at that moment is added to
the new motion and decays.

Each curve's difference follows the quintic that begins with it and its rate of change and ends at rest (Bollo 2016,
"Inertialization"), but begins without acceleration. Rotations differ by a rotation vector on the left. Radians, metres,
seconds.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..model import FloatArray
from ..realizer.geometry.rotations import from_rotation_vector, inverse, length, multiply, to_rotation_vector

SHORTEST_S, LONGEST_S = 0.25, 0.9
SPEED = 4.0
"""The fastest decay of a difference, radians a second."""

_PEAK = 1.875
"""The quintic's peak speed, relative to a linear decay."""

FACE_S = 0.12


@dataclass(frozen=True, slots=True, eq=False)
class Pose:
    """Local rotations (J, 4), place of the hips (3,), shapes of the face (52,); or of many frames, first axis time."""

    rotations: FloatArray
    hips_m: FloatArray
    shapes: FloatArray

    @classmethod
    def of(cls, frames: Sequence["Pose"]) -> "Pose":
        """Single frames stacked into a motion."""
        return cls(
            np.stack([each.rotations for each in frames]),
            np.stack([each.hips_m for each in frames]),
            np.stack([each.shapes for each in frames]),
        )

    def at(self, frames: int | slice) -> "Pose":
        """That frame, or those."""
        return Pose(self.rotations[frames], self.hips_m[frames], self.shapes[frames])


@dataclass(frozen=True, slots=True, eq=False)
class Offset:
    """The difference added from `from_s` on: rotation vectors (J, 3), position (3,) and shapes (52,), their rates of
    change, and each joint's time of decay (J,)."""

    from_s: float
    turned: FloatArray
    turning: FloatArray
    hips_m: FloatArray
    hips_m_per_s: FloatArray
    shapes: FloatArray
    lasts_s: FloatArray

    @classmethod
    def between(cls, shown: Pose, new: Pose, *, at_s: float, frame_s: float) -> "Offset":
        """`shown` are the last two frames that were sent, `new` the new motion's frames at the same times."""
        turned = to_rotation_vector(multiply(shown.rotations, inverse(new.rotations)))
        moved, reshaped = shown.hips_m - new.hips_m, shown.shapes - new.shapes
        by = length(turned[1])[:, 0]
        return cls(
            from_s=at_s,
            turned=turned[1],
            turning=(turned[1] - turned[0]) / frame_s,
            hips_m=moved[1],
            hips_m_per_s=(moved[1] - moved[0]) / frame_s,
            shapes=reshaped[1],
            lasts_s=np.clip(_PEAK * by / SPEED, SHORTEST_S, LONGEST_S),
        )

    def added(self, motion: Pose, times_s: FloatArray) -> Pose:
        """The motion (frames at `times_s`) plus the rest of the difference."""
        since_s = (times_s - self.from_s)[:, None, None]
        if since_s[0, 0, 0] >= LONGEST_S:
            return motion
        turned = _dying(since_s, self.lasts_s[:, None], self.turned, self.turning)
        hips = _dying(since_s[:, 0], np.full(3, LONGEST_S), self.hips_m, self.hips_m_per_s)
        shapes = _dying(since_s[:, 0], np.full(len(self.shapes), FACE_S), self.shapes, np.zeros_like(self.shapes))
        return Pose(
            multiply(from_rotation_vector(turned), motion.rotations),
            motion.hips_m + hips,
            np.clip(motion.shapes + shapes, 0.0, 1.0),
        )


def _dying(since_s: FloatArray, lasts_s: FloatArray, by: FloatArray, rate: FloatArray) -> FloatArray:
    """The quintic from `by` at `rate` to zero."""
    share = np.clip(since_s / lasts_s, 0.0, 1.0)
    cubed = share**3
    place = 1 - cubed * (10 - 15 * share + 6 * share**2)
    speed = share - cubed * (6 - 8 * share + 3 * share**2)
    return np.asarray(by * place + rate * lasts_s * speed)
