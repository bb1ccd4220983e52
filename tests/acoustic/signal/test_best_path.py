"""The best path against all paths."""

from itertools import pairwise, product

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from understudy.acoustic.signal.best_path import best_path


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
