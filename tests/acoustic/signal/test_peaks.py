"""Peaks of parabolas with known positions."""

import numpy as np
import pytest

from understudy.acoustic.signal.peaks import is_peak, peak_offsets


@pytest.mark.parametrize("offset", [-0.4, 0.0, 0.25])
def test_the_top_of_a_parabola_lies_where_it_does(offset: float) -> None:
    curve = 1 - (np.arange(5.0)[None] - 2 - offset) ** 2
    assert peak_offsets(curve, np.array([[2]])) == pytest.approx(offset)


def test_a_place_that_is_no_peak_is_hardly_moved() -> None:
    rising = np.array([[0.0, 1.0, 1.9, 2.0]])
    assert peak_offsets(rising, np.array([[0, 1, 3]])).tolist() == [[0.0, 0.5, 0.5]]


def test_edges_and_plateaus_count_as_peaks() -> None:
    assert is_peak(np.array([[3.0, 1.0, 2.0, 2.0, 1.0]])).tolist() == [[True, False, True, True, False]]
