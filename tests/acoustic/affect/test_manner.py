"""How movements are made follows the voice: agitated lines bigger and faster, sad ones smaller, loud words more."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.words.measured import stretch_of
from understudy.acoustic.affect.manner import LIMITS, SIZE, USUAL, line_manner, measures, word_manners
from understudy.model import NEUTRAL, SAMPLE_RATE_HZ, Agitation, Audio, Interval, LineAffect, Tone, Word
from understudy.model.voice.affect import affect_of_tone

CALM, MEDIUM, HIGH = Agitation(0.9, 0.1, 0.0), Agitation(0.1, 0.8, 0.1), Agitation(0.0, 0.1, 0.9)
USUAL_FEATURES = np.full(149, np.nan)
WORDS = (
    Word(0, "so", Interval(0.1, 0.5)),
    Word(1, "—"),
    Word(2, "GOOD", Interval(0.6, 1.0)),
    Word(3, "now", Interval(1.1, 1.5)),
)


def test_there_is_a_weight_for_each_measure() -> None:
    assert len(measures(USUAL_FEATURES, MEDIUM, NEUTRAL)) == len(USUAL) == len(SIZE)


def test_a_usual_line_is_made_as_usual_and_unknown_measures_are_usual() -> None:
    manner = line_manner(USUAL, NEUTRAL)
    assert (manner.amplitude, manner.speed) == (1, 1)
    assert measures(USUAL_FEATURES, MEDIUM, NEUTRAL)[-2:] == USUAL[-2:]


def test_agitation_makes_bigger_and_faster() -> None:
    calm, medium, high = (
        line_manner(measures(USUAL_FEATURES, each, NEUTRAL), NEUTRAL) for each in (CALM, MEDIUM, HIGH)
    )
    assert calm.amplitude < medium.amplitude < high.amplitude
    assert calm.speed < medium.speed < high.speed
    assert calm.tension < medium.tension < high.tension


@pytest.mark.parametrize(("tone", "other"), [(Tone.SAD, Tone.NEUTRAL), (Tone.SAD, Tone.ANGRY)])
def test_sadness_is_smaller_slower_and_laxer(tone: Tone, other: Tone) -> None:
    low, high = (
        line_manner(measures(USUAL_FEATURES, MEDIUM, affect_of_tone(each)), affect_of_tone(each))
        for each in (tone, other)
    )
    assert (low.amplitude < high.amplitude, low.speed < high.speed, low.tension < high.tension) == (True, True, True)


def test_no_voice_goes_beyond_the_limits() -> None:
    for value in (-100.0, 100.0):
        manner = line_manner([value] * len(USUAL), NEUTRAL)
        for name, (low, high) in LIMITS.items():
            assert low <= getattr(manner, name) <= high


def test_a_loud_word_gets_more_than_the_others_of_its_line() -> None:
    time_s = np.arange(round(1.6 * SAMPLE_RATE_HZ)) / SAMPLE_RATE_HZ
    gain = np.where((time_s > 0.55) & (time_s < 1.05), 0.5, 0.1)
    stretch = stretch_of(Audio(gain * np.random.default_rng(0).normal(0, 0.3, len(time_s))))
    so, dash, good, now = word_manners(stretch, WORDS, CALM, LineAffect(affect_of_tone(Tone.SAD)))
    assert good.amplitude > max(so.amplitude, now.amplitude)
    assert good.speed > max(so.speed, now.speed)
    assert dash.amplitude == pytest.approx(so.amplitude, abs=0.05)


def test_what_an_author_gives_counts_as_if_it_were_heard() -> None:
    stretch = stretch_of(Audio(np.random.default_rng(0).normal(0, 0.1, SAMPLE_RATE_HZ)))
    words = tuple(replace(word, interval=None) for word in WORDS)
    sad, angry = (
        word_manners(stretch, words, MEDIUM, LineAffect(affect_of_tone(tone), given=True))[0]
        for tone in (Tone.SAD, Tone.ANGRY)
    )
    assert sad.amplitude < angry.amplitude
