"""Detecting wrong transcripts by scores and by sound outside the words, at the limits."""

import numpy as np
import pytest

from understudy.acoustic.alignment.decoder_process import DecodedPhone
from understudy.acoustic.alignment.fit import (
    EVIDENCE,
    REFUSED,
    SUSPECT,
    WEIGHTS,
    check_fit,
    check_found,
    evidence,
    is_raised,
    is_telephone,
    misfit,
    power_outside,
    signal_to_noise_db,
)
from understudy.errors import InputError
from understudy.model import SAMPLE_RATE_HZ, Audio, Interval, Phone, Word

FRAMES = 50


def _audio(noise: float = 1e-4) -> Audio:
    """A tone from 0.25 to 0.75 s of one second, in noise."""
    times_s = np.arange(SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ
    tone = 0.5 * np.sin(2 * np.pi * 200 * times_s) * ((times_s >= 0.25) & (times_s < 0.75))
    return Audio(tone + np.random.default_rng(0).standard_normal(SAMPLE_RATE_HZ) * noise)


def _shouted() -> Audio:
    """A buzz of 400 Hz from 0.25 to 0.75 s of one second."""
    times_s = np.arange(SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ
    numbers = np.arange(1, 16)
    buzz = np.sin(2 * np.pi * 400 * numbers * times_s[:, np.newaxis]) @ (0.2 / numbers)
    noise = np.random.default_rng(0).standard_normal(SAMPLE_RATE_HZ) * 1e-4
    return Audio(buzz * ((times_s >= 0.25) & (times_s < 0.75)) + noise)


def _word(start_s: float = 0.25, end_s: float = 0.75) -> Word:
    interval = Interval(start_s, end_s)
    return Word(0, "ah", interval, (Phone("AH", interval),))


def _scored(per_frame: float) -> list[list[DecodedPhone]]:
    return [[DecodedPhone("AH", 25, FRAMES, round(per_frame * FRAMES))]]


def _score_at(log_odds: float) -> float:
    """The score per frame at which one phone of `FRAMES` says that."""
    scores = np.arange(-400, 0, 0.5)
    return float(max(score for score in scores if misfit(_scored(score)[0]) > log_odds))


def test_a_fitting_text_passes() -> None:
    assert check_fit(_audio(), (_word(),), _scored(-12)) == ()


def test_a_raised_voice_is_never_refused_but_warned_of() -> None:
    raised = _shouted()
    assert is_raised(raised)
    assert not is_raised(_audio())
    assert not is_raised(Audio(np.zeros(SAMPLE_RATE_HZ)))
    (notice,) = check_fit(raised, (_word(),), _scored(_score_at(REFUSED + 5)))
    assert notice.code == "transcript_suspect"


def test_a_text_beyond_the_limit_is_refused_and_just_before_it_suspect() -> None:
    score = _score_at(REFUSED)
    with pytest.raises(InputError) as caught:
        check_fit(_audio(), (_word(),), _scored(score))
    assert (caught.value.code, caught.value.field) == ("transcript_mismatch", "text")
    (notice,) = check_fit(_audio(), (_word(),), _scored(score + 1))
    assert notice.code == "transcript_suspect"
    assert "worst at word 0 (ah)" in notice.message


def test_a_text_without_a_path_is_refused_but_in_noise() -> None:
    with pytest.raises(InputError) as caught:
        check_found(_audio())
    assert caught.value.code == "transcript_mismatch"
    check_found(_audio(noise=0.2))


def test_noise_moves_the_limits_and_refuses_nothing() -> None:
    noisy = _audio(noise=0.2)
    assert signal_to_noise_db(noisy) < 12
    assert check_fit(noisy, (_word(),), _scored(_score_at(SUSPECT))) == ()
    (notice,) = check_fit(noisy, (_word(),), _scored(_score_at(REFUSED)))
    assert "word 0 (ah)" in notice.message


def test_sound_outside_the_words_is_suspect() -> None:
    assert power_outside(_audio(), (_word(),)) == pytest.approx(0.0, abs=0.01)
    assert power_outside(_audio(), (_word(0.25, 0.5),)) == pytest.approx(0.5, abs=0.02)
    (notice,) = check_fit(_audio(), (_word(0.25, 0.5),), _scored(-12))
    assert "50% of the sound lies outside the words, most of it after word 0 (ah)" in notice.message


def test_a_word_stretched_beyond_speech_is_suspect() -> None:
    (notice,) = check_fit(_audio(), (_word(0.1, 0.9),), _scored(-12))
    assert "too long for the sounds in them: word 0 (ah)" in notice.message


def test_silence_has_no_sound_outside() -> None:
    assert power_outside(Audio(np.zeros(SAMPLE_RATE_HZ)), (_word(),)) == 0.0


def test_a_narrow_band_moves_the_limit_of_suspicion() -> None:
    wide, narrow = _audio(noise=1e-2), _audio(noise=1e-5)
    assert (is_telephone(wide), is_telephone(narrow)) == (False, True)
    doubtful = _scored(_score_at(SUSPECT))
    assert check_fit(narrow, (_word(),), doubtful) == ()
    assert check_fit(wide, (_word(),), doubtful) != ()


def phones(*scored: tuple[int, float]) -> list[DecodedPhone]:
    """Phones of so many frames, with a score per frame."""
    return [DecodedPhone("AH", 0, frames, round(frames * score)) for frames, score in scored]


SPOKEN = phones(*[(6, -10.0), (10, -20.0), (8, -15.0), (12, -12.0)] * 5)


def test_the_evidence_is_what_it_is_called() -> None:
    found = dict(zip(EVIDENCE, evidence(phones((10, -10.0), (30, -50.0))), strict=True))
    assert found["mean score of frames"] == pytest.approx(-40.0)
    assert found["share of phones that fit poorly"] == 0.5
    assert found["score of the quarter of the phones that fits worst"] == pytest.approx(-40.0)
    assert evidence(phones((3, -10.0)))[5] == 1.0
    assert len(WEIGHTS) == len(EVIDENCE)


def test_plain_speech_fits() -> None:
    assert misfit(SPOKEN) < -3


@pytest.mark.parametrize(
    "worse",
    [
        phones(*[(6, -50.0), (10, -60.0), (8, -55.0), (12, -52.0)] * 5),
        phones(*[(3, -10.0), (40, -20.0), (3, -15.0), (60, -12.0)] * 5),
    ],
    ids=["sounds that do not fit", "squeezed and stretched"],
)
def test_what_speaks_against_a_text(worse: list[DecodedPhone]) -> None:
    assert misfit(worse) > misfit(SPOKEN) + 2
