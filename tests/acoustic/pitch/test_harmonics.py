"""Peaks of parabolas with known positions."""

from itertools import pairwise, product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import fft

from understudy.acoustic.pitch import harmonics
from understudy.acoustic.pitch.harmonics import (
    CANDIDATES_HZ,
    best_path,
    is_peak,
    peak_offsets,
    prediction_residual,
    summed_harmonics,
)
from understudy.model import SAMPLE_RATE_HZ, FloatArray


@pytest.mark.parametrize("offset", [-0.4, 0.0, 0.25])
def test_the_top_of_a_parabola_lies_where_it_does(offset: float) -> None:
    curve = 1 - (np.arange(5.0)[None] - 2 - offset) ** 2
    assert peak_offsets(curve, np.array([[2]])) == pytest.approx(offset)


def test_a_place_that_is_no_peak_is_hardly_moved() -> None:
    rising = np.array([[0.0, 1.0, 1.9, 2.0]])
    assert peak_offsets(rising, np.array([[0, 1, 3]])).tolist() == [[0.0, 0.5, 0.5]]


def test_edges_and_plateaus_count_as_peaks() -> None:
    assert is_peak(np.array([[3.0, 1.0, 2.0, 2.0, 1.0]])).tolist() == [[True, False, True, True, False]]


@given(frames=st.integers(1, 5), columns=st.integers(1, 3), seed=st.integers(0, 10_000))
def test_no_path_is_better(frames: int, columns: int, seed: int) -> None:
    generator = np.random.default_rng(seed)
    gains = generator.normal(size=(frames, columns))
    positions = 2 * generator.random((frames, columns))

    def worth(path: tuple[int, ...]) -> float:
        places = [positions[frame, column] for frame, column in enumerate(path)]
        costs = sum(0.5 * min(abs(after - before), 1.0) for before, after in pairwise(places))
        return float(sum(gains[frame, column] for frame, column in enumerate(path)) - costs)

    found = tuple(int(column) for column in best_path(gains, positions, price=0.5))
    np.testing.assert_allclose(worth(found), max(map(worth, product(range(columns), repeat=frames))))


def test_a_path_longer_than_a_block_stays_in_its_place() -> None:
    gains = np.random.default_rng(0).normal(loc=[0.0, 0.0, 0.5], size=(1000, 3))
    assert (best_path(gains, np.broadcast_to([0.0, 2.0, 4.0], gains.shape), price=100.0) == 2).all()


def pulses(f0_hz: float, duration_s: float = 1.0) -> FloatArray:
    """One sample a period through a resonance at 700 Hz, in faint noise."""
    count = round(duration_s * SAMPLE_RATE_HZ)
    train = np.zeros(count)
    train[np.arange(0, count, SAMPLE_RATE_HZ / f0_hz).astype(int)] = 1.0
    times = np.arange(300)
    resonance = 0.97**times * np.cos(2 * np.pi * 700 / SAMPLE_RATE_HZ * times)
    return np.convolve(train, resonance)[:count] + np.random.default_rng(0).normal(0, 1e-3, count)


def srh(samples: FloatArray, band_hz: int) -> FloatArray:
    """Frames × candidates."""
    return np.concatenate([strengths.T for _, strengths in summed_harmonics(samples, band_hz)])


@pytest.mark.parametrize(("band_hz", "decimation"), [(3500, 2), (8000, 1)])
def test_it_is_eq_3(band_hz: int, decimation: int) -> None:
    samples = pulses(130.0)
    rate_hz = SAMPLE_RATE_HZ // decimation
    residual = prediction_residual(samples, decimation=decimation)
    window = rate_hz // 10
    frame = residual[rate_hz // 2 - window // 2 :][:window] * np.blackman(window + 1)[:-1]
    amplitudes = np.abs(fft.rfft(frame, rate_hz // 2))[: band_hz // 2]
    amplitudes /= np.sqrt(np.sum(amplitudes**2) * 2 * 8000 / band_hz)
    every_hz = np.interp(np.arange(2501), 2 * np.arange(len(amplitudes)), amplitudes)
    for number, f in enumerate(CANDIDATES_HZ.astype(int)):
        expected = every_hz[f] + sum(every_hz[k * f] - every_hz[k * f - f // 2] for k in range(2, 6))
        assert srh(samples, band_hz)[50, number] == pytest.approx(expected, abs=1e-4)


@pytest.mark.parametrize("f0_hz", [70.0, 131.0, 220.0, 390.0])
def test_between_half_and_double_it_is_greatest_at_f0(f0_hz: float) -> None:
    nearby = np.abs(np.log2(CANDIDATES_HZ / f0_hz)) <= 1
    greatest_hz = CANDIDATES_HZ[nearby][srh(pulses(f0_hz), 3500)[:, nearby].argmax(axis=1)]
    np.testing.assert_allclose(greatest_hz[8:-8], f0_hz, atol=2)


@pytest.mark.parametrize("count", [1, 8_000, 16 * 160 - 1, 64 * 160, 10_400])
def test_every_frame_comes_once_in_order(count: int) -> None:
    blocks = [block for block, _ in summed_harmonics(np.resize(pulses(100.0, 0.2), count), 3500)]
    assert [frame for block in blocks for frame in range(block.start, block.stop)] == list(range(1 + count // 160))


def test_stretches_of_long_audio_are_as_the_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    samples = pulses(110.0, 3.0)
    whole = srh(samples, 3500)
    monkeypatch.setattr(harmonics, "_STRETCH", 100)
    np.testing.assert_allclose(srh(samples, 3500), whole, atol=1e-5)


def resonant_pulses(period: int = 160, formant_hz: float = 900.0) -> FloatArray:
    """Half a second of pulses through one resonance."""
    decay, turn = 0.97, 2 * np.pi * formant_hz / SAMPLE_RATE_HZ
    times = np.arange(400)
    response = decay**times * np.cos(turn * times)
    pulses = np.zeros(SAMPLE_RATE_HZ // 2)
    pulses[80::period] = 1.0
    return np.convolve(pulses, response)[: len(pulses)]


def test_pulses_are_freed_of_their_resonance() -> None:
    voice = resonant_pulses()
    residual = prediction_residual(voice)[1600:-1600].reshape(-1, 160)
    strongest = np.sort(np.abs(residual), axis=1)[:, ::-1]
    assert (strongest[:, :8] ** 2).sum() > 0.9 * (residual**2).sum()
    assert (np.sort(np.abs(voice[1600:-1600].reshape(-1, 160)), axis=1)[:, -8:] ** 2).sum() < 0.9 * (
        voice[1600:-1600] ** 2
    ).sum()


def test_at_half_the_rate_it_is_the_same_below_the_half_band() -> None:
    voice = resonant_pulses() + np.random.default_rng(0).normal(0, 1e-3, 8000)
    whole, half = prediction_residual(voice), prediction_residual(voice, decimation=2)
    spectra = [np.abs(np.fft.rfft(each * np.hanning(len(each)))) * scale for each, scale in ((whole, 0.5), (half, 1))]
    np.testing.assert_allclose(spectra[1][:1750], spectra[0][:1750], atol=0.02 * spectra[0].max())


@pytest.mark.parametrize("length", [1, 2, 199, 200, 201, 8001])
def test_it_is_as_long_as_the_signal(length: int) -> None:
    samples = np.random.default_rng(0).normal(size=length)
    assert len(prediction_residual(samples)) == length
    assert len(prediction_residual(samples, decimation=2)) == -(-length // 2)
