"""Hears a voice at any rate: its samples at ours, its contours, its phrases. Memory does not grow."""

import numpy as np
import soxr

from ..model import SAMPLE_RATE_HZ, FloatArray
from .phrases import PhraseEdge, Phrases
from .voice import StreamingVoice


class Ear:
    """Takes mono samples in [-1, 1] at `rate_hz`."""

    def __init__(self, rate_hz: int) -> None:
        same = rate_hz == SAMPLE_RATE_HZ
        self._resampler = None if same else soxr.ResampleStream(rate_hz, SAMPLE_RATE_HZ, 1, dtype="float64")
        self._voice, self._phrases = StreamingVoice(), Phrases()

    @property
    def phrase_began_s(self) -> float | None:
        """Where the phrase began that still goes on."""
        return self._phrases.began_s

    def resampled(self, samples: FloatArray, *, last: bool = False) -> FloatArray:
        """The samples at `SAMPLE_RATE_HZ`; the resampler keeps some milliseconds back."""
        samples = np.asarray(samples, dtype=np.float64)
        return samples if self._resampler is None else self._resampler.resample_chunk(samples, last)

    def contours(self, samples: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Energy in dB and f0 in Hz of the frames that are decided by more samples at `SAMPLE_RATE_HZ`."""
        return self._voice.hear(samples)

    def phrases(self, f0_hz: FloatArray) -> tuple[PhraseEdge, ...]:
        """Where phrases begin and end, by more of f0."""
        return self._phrases.hear(f0_hz)
