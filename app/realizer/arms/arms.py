"""An arm in time: key poses on a track → the rotations of its joints in every frame (Gesture Engine §5.1, §5.2).

Conventions: times in seconds of the audio, rising; an arm's rotations are (T, 19, 4) in the order of
`posing.arm_joints`. Each part of the arm goes through its own keys only, those that say something of it, on a
Kochanek-Bartels spline; so what a key leaves open flows on between its neighbours.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ...model import FloatArray, Hand
from ..geometry.noise import perlin
from ..geometry.rotations import from_rotation_vector, multiply, of_one_sign
from ..geometry.splines import Curve, splines
from ..gestures.arm_joints import PARTS
from .posing import PartialPose, arm_rotations

FOLLOW_THROUGH_S = 0.3
"""The most that fingertips come after the collarbone: 9 frames at 30 a second (Gesture Engine §5.1)."""

_SHARE_OF_INTERVAL = 0.35
_NOISE_HZ = 0.7


def _delay(part: str) -> float:
    """A part's place between the collarbone, which moves first, and the fingertips, in shares of the follow-through."""
    first = {"Shoulder": -0.3, "UpperArm": -0.15, "Elbow": 0.0, "LowerArm": 0.15, "Hand": 0.15}
    return first[part] if part in first else {"Distal": 0.7, "Intermediate": 0.55}.get(part[-6:], 0.4)


@dataclass(frozen=True, slots=True, eq=False)
class TimedPose:
    """A key of a track.

    `tension`, `continuity` and `bias` in [-1, 1] shape the spline at the key. `follow_through` lets collarbone and
    shoulder come before its time and wrist and fingers after it; `marked` keys, which stand for a sync point, keep
    shoulder, elbow and wrist on time all the same. `noise` in [0, 1] is how much the arm stirs at the key; between keys
    it changes evenly, so a hold that stirs has it on both its keys."""

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
    """The keys of one arm; the first says the whole arm."""

    side: Hand
    keys: tuple[TimedPose, ...]

    def __post_init__(self) -> None:
        times_s = [key.time_s for key in self.keys]
        if not self.keys or not self.keys[0].pose.said.all():
            raise ValueError("an arm's track begins with a pose that says the whole arm")
        if any(later <= sooner for sooner, later in pairwise(times_s)):
            raise ValueError("the keys of an arm's track are at rising times")


def arm_motion(track: ArmTrack, times_s: FloatArray, *, seed: int, life: float = 1.0) -> FloatArray:
    """The arm's rotations (T, 19, 4) at `times_s` (T,), neighbours of one sign, with `life` (0 to 1) of the keys'
    noise."""
    said = np.stack([key.pose.said for key in track.keys])
    keys = np.stack([key.pose.parts for key in track.keys])
    shapes = np.array([(key.tension, key.continuity, key.bias) for key in track.keys])
    key_times_s = _shifted(track)
    through = [(row, said[:, row]) for row in range(len(PARTS))]
    curves = [Curve(key_times_s[keyed, row], keys[keyed, row], shapes[keyed]) for row, keyed in through]
    return of_one_sign(arm_rotations(_stirred(track, splines(curves, times_s), times_s, seed, life=life)))


def _shifted(track: ArmTrack) -> FloatArray:
    """When each part reaches each key: (K, 20). The follow-through grows with the time to the key after, and never so
    far that keys change places; the last key is everyone's."""
    times_s = np.array([key.time_s for key in track.keys])
    until_next_s = np.append(np.diff(times_s), 0.0)
    since_last_s = np.append(np.inf, np.diff(times_s))
    most_s = np.minimum(FOLLOW_THROUGH_S, _SHARE_OF_INTERVAL * np.minimum(until_next_s, since_last_s))
    most_s *= [key.follow_through for key in track.keys]
    delays = np.array([_delay(part) for part in PARTS])
    kept = np.where([part in {"UpperArm", "LowerArm", "Hand"} for part in PARTS], 0.0, delays)
    marked = np.array([key.marked for key in track.keys])[:, None]
    return np.asarray(times_s[:, None] + most_s[:, None] * np.where(marked, kept, delays))


def _stir_deg() -> FloatArray:
    """How much each part stirs about its axes x, y, z, in degrees (20, 3): joints only as they turn, fingers at their
    roots."""
    stir = {"Shoulder": (0.0, 0.5, 0.5), "UpperArm": (1.0, 1.0, 1.0), "Elbow": (0.0, 1.2, 0.0)}
    stir |= {"LowerArm": (1.5, 0.0, 0.0), "Hand": (0.0, 0.8, 1.4)}
    stir |= {part: (0.0, 0.0, 1.5) for part in PARTS if part.endswith("Proximal") and not part.startswith("Thumb")}
    return np.array([stir.get(part, (0.0, 0.0, 0.0)) for part in PARTS])


def _stirred(track: ArmTrack, parts: FloatArray, times_s: FloatArray, seed: int, *, life: float) -> FloatArray:
    """Perlin noise on top, which "removes the freezing effect during the gesture hold" (paper §3.8)."""
    strengths = [life * key.noise for key in track.keys]
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
