"""How loud the signal is, 10 ms by 10 ms: enough to tell sound from silence."""

import numpy as np

from ...model import SAMPLE_RATE_HZ, Audio, FloatArray

FRAME_S = 0.010


def frame_power(audio: Audio) -> FloatArray:
    """Mean square of each stretch of `FRAME_S`, one after the other; a rest shorter than that is left out.

    Audio shorter than one stretch counts as one.
    """
    length = round(FRAME_S * SAMPLE_RATE_HZ)
    samples = audio.samples if len(audio.samples) >= length else np.resize(audio.samples, length)
    frames = samples[: len(samples) // length * length].reshape(-1, length)
    power: FloatArray = np.einsum("ij,ij->i", frames, frames) / length  # without a copy of an hour's samples
    return power
