"""What an author may give for a feeling, and what is told where it is wrong."""

import pytest

from understudy.acoustic.affect.dimensions import PLACES
from understudy.acoustic.affect.given import given_line
from understudy.errors import InputError
from understudy.model import AffectTrack, Interval, Tone, Word
from understudy.schemas.affect import affect_rows, affect_track, read_affect, read_affect_track

HEADER = "time_s,activation,valence,dominance\n"
RISING = (HEADER + "0,-1,0,0\n2,1,0,0.5\n").encode()
WORDS = (Word(0, "No.", Interval(0.0, 0.8)), Word(1, "Never!", Interval(1.2, 2.0)))


def test_a_tone_is_given_by_its_name() -> None:
    line = given_line(read_affect("sad"), WORDS, 2.0)
    assert line.given
    assert line.line.tone is Tone.SAD
    assert [phrase.affect.tone for phrase in line.phrases] == [Tone.SAD, Tone.SAD]


def test_three_numbers_are_taken_as_they_are() -> None:
    affect = given_line(read_affect("0.6, -0.5,0.3"), WORDS, 2.0).line
    assert (affect.activation, affect.valence, affect.dominance) == (0.6, -0.5, 0.3)
    assert affect.tone is Tone.ANGRY


def test_a_track_goes_evenly_from_row_to_row_and_stays_at_its_ends() -> None:
    track = read_affect_track(RISING, "a.csv")
    assert [track.at(time_s).activation for time_s in (-1, 0, 0.5, 1, 2, 9)] == [-1, -1, -0.5, 0, 1, 1]


def test_a_phrase_has_the_mean_of_its_time() -> None:
    line = given_line(read_affect_track(RISING, "a.csv"), WORDS, 2.0)
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
        ("furious", "'furious' is no tone"),
        ("1,2", "no three numbers"),
        ("0,0,1.5", "'1.5' is no number from -1 to 1"),
        ("0,nan,0", "'nan' is no number"),
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
        ((HEADER + "-1,0,0,0\n").encode(), "track.csv:2: '-1' is no time"),
        ((HEADER + "0,0,0,2\n").encode(), "'2' is no number"),
        (b"\xff\xfe", "no CSV in UTF-8"),
    ],
)
def test_a_wrong_track_is_told_with_its_line(content: bytes, reason: str) -> None:
    with pytest.raises(InputError, match=reason):
        read_affect_track(content, "track.csv")
