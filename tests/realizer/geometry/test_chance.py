"""Generators draw what NumPy's draw, from the beginning each time."""

import numpy as np
import pytest

from understudy.realizer.geometry.chance import generator_of


@pytest.mark.parametrize("seed", [(0,), (7,), (2**64 - 1,), (0, 123456789), (3, 123456789, 2)])
def test_a_generator_draws_what_numpys_does_each_time(seed: tuple[int, ...]) -> None:
    expected = np.random.default_rng(seed if len(seed) > 1 else seed[0]).normal(size=20)
    for _again in range(2):
        assert np.array_equal(generator_of(*seed).normal(size=20), expected)


def test_generators_of_one_seed_do_not_draw_from_each_other() -> None:
    one, other = generator_of(5), generator_of(5)
    drawn = one.random(3)
    assert np.array_equal(other.random(3), drawn)
    assert not np.array_equal(one.random(3), drawn)
