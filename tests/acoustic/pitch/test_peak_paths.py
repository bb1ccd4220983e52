"""Peaks of parabolas with known positions."""

from itertools import pairwise, product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from understudy.acoustic.pitch.peak_paths import best_path, is_peak, peak_offsets


@pytest.mark.parametrize("offset", [-0.4, 0.0, 0.25])
def test_the_top_of_a_parabola_lies_where_it_does(offset: float) -> None:
    curve = 1 - (np.arange(5.0)[None] - 2 - offset) ** 2
    assert peak_offsets(curve, np.array([[2]])) == pytest.approx(offset)


def test_a_place_that_is_no_peak_is_hardly_moved() -> None:
    rising = np.array([[0.0, 1.0, 1.9, 2.0]])
    assert peak_offsets(rising, np.array([[0, 1, 3]])).tolist() == [[0.0, 0.5, 0.5]]


def test_edges_and_plateaus_count_as_peaks() -> None:
    assert is_peak(np.array([[3.0, 1.0, 2.0, 2.0, 1.0]])).tolist() == [[True, False, True, True, False]]


@given(frames=st.integers(1, 5), columns=st.integers(1, 3), seed=st.integers(0, 10_000))
def test_no_path_is_better(frames: int, columns: int, seed: int) -> None:
    generator = np.random.default_rng(seed)
    gains = generator.normal(size=(frames, columns))
    positions = 2 * generator.random((frames, columns))

    def worth(path: tuple[int, ...]) -> float:
        places = [positions[frame, column] for frame, column in enumerate(path)]
        costs = sum(0.5 * min(abs(after - before), 1.0) for before, after in pairwise(places))
        return float(sum(gains[frame, column] for frame, column in enumerate(path)) - costs)

    found = tuple(int(column) for column in best_path(gains, positions, price=0.5))
    np.testing.assert_allclose(worth(found), max(map(worth, product(range(columns), repeat=frames))))


def test_a_path_longer_than_a_block_stays_in_its_place() -> None:
    gains = np.random.default_rng(0).normal(loc=[0.0, 0.0, 0.5], size=(1000, 3))
    assert (best_path(gains, np.broadcast_to([0.0, 2.0, 4.0], gains.shape), price=100.0) == 2).all()
