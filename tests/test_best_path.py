"""The best path against all paths."""

from itertools import pairwise, product

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from app.acoustic.best_path import best_path


@given(frames=st.integers(1, 5), columns=st.integers(1, 3), seed=st.integers(0, 10_000))
def test_no_path_is_better(frames: int, columns: int, seed: int) -> None:
    generator = np.random.default_rng(seed)
    gains = generator.normal(size=(frames, columns))
    costs = generator.random((frames - 1, columns, columns))

    def worth(path: tuple[int, ...]) -> float:
        gained = sum(gains[frame, column] for frame, column in enumerate(path))
        return float(gained - sum(costs[frame, after, before] for frame, (before, after) in enumerate(pairwise(path))))

    found = tuple(int(column) for column in best_path(gains, costs))
    np.testing.assert_allclose(worth(found), max(map(worth, product(range(columns), repeat=frames))))
