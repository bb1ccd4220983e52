"""Correlations of motion models' scores: above chance only where the two streams go together in time."""

import numpy as np
import pytest

from understudy.model import FloatArray
from understudy.motion_models.scoring import correlation_of


def _streams(seed: int, lengths: tuple[int, ...]) -> list[FloatArray]:
    """Smooth streams (frames × 3), as those of arms are."""
    rng = np.random.default_rng(seed)
    window = np.hanning(41) / np.hanning(41).sum()
    made = (rng.normal(size=(length + 40, 3)) for length in lengths)
    return [np.stack([np.convolve(column, window, "valid") for column in each.T], axis=1) for each in made]


LENGTHS = (250, 400, 900, 2000)


def test_streams_that_have_nothing_to_do_with_each_other_are_at_chance_however_short_they_are() -> None:
    """Recordings of unlike length: a counterpart that were cut to the shorter one would correlate more by chance."""
    found = correlation_of(_streams(0, LENGTHS), _streams(1, LENGTHS))
    assert found.mean == pytest.approx(found.chance, abs=0.06)
    assert found.mean > 2 * found.together, "short smooth streams correlate by chance"
    assert found.together == pytest.approx(found.together_by_chance, abs=0.06)
    assert found.together < 0.35


def test_streams_that_go_together_are_above_chance() -> None:
    ones, noise = _streams(0, LENGTHS), _streams(1, LENGTHS)
    found = correlation_of(ones, [one + 2 * other for one, other in zip(ones, noise, strict=True)])
    assert found.mean > found.chance + 0.05
    assert found.together > found.together_by_chance + 0.15
