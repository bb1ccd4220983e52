"""Mel filter banks over the bins of a power spectrum.

The scale is Slaney's (Auditory Toolbox, 1998): 3 / 200 Mel per Hz up to 1 kHz, and 27 Mel per factor of 6.4 above.
Filters are triangles between the centres of their neighbours, normalized to area 1 over Hz.
"""

import numpy as np

from ...model import SAMPLE_RATE_HZ, FloatArray

_LINEAR_UP_TO_HZ = 1000.0
_HZ_PER_MEL = 200 / 3
_LINEAR_UP_TO_MEL = _LINEAR_UP_TO_HZ / _HZ_PER_MEL
_LOG_STEP = np.log(6.4) / 27
"""Log frequency per Mel above `_LINEAR_UP_TO_HZ`."""


def mel_filters(transform_samples: int, *, bands: int, lowest_hz: float, highest_hz: float) -> FloatArray:
    """The filters (bands, 1 + transform_samples // 2) of bands from `lowest_hz` to `highest_hz`."""
    bins_hz = np.fft.rfftfreq(transform_samples, 1 / SAMPLE_RATE_HZ)
    lowest, highest = _mel(np.array([lowest_hz, highest_hz]))
    edges_hz = _hz(np.linspace(lowest, highest, bands + 2))
    widths_hz = np.diff(edges_hz)[:, None]
    from_edges_hz = bins_hz - edges_hz[:, None]
    rising, falling = from_edges_hz[:-2] / widths_hz[:-1], -from_edges_hz[2:] / widths_hz[1:]
    heights = 2 / (edges_hz[2:] - edges_hz[:-2])[:, None]
    filters: FloatArray = heights * np.maximum(np.minimum(rising, falling), 0.0)
    return filters


def _mel(hz: FloatArray) -> FloatArray:
    above = np.log(np.maximum(hz, _LINEAR_UP_TO_HZ) / _LINEAR_UP_TO_HZ) / _LOG_STEP
    mel: FloatArray = np.minimum(hz, _LINEAR_UP_TO_HZ) / _HZ_PER_MEL + above
    return mel


def _hz(mel: FloatArray) -> FloatArray:
    linear = np.minimum(mel, _LINEAR_UP_TO_MEL) * _HZ_PER_MEL
    hz: FloatArray = linear * np.exp(_LOG_STEP * np.maximum(mel - _LINEAR_UP_TO_MEL, 0.0))
    return hz
