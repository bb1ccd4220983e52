"""Noise is bounded, smooth, zero at its lattice points, and the same whenever it is asked for."""

import numpy as np
import pytest

from understudy.realizer.geometry.noise import Noise, perlin, perlins

TIMES_S = np.arange(-600, 6000) / 600


def test_noise_is_zero_at_lattice_points_and_moves_between_them() -> None:
    at_points = perlin(np.arange(-5, 50) / 2.0, frequency_hz=2.0, seed=1, channels=3)
    assert np.allclose(at_points, 0)
    noise = perlin(TIMES_S, frequency_hz=2.0, seed=1, channels=3)
    assert noise.shape == (len(TIMES_S), 3)
    assert np.abs(noise).max() <= 1
    assert np.all(noise.std(axis=0) > 0.15)


def test_channels_out_of_step_are_never_all_at_zero() -> None:
    together, apart = (perlin(TIMES_S, frequency_hz=2.0, seed=1, channels=4, in_step=step) for step in (True, False))
    assert np.abs(together).max(axis=1).min() < 1e-9
    assert np.abs(apart).max(axis=1).min() > 0.01
    assert np.array_equal(apart[:, 0], together[:, 0])


def test_noise_has_no_step_in_place_speed_or_acceleration() -> None:
    """Steps would grow relative to the next difference as the sampling gets finer; here each shrinks with it."""
    noise = perlin(TIMES_S, frequency_hz=1.0, seed=7)[:, 0]
    step_s = TIMES_S[1] - TIMES_S[0]
    for order, bound in ((1, 4.0), (2, 16.0), (3, 200.0)):
        assert np.abs(np.diff(noise, order)).max() / step_s**order < bound


@pytest.mark.parametrize("seed", [0, 1, -3, 2**70])
def test_a_moment_has_its_noise_whatever_is_asked_for_with_it(seed: int) -> None:
    whole = perlin(TIMES_S, frequency_hz=0.7, seed=seed, channels=2)
    assert np.array_equal(whole[1234:1240], perlin(TIMES_S[1234:1240], frequency_hz=0.7, seed=seed, channels=2))
    assert np.array_equal(whole[:, :1], perlin(TIMES_S, frequency_hz=0.7, seed=seed))


def test_seeds_and_channels_differ() -> None:
    one, other = (perlin(TIMES_S, frequency_hz=3.0, seed=seed, channels=2) for seed in (1, 2))
    together = np.corrcoef(np.concatenate([one, other], axis=1).T)
    assert np.abs(together[~np.eye(4, dtype=bool)]).max() < 0.5


def test_no_moments_have_no_noise() -> None:
    assert perlin(np.zeros(0), frequency_hz=1.0, seed=0, channels=4).shape == (0, 4)


def test_kinds_of_noise_together_are_those_of_each_alone() -> None:
    kinds = Noise(0.05, 3), Noise(2.3, 4, 6, in_step=False), Noise(0.7, -1, 2)
    alone = [
        perlin(TIMES_S, frequency_hz=kind.frequency_hz, seed=kind.seed, channels=kind.channels, in_step=kind.in_step)
        for kind in kinds
    ]
    assert np.abs(perlins(TIMES_S, *kinds) - np.concatenate(alone, axis=1)).max() < 1e-12


def test_noise_goes_on_beyond_the_lattice_points_whose_slopes_are_kept() -> None:
    at_edge_s = 63.0 + np.arange(-40, 41) / 40
    across = perlin(at_edge_s, frequency_hz=1.0, seed=4, channels=3)
    halves = [perlin(part, frequency_hz=1.0, seed=4, channels=3) for part in (at_edge_s[:30], at_edge_s[30:])]
    assert np.array_equal(across, np.concatenate(halves))
    assert np.abs(np.diff(across, 2, axis=0)).max() < 0.02
