"""Smoothing is scipy's Gaussian filter, however many curves there are."""

import numpy as np
import pytest
import scipy.ndimage

from understudy.realizer.geometry.smoothing import smooth, smoothed


@pytest.mark.parametrize("shape", [(200, 3), (200, 19, 4), (5, 1), (2, 19, 4)])
@pytest.mark.parametrize("width", [0.9, 1.8, 13.2])
def test_curves_are_smoothed_as_by_scipy(shape: tuple[int, ...], width: float) -> None:
    curves = np.random.default_rng(0).normal(size=shape)
    expected = scipy.ndimage.gaussian_filter1d(curves, width, axis=0, mode="nearest")
    assert np.abs(smoothed(curves, width) - expected).max() < 1e-12


@pytest.mark.parametrize("frames", [1, 5, 1920, 1925, 4500])
def test_long_curves_are_smoothed_in_place_as_whole_ones_are(frames: int) -> None:
    curves = np.random.default_rng(0).normal(size=(frames, 5, 4))
    expected = smoothed(curves, 1.8)
    smooth(curves[:, 1:4], 1.8)
    assert np.abs(curves[:, 1:4] - expected[:, 1:4]).max() < 1e-12
    assert np.array_equal(curves[:, ::4], np.random.default_rng(0).normal(size=(frames, 5, 4))[:, ::4])
