"""Words with times and without."""

import numpy as np
import pytest

from understudy.errors import InputError
from understudy.live.ear import RecentVoice
from understudy.live.models import LiveModels
from understudy.live.words import TimedText, paced_words, perform_words, timed_words
from understudy.model import FRAME_SHIFT_S, Interval, Word
from understudy.options import Options

NO = (TimedText("No,", Interval(2.0, 2.4)), TimedText("never.", Interval(2.5, 3.0)))


SAID = ["I", "never", "said", "that"]


def said(durations_s: dict[str, float], f0_hz: dict[str, float]) -> tuple[tuple[TimedText, ...], RecentVoice]:
    """Words one after the other and the voice that said them; .3 s and 120 Hz where nothing else is told."""
    recent, timed, begin_s = RecentVoice(), list[TimedText](), 0.0
    for word in SAID:
        duration_s = durations_s.get(word, 0.3)
        timed.append(TimedText(word, Interval(round(begin_s, 3), round(begin_s + duration_s, 3))))
        begin_s += duration_s
        count = round(duration_s / FRAME_SHIFT_S)
        recent.hear(np.full(count, -20.0), np.linspace(120.0, f0_hz.get(word, 120.0), count))
    return tuple(timed), recent


def most_stressed(words: tuple[Word, ...]) -> str:
    return max(words, key=lambda word: word.emphasis or 0.0).text


def test_a_word_that_takes_longer_is_stressed_before_it_is_heard(models: LiveModels) -> None:
    for long in ("I", "said"):
        timed, _ = said({long: 0.7}, {})
        words = timed_words(models, timed, RecentVoice())
        assert most_stressed(words) == long
        assert [word.interval for word in words] == [each.interval for each in timed]


def test_a_voice_that_rises_on_a_word_stresses_it(models: LiveModels) -> None:
    for rising in ("I", "said"):
        timed, recent = said({}, {rising: 200.0})
        assert most_stressed(timed_words(models, timed, recent)) == rising


def test_the_focus_is_shared_among_the_words_heard_so_far(models: LiveModels) -> None:
    timed, recent = said({}, {"never": 200.0})
    shares = [word.focus for word in timed_words(models, timed, recent)]
    assert max(range(len(SAID)), key=lambda place: shares[place] or 0.0) == SAID.index("never")
    earlier = RecentVoice()
    earlier.hear(np.full(70, -20.0), np.full(70, 120.0))
    among_two = [word.focus or 0.0 for word in timed_words(models, timed, earlier)]
    assert sum(among_two[:2]) == pytest.approx(1, abs=0.001)
    assert among_two[2:] == [0, 0]
    assert {word.focus for word in timed_words(models, timed, RecentVoice())} == {None}


def test_text_without_times_has_no_stress(models: LiveModels) -> None:
    assert {word.emphasis for word in paced_words(models, "No, never.", 1.0)} == {None}


def test_sounds_share_their_word_by_how_long_they_usually_last(models: LiveModels) -> None:
    no, never = timed_words(models, NO, RecentVoice())
    assert [phone.label for phone in no.phones] == ["N", "OW"]
    usual_s = models.durations.usual_s
    assert no.phones[0].interval.duration_s == pytest.approx(
        0.4 * usual_s["N"] / (usual_s["N"] + usual_s["OW"]), abs=1e-3
    )
    assert no.phones[1].interval.end_s == 2.4
    assert never.phones[-1].interval.end_s == 3.0
    assert no.spread


def test_text_takes_its_usual_time(models: LiveModels) -> None:
    no, never = paced_words(models, "No, never.", 1.0)
    assert no.interval == Interval(1.0, round(1.0 + models.durations.of(no.phones), 3))
    assert never.interval is not None
    assert never.interval.start_s > no.interval.end_s


def test_what_is_known_in_time_is_done_in_time_and_what_comes_too_late_is_left_out(models: LiveModels) -> None:
    words = timed_words(models, NO, RecentVoice())
    early = perform_words(models.understudy, words, Options(), 0.0)
    assert early.interval == Interval(2.0, 3.0)
    assert {each.lexeme for each in early.behaviors} & {"SHAKE", "NEGATION", "REJECT"}
    assert {viseme.label for viseme in early.visemes} >= {"nn", "O"}
    late = perform_words(models.understudy, words, Options(), 2.2)
    assert all(each.sync.start >= 2.2 for each in late.behaviors)
    assert len(late.behaviors) < len(early.behaviors)


def test_text_of_which_nothing_can_be_spoken_is_refused(models: LiveModels) -> None:
    with pytest.raises(InputError) as raised:
        paced_words(models, "— …", 0.0)
    assert raised.value.code == "transcript_unspoken"
