"""A line has the feeling of the whole, its phrases their own, by their length."""

import numpy as np
import pytest

from tests.support.words.measured import stretch_of
from understudy.acoustic.affect.line_affect import HALF_TRUSTED_S, line_affect
from understudy.acoustic.affect.stretch import Stretch
from understudy.model import SAMPLE_RATE_HZ, Affect, Audio, Interval, Word

WORDS = (Word(0, "Well.", Interval(0.0, 0.8)), Word(1, "Go!", Interval(1.2, 2.0)))


class LoudnessJudge:
    """Activation is how loud a stretch is."""

    def affect_of(self, stretch: Stretch, _reference: object = None) -> Affect:
        return Affect(activation=float(np.sqrt(np.mean(stretch.audio.samples**2))))


@pytest.fixture(scope="module")
def rising() -> Stretch:
    gain = np.where(np.arange(2 * SAMPLE_RATE_HZ) < SAMPLE_RATE_HZ, 0.1, 0.5)
    return stretch_of(Audio(gain * np.random.default_rng(0).choice([-1.0, 1.0], 2 * SAMPLE_RATE_HZ)))


def test_each_phrase_is_judged_alone_and_counts_by_its_length(rising: Stretch) -> None:
    affect = line_affect(LoudnessJudge(), rising, Affect(activation=0.3), WORDS)
    weight = 0.8 / (0.8 + HALF_TRUSTED_S)
    expected = [weight * alone + (1 - weight) * 0.3 for alone in (0.1, 0.5)]
    assert [phrase.affect.activation for phrase in affect.phrases] == pytest.approx(expected, abs=1e-6)
    assert affect.line.activation == 0.3
    assert not affect.given


def test_a_line_of_one_phrase_is_judged_once(rising: Stretch) -> None:
    heard = Affect(activation=0.3)
    [phrase] = line_affect(LoudnessJudge(), rising, heard, WORDS[:1]).phrases
    assert (phrase.first, phrase.last, phrase.affect) == (0, 0, heard)


def test_a_stretch_has_the_frames_of_its_time(rising: Stretch) -> None:
    part = rising.between(Interval(1.2, 2.0))
    assert part is not None
    assert part.duration_s == pytest.approx(0.8)
    assert part.contours.energy_db == pytest.approx(rising.contours.energy_db[120:200])
    assert len(part.quality.tilt_db) == 80


def test_too_short_a_stretch_is_none(rising: Stretch) -> None:
    assert rising.between(Interval(1.0, 1.1)) is None
