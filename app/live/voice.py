"""The contours of a signal as it arrives: energy and f0, a row each `FRAME_SHIFT_S`.

Energies equal those of a whole recording; f0 is close to it (`understudy.acoustic.pitch.streaming`). A row is given
when its f0 is final.
"""

import numpy as np

from ..acoustic.pitch.streaming import StreamingPitch
from ..acoustic.signal.frames import SHIFT_SAMPLES
from ..acoustic.signal.spectrum import FRAME_SAMPLES, energy_db
from ..model import FRAME_SHIFT_S, Audio, Contours, FloatArray

CONTEXT_FRAMES = -(-FRAME_SAMPLES // 2 // SHIFT_SAMPLES)
"""How many frames a window reaches into on either side."""

RECENT_FRAMES = 2000
LONGEST_FRAMES = 12_000
"""The longest stretch whose contours are given."""


class StreamingVoice:
    """Takes mono samples in [-1, 1] at `SAMPLE_RATE_HZ`. Memory is bounded."""

    def __init__(self) -> None:
        self._pitch = StreamingPitch()
        self._samples: FloatArray = np.empty(0)
        self._begin = self._frames = 0
        """The frame at which the kept samples begin, and the number of rows given."""

    def hear(self, samples: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Energy in dB and f0 in Hz (0: unvoiced) of the frames that are final after more samples."""
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


class RecentVoice:
    """The last `RECENT_FRAMES` of energy in dB and f0 in Hz."""

    def __init__(self) -> None:
        self._energy_db, self._f0_hz = np.empty(0), np.empty(0)
        self._begin = 0

    def hear(self, energy_db: FloatArray, f0_hz: FloatArray) -> None:
        """More of both."""
        heard = self._begin + len(self._f0_hz) + len(f0_hz)
        self._energy_db = np.concatenate([self._energy_db, energy_db])[-RECENT_FRAMES:]
        self._f0_hz = np.concatenate([self._f0_hz, f0_hz])[-RECENT_FRAMES:]
        self._begin = heard - len(self._f0_hz)

    @property
    def until_s(self) -> float:
        """The time up to which the voice was heard."""
        return (self._begin + len(self._f0_hz)) * FRAME_SHIFT_S

    def during(self, begin_s: float, end_s: float) -> Contours:
        """The contours of a stretch, without spectra; the medians for what was not heard or is no longer kept."""
        first = round(begin_s / FRAME_SHIFT_S)
        count = min(max(1, round((end_s - begin_s) / FRAME_SHIFT_S)), LONGEST_FRAMES)
        places = np.arange(first, first + count) - self._begin
        known = (places >= 0) & (places < len(self._f0_hz))
        voiced_hz = self._f0_hz[self._f0_hz > 0]
        energy_db = np.full(count, np.median(self._energy_db) if len(self._energy_db) else 0.0)
        f0_hz = np.full(count, np.median(voiced_hz) if len(voiced_hz) else 0.0)
        energy_db[known], f0_hz[known] = self._energy_db[places[known]], self._f0_hz[places[known]]
        return Contours(energy_db, f0_hz, np.empty((count, 0)), np.empty((count, 0), dtype=np.float32))
