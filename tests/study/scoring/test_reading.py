"""Answers read from CSV, and what is wrong with them told by line and column."""

from pathlib import Path

import pytest

from understudy.errors import InputError
from understudy.study.comparison import Comparison, RaterChoice
from understudy.study.scoring.reading import (
    PreferenceAnswer,
    Rating,
    RecognitionAnswer,
    Understanding,
    Verdict,
    read_answers,
)
from understudy.study.scoring.tables import AnswersError

KEY = "clip,line,condition\nk1,one,semantic\nk2,one,prosody\nk3,one,random\nk4,two,U\nk5,two,S\n"


def _file(folder: Path, name: str, content: str) -> Path:
    path = folder / name
    path.write_text(content, encoding="utf-8")
    return path


def _told(folder: Path, content: str) -> list[str]:
    """The mistakes in a file, without its name."""
    with pytest.raises(AnswersError) as raised:
        read_answers([_file(folder, "a.csv", content)])
    return [str(each).split("a.csv:", 1)[1] for each in raised.value.mistakes]


def test_ratings_are_told_by_the_key_beside_them(tmp_path: Path) -> None:
    _file(tmp_path, "key.csv", KEY)
    answers = read_answers([_file(tmp_path, "a.csv", "rater,clip,rating,choice\n1,k1,9,best\n1,k2,3,\n1,k3,2,worst\n")])
    assert answers.comparison is Comparison.MODES
    assert answers.ratings == (
        Rating("1", "one", "semantic", 9, RaterChoice.BEST),
        Rating("1", "one", "prosody", 3),
        Rating("1", "one", "random", 2, RaterChoice.WORST),
    )


def test_the_key_may_lie_in_the_folder_above_or_be_named(tmp_path: Path) -> None:
    (tmp_path / "answers").mkdir()
    answer = _file(tmp_path / "answers", "a.csv", "rater,clip,rating\n1,k1,9\n")
    key = _file(tmp_path, "key.csv", KEY)
    assert read_answers([answer]).ratings == (Rating("1", "one", "semantic", 9),)
    key.rename(tmp_path / "other.csv")
    assert read_answers([answer], tmp_path / "other.csv").ratings == (Rating("1", "one", "semantic", 9),)
    with pytest.raises(AnswersError, match=r"as --key"):
        read_answers([answer])


def test_other_forms_say_line_and_condition_themselves(tmp_path: Path) -> None:
    """As a spreadsheet saves it: a byte order mark, semicolons, capitals, quoted cells and an empty line."""
    content = '\ufeffRater;Line;Condition;Rating\r\n"a;b";one;semantic;7,5\r\n\r\n'.replace("7,5", "7.5")
    assert read_answers([_file(tmp_path, "a.csv", content)]).ratings == (Rating("a;b", "one", "semantic", 7.5),)


def test_comparisons_are_told_by_the_key(tmp_path: Path) -> None:
    _file(tmp_path, "key.csv", KEY)
    content = (
        "rater,a,b,dimension,answer\n1,k5,k4,natural,B\n1,k5,k4,nervous,A\n1,k5,k4,friendly,undecided\n"
        "1,k5,k4,understood,3\n"
    )
    answers = read_answers([_file(tmp_path, "a.csv", content)])
    assert answers.comparison is Comparison.UNITS
    assert answers.verdicts == (
        Verdict("1", "two", "natural", "U"),
        Verdict("1", "two", "nervous", "S"),
        Verdict("1", "two", "friendly", None),
    )
    assert answers.understood == (Understanding("1", "two", 3),)


def test_comparisons_of_other_forms_name_the_versions(tmp_path: Path) -> None:
    content = "rater,line,dimension,answer\n1,two,natural,U\n1,two,nervous,undecided\n"
    answers = read_answers([_file(tmp_path, "a.csv", content)])
    assert answers.verdicts == (Verdict("1", "two", "natural", "U"), Verdict("1", "two", "nervous", None))


def test_preferences_and_speakers_are_read_with_their_groups(tmp_path: Path) -> None:
    key = "clip,line,condition\nk1,one,live\nk2,one,random\n"
    content = "rater,group,a,b,preference\n1,DE,k2,k1,-2\n2,,k1,k2,0\n"
    answers = read_answers([_file(tmp_path, "p.csv", content)], _file(tmp_path, "pairs.csv", key))
    assert answers.comparison is Comparison.WAYS
    assert answers.preferred[0] == PreferenceAnswer("1", "one", "random", "live", -2)
    assert answers.groups == {"1": "DE"}
    named = "rater,line,first,second,preference\n1,one,both,affect,1.5\n"
    assert read_answers([_file(tmp_path, "n.csv", named)]).comparison is Comparison.AFFECT
    key = "clip,line,condition\nk1,one,JL\nk2,one,MR\n"
    content = "rater,clip,beside,answer\n1,k1,,MR\n1,k2,k1,MR\n"
    answers = read_answers([_file(tmp_path, "s.csv", content)], _file(tmp_path, "speakers.csv", key))
    assert answers.named == (
        RecognitionAnswer("1", "one", "JL", "MR", False),
        RecognitionAnswer("1", "one", "MR", "MR", True),
    )


def test_mistakes_of_preferences_and_speakers_are_told(tmp_path: Path) -> None:
    told = _told(tmp_path, "rater,group,line,first,second,preference\n1,DE,one,live,later,-3\n1,US,one,live,live,0\n")
    assert [each.split(": ")[0] for each in told] == ["2:5", "2:6", "3:2"]
    told = _told(tmp_path, "rater,line,speaker,answer\n1,one,JL,\n")
    assert [each.split(": ")[0] for each in told] == ["2:4"]


def test_every_mistake_is_told_with_line_and_column(tmp_path: Path) -> None:
    content = (
        "rater,line,condition,rating,choice\n"
        "1,one,semantic,11,\n"
        "1,one,meaning,5,\n"
        "1,one,random,5,better\n"
        ",one,prosody,many,\n"
        "2,one,prosody,5,\n"
        "2,one,prosody,6,\n"
    )
    told = _told(tmp_path, content)
    assert [each.split(": ")[0] for each in told] == ["2:4", "3:3", "4:5", "5:1", "5:4", "7:1"]
    assert "give a number from 1 to 10" in told[0]
    assert "semantic, prosody, random" in told[1]
    assert "already" in told[5]
    assert told[5].endswith("a.csv:6")


def test_comparisons_have_their_mistakes_told_too(tmp_path: Path) -> None:
    content = "rater,line,dimension,answer\n1,two,naturel,U\n1,two,natural,A\n1,two,understood,4\n"
    assert [each.split(": ")[0] for each in _told(tmp_path, content)] == ["2:3", "3:4", "4:4"]


def test_lines_of_another_length_are_told(tmp_path: Path) -> None:
    assert _told(tmp_path, "rater,line,condition,rating\n1,one\n") == ["2: 2 cells, and the first line has 4"]


@pytest.mark.parametrize(
    ("content", "told"),
    [
        ("", "no column rater, rating; the first line has nothing"),
        ("rater,grade\n1,5\n", "no column rating"),
        ("rater,rating\n1,5\n", "no column line, condition"),
        ("rater,rating,Rating\n1,5,5\n", "two columns are called 'rating'"),
        ("{\n}\n", "one column alone, '{'"),
        ('rater,rating\n"1,5\n', "unexpected end of data"),
    ],
)
def test_what_is_no_table_of_answers_is_told(tmp_path: Path, content: str, told: str) -> None:
    assert told in _told(tmp_path, content)[0]


def test_a_clip_of_another_study_is_told(tmp_path: Path) -> None:
    _file(tmp_path, "key.csv", KEY)
    assert "the key has no such clip" in _told(tmp_path, "rater,clip,rating\n1,k9,9\n")[0]


def test_two_comparisons_are_not_mixed(tmp_path: Path) -> None:
    ratings = _file(tmp_path, "a.csv", "rater,line,condition,rating\n1,one,semantic,5\n")
    choices = _file(tmp_path, "b.csv", "rater,line,dimension,answer\n1,two,natural,U\n")
    with pytest.raises(AnswersError, match="score them separately"):
        read_answers([ratings, choices])


def test_a_file_that_is_not_there_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError) as raised:
        read_answers([tmp_path / "none.csv"])
    assert raised.value.code == "file_unreadable"
