"""A product in parts is the product, whatever the number of rows."""

import numpy as np
import pytest

from understudy.acoustic.signal.products import MULTIPLICATIONS, product
from understudy.model import FloatArray


@pytest.mark.parametrize("rows", [0, 1, 26, 27, 500])
@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_it_is_the_product(rows: int, kind: type) -> None:
    chance = np.random.default_rng(0)
    one: FloatArray = chance.random((rows, 100)).astype(kind)
    other: FloatArray = chance.random((100, 100)).astype(kind)
    found = product(one, other)
    assert found.dtype == kind
    np.testing.assert_allclose(found, one @ other, rtol=1e-5)


def test_a_matrix_that_is_too_large_for_one_row_is_taken_all_the_same() -> None:
    matrix = np.ones((2, MULTIPLICATIONS))
    assert product(np.ones((3, 2)), matrix)[:, 0].tolist() == [2.0, 2.0, 2.0]
