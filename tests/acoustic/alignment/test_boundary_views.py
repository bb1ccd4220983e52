"""Features of boundaries: levels independent of the recording's level, phone classes, and log distances."""

import numpy as np

from understudy.acoustic.alignment.boundary_views import (
    BANDS,
    CONTEXT_STEPS,
    FRAMES_AT_ONCE,
    LONGEST_GAP_S,
    STEP_S,
    STEP_SAMPLES,
    TYPICAL_GAP_S,
    BoundaryArrays,
    BoundaryView,
    levels_around,
    mel_levels,
)
from understudy.acoustic.alignment.phone_boundaries import Boundary
from understudy.model import SAMPLE_RATE_HZ

FOUND = (Boundary(0.20, None, "S"), Boundary(0.32, "S", "AA"), Boundary(0.60, "AA", None))


def _tone(seconds: float, hertz: float) -> np.ndarray:
    return 0.5 * np.sin(2 * np.pi * hertz * np.arange(round(seconds * SAMPLE_RATE_HZ)) / SAMPLE_RATE_HZ)


def test_places_have_gaps_to_their_neighbours_and_the_ends_long_ones() -> None:
    places = BoundaryArrays.of(FOUND)
    assert np.allclose(places.gaps_s, [[LONGEST_GAP_S, 0.12], [0.12, 0.28], [0.28, LONGEST_GAP_S]])
    assert places.at_silence.tolist() == [True, False, True]


def test_a_place_that_is_shifted_comes_nearer_one_neighbour_and_leaves_the_other() -> None:
    shifted = BoundaryArrays.of(FOUND).shifted(np.array([0.0, 0.02, 0.0])).part(1, 2)
    assert np.allclose(shifted.times_s, [0.34])
    assert np.allclose(shifted.gaps_s, [[0.14, 0.26]])


def test_levels_are_relative_to_the_loud_frames_of_each_band() -> None:
    tone = np.concatenate([np.zeros(SAMPLE_RATE_HZ), _tone(1.0, 1000.0)])
    levels = mel_levels(tone)
    assert levels.shape == (1 + len(tone) // STEP_SAMPLES, BANDS)
    assert np.array_equal(levels, mel_levels(tone * 2**-6))
    ringing = np.argmin(levels[50])
    assert np.abs(levels[210:390, ringing]).max() < 0.1
    assert levels[:190, ringing].max() < -10


def test_levels_are_the_same_however_the_steps_fall_into_blocks() -> None:
    noise = np.random.default_rng(0).standard_normal(2 * FRAMES_AT_ONCE * STEP_SAMPLES)
    later = np.concatenate([np.zeros(7 * STEP_SAMPLES), noise[: -7 * STEP_SAMPLES]])
    here, there = mel_levels(noise), mel_levels(later)
    difference = here[10 : -2 * 7].astype(float) - there[17:-7]
    assert np.ptp(difference, axis=0).max() < 0.02


def test_beyond_the_audio_its_ends_are_seen() -> None:
    levels = np.arange(3 * BANDS, dtype=np.float16).reshape(3, BANDS)
    seen = levels_around(levels, np.array([STEP_S])).reshape(-1, BANDS)
    assert seen[CONTEXT_STEPS].tolist() == levels[1].tolist()
    assert (seen[:CONTEXT_STEPS] == levels[0]).all()
    assert (seen[CONTEXT_STEPS + 1 :] == levels[2]).all()


def test_points_tell_kinds_gaps_and_spectra_by_their_weights() -> None:
    width = (2 * CONTEXT_STEPS + 1) * BANDS
    view = BoundaryView(np.ones(width, np.float32), np.eye(width, 2, dtype=np.float32), kind_weight=3.0, gap_weight=2.0)
    points = view.points(np.full((200, BANDS), 5.0, np.float16), BoundaryArrays.of(FOUND))
    assert np.allclose(np.sort(points[:, :18], axis=1)[:, -3:], [[0.0, 3.0, 3.0]] * 3)
    assert np.allclose(points[1, 18:20], 2.0 * np.log(np.array([0.12, 0.28]) / TYPICAL_GAP_S))
    assert np.allclose(points[:, 20:], 4.0)
