"""f0 of signals whose f0 is known: pulse trains through a vocal tract, glides, missing and strong harmonics, noise."""

import tracemalloc

import numpy as np
import pytest
import soxr
from hypothesis import given
from hypothesis import strategies as st

from tests.support.examples import examples
from tests.support.shared_data import SHARED_SPEECH, needs
from understudy.acoustic.pitch.harmonics import HIGHEST_F0_HZ, LOWEST_F0_HZ
from understudy.acoustic.pitch.tracking import PUBLISHED, TUNED, Tuning, track_f0
from understudy.acoustic.signal.decoding import AudioLimits, decode
from understudy.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Audio, FloatArray

RECORDING = SHARED_SPEECH / "fda" / "sb002.flac"
VOWEL_HZ = (700, 1200, 2500, 3500)


def voice(f0_hz: float | FloatArray, duration_s: float = 1.0, formants_hz: tuple[float, ...] = VOWEL_HZ) -> FloatArray:
    """All harmonics of f0 below 4 kHz, falling 12 dB an octave and raised near the formants; peak 0.5."""
    track = np.broadcast_to(np.asarray(f0_hz, dtype=float), (round(duration_s * SAMPLE_RATE_HZ),))
    phase = 2 * np.pi * np.cumsum(track) / SAMPLE_RATE_HZ
    total = np.zeros(len(track))
    for harmonic in range(1, int(4000 / track.min()) + 1):
        frequency_hz = harmonic * track
        resonance = sum(1 / (1 + ((frequency_hz - formant) / 80) ** 2) for formant in formants_hz)
        total += (frequency_hz < 4000) * (0.05 + resonance) / harmonic**2 * np.sin(harmonic * phase)
    scaled: FloatArray = 0.5 * total / np.max(np.abs(total))
    return scaled


def noise(duration_s: float = 1.0, amplitude: float = 0.1) -> FloatArray:
    return np.random.default_rng(0).normal(0, amplitude, round(duration_s * SAMPLE_RATE_HZ))


def inner(f0_hz: FloatArray) -> FloatArray:
    """Without the frames whose window passes the signal's ends."""
    return f0_hz[6:-6]


@pytest.mark.parametrize("f0_hz", [60.0, 83.3, 120.0, 199.0, 251.7, 333.0, 480.0])
def test_a_steady_voice_is_found_within_one_percent(f0_hz: float) -> None:
    np.testing.assert_allclose(inner(track_f0(Audio(voice(f0_hz)))), f0_hz, rtol=0.01)


@examples(40)
@given(f0_hz=st.floats(70, 490), formant_hz=st.floats(300, 900), level=st.floats(1e-3, 1))
def test_any_voice_is_found_at_any_level(f0_hz: float, formant_hz: float, level: float) -> None:
    samples = level * voice(f0_hz, 0.3, (formant_hz, 1500, 2500))
    np.testing.assert_allclose(inner(track_f0(Audio(samples))), f0_hz, rtol=0.02)


@pytest.mark.parametrize("f0_hz", [90.0, 150.0, 240.0])
@pytest.mark.parametrize("harmonic", [2, 3])
def test_a_formant_on_a_higher_harmonic_is_no_octave_error(f0_hz: float, harmonic: int) -> None:
    samples = voice(f0_hz, formants_hz=(harmonic * f0_hz, 2500))
    np.testing.assert_allclose(inner(track_f0(Audio(samples))), f0_hz, rtol=0.02)


def test_a_range_without_triples_can_be_searched() -> None:
    pulses = (np.arange(SAMPLE_RATE_HZ) % 640 == 0).astype(float)
    assert (inner(track_f0(Audio(pulses))) < 60).all()  # 25 Hz and 50 Hz are as good


def test_a_missing_fundamental_is_still_heard() -> None:
    times = np.arange(SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ
    samples = sum((np.sin(2 * np.pi * 150 * k * times) for k in range(2, 20)), start=np.zeros(len(times)))
    np.testing.assert_allclose(inner(track_f0(Audio(samples / 20))), 150, rtol=0.02)


@pytest.mark.parametrize(("start_hz", "end_hz"), [(100, 180), (300, 170)])
def test_a_glide_is_followed_at_the_centre_of_each_frame(start_hz: float, end_hz: float) -> None:
    glide = np.geomspace(start_hz, end_hz, SAMPLE_RATE_HZ)
    found = track_f0(Audio(voice(glide)))
    centres = np.minimum(np.arange(len(found)) * round(FRAME_SHIFT_S * SAMPLE_RATE_HZ), len(glide) - 1)
    np.testing.assert_allclose(inner(found), inner(glide[centres]), rtol=0.02)


def test_voice_between_silence_and_noise_is_placed_to_within_half_a_window() -> None:
    samples = np.concatenate([np.zeros(16_000), voice(140.0), noise()])
    f0_hz = track_f0(Audio(samples))
    voiced = f0_hz > 0
    assert not voiced[:95].any()
    assert voiced[103:198].all()
    assert voiced[206:].mean() < 0.05


def test_a_glide_of_almost_an_octave_has_no_octave_errors_under_noise() -> None:
    glide = np.geomspace(110, 210, 2 * SAMPLE_RATE_HZ)
    samples = voice(glide, 2.0) + noise(2.0, 0.03)
    found = inner(track_f0(Audio(samples)))
    truth = inner(glide[np.minimum(np.arange(201) * 160, len(glide) - 1)])
    voiced = found > 0
    assert voiced.mean() > 0.9
    assert (np.abs(found[voiced] / truth[voiced] - 1) < 0.2).all()


@pytest.mark.parametrize("tuning", [TUNED, PUBLISHED])
@pytest.mark.parametrize("length", [1, 159, 160, 161, 800, 1_600, 40_961])
def test_there_is_one_frame_every_ten_milliseconds(tuning: Tuning, length: int) -> None:
    f0_hz = track_f0(Audio(np.resize(voice(130.0), length)), tuning)
    assert len(f0_hz) == 1 + length // 160
    assert ((f0_hz == 0) | ((f0_hz >= LOWEST_F0_HZ - 1) & (f0_hz <= HIGHEST_F0_HZ + 1))).all()


@pytest.mark.parametrize("samples", [np.zeros(16_000), noise(), np.eye(1, 16_000, 8_000)[0]])
def test_silence_noise_and_a_click_have_no_voice(samples: FloatArray) -> None:
    assert (track_f0(Audio(samples)) > 0).mean() < 0.05


def test_a_short_voice_in_noise_is_one_run_of_its_length() -> None:
    samples = np.concatenate([noise(0.5, 0.01), voice(150.0, 0.2), noise(0.5, 0.01)])
    voiced = track_f0(Audio(samples)) > 0
    runs = np.diff(np.flatnonzero(np.diff(voiced, prepend=False, append=False)))[::2]
    assert len(runs) == 1
    assert 18 <= runs[0] <= 24


def test_a_recording_of_8_khz_keeps_its_voicing() -> None:
    narrow = soxr.resample(soxr.resample(voice(120.0), 16_000, 8_000), 8_000, 16_000)
    np.testing.assert_allclose(inner(track_f0(Audio(narrow))), 120, rtol=0.02)


def test_a_minute_takes_little_more_memory_than_its_samples() -> None:
    audio = Audio(np.tile(voice(120.0), 60).astype(np.float32))
    tracemalloc.start()
    track_f0(audio)
    peak_bytes = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak_bytes < audio.samples.nbytes + 4e6  # the SRH of all candidates, and blocks


@needs(RECORDING)
def test_a_real_voice_agrees_with_its_laryngograph() -> None:
    reference_hz = np.loadtxt(RECORDING.with_suffix(".f0ref"))[::2]
    audio, _ = decode(RECORDING.read_bytes(), AudioLimits())
    found_hz = track_f0(audio)[::3][: len(reference_hz)]
    both = (found_hz > 0) & (reference_hz[: len(found_hz)] > 0)
    assert both.sum() > 25
    assert np.median(np.abs(found_hz[both] / reference_hz[: len(found_hz)][both] - 1)) < 0.03
