"""Boundaries are moved as the model says, stay in order, and are unchanged where it predicts nothing."""

import json
import tracemalloc
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from understudy.acoustic.alignment.boundaries import (
    BANDS,
    BOUNDARIES_AT_ONCE,
    CONTEXT_STEPS,
    FRAMES_AT_ONCE,
    LONGEST_GAP_S,
    SHORTEST_PAUSE_S,
    SHORTEST_PHONE_S,
    STEP_S,
    STEP_SAMPLES,
    TYPICAL_GAP_S,
    Boundary,
    BoundaryArrays,
    BoundaryModel,
    BoundaryView,
    boundaries,
    levels_around,
    mel_levels,
    spaced_times,
    with_boundaries,
)
from understudy.errors import ServiceError
from understudy.model import SAMPLE_RATE_HZ, Audio, Interval, Phone, Word

MODEL = Path(__file__).resolve().parents[3] / "models" / "alignment" / "boundaries.npz"
AUDIO = Path(__file__).resolve().parents[2] / "audio"


def _word(index: int, *phones: tuple[str, float, float]) -> Word:
    made = tuple(Phone(label, Interval(start_s, end_s)) for label, start_s, end_s in phones)
    return Word(index, "word", Interval(made[0].interval.start_s, made[-1].interval.end_s), made)


WORDS = (_word(0, ("S", 0.2, 0.3), ("AA", 0.3, 0.5)), _word(1, ("M", 0.5, 0.6)), _word(2, ("T", 0.8, 0.9)))


def _audio() -> Audio:
    """Hiss from 0.2 s, a buzz from 0.32 to 0.6, a click at 0.85."""
    times_s = np.arange(SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ
    noise = np.random.default_rng(0).standard_normal(SAMPLE_RATE_HZ)
    hiss = np.diff(noise, prepend=0.0) * ((times_s >= 0.2) & (times_s < 0.32))
    buzz = np.sign(np.sin(2 * np.pi * 120 * times_s)) * ((times_s >= 0.32) & (times_s < 0.6))
    return Audio(0.2 * (hiss + buzz + noise * ((times_s >= 0.85) & (times_s < 0.86))))


def _constant(moves_s: float) -> BoundaryModel:
    """A model that sees nothing and moves everything alike."""
    width = (2 * CONTEXT_STEPS + 1) * BANDS
    view = BoundaryView(np.zeros(width, np.float32), np.zeros((width, 1), np.float32), kind_weight=0.0, gap_weight=0.0)
    points = view.points(mel_levels(_audio().samples), BoundaryArrays.of(boundaries(WORDS)))
    return BoundaryModel(view, np.zeros_like(points[:1]), np.array([moves_s], np.float32))


def _figure8() -> tuple[Audio, tuple[Word, ...]]:
    """A line of flite's with its words where it spoke them."""
    samples, rate_hz = soundfile.read(AUDIO / "figure8.flac")
    assert rate_hz == SAMPLE_RATE_HZ
    words = json.loads((AUDIO / "figure8.json").read_text(encoding="utf-8"))["words"]
    phones = [[(phone["label"], phone["start_s"], phone["end_s"]) for phone in word["phones"]] for word in words]
    return Audio(samples), tuple(_word(index, *said) for index, said in enumerate(phones))


def _shifted(word: Word, by_s: float) -> Word:
    return _word(
        word.index, *((each.label, each.interval.start_s + by_s, each.interval.end_s + by_s) for each in word.phones)
    )


def test_every_boundary_moves_and_words_keep_their_phones() -> None:
    moved = _constant(0.030).refine(_audio(), WORDS)
    assert [boundary.time_s for boundary in boundaries(moved)] == [0.23, 0.33, 0.53, 0.63, 0.83, 0.93]
    assert [[phone.label for phone in word.phones] for word in moved] == [["S", "AA"], ["M"], ["T"]]
    assert moved[0].interval == Interval(0.23, 0.53)


def test_times_stay_within_the_audio_and_phones_keep_a_length() -> None:
    audio = Audio(_audio().samples[: round(0.92 * SAMPLE_RATE_HZ)])
    for move_s in (-9.0, 9.0):
        late = (_word(0, *((label, 0.91, 0.915) for label in ("S", "AA", "T"))),)
        for words in (WORDS, late):
            times_s = [boundary.time_s for boundary in boundaries(_constant(move_s).refine(audio, words))]
            assert times_s[0] >= 0.0
            assert times_s[-1] <= 0.92
            assert np.diff(times_s).min() >= SHORTEST_PHONE_S - 1e-9


def test_what_is_like_nothing_in_the_training_stays() -> None:
    model = BoundaryModel.load(MODEL)
    strange = replace(model, supports=model.supports + 1000.0)
    assert strange.refine(_audio(), WORDS) == WORDS


def test_the_shipped_model_brings_what_is_20_ms_late_nearer_and_does_not_hear_how_loud_it_is() -> None:
    model = BoundaryModel.load(MODEL)
    audio, truth = _figure8()
    late = tuple(_shifted(word, 0.020) for word in truth)
    true_s, refined_s = ([each.time_s for each in boundaries(words)] for words in (truth, model.refine(audio, late)))
    assert np.mean(np.abs(np.array(refined_s) - true_s)) < 0.018
    assert model.refine(Audio(audio.samples * 0.01), late) == model.refine(audio, late)


def _repeated(times: int) -> tuple[Audio, tuple[Word, ...]]:
    """The line again and again."""
    audio, line = _figure8()
    samples = audio.samples[: len(audio.samples) // STEP_SAMPLES * STEP_SAMPLES]
    length_s = len(samples) / SAMPLE_RATE_HZ
    return Audio(np.tile(samples, times)), tuple(_shifted(word, n * length_s) for n in range(times) for word in line)


def test_a_line_is_refined_alike_wherever_in_long_audio_it_comes() -> None:
    count = len(boundaries(_figure8()[1]))
    times = 2 * BOUNDARIES_AT_ONCE // count + 3
    audio, words = _repeated(times)
    refined = BoundaryModel.load(MODEL).refine(audio, words)
    moves_s = [
        after.time_s - before.time_s for before, after in zip(boundaries(words), boundaries(refined), strict=True)
    ]
    moved = np.reshape(moves_s, (times, count))[1:-1]
    assert np.abs(moved).max() > 0.005
    assert np.ptp(moved, axis=0).max() <= 0.0011


def test_beside_the_samples_long_audio_needs_little() -> None:
    audio, words = _repeated(30)
    model = BoundaryModel.load(MODEL)
    tracemalloc.start()
    model.refine(audio, words)
    _, most_bytes = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most_bytes < 20e6


def test_a_file_that_is_no_model_is_named(tmp_path: Path) -> None:
    path = tmp_path / "boundaries.npz"
    path.write_bytes(b"nothing")
    with pytest.raises(ServiceError, match=r"boundaries\.npz is not a boundary model") as caught:
        BoundaryModel.load(path)
    assert caught.value.code == "model_unreadable"


def test_phones_that_touch_share_a_boundary_and_pauses_have_two() -> None:
    assert boundaries(WORDS) == [
        Boundary(0.2, None, "S"),
        Boundary(0.3, "S", "AA"),
        Boundary(0.5, "AA", "M"),
        Boundary(0.6, "M", None),
        Boundary(0.8, None, "T"),
        Boundary(0.9, "T", None),
    ]


def test_a_gap_shorter_than_a_pause_is_none() -> None:
    for gap_s, count in ((SHORTEST_PAUSE_S - 0.001, 3), (SHORTEST_PAUSE_S + 0.001, 4)):
        words = (_word(0, ("M", 1.0, 1.1)), _word(1, ("T", 1.1 + gap_s, 1.3)))
        assert len(boundaries(words)) == count


def test_words_are_rebuilt_as_they_were_and_between_other_times() -> None:
    times_s = np.array([boundary.time_s for boundary in boundaries(WORDS)])
    assert with_boundaries(WORDS, times_s) == WORDS
    later = with_boundaries(WORDS, times_s + np.arange(6.0))
    assert [word.interval for word in later] == [Interval(0.2, 2.5), Interval(2.5, 3.6), Interval(4.8, 5.9)]
    assert later[0].phones[1].interval == Interval(1.3, 2.5)


def test_times_that_crossed_are_put_in_order() -> None:
    assert spaced_times(np.array([0.5, 0.4, 0.9]), 1.0).tolist() == [0.5, 0.51, 0.9]
    assert spaced_times(np.array([-0.1, 0.995, 1.4]), 1.0).tolist() == [0.0, 0.99, 1.0]


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
