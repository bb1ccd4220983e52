"""Sines and cosines by the tangent of half the angle are NumPy's own, also where that tangent has a pole."""

import numpy as np

from understudy.realizer.geometry.trigonometry import sine_and_cosine


def test_sines_and_cosines_are_those_of_numpy() -> None:
    angles = np.concatenate([np.linspace(-20.0, 20.0, 4001), np.pi * np.arange(-5, 6)]).reshape(-1, 4)
    sine, cosine = sine_and_cosine(angles)
    assert np.abs(sine - np.sin(angles)).max() < 1e-14
    assert np.abs(cosine - np.cos(angles)).max() < 1e-14
