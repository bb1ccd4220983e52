"""Interpolates the key poses of an arm's track into joint rotations for every frame (Gesture Engine §5.1, §5.2).

Conventions: times in seconds of the audio, increasing; an arm's rotations are (T, 19, 4) in the order of
`posing.arm_joints`. Each part of the arm follows a Kochanek-Bartels spline through only those keys that define it, so a
part that a key leaves open is interpolated between its neighbours.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np

from ...model import FloatArray, Hand
from ..body.skeleton import PARTS
from ..geometry.curves import means_around, reach_of
from ..geometry.noise import Noise, perlins
from ..geometry.rotations import keep_signs, multiply_parts, sine_and_cosine
from ..geometry.splines import Curves, rotations_at, splines
from .posing import PartialPose

FOLLOW_THROUGH_S = 0.3
"""The maximum delay of the fingertips behind the collarbone: 9 frames at 30 per second (Gesture Engine §5.1)."""

_SHARE_OF_INTERVAL = 0.35
_NOISE_HZ = 0.7
_NEAR_ZERO = 1e-12
_BLOCK = 500
"""Frames interpolated at a time, to limit memory in long motions."""


def _delay(part: str) -> float:
    """The delay of a part between the collarbone (0), which moves first, and the fingertips (1)."""
    first = {"Shoulder": -0.3, "UpperArm": -0.15, "Elbow": 0.0, "LowerArm": 0.15, "Hand": 0.25}
    return first[part] if part in first else {"Distal": 0.7, "Intermediate": 0.55}.get(part[-6:], 0.4)


def _finger_lag_s(part: str) -> float:
    """How much later than the hand a finger is at each key: fingers are there one after another, 35 ms apart."""
    lags_s = {"Middle": 0.035, "Ring": 0.07, "Little": 0.105}
    return next((lag_s for finger, lag_s in lags_s.items() if part.startswith(finger)), 0.0)


_FINGER_LAGS_S: FloatArray = np.array([_finger_lag_s(part) for part in PARTS])
_FINGER_LAGS_S.setflags(write=False)
_MOMENT_S = 1e-3
_DELAYS: FloatArray = np.array([_delay(part) for part in PARTS])
_DELAYS.setflags(write=False)


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
            raise ValueError("an arm's track begins with a pose that defines the whole arm")
        if any(later <= sooner for sooner, later in pairwise(times_s)):
            raise ValueError("the keys of an arm's track are at rising times")


def arm_motion(track: ArmTrack, times_s: FloatArray, *, seed: int, noise_scale: float = 1.0) -> FloatArray:
    """The arm's rotations (T, 19, 4) at `times_s` (T,); see `set_arms`."""
    arm = np.empty((len(times_s), 1, len(PARTS) - 1, 4))
    set_arms(arm, (track,), times_s, seed=seed, noise_scale=noise_scale)
    return arm[:, 0]


def set_arms(
    arms: FloatArray,
    tracks: Sequence[ArmTrack],
    times_s: FloatArray,
    *,
    seed: int,
    noise_scale: float = 1.0,
    width: float = 0.0,
) -> None:
    """Fill in the rotations `arms` (T, A, 19, 4) of A arms at `times_s` (T,), with continuous quaternion signs; two
    cost little more than one. `noise_scale` (0 to 1) scales the noise of the keys. Each frame is the mean of its
    neighbours, weighted by a Gaussian of `width` frames, which takes away the steps in acceleration that splines have
    at their keys.

    Until the end the quaternions are four arrays of their parts (4, A, 19, F), since NumPy is several times as fast
    with what lies together in memory.
    """
    curves = splines(Curves.joined([_curves(track) for track in tracks]))
    reach = reach_of(width)
    for first in range(0, len(times_s), _BLOCK):
        block = arms[first : first + _BLOCK]
        near = np.arange(first - reach, first + len(block) + reach)
        near_s = times_s.take(near, mode="clip")
        parts = rotations_at(curves, near_s).T.reshape(4, len(tracks), len(PARTS), len(near))
        joints = _joints(_stirred(tracks, parts, near_s, seed, noise_scale=noise_scale))
        _keep_signs(joints)
        block[...] = (_smoothed(joints, width) if reach else joints).transpose(3, 1, 2, 0)
    if len(times_s) > _BLOCK:
        keep_signs(arms)


def _smoothed(joints: FloatArray, width: float) -> FloatArray:
    """The mean rotations (4, A, 19, T) of neighbours, of those (4, A, 19, T + 2 × `reach_of`) and as many before and
    after."""
    means = means_around(joints.reshape(-1, joints.shape[-1]), width).reshape(*joints.shape[:-1], -1)
    means /= np.sqrt(_dot(means, means))
    return means


def _keep_signs(joints: FloatArray) -> None:
    """`keep_signs` of parts (4, A, 19, T)."""
    turned = _dot(joints[..., 1:], joints[..., :-1]) < 0
    if turned.any():
        joints[..., 1:] *= np.cumprod(np.where(turned, -1.0, 1.0), axis=-1)


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    found = a[0] * b[0]
    for part in range(1, 4):
        found += a[part] * b[part]
    return np.asarray(found)


def _joints(parts: FloatArray) -> FloatArray:
    """`posing.arm_rotations` (4, A, 19, F) of parts (4, A, 20, F)."""
    joints = np.empty((4, parts.shape[1], len(PARTS) - 1, parts.shape[3]))
    joints[:, :, :2], joints[:, :, 3:] = parts[:, :, :2], parts[:, :, 4:]
    joints[:, :, 2] = multiply_parts(parts[:, :, 2], parts[:, :, 3])
    return joints


def _curves(track: ArmTrack) -> Curves:
    """The curve of each of `PARTS`, through the keys that define it."""
    keys = np.array([key.pose.parts for key in track.keys]).swapaxes(0, 1)
    said = ~np.isnan(keys[:, :, 3])
    shapes = np.array([(key.tension, key.continuity, key.bias) for key in track.keys])
    counts = said.sum(axis=1, dtype=np.intp)
    return Curves(_shifted(track).T[said], keys[said], shapes[said.nonzero()[1]], counts)


def _shifted(track: ArmTrack) -> FloatArray:
    """The time (K, 20) at which each part reaches each key. The follow-through grows with the time to the next key but
    never reorders keys; the first key is reached by all parts at once."""
    times_s = np.array([key.time_s for key in track.keys])
    until_next_s = np.append(np.diff(times_s), 0.0)
    since_last_s = np.append(np.inf, np.diff(times_s))
    most_s = np.minimum(FOLLOW_THROUGH_S, _SHARE_OF_INTERVAL * np.minimum(until_next_s, since_last_s))
    most_s *= [key.follow_through for key in track.keys]
    lags_s = np.array([key.follow_through for key in track.keys])[:, None] * _FINGER_LAGS_S
    reached_s = times_s[:, None] + most_s[:, None] * _DELAYS + lags_s
    reached_s[0] = times_s[0]
    return np.asarray(np.maximum(reached_s, reached_s[0] + _MOMENT_S * np.arange(len(times_s))[:, None]))


_STIRRED_ROWS = (slice(0, 5), slice(8, None, 3))
"""Of `PARTS`: the arm, and the roots of four fingers."""


@cache
def _stirs() -> FloatArray:
    """By how much each channel of noise turns each part that it stirs about its axes x, y and z, in half radians (3, 1,
    9, channels): joints only in directions in which they turn. Never mutated."""
    stir = {"Shoulder": (0.0, 0.5, 0.5), "UpperArm": (1.0, 1.0, 1.0), "Elbow": (0.0, 1.2, 0.0)}
    stir |= {"LowerArm": (1.5, 0.0, 0.0), "Hand": (0.0, 0.8, 1.4)}
    degrees = np.array([stir.get(part, (0.0, 0.0, 1.5)) for rows in _STIRRED_ROWS for part in PARTS[rows]])
    rows, axes = np.nonzero(degrees)
    spread = np.zeros((3, 1, len(degrees), len(rows)))
    spread[axes, 0, rows, np.arange(len(rows))] = np.radians(degrees[rows, axes]) / 2
    return spread


def _stirred(
    tracks: Sequence[ArmTrack], parts: FloatArray, times_s: FloatArray, seed: int, *, noise_scale: float
) -> FloatArray:
    """Parts (4, A, 20, T), changed in place, with Perlin noise, which "removes the freezing effect during the gesture
    hold" (paper §3.8)."""
    if not noise_scale:
        return parts
    stirs = noise_scale * _stirs()
    kinds = (Noise(_NOISE_HZ, 2 * seed + (track.side is not Hand.LEFT), stirs.shape[-1]) for track in tracks)
    noise = perlins(times_s, *kinds).T.reshape(len(tracks), -1, len(times_s))
    for arm, track in enumerate(tracks):
        noise[arm] *= np.interp(times_s, [key.time_s for key in track.keys], [key.noise for key in track.keys])
    turned, first = _turned(stirs @ noise), 0
    for rows in _STIRRED_ROWS:
        stirred = parts[:, :, rows]
        stirred[...] = multiply_parts(stirred, turned[:, :, first : first + stirred.shape[2]])
        first += stirred.shape[2]
    return parts


def _turned(halves: FloatArray) -> FloatArray:
    """The parts (4, …) of the rotations by twice these rotation vectors (3, …)."""
    x, y, z = halves
    angle = np.sqrt(x * x + y * y + z * z)
    turned = np.empty((4, *angle.shape))
    sine, turned[3] = sine_and_cosine(angle)
    np.multiply(halves, sine / np.maximum(angle, _NEAR_ZERO), out=turned[:3])
    return turned
