"""The frames that all contours share: frame k is centred on k × `FRAME_SHIFT_S`, however long it is.

The signal counts as silent outside itself. Frames come in blocks that fit into the processor's cache, so that half an
hour takes little more memory than a minute. They are in single precision, as fine as a recording of 24 bits, since
spectra take half the time in it.
"""

from collections.abc import Iterator

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from ...model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, FloatArray, SingleArray

SHIFT_SAMPLES = round(FRAME_SHIFT_S * SAMPLE_RATE_HZ)
BLOCK = 96
"""Frames in a block."""


def frame_count(samples: int) -> int:
    """How many frames a signal of so many samples has."""
    return 1 + samples // SHIFT_SAMPLES


def blocks_of_frames(
    signal: FloatArray, length: int, count: int, *, shift: int = SHIFT_SAMPLES, centre: int = 0
) -> Iterator[tuple[slice, SingleArray]]:
    """So many frames of `length` samples (an even number), the first around `centre`, each `shift` after the last.

    They come `BLOCK` at a time: which they are, and their samples (frames × length).
    """
    before = centre - length // 2
    for first in range(0, count, BLOCK):
        end = min(first + BLOCK, count)
        stretch = excerpt(signal, before + first * shift, before + (end - 1) * shift + length)
        yield slice(first, end), sliding_window_view(stretch, length)[::shift]


def excerpt(signal: FloatArray, first: int, end: int) -> SingleArray:
    """The samples from `first` up to `end`, either of which may lie outside the signal."""
    stretch = np.zeros(end - first, dtype=np.float32)
    inside = signal[max(first, 0) : max(end, 0)]
    begin = max(-first, 0)
    stretch[begin : begin + len(inside)] = inside
    return stretch
