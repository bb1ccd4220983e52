"""Prepares a signal for the decoder: 16-bit, normalized, padded with faint noise, counted in frames."""

import numpy as np

from ...model import SAMPLE_RATE_HZ, FloatArray

FRAMES_PER_S = 100
FRAME_SAMPLES = SAMPLE_RATE_HZ // FRAMES_PER_S
PADDING_FRAMES = FRAMES_PER_S // 5

PEAK = 0.9
NOISE_AMPLITUDE = 3e-4
NOISE_SEED = 20_200


def pcm(samples: FloatArray) -> bytes:
    """The signal with `PADDING_FRAMES` of noise before and after it; deterministic."""
    noise = np.random.default_rng(NOISE_SEED).standard_normal(2 * PADDING_FRAMES * FRAME_SAMPLES) * NOISE_AMPLITUDE
    before, after = np.split(noise, 2)
    peak = float(np.abs(samples).max(initial=0.0)) or 1.0
    padded = np.concatenate([before, samples * (PEAK / peak), after])
    return (padded * 32767).round().astype("<i2").tobytes()
