"""Fundamental frequency (f0) tracking by summation of residual harmonics (SRH).

Inverse filtering by linear prediction removes the vocal tract; what remains of a voiced sound is a pulse train, whose
spectrum has peaks of equal height at the multiples of f0 (`understudy.acoustic.pitch.harmonics`). Source: paper §3.1.3,
eq. 3; Drugman & Alwan, "Joint robust voicing detection and pitch estimation based on residual harmonics" (Interspeech
2011).

Frame k is centred on k × `FRAME_SHIFT_S`; frequencies are in Hz. `TUNED` differs from `PUBLISHED` in these points,
measured together by `benchmarks.acoustic.pitch`:

- A path of least cost through each frame's ten best candidates replaces the best candidate of each frame: most octave
  errors vanish. Faint frames have less weight, since they may contain other voices or none.
- In eq. 3 a candidate at three times f0, or at other odd multiples, scores as high as f0 itself if the harmonics are
  even, since no valley of its comb falls on them. So a share of the SRH at f / 3, f / 5 or f / 7, whichever is
  greatest, is subtracted from that at f in the search; f0 itself has little there.
- The energy is normalized below 3.5 kHz and extrapolated, instead of over the whole spectrum. This makes no difference
  for wide-band recordings, and keeps the voicing of speech recorded at 8 kHz.
- Where pitch moves fast, the window of 100 ms blurs it; the period is refined in one of 40 ms.
- Voicing is decided by more than the SRH (`understudy.acoustic.pitch.voicing`).
- The second pass searches further than an octave below the speaker's median, where sentences end in creaky voice.

Parabolic interpolation refines the frequency of each peak.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...model import SAMPLE_RATE_HZ, Audio, FloatArray, SingleArray
from ..signal.frames import BLOCK, frame_count
from .harmonics import BIN_HZ, CANDIDATES_HZ, LOWEST_F0_HZ, best_path, is_peak, peak_offsets, summed_harmonics
from .voicing import (
    SRH_ALONE,
    WEIGHED,
    WIDEST_BELOW_LOUD_DB,
    Levels,
    Voicing,
    band_levels,
    band_power,
    measures,
    periods_nearby,
    voiced_frames,
)

ODD_DIVISORS = (3, 5, 7)
RANGE_THRESHOLD = 0.1
"""The SRH above which a frame is used to estimate the speaker's range in the first pass."""

_CANDIDATES_PER_FRAME = 10

_Halves = NDArray[np.float16]
"""SRH is kept in half precision: half an hour has 43 million values."""


@dataclass(frozen=True, slots=True)
class Tuning:
    """The parameters of the tracker.

    speaker_range: multiples of the first pass's median between which the second pass searches.
    unit_energy_band_hz: the energy from 0 Hz to here is normalized to 1.
    octave_cost: cost, in SRH, of an octave jump between neighbouring frames; larger jumps cost no more.
    faintest_weight: weight in the path of frames 25 dB below the loud ones, which have weight 1.
    submultiple_share: share of the SRH at f / 3, f / 5 or f / 7 that is subtracted from that at f.
    refines: whether f0 is refined to the best period nearby (`understudy.acoustic.pitch.voicing`).
    voicing: how voiced frames are found.
    """

    speaker_range: tuple[float, float]
    unit_energy_band_hz: int
    octave_cost: float
    faintest_weight: float
    submultiple_share: float
    refines: bool
    voicing: Voicing


PUBLISHED = Tuning(
    speaker_range=(0.5, 2.0),
    unit_energy_band_hz=SAMPLE_RATE_HZ // 2,
    octave_cost=0.0,
    faintest_weight=1.0,
    submultiple_share=0.0,
    refines=False,
    voicing=SRH_ALONE,
)
TUNED = Tuning(
    speaker_range=(0.4, 2.0),
    unit_energy_band_hz=3500,
    octave_cost=0.15,
    faintest_weight=0.05,
    submultiple_share=0.35,
    refines=True,
    voicing=WEIGHED,
)


def track_f0(audio: Audio, tuning: Tuning = TUNED) -> FloatArray:
    """The f0 in Hz of each frame, 0 where unvoiced; `1 + len(samples) // 160` frames (paper §3.1.3, eq. 3)."""
    f0_hz, evidence = pitch_if_voiced(audio, tuning)
    return np.where(voiced_frames(evidence, tuning.voicing), f0_hz, 0.0)


def pitch_if_voiced(audio: Audio, tuning: Tuning = TUNED) -> tuple[FloatArray, FloatArray]:
    """The best f0 in Hz of every frame, voiced or not, and the evidence of voicing (`voicing.measures`)."""
    candidates = _best_candidates(audio.samples, tuning)
    power = band_power(audio.samples)
    levels = band_levels(power)
    gains = candidates.merits * frame_weights(levels, tuning.faintest_weight)[:, None]
    path = best_path(gains, candidates.octaves, tuning.octave_cost)
    f0_hz, srh = (_along(path, each) for each in (candidates.f0_hz, candidates.srh))
    refined_hz, correlation = periods_nearby(power, f0_hz)
    return refined_hz if tuning.refines else f0_hz, measures(srh, correlation, levels)


def _along(path: NDArray[np.intp], table: FloatArray) -> FloatArray:
    """The table's value in the path's column of every frame."""
    return np.take_along_axis(table, path[:, None], axis=1)[:, 0].astype(np.float64)


@dataclass(frozen=True, slots=True, eq=False)
class Candidates:
    """The ten best candidates of every frame (frames × 10).

    numbers: indices into `CANDIDATES_HZ`.
    merits: scores for the path search; minus infinity where a frame has fewer than ten candidates.
    f0_hz: frequency of the interpolated peak.
    srh: SRH of the candidate.
    """

    numbers: NDArray[np.uint8]
    merits: SingleArray
    f0_hz: SingleArray
    srh: _Halves

    @property
    def octaves(self) -> FloatArray:
        """log2 of the candidates in Hz."""
        return np.log2(CANDIDATES_HZ).astype(np.float32)[self.numbers]


def _best_candidates(samples: FloatArray, tuning: Tuning) -> Candidates:
    """The greatest local maxima within the speaker's range, including its ends if SRH rises towards them."""
    halves, searched = _first_pass(samples, tuning)
    shape = (halves.shape[1], _CANDIDATES_PER_FRAME)
    numbers, srh = np.empty(shape, dtype=np.uint8), np.empty(shape, dtype=np.float16)
    merits_of_best, f0_hz = np.empty((2, *shape), dtype=np.float32)
    for first in range(0, halves.shape[1], BLOCK):
        block = slice(first, first + BLOCK)
        found = candidates_of(halves[: searched.stop + 1, block].astype(np.float32), searched, tuning)
        numbers[block], merits_of_best[block] = found.numbers, found.merits
        f0_hz[block], srh[block] = found.f0_hz, found.srh
    return Candidates(numbers, merits_of_best, f0_hz, srh)


def candidates_of(strengths: SingleArray, searched: slice, tuning: Tuning) -> Candidates:
    """The best candidates of some frames within a range, from their SRH (candidates × frames)."""
    merits = merits_of(strengths, tuning.submultiple_share).T.copy()
    peaks = np.where(is_peak(merits[:, searched]), merits[:, searched], np.float32(-np.inf))
    best = np.argpartition(-peaks, _CANDIDATES_PER_FRAME, axis=1)[:, :_CANDIDATES_PER_FRAME]
    columns = best + searched.start
    return Candidates(
        columns.astype(np.uint8),
        np.take_along_axis(peaks, best, axis=1),
        (CANDIDATES_HZ[columns] + BIN_HZ * peak_offsets(merits, columns)).astype(np.float32),
        np.take_along_axis(strengths, columns.T, axis=0).T.astype(np.float16),
    )


def _first_pass(samples: FloatArray, tuning: Tuning) -> tuple[_Halves, slice]:
    """The SRH of each frame (candidates × frames), and the slice of candidates in the speaker's range: all if no frame
    is reliable."""
    halves = np.empty((len(CANDIDATES_HZ), frame_count(len(samples))), dtype=np.float16)
    trusted = []
    for block, strengths in summed_harmonics(samples, tuning.unit_energy_band_hz):
        merits = merits_of(strengths, tuning.submultiple_share)
        trusted.append(merits.argmax(axis=0)[merits.max(axis=0) > RANGE_THRESHOLD])
        halves[:, block] = strengths
    return halves, speaker_range(CANDIDATES_HZ[np.concatenate(trusted)], tuning)


def speaker_range(trusted_hz: FloatArray, tuning: Tuning) -> slice:
    """The candidates that are searched, given the f0 of reliable frames; all, if there are none."""
    if not len(trusted_hz):
        return slice(0, len(CANDIDATES_HZ))
    first, last = np.searchsorted(CANDIDATES_HZ, np.median(trusted_hz) * np.array(tuning.speaker_range))
    return slice(int(first), min(int(last) + 1, len(CANDIDATES_HZ)))


def merits_of(strengths: SingleArray, submultiple_share: float) -> SingleArray:
    """The scores of the first candidates for the path search (candidates × frames): SRH less a share of the greatest at
    an odd submultiple."""
    if not submultiple_share:
        return strengths
    merits = np.zeros_like(strengths)
    for first, below, share in _SUBMULTIPLES:
        count = max(len(strengths) - first, 0)
        interpolated = strengths[below[:count]] * (1 - share[:count])
        interpolated += strengths[below[:count] + 1] * share[:count]
        np.maximum(merits[first:], interpolated, out=merits[first:])
    merits *= np.float32(-submultiple_share)
    merits += strengths
    return merits


def _submultiples(divisor: int) -> tuple[int, NDArray[np.intp], SingleArray]:
    """The first candidate f for which f / divisor is a candidate; and for all from there the candidate below f /
    divisor and its fractional distance to the next (candidates × 1)."""
    places = (CANDIDATES_HZ / divisor - LOWEST_F0_HZ) / BIN_HZ
    first = int(np.argmax(places >= 0))
    below = np.floor(places[first:]).astype(np.intp)
    return first, below, (places[first:] - below).astype(np.float32)[:, None]


_SUBMULTIPLES = tuple(map(_submultiples, ODD_DIVISORS))


def frame_weights(levels: Levels, faintest: float) -> FloatArray:
    """Weights from 1 for loud frames down to `faintest`, linear in dB."""
    return faintest + (1 - faintest) * (1 + levels.below_loud_db / WIDEST_BELOW_LOUD_DB)
