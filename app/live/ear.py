"""Hears a voice at any sample rate: its samples at ours, its contours, where its phrases begin and end, and the affect
of the current phrase so far.

The contours are energy and f0 as the signal arrives, a row each `FRAME_SHIFT_S`, given when its f0 is final. Energies
equal those of a whole recording; f0 is close to it (`understudy.acoustic.pitch.streaming`).

A phrase is a stretch of voiced speech, until it has been silent for `PAUSE_FRAMES`. Times are seconds of the stream; a
phrase's beginning is known `BEGIN_FRAMES` voiced frames after it, its end `PAUSE_FRAMES` after the last voiced one. For
the affect the last seconds of sound are kept and judged on demand. Memory is bounded.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import soxr

from ..acoustic.models import AcousticModels
from ..acoustic.pitch.streaming import StreamingPitch
from ..acoustic.signal.frames import SHIFT_SAMPLES
from ..acoustic.signal.spectrum import FRAME_SAMPLES, energy_db
from ..acoustic.stage import hear_sound
from ..model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Affect, Audio, Contours, FloatArray

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


BEGIN_FRAMES = 4
"""Fewer voiced frames in a row are a click, not a voice."""

PAUSE_FRAMES = 30


@dataclass(frozen=True, slots=True)
class PhraseEdge:
    """A phrase `begins`, or ends, at `at_s`."""

    at_s: float
    begins: bool


class Phrases:
    """Takes f0, a value each `FRAME_SHIFT_S` (0: unvoiced), and gives the edges of phrases."""

    def __init__(self) -> None:
        self._frames = self._voiced = 0
        self._silent = PAUSE_FRAMES
        self.began_s: float | None = None
        """The beginning of the current phrase; None between phrases."""

    def hear(self, f0_hz: FloatArray) -> tuple[PhraseEdge, ...]:
        return tuple(edge for f0 in f0_hz.tolist() for edge in self._frame(voiced=f0 > 0))

    def _frame(self, *, voiced: bool) -> Iterator[PhraseEdge]:
        self._frames += 1
        self._voiced = self._voiced + 1 if voiced else 0
        self._silent = 0 if voiced else self._silent + 1
        if self.began_s is None and self._voiced == BEGIN_FRAMES:
            self.began_s = (self._frames - BEGIN_FRAMES) * FRAME_SHIFT_S
            yield PhraseEdge(self.began_s, begins=True)
        elif self.began_s is not None and self._silent == PAUSE_FRAMES:
            self.began_s = None
            yield PhraseEdge((self._frames - PAUSE_FRAMES) * FRAME_SHIFT_S, begins=False)


class Ear:
    """Takes mono samples in [-1, 1] at `rate_hz`."""

    def __init__(self, rate_hz: int) -> None:
        same = rate_hz == SAMPLE_RATE_HZ
        self._resampler = None if same else soxr.ResampleStream(rate_hz, SAMPLE_RATE_HZ, 1, dtype="float64")
        self._voice, self._phrases = StreamingVoice(), Phrases()

    @property
    def phrase_began_s(self) -> float | None:
        """The beginning of the current phrase; None between phrases."""
        return self._phrases.began_s

    def resampled(self, samples: FloatArray, *, last: bool = False) -> FloatArray:
        """The samples at `SAMPLE_RATE_HZ`; the resampler keeps some milliseconds back."""
        samples = np.asarray(samples, dtype=np.float64)
        return samples if self._resampler is None else self._resampler.resample_chunk(samples, last)

    def contours(self, samples: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Energy in dB and f0 in Hz of the frames that are final after more samples at `SAMPLE_RATE_HZ`."""
        return self._voice.hear(samples)

    def phrases(self, f0_hz: FloatArray) -> tuple[PhraseEdge, ...]:
        """The edges of phrases in more f0."""
        return self._phrases.hear(f0_hz)


LONGEST_S = 6.0

SHORTEST_S = 0.8
"""A shorter part of a phrase is not judged."""


class RunningFeeling:
    """Takes mono samples in [-1, 1] at `SAMPLE_RATE_HZ`."""

    def __init__(self) -> None:
        self._recent: FloatArray = np.empty(0)
        self._last: Affect | None = None

    def hear(self, samples: FloatArray) -> None:
        """More of the voice."""
        self._recent = np.concatenate([self._recent, samples])[-round(LONGEST_S * SAMPLE_RATE_HZ) :]

    def of_phrase(self, acoustic: AcousticModels, lasting_s: float | None) -> Affect | None:
        """The affect of the current phrase, which has lasted so long; that of the phrase before if the current one is
        too short or there is none; None before the first."""
        if lasting_s is not None and lasting_s >= SHORTEST_S:
            samples = self._recent[-round(min(lasting_s, LONGEST_S) * SAMPLE_RATE_HZ) :]
            self._last = hear_sound(acoustic, Audio(samples))
        return self._last
