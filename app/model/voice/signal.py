"""The sound of a line: the recording and what is measured in it frame by frame, how its speaker usually sounds (the
statistics of other recordings, by which an utterance is normalized), or, without a recording, how its text says that it
is to be spoken.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.floating]
SingleArray = NDArray[np.float32]

SAMPLE_RATE_HZ = 16_000
"""The sample rate of every signal that passes between the stages."""

FRAME_SHIFT_S = 0.010
"""One analysis frame every 10 ms: frame k is centred on k × 10 ms (paper §3.1.1, §3.1.2)."""


@dataclass(frozen=True, slots=True, eq=False)
class Audio:
    """One mono signal at `SAMPLE_RATE_HZ`; full scale is ±1. Single precision once decoded, as fine as 24 bits."""

    samples: FloatArray

    @property
    def duration_s(self) -> float:
        return len(self.samples) / SAMPLE_RATE_HZ


@dataclass(frozen=True, slots=True, eq=False)
class Contours:
    """One row a frame (`FRAME_SHIFT_S`): energy in dB, f0 in Hz (0: unvoiced), 12 MFCC, and their Mel bands in dB."""

    energy_db: FloatArray
    f0_hz: FloatArray
    mfcc: FloatArray
    mel_db: SingleArray


@dataclass(frozen=True, slots=True, eq=False)
class VoiceQuality:
    """Frame-wise measures, shape (frames,) each; the first is meaningful in voiced frames only.

    harmonicity_db: harmonics-to-noise ratio (Boersma 1993), from the autocorrelation at the period, divided by that of
        the window; the minimum where the frame is unvoiced.
    cepstral_peak_db: cepstral peak prominence between 60 and 500 Hz over a regression line (Hillenbrand, Cleveland &
        Erickson 1994).
    tilt_db: power from 1 to 5 kHz over power from 50 Hz to 1 kHz.
    peak_slope: slope of wavelet peaks over octaves (`understudy.acoustic.agitation.voice_quality`).
    """

    harmonicity_db: FloatArray
    cepstral_peak_db: FloatArray
    tilt_db: FloatArray
    peak_slope: FloatArray


@dataclass(frozen=True, slots=True)
class Speaking:
    """The `emphasized` words; `pauses_s`, pauses in seconds by the word that they follow (-1: before the first), which
    replace those of punctuation; `rates`, speeds of words other than 1; `unread_tags`, names of tags that say nothing
    here."""

    emphasized: frozenset[int] = frozenset()
    pauses_s: tuple[tuple[int, float], ...] = ()
    rates: tuple[tuple[int, float], ...] = ()
    unread_tags: tuple[str, ...] = ()

    def pause_s(self, word: int, usual_s: float) -> float:
        """The pause after a word, in seconds."""
        return dict(self.pauses_s).get(word, usual_s)

    def slowness(self, word: int) -> float:
        """How much longer than usual a word lasts."""
        return 1 / dict(self.rates).get(word, 1.0)


PLAINLY_SPOKEN = Speaking()


@dataclass(frozen=True, slots=True, eq=False)
class SpeakerReference:
    """A speaker's statistics over `recordings` recordings; `mean` and `deviation` have shape (features,)."""

    feature_set: str
    recordings: int
    mean: FloatArray
    deviation: FloatArray

    @classmethod
    def of(cls, feature_set: str, rows: Sequence[FloatArray] | FloatArray) -> "SpeakerReference":
        """The statistics of `rows`, the features of at least one recording each."""
        return cls(feature_set, len(rows), np.mean(rows, axis=0), np.std(rows, axis=0))
