"""The positions of frames; frames in blocks equal those of the whole signal."""

import numpy as np
import pytest

from understudy.acoustic.signal.frames import (
    BLOCK,
    MULTIPLICATIONS,
    SHIFT_SAMPLES,
    blocks_of_frames,
    excerpt,
    frame_count,
    percentiles,
    product,
)
from understudy.model import FloatArray


def test_a_frame_is_centred_on_its_time() -> None:
    [(_, frames)] = blocks_of_frames(np.arange(1.0, 1001.0), 4, frame_count(1000))
    assert frames.tolist()[:2] == [[0, 0, 1, 2], [159, 160, 161, 162]]


@pytest.mark.parametrize("samples", [1, 159, 160, BLOCK * SHIFT_SAMPLES - 1, BLOCK * SHIFT_SAMPLES, 25_000])
def test_blocks_hold_every_frame_once(samples: int) -> None:
    signal = np.random.default_rng(0).normal(size=samples)
    frames = np.full((frame_count(samples), 400), np.nan)
    for block, some in blocks_of_frames(signal, 400, len(frames)):
        frames[block] = some
    padded = np.pad(signal, 200 + SHIFT_SAMPLES)[SHIFT_SAMPLES:]
    expected = [padded[160 * number : 160 * number + 400] for number in range(1 + samples // 160)]
    np.testing.assert_allclose(frames, expected, rtol=1e-6)


@pytest.mark.parametrize(("first", "end"), [(-3, 0), (-1, 2), (1, 3), (2, 9), (4, 6), (-2, 7)])
def test_an_excerpt_is_silent_outside_the_signal(first: int, end: int) -> None:
    signal = np.array([1.0, 2.0, 3.0, 4.0])
    expected = [signal[at] if 0 <= at < 4 else 0.0 for at in range(first, end)]
    assert excerpt(signal, first, end).tolist() == expected


def test_frames_may_begin_elsewhere() -> None:
    [(_, frames)] = blocks_of_frames(np.arange(1.0, 1001.0), 4, 2, shift=10, centre=5)
    assert frames.tolist() == [[4, 5, 6, 7], [14, 15, 16, 17]]


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


@pytest.mark.parametrize("count", [1, 2, 7, 10])
def test_percentiles_are_those_of_numpy(count: int) -> None:
    values, percents = np.random.default_rng(count).normal(size=count), (0, 10, 50, 90, 100)
    np.testing.assert_allclose(percentiles(values, *percents), np.percentile(values, percents), rtol=1e-14)
