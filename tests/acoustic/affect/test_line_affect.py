"""A line has the feeling of the whole, its phrases their own, by their length."""

import numpy as np
import pytest

from tests.support.words.measured import stretch_of
from understudy.acoustic.affect.line_affect import (
    HALF_TRUSTED_S,
    Stretch,
    given_line,
    line_affect,
    phrase_interval,
    phrases_of,
)
from understudy.errors import InputError
from understudy.model import SAMPLE_RATE_HZ, Affect, AffectTrack, Audio, Interval, Tone, Word
from understudy.model.voice.affect import PLACES
from understudy.schemas.affect import affect_rows, affect_track, read_affect, read_affect_track

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


def words(*spans: tuple[float, float] | None) -> tuple[Word, ...]:
    return tuple(Word(index, "so", span and Interval(*span)) for index, span in enumerate(spans))


@pytest.mark.parametrize(
    ("spans", "phrases"),
    [
        ((), ()),
        ((None,), ()),
        (((0.0, 0.5), (0.5, 1.0)), ((0, 1),)),
        (((0.0, 0.7), (1.0, 1.7)), ((0, 0), (1, 1))),
        (((0.0, 0.7), (0.9, 1.7)), ((0, 1),)),
        (((0.0, 0.2), (1.0, 1.7)), ((0, 1),)),
        (((0.0, 0.7), (1.0, 1.2)), ((0, 1),)),
        ((None, (0.0, 0.7), None, (1.0, 1.7)), ((0, 2), (3, 3))),
    ],
    ids=["nothing", "untimed", "no pause", "a pause", "a closure", "short before", "short after", "unspoken words"],
)
def test_pauses_divide(spans: tuple[tuple[float, float] | None, ...], phrases: tuple[tuple[int, int], ...]) -> None:
    assert phrases_of(words(*spans)) == phrases


def test_a_phrase_reaches_from_first_to_last_timed_word() -> None:
    assert phrase_interval(words(None, (0.2, 0.7), (0.7, 1.0), None), 0, 3) == Interval(0.2, 1.0)


HEADER = "time_s,activation,valence,dominance\n"
RISING = (HEADER + "0,-1,0,0\n2,1,0,0.5\n").encode()
GIVEN_WORDS = (Word(0, "No.", Interval(0.0, 0.8)), Word(1, "Never!", Interval(1.2, 2.0)))


def test_a_tone_is_given_by_its_name() -> None:
    line = given_line(read_affect("sad"), GIVEN_WORDS, 2.0)
    assert line.given
    assert line.line.tone is Tone.SAD
    assert [phrase.affect.tone for phrase in line.phrases] == [Tone.SAD, Tone.SAD]


def test_three_numbers_are_taken_as_they_are() -> None:
    affect = given_line(read_affect("0.6, -0.5,0.3"), GIVEN_WORDS, 2.0).line
    assert (affect.activation, affect.valence, affect.dominance) == (0.6, -0.5, 0.3)
    assert affect.tone is Tone.ANGRY


def test_a_track_goes_evenly_from_row_to_row_and_stays_at_its_ends() -> None:
    track = read_affect_track(RISING, "a.csv")
    assert [track.at(time_s).activation for time_s in (-1, 0, 0.5, 1, 2, 9)] == [-1, -1, -0.5, 0, 1, 1]


def test_a_phrase_has_the_mean_of_its_time() -> None:
    line = given_line(read_affect_track(RISING, "a.csv"), GIVEN_WORDS, 2.0)
    assert [phrase.affect.activation for phrase in line.phrases] == pytest.approx([-0.6, 0.6])
    assert line.line.activation == pytest.approx(0.0)
    assert sum(line.line.tones) == pytest.approx(1)


@pytest.mark.parametrize("told", ["happy", [0.1, 0.2, 0.3], [[0.0, 0.1, 0.2, 0.3], [1.0, 0.4, 0.5, 0.6]]])
def test_json_is_read_and_written_alike(told: str | list[float] | list[list[float]]) -> None:
    track = affect_track(told)
    assert affect_track(affect_rows(track)) == track


def test_numbers_in_json_are_those_of_the_command_line() -> None:
    assert affect_track([0.6, -0.5, 0.3]) == read_affect("0.6,-0.5,0.3")
    assert isinstance(affect_track(PLACES[Tone.HAPPY]), AffectTrack)


@pytest.mark.parametrize(
    ("told", "reason"),
    [
        ("furious", "'furious' is neither a tone"),
        ("1,2", "nor three numbers"),
        ("0,0,1.5", "'1.5' is not a number from -1 to 1"),
        ("0,nan,0", "'nan' is not a number"),
    ],
)
def test_what_is_wrong_is_told(told: str, reason: str) -> None:
    with pytest.raises(InputError, match=reason) as raised:
        read_affect(told)
    assert (raised.value.code, raised.value.field) == ("affect_wrong", "affect")


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"", "first line must be"),
        (b"time,a,v,d\n0,0,0,0\n", "first line must be"),
        (HEADER.encode(), "a row for each time"),
        ((HEADER + "0,0,0\n").encode(), "track.csv:2: 3 cells"),
        ((HEADER + "0,0,0,0\n0,0,0,0\n").encode(), "track.csv:3: the time 0 s is not after"),
        ((HEADER + "-1,0,0,0\n").encode(), "track.csv:2: '-1' is not a time"),
        ((HEADER + "0,0,0,2\n").encode(), "'2' is not a number"),
        (b"\xff\xfe", "not CSV in UTF-8"),
    ],
)
def test_a_wrong_track_is_told_with_its_line(content: bytes, reason: str) -> None:
    with pytest.raises(InputError, match=reason):
        read_affect_track(content, "track.csv")
