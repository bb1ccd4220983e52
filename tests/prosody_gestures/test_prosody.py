"""The features of prosody."""

import numpy as np
import pytest

from understudy.model import FloatArray
from understudy.prosody_gestures.prosody import (
    FEATURES,
    LOOKAHEAD_FRAMES,
    WIDTH,
    ProsodyContext,
    features,
    in_context,
    raw_frames,
    whole_frames,
)


def spoken(seconds: float = 3.0, seed: int = 0) -> tuple[FloatArray, FloatArray]:
    """Energy and f0 as of syllables, voiced three fifths of the time."""
    times_s = np.arange(0, seconds, 0.01)
    generator = np.random.default_rng(seed)
    voiced = (times_s * 4) % 1 < 0.6
    f0_hz = np.where(voiced, 120 * np.exp(0.2 * np.sin(times_s * 3)) + generator.normal(0, 1, len(times_s)), 0.0)
    return np.where(voiced, -20.0, -45.0) + generator.normal(0, 1, len(times_s)), f0_hz


def test_a_window_is_a_twentieth_of_a_second() -> None:
    """Frame 4 is centred on .1 s: contour frames 8 to 12, their mean energy and geometric mean of f0."""
    energy_db, f0_hz = np.full(40, -60.0), np.zeros(40)
    energy_db[10], f0_hz[[9, 10]] = 0.0, (100.0, 400.0)
    energy, pitch, confidence = raw_frames(energy_db, f0_hz)[4]
    assert energy == pytest.approx(np.log((1 + 4e-6) / 5))
    assert pitch == pytest.approx(200.0)
    assert confidence == pytest.approx(0.4)


def test_no_frame_looks_beyond_what_was_heard() -> None:
    """The last window ends within the contour, which more of it does not change."""
    energy_db, f0_hz = spoken()
    for heard in (3, 4, 57, 100):
        part = raw_frames(energy_db[:heard], f0_hz[:heard])
        assert len(part) == whole_frames(heard)
        assert (part == raw_frames(energy_db, f0_hz)[: len(part)]).all()
    assert whole_frames(2) == 0
    assert whole_frames(3) == 0
    assert whole_frames(4) == 1


def test_features_of_a_part_are_part_of_the_features() -> None:
    raw = raw_frames(*spoken())
    assert (features(raw[:50]) == features(raw)[:50]).all()


def test_neither_level_nor_range_of_voice_matter_for_long() -> None:
    """A louder, higher voice has the same features once its mean is known."""
    energy_db, f0_hz = spoken(8.0)
    one, other = features(raw_frames(energy_db, f0_hz)), features(raw_frames(energy_db + 20, f0_hz * 1.8))
    assert one[120:, 1:] == pytest.approx(other[120:, 1:], abs=0.05)
    assert one[120:, 0] == pytest.approx(other[120:, 0], abs=0.05)


def test_silence_has_features_too() -> None:
    silent = features(raw_frames(np.full(50, -np.inf), np.zeros(50)))
    assert silent.shape == (len(silent), len(FEATURES))
    assert np.isfinite(silent).all()


def test_changes_are_since_two_frames_ago() -> None:
    made = features(raw_frames(*spoken()))
    assert made[10:, 3:] == pytest.approx(made[10:, :3] - made[8:-2, :3])


MADE = features(raw_frames(*spoken()))


def test_a_row_holds_its_frame_and_the_one_heard_later() -> None:
    rows = in_context(MADE)
    assert rows.shape == (len(MADE), WIDTH)
    assert (rows[:, :6] == MADE).all()
    assert (rows[:-LOOKAHEAD_FRAMES, WIDTH // 2 : WIDTH // 2 + 6] == MADE[LOOKAHEAD_FRAMES:]).all()
    assert (rows[-LOOKAHEAD_FRAMES:, WIDTH // 2 : WIDTH // 2 + 6] == MADE[-1]).all(), "as if the last went on"


def test_means_are_of_what_was_heard_lately() -> None:
    rows = in_context(MADE)
    assert rows[40, 6:9] == pytest.approx(MADE[37:41, :3].mean(axis=0))
    assert rows[40, 15:18] == pytest.approx(MADE[9:41, :3].mean(axis=0))
    assert rows[0, 6:9] == pytest.approx(MADE[0, :3] / 4), "before the beginning there is nothing"


def test_a_pause_begins_a_phrase_anew() -> None:
    voiced, silent = np.array([0, 0, 1.0, 0, 0, 0]), np.array([-4, 0, -1.0, 0, 0, 0])
    rows = in_context(np.array([voiced] * 20 + [silent] * 8 + [voiced] * 3))
    since, silence = np.expm1(rows[:, 18]), np.expm1(rows[:, 19])
    assert since[[19, 26, 27, 30]] == pytest.approx([20, 27, 0, 3])
    assert silence[[19, 20, 27, 28]] == pytest.approx([0, 1, 8, 0])


def test_few_frames_are_enough() -> None:
    assert in_context(MADE[:1]).shape == (1, WIDTH)
    assert ProsodyContext().finish() == []
