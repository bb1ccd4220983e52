"""Hears a signal as it comes: energy and f0, a row each `FRAME_SHIFT_S`.

Energies are those of the recording; f0 is near to it (`understudy.acoustic.pitch.streaming`). Rows leave when f0 is
decided.
"""

import numpy as np

from ..acoustic.pitch.streaming import StreamingPitch
from ..acoustic.signal.frames import SHIFT_SAMPLES
from ..acoustic.signal.spectrum import FRAME_SAMPLES, energy_db
from ..model import Audio, FloatArray

CONTEXT_FRAMES = -(-FRAME_SAMPLES // 2 // SHIFT_SAMPLES)
"""How many frames before and after a frame's its window reaches into."""


class StreamingVoice:
    """Takes mono samples in [-1, 1] at `SAMPLE_RATE_HZ`. Memory does not grow."""

    def __init__(self) -> None:
        self._pitch = StreamingPitch()
        self._samples: FloatArray = np.empty(0)
        self._begin = self._frames = 0
        """The frame at which the kept samples begin, and how many have left."""

    def hear(self, samples: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Energy in dB and f0 in Hz (0: unvoiced) of the frames that are decided by more samples."""
        return self._rows(samples, last=False)

    def finish(self) -> tuple[FloatArray, FloatArray]:
        """The remaining rows, when the signal has ended."""
        return self._rows(np.empty(0), last=True)

    def _rows(self, samples: FloatArray, *, last: bool) -> tuple[FloatArray, FloatArray]:
        self._samples = np.concatenate([self._samples, samples])
        f0_hz = self._pitch.hear(samples)
        if last:
            f0_hz = np.concatenate([f0_hz, self._pitch.finish()])
        first, self._frames = self._frames - self._begin, self._frames + len(f0_hz)
        end = (first + len(f0_hz) + CONTEXT_FRAMES) * SHIFT_SAMPLES
        levels_db = energy_db(Audio(self._samples[:end]))[first : first + len(f0_hz)] if len(f0_hz) else np.empty(0)
        dropped = max(0, self._frames - CONTEXT_FRAMES - self._begin)
        self._samples = self._samples[dropped * SHIFT_SAMPLES :]
        self._begin += dropped
        return levels_db, f0_hz
