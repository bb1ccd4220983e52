"""Follow-through: hands lag behind their wrists, fingers lag behind the hand one after another, and never stand still.

A hand is not rigidly fixed to the forearm: it lags when the wrist starts, and swings on when the wrist stops. The
fingers do the same a little later, from the index to the little finger. The lag is a function of the delayed speed of
the wrist across the hand, so during a hold the hand has the pose of its gesture. In addition, each finger curls and
stretches slightly all the time.

Conventions: `posing.arm_joints` has the rows of an arm; the left arm's axes, mirrored for the right arm.
"""

import numpy as np

from ...model import FloatArray
from ..body.limits import MIRROR
from ..body.movement_style import Dragging
from ..geometry.curves import clipped, smoothed, soft_maximum
from ..geometry.noise import Noise, perlins
from ..geometry.rotations import from_rotation_vector, inverse, multiply, rotate, turn_about_z

_COLLARBONE, _UPPER_ARM, _LOWER_ARM, _HAND, _FINGERS = 0, 1, 2, 3, slice(7, 19)
_SMOOTH_S = 0.04
_MOST_RAD = float(np.radians(32.0))

_MIDDLE_JOINTS, _CLOSED = slice(8, 19, 3), 1.5
"""The intermediate joints of the fingers, and twice the sine of half their bend in a hand that is nearly a fist."""
_POINTING, _RELAXED = 0.7, 0.6
_SOFT_RAD, _MOST_CURL_RAD = float(np.radians(3.0)), float(np.radians(16.0))

_ASIDE = 0.4
"""The factor of sideways lag, towards thumb or little finger, relative to lag towards palm and back."""
_LIFE_HZ = 0.75

_AT_EASE = 0.4
"""The mean curl of the fingers at rest, as a share of the amplitude of their movement about it."""

_FRAMES_AT_ONCE = 2048
"""Frames whose fingers are curled at a time, so that long takes need little more memory."""

_JOINTS: FloatArray = np.array([1.0, 1.0, 0.7])
"""The shares of a finger's three joints in its curl."""

_MIRRORS: FloatArray = np.stack((np.ones(4), MIRROR))
"""What makes rotations of the left and the right arm those of two left ones."""
_CURLING: FloatArray = -_MIRRORS[:, 2:3]
"""The direction about z in which fingers of the left and the right arm curl."""


def drag(
    arms: FloatArray, wrists_m: FloatArray, times_s: FloatArray, style: Dragging, *, seed: int, life: float
) -> None:
    """Turn hands and fingers of the left and the right arm (T, 2, 19, 4), in place, by the paths of their wrists (2, T,
    3), seen from their own side; `life` (0 to 1) scales the curling of fingers at rest."""
    if len(times_s) < 2 or not (style.hand_deg or style.fingers_deg or style.life_deg):
        return
    step_s = float(times_s[1] - times_s[0])
    noise = perlins(times_s, Noise(_LIFE_HZ, 2 * seed + 1, 8)).reshape(-1, 2, 4)
    curls = np.radians(style.life_deg * life) * (noise + _AT_EASE)
    across = smoothed(_across_the_hands(arms, _speeds(wrists_m, step_s)), _SMOOTH_S / step_s)
    late = _delayed(across, style.hand_lag_s / step_s)
    turns = np.zeros((len(times_s), 2, 3))
    turns[..., 1] = _ASIDE * np.radians(style.hand_deg) * late[..., 1]
    turns[..., 2] = -np.radians(style.hand_deg) * late[..., 0]
    turned = from_rotation_vector(_at_most(turns)) * _MIRRORS
    lags = (style.hand_lag_s + (1 + finger) * style.finger_lag_s for finger in range(4))
    behind = np.array([_delayed(across[..., 0], lag_s / step_s) for lag_s in lags]).transpose(1, 2, 0)
    curled = np.radians(style.fingers_deg) * behind + curls
    arms[:, :, _HAND] = multiply(arms[:, :, _HAND], turned)
    for first in range(0, len(arms), _FRAMES_AT_ONCE):
        block = arms[first : first + _FRAMES_AT_ONCE]
        bends = (_CURLING * _within(curled[first : first + len(block)], block))[..., None] * _JOINTS
        turn_about_z(block[:, :, _FINGERS], bends.reshape(len(block), 2, -1))


def _speeds(wrists_m: FloatArray, step_s: float) -> FloatArray:
    """The velocities (T, 2, 3) of the wrists (2, T, 3): as by `np.gradient`, which takes longer."""
    places_m, speeds = wrists_m.swapaxes(0, 1), np.empty((wrists_m.shape[1], 2, 3))
    np.subtract(places_m[2:], places_m[:-2], out=speeds[1:-1])
    speeds[1:-1] /= 2 * step_s
    speeds[0], speeds[-1] = ((places_m[at + 1] - places_m[at]) / step_s for at in (0, -2))
    return speeds


def _across_the_hands(arms: FloatArray, speeds: FloatArray) -> FloatArray:
    """The speeds (T, 2, 2) of both wrists towards the back of the hand and towards the thumb."""
    upper = multiply(arms[:, :, _COLLARBONE], arms[:, :, _UPPER_ARM])
    hands = multiply(multiply(upper, arms[:, :, _LOWER_ARM]), arms[:, :, _HAND]) * _MIRRORS
    return np.asarray(rotate(inverse(hands), speeds)[..., 1:])


def _delayed(values: FloatArray, frames: float) -> FloatArray:
    """The values (T, …) delayed by this many frames."""
    return values.take(np.maximum(np.arange(len(values)) - round(frames), 0), axis=0)


def _at_most(angles: FloatArray) -> FloatArray:
    """Lags, limited smoothly to `_MOST_RAD` at any speed of the wrist."""
    return np.asarray(_MOST_RAD * np.tanh(angles / _MOST_RAD))


def _within(curled: FloatArray, arms: FloatArray) -> FloatArray:
    """Curls (T, 2, 4) limited to what the pose allows: a stretched finger stretches no further, a closed one hardly
    curls more, and one that is straight beside closed ones, because it points or counts, stays nearly straight."""
    closed = clipped(2 / _CLOSED * np.abs(arms[:, :, _MIDDLE_JOINTS, 2]), 0.0, 1.0)
    beside = clipped((closed.max(axis=-1, keepdims=True) - _RELAXED) / (1 - _RELAXED), 0.0, 1.0)
    free = (1 - closed) * (1 - _POINTING * beside)
    flexed = soft_maximum(curled, 0.0, _SOFT_RAD)
    return np.asarray(free * _MOST_CURL_RAD * np.tanh(flexed / _MOST_CURL_RAD))
