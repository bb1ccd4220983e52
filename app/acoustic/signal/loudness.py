"""The power of the signal every 10 ms, to tell sound from silence."""

import numpy as np

from ...model import SAMPLE_RATE_HZ, Audio, FloatArray

FRAME_S = 0.010


def frame_power(audio: Audio) -> FloatArray:
    """The mean square of successive intervals of `FRAME_S`; a shorter rest is left out, unless it is all there is."""
    length = round(FRAME_S * SAMPLE_RATE_HZ)
    samples = audio.samples if len(audio.samples) >= length else np.resize(audio.samples, length)
    frames = samples[: len(samples) // length * length].reshape(-1, length)
    power: FloatArray = np.einsum("ij,ij->i", frames, frames) / length  # without a copy of an hour's samples
    return power
