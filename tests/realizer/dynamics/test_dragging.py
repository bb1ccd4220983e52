"""Hands and fingers that come behind their wrists, one finger after another."""

import numpy as np
import pytest

from understudy.models import load_realizer
from understudy.realizer.dynamics.dragging import drag
from understudy.realizer.geometry.rotations import IDENTITY, angle_between

RATE_HZ = 240
INDEX, LITTLE = 7, 16
"""The first joints of the index and of the little finger in an arm's rows."""


def peaks_s(rows: tuple[int, ...]) -> list[float]:
    """When each of these joints is bent most after a wrist that was fastest at 1 s."""
    times_s = np.arange(0.0, 2.0, 1 / RATE_HZ)
    arms = np.tile(IDENTITY, (len(times_s), 2, 19, 1))
    wrists_m = np.zeros((2, len(times_s), 3))
    wrists_m[:, :, 1] = 0.3 * np.tanh((times_s - 1.0) / 0.1)
    drag(arms, wrists_m, times_s, load_realizer().style.dragging, seed=0, life=0.0)
    bends = angle_between(arms[:, 0, list(rows)], np.broadcast_to(IDENTITY, (len(times_s), len(rows), 4)))
    return [float(times_s[at]) for at in bends.argmax(axis=0)]


def test_the_hand_comes_behind_the_wrist_and_the_fingers_behind_the_hand() -> None:
    hand_s, index_s, little_s = peaks_s((3, INDEX, LITTLE))
    assert 1.0 < hand_s < index_s < little_s


def test_each_finger_is_30_to_80_ms_behind_its_neighbour() -> None:
    lags_s = np.diff(peaks_s(tuple(range(INDEX, LITTLE + 1, 3))))
    assert lags_s == pytest.approx(np.full(3, 0.055), abs=0.025)
