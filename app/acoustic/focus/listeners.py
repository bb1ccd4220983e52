"""How likely listeners mark each word of a recording as emphasised, by a network trained on crowdsourced judgements.

The network is that of `emphases` (Morrison et al. 2024, "Crowdsourced and automatic speech prominence estimation"; MIT
licence), unchanged: it hears 80 Mel bands of the recording and judges its words and the silences between them. It was
trained on read American English. On words of TIMIT it agrees far better with what speakers accent than syllables'
prominence does, the two together better still (`benchmarks/acoustic/prominence.py`); of single syllables it knows
little.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ...loading import OnnxSession, load_session
from ...model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Audio, FloatArray, Interval, SingleArray, Word
from ..signal.fourier import rfft
from ..signal.frames import SHIFT_SAMPLES, blocks_of_frames, product
from ..signal.spectrum import mel_filters

WINDOW_SAMPLES = 1024
BANDS = 80
LEVEL = 0.08
"""The root mean square to which recordings are brought; read speech as it was taught on is about as loud."""

_LEAST_POWER = 1e-6
_LEAST_BAND = 1e-5
_QUIETEST = 1e-6
_SHORTEST_SILENCE_S = 0.001
_HANN = np.hanning(WINDOW_SAMPLES + 1)[:-1].astype(np.float32)


@dataclass(frozen=True, slots=True, eq=False)
class Listeners:
    """The network, as it was taught; thread-safe."""

    session: OnnxSession

    @classmethod
    def load(cls, path: Path) -> "Listeners":
        """Raises ServiceError `model_unreadable` where the file is missing or not such a model."""
        return cls(load_session(path, "a model for emphases"))

    def heard(self, audio: Audio, words: tuple[Word, ...]) -> dict[int, float]:
        """The log odds by the index of each word that has an interval."""
        timed = {word.index: word.interval for word in words if word.interval}
        if not timed:
            return {}
        return dict(zip(timed, self.log_odds(audio, tuple(timed.values())).tolist(), strict=True))

    def log_odds(self, audio: Audio, words: Sequence[Interval]) -> FloatArray:
        """The log odds that a listener marks each word, given the times of all words in order; shape (words,)."""
        levels = _levels(audio)
        parts, places = _with_silences(words, len(levels) * FRAME_SHIFT_S)
        edges_s = np.array([(part.start_s, part.end_s) for part in parts])
        firsts, ends = np.clip((edges_s / FRAME_SHIFT_S).astype(np.int64), 0, len(levels)).T
        heard = {"levels": np.ascontiguousarray(levels.T)[np.newaxis], "firsts": firsts, "ends": ends}
        (log_odds,) = self.session.run(["log_odds"], heard)
        return log_odds[places].astype(float)


def _levels(audio: Audio) -> SingleArray:
    """Natural logarithms of the magnitude in Mel bands (frames, `BANDS`); frame k is centred on (k + ½) × 10 ms."""
    samples = audio.samples
    loudness = float(np.sqrt(np.mean(np.square(samples)))) if len(samples) else 0.0
    gain = LEVEL / max(loudness, _QUIETEST)
    filters = mel_filters(WINDOW_SAMPLES, bands=BANDS, lowest_hz=0.0, highest_hz=SAMPLE_RATE_HZ / 2)
    bands = filters.T.astype(np.float32, order="C")
    levels = np.empty((max(len(samples) // SHIFT_SAMPLES, 1), BANDS), np.float32)
    for block, frames in blocks_of_frames(samples, WINDOW_SAMPLES, len(levels), centre=SHIFT_SAMPLES // 2):
        power = np.square(np.abs(rfft(frames * (gain * _HANN).astype(np.float32))))
        levels[block] = np.log(np.maximum(product(np.sqrt(power + _LEAST_POWER), bands), _LEAST_BAND))
    return levels


def _with_silences(words: Sequence[Interval], duration_s: float) -> tuple[list[Interval], list[int]]:
    """The words with the silences before, between and after them, and where the words are among these."""
    parts, places, last_s = list[Interval](), list[int](), 0.0
    for word in words:
        if word.start_s > last_s + _SHORTEST_SILENCE_S:
            parts.append(Interval(last_s, word.start_s))
        places.append(len(parts))
        parts.append(word)
        last_s = word.end_s
    if duration_s > last_s + _SHORTEST_SILENCE_S:
        parts.append(Interval(last_s, duration_s))
    return parts, places
