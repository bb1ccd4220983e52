"""Energy and Mel-frequency cepstral coefficients (MFCC), every 10 ms (paper §3.1.1, §3.1.2); and, by the power of the
signal, sound and silence: the signal-to-background ratio, and whether it suffices to judge agitation.

Frames are 32 ms long and placed as in `understudy.acoustic.signal.frames`. Levels are in dB re full scale squared, so
that energy is 0 dB where the windowed samples' squares sum to 1.

The Mel filters and cepstral coefficients are librosa's, as matrices by which a spectrum is multiplied. The scale is
Slaney's (Auditory Toolbox, 1998), linear up to 1 kHz and logarithmic beyond; filters are triangles of area 1 over
hertz. Both are constants of librosa's, and importing librosa takes longer than analysing a line, and 180 MB
(docs/measurements/speed.md): so it is imported only if a matrix is not cached (`understudy.cache`).
"""

from collections.abc import Callable
from functools import cache
from importlib.metadata import version

import numpy as np

from ...cache import Cache
from ...model import SAMPLE_RATE_HZ, Audio, FloatArray, Notice, SingleArray
from .fourier import rfft
from .frames import blocks_of_frames, frame_count, product

FRAME_SAMPLES = round(0.032 * SAMPLE_RATE_HZ)

ENERGY_FLOOR_DB = -100.0
"""The energy of digital silence: some 20 dB below the rounding noise of 16-bit samples (about -78 dB per frame)."""

_LEAST_POWER = 1e-20
"""The minimum power of a Mel band, for digital silence."""

MEL_BANDS = 40

MEL_MIN_HZ = 80.0
"""Below the voice there is only rumble, which identifies the recording, not the voice."""

MEL_RANGE_DB = 50.0
"""Bands are clamped to at most this far below the loudest of the utterance, so that the cepstrum does not follow
noise."""

COEFFICIENTS = 12

_HAMMING = np.hamming(FRAME_SAMPLES + 1)[:-1].astype(np.float32)
_HANN = np.hanning(FRAME_SAMPLES + 1)[:-1].astype(np.float32)


def energy_db(audio: Audio) -> FloatArray:
    """The energy of each frame in dB, 10 log10 of the sum of the squared Hamming-windowed samples (paper §3.1.2, eq. 1,
    2).

    At least `ENERGY_FLOOR_DB`; shape (frames,).
    """
    energy = np.empty(frame_count(len(audio.samples)))
    for block, frames in blocks_of_frames(audio.samples, FRAME_SAMPLES, len(energy)):
        energy[block] = np.sum(np.square(frames * _HAMMING), axis=1)
    decibels: FloatArray = 10 * np.log10(np.maximum(energy, 10 ** (ENERGY_FLOOR_DB / 10)))
    return decibels


def mfcc(levels_db: SingleArray, *, range_db: float = MEL_RANGE_DB) -> SingleArray:
    """Mel-frequency cepstral coefficients 1 to 12 from Mel levels; shape (frames, 12) (paper §3.1.1).

    The paper does not say which 12. Coefficient 0, the mean level in dB, is left out, since it depends on the
    recording's gain rather than the voice. The result does not depend on the signal's scale: faint bands are clamped
    relative to the loudest (`python -m benchmarks.acoustic.agitation --ablation` shows the effect of this and of the
    lower band edge).
    """
    basis = cepstral_basis(levels_db.shape[1], 1 + COEFFICIENTS)[:, 1:].astype(np.float32, order="C")
    return product(np.maximum(levels_db - levels_db.max(), -range_db), basis)


def mel_db(audio: Audio, *, min_hz: float = MEL_MIN_HZ) -> SingleArray:
    """The level of each Mel band of Hann-windowed frames; shape (frames, `MEL_BANDS`)."""
    filters = mel_filters(FRAME_SAMPLES, bands=MEL_BANDS, lowest_hz=min_hz, highest_hz=SAMPLE_RATE_HZ / 2)
    bands = filters.T.astype(np.float32, order="C")
    levels_db = np.empty((frame_count(len(audio.samples)), MEL_BANDS), dtype=np.float32)
    for block, frames in blocks_of_frames(audio.samples, FRAME_SAMPLES, len(levels_db)):
        power = np.square(np.abs(rfft(frames * _HANN)))
        levels_db[block] = 10 * np.log10(np.maximum(product(power, bands), _LEAST_POWER))
    return levels_db


@cache
def mel_filters(transform_samples: int, *, bands: int, lowest_hz: float, highest_hz: float) -> FloatArray:
    """The filters (bands, 1 + transform_samples // 2) over the bins of a power spectrum, for bands of equal width on
    the Mel scale from `lowest_hz` to `highest_hz`; read-only."""

    def make() -> FloatArray:
        from librosa.filters import mel

        filters: FloatArray = mel(
            sr=SAMPLE_RATE_HZ,
            n_fft=transform_samples,
            n_mels=bands,
            fmin=lowest_hz,
            fmax=highest_hz,
            dtype=np.float64,
        )
        return filters

    return _kept(f"mel_filters_{transform_samples}_{bands}_{lowest_hz:g}_{highest_hz:g}", make)


@cache
def cepstral_basis(bands: int, coefficients: int) -> FloatArray:
    """The matrix from levels (…, bands) to MFCC 0 to `coefficients` - 1, shape (bands, coefficients); read-only.

    MFCC are linear in the levels, so its rows are the MFCC of each band alone.
    """

    def make() -> FloatArray:
        from librosa.feature import mfcc

        basis: FloatArray = mfcc(S=np.eye(bands), n_mfcc=coefficients, dct_type=2, norm="ortho").T
        return np.ascontiguousarray(basis)

    return _kept(f"cepstral_basis_{bands}_{coefficients}", make)


def _kept(name: str, make: Callable[[], FloatArray]) -> FloatArray:
    matrix = Cache.of_environment().kept(name, (), make, made_with=f"librosa {version('librosa')}")
    matrix.setflags(write=False)
    return matrix


LEAST_TRUSTED_DB = 12.0
"""The lowest ratio in the training data of the agitation models (`training/agitation/degradations.py`).

At 6 dB they lose .2 of balanced accuracy on RAVDESS. No quiet recording that they were trained on is below 16 dB.
"""

_FAINTEST_PERCENT = 5
_DEEPEST_DB = 60.0
"""Frames further below the loudest are digital silence, not background."""

FRAME_S = 0.010


def above_background_db(energy_db: FloatArray) -> float:
    """The mean power relative to that of the faintest frames, which are background in pauses and stop closures; dB.

    For steady noise and sentences of two seconds the error is .5 dB. Without pauses the background is overestimated.
    """
    heard_db = energy_db[energy_db >= energy_db.max() - _DEEPEST_DB]
    return float(10 * np.log10(np.mean(10 ** (heard_db / 10))) - np.percentile(heard_db, _FAINTEST_PERCENT))


def doubts(energy_db: FloatArray) -> tuple[Notice, ...]:
    """The notice `agitation_unsure` if the energy (frames,) indicates too much noise."""
    above_db = above_background_db(energy_db)
    if above_db >= LEAST_TRUSTED_DB:
        return ()
    message = (
        f"the voice is only {above_db:.0f} dB above the noise: the measured agitation may be wrong; give it if known"
    )
    return (Notice("agitation_unsure", message),)


def frame_power(audio: Audio) -> FloatArray:
    """The mean square of successive intervals of `FRAME_S`; a shorter rest is left out, unless it is all there is."""
    length = round(FRAME_S * SAMPLE_RATE_HZ)
    samples = audio.samples if len(audio.samples) >= length else np.resize(audio.samples, length)
    frames = samples[: len(samples) // length * length].reshape(-1, length)
    power: FloatArray = np.einsum("ij,ij->i", frames, frames) / length  # without a copy of an hour's samples
    return power
