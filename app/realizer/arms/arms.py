"""Interpolates the key poses of an arm's track into joint rotations for every frame (Gesture Engine §5.1, §5.2).

Conventions: times in seconds of the audio, increasing; an arm's rotations are (T, 19, 4) in the order of
`posing.arm_joints`. Each part of the arm follows a Kochanek-Bartels spline through only those keys that define it, so a
part that a key leaves open is interpolated between its neighbours.
"""

from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np

from ...model import FloatArray, Hand
from ..geometry.noise import perlin
from ..geometry.rotations import from_rotation_vector, multiply, with_continuous_signs
from ..geometry.splines import Curve, splines
from ..gestures.arm_joints import PARTS
from .posing import PartialPose, arm_rotations

FOLLOW_THROUGH_S = 0.3
"""The maximum delay of the fingertips behind the collarbone: 9 frames at 30 per second (Gesture Engine §5.1)."""

_SHARE_OF_INTERVAL = 0.35
_NOISE_HZ = 0.7
_BLOCK = 1_000
"""Frames interpolated at a time, to limit memory in long motions."""


def _delay(part: str) -> float:
    """The delay of a part between the collarbone (0), which moves first, and the fingertips (1)."""
    first = {"Shoulder": -0.3, "UpperArm": -0.15, "Elbow": 0.0, "LowerArm": 0.15, "Hand": 0.25}
    return first[part] if part in first else {"Distal": 0.7, "Intermediate": 0.55}.get(part[-6:], 0.4)


@dataclass(frozen=True, slots=True, eq=False)
class TimedPose:
    """A key of a track.

    `tension`, `continuity` and `bias` in [-1, 1] shape the spline at the key. With `follow_through`, collarbone and
    shoulder reach the pose before its time, wrist and fingers after it. `marked` keys stand for sync points. `noise` in
    [0, 1] is the amount of Perlin noise at the key, interpolated linearly between keys.
    """

    time_s: float
    pose: PartialPose
    follow_through: bool = True
    tension: float = 0.0
    continuity: float = 0.0
    bias: float = 0.0
    noise: float = 0.0
    marked: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class ArmTrack:
    """The keys of one arm in order; the first must define the whole arm."""

    side: Hand
    keys: tuple[TimedPose, ...]

    def __post_init__(self) -> None:
        times_s = [key.time_s for key in self.keys]
        if not self.keys or not self.keys[0].pose.defined.all():
            raise ValueError("an arm's track begins with a pose that says the whole arm")
        if any(later <= sooner for sooner, later in pairwise(times_s)):
            raise ValueError("the keys of an arm's track are at rising times")


def arm_motion(track: ArmTrack, times_s: FloatArray, *, seed: int, noise_scale: float = 1.0) -> FloatArray:
    """The arm's rotations (T, 19, 4) at `times_s` (T,), with continuous quaternion signs. `noise_scale` (0 to 1)
    scales the noise of the keys."""
    said = np.stack([key.pose.defined for key in track.keys])
    keys = np.stack([key.pose.parts for key in track.keys])
    shapes = np.array([(key.tension, key.continuity, key.bias) for key in track.keys])
    key_times_s = _shifted(track)
    through = [(row, said[:, row]) for row in range(len(PARTS))]
    curves = [Curve(key_times_s[keyed, row], keys[keyed, row], shapes[keyed]) for row, keyed in through]
    found = np.empty((len(times_s), len(PARTS) - 1, 4))
    for first in range(0, len(times_s), _BLOCK):
        block = slice(first, first + _BLOCK)
        parts = splines(curves, times_s[block])
        found[block] = arm_rotations(_stirred(track, parts, times_s[block], seed, noise_scale=noise_scale))
    return with_continuous_signs(found)


def _shifted(track: ArmTrack) -> FloatArray:
    """The time (K, 20) at which each part reaches each key. The follow-through grows with the time to the next key but
    never reorders keys; the last key is reached by all parts at once."""
    times_s = np.array([key.time_s for key in track.keys])
    until_next_s = np.append(np.diff(times_s), 0.0)
    since_last_s = np.append(np.inf, np.diff(times_s))
    most_s = np.minimum(FOLLOW_THROUGH_S, _SHARE_OF_INTERVAL * np.minimum(until_next_s, since_last_s))
    most_s *= [key.follow_through for key in track.keys]
    delays = np.array([_delay(part) for part in PARTS])
    return np.asarray(times_s[:, None] + most_s[:, None] * delays)


@cache
def _stir_deg() -> FloatArray:
    """The amplitude of noise of each part about its axes x, y, z, in degrees (20, 3): joints only in directions in
    which they turn, fingers only at their roots. Never mutated."""
    stir = {"Shoulder": (0.0, 0.5, 0.5), "UpperArm": (1.0, 1.0, 1.0), "Elbow": (0.0, 1.2, 0.0)}
    stir |= {"LowerArm": (1.5, 0.0, 0.0), "Hand": (0.0, 0.8, 1.4)}
    stir |= {part: (0.0, 0.0, 1.5) for part in PARTS if part.endswith("Proximal") and not part.startswith("Thumb")}
    return np.array([stir.get(part, (0.0, 0.0, 0.0)) for part in PARTS])


def _stirred(track: ArmTrack, parts: FloatArray, times_s: FloatArray, seed: int, *, noise_scale: float) -> FloatArray:
    """Adds Perlin noise, which "removes the freezing effect during the gesture hold" (paper §3.8)."""
    strengths = [noise_scale * key.noise for key in track.keys]
    if not any(strengths):
        return parts
    strength = np.interp(times_s, [key.time_s for key in track.keys], strengths)
    stir_deg = _stir_deg()
    rows, axes = np.nonzero(stir_deg)
    side = 0 if track.side is Hand.LEFT else 1
    noise = perlin(times_s, frequency_hz=_NOISE_HZ, seed=2 * seed + side, channels=len(rows))
    stirring = np.unique(rows)
    turn = np.zeros((len(times_s), len(stirring), 3))
    turn[:, np.searchsorted(stirring, rows), axes] = np.radians(stir_deg[rows, axes]) * noise * strength[:, None]
    stirred = parts.copy()
    stirred[:, stirring] = multiply(parts[:, stirring], from_rotation_vector(turn))
    return stirred
