"""Profiles as files: what is written is read again, and every mistake has its line and column."""

from pathlib import Path

import pytest

from tests.support.annotations import SWEEPING
from understudy.errors import AuthoringError
from understudy.profiles.annotation.reading import read_annotations
from understudy.profiles.annotation.spans import DEPTHS, HEIGHTS, RESTS, SIDEWAYS
from understudy.profiles.files.reading import read_profile
from understudy.profiles.files.writing import profile_yaml
from understudy.profiles.learning.learner import learn
from understudy.realizer.arms.rest_poses import LIFTED, WAITS
from understudy.realizer.arms.rest_poses import RESTS as POSES
from understudy.realizer.gestures.gesture import Depth, HeightSector, Sideways

SMALL = """\
description: "Nobody."
gestures_per_minute: 12
lexemes:
  BEAT: {share: 0.6, hands: {right: 1}}
  ME: {share: 0.4, hands: {left: 0.5, right: 0.5}, strokes: [1, 0], size: 0.8}
tags:
  any: {occurrences: 10, gestures: {BEAT: 0.2, ME: 0.1}}
"""


def _written(folder: Path, text: str) -> Path:
    path = folder / "nobody.yaml"
    path.write_text(text, encoding="utf-8")
    return path


def test_what_is_written_is_read_again(tmp_path: Path) -> None:
    learnt = learn(read_annotations([SWEEPING]), "nobody")
    first = profile_yaml(learnt)
    read = read_profile(_written(tmp_path, first.decode()))
    assert profile_yaml(read) == first
    assert read.gestures_per_minute == pytest.approx(learnt.gestures_per_minute, abs=0.001)
    assert read.database == learnt.database


def test_a_small_profile_is_enough(tmp_path: Path) -> None:
    profile = read_profile(_written(tmp_path, SMALL), {"BEAT", "ME"})
    assert profile.name == "nobody"
    assert profile.forms["ME"].size == 0.8
    assert profile.tag("deixis.self") == profile.tags["any"]


@pytest.mark.parametrize(("said", "shares"), [("0.5", (0.5,)), ("[0.9, 0.2]", (0.9, 0.2))])
def test_units_go_on_by_one_share_or_by_one_for_each_size(tmp_path: Path, said: str, shares: tuple[float, ...]) -> None:
    assert read_profile(_written(tmp_path, f"{SMALL}units: {{joined: {said}}}\n")).units.joined == shares


@pytest.mark.parametrize(
    ("old", "new", "line", "told"),
    [
        ("  BEAT: {share", "  BEET: {share", 4, "the library has no gesture 'BEET'; did you mean 'BEAT'?"),
        ("  any:", "  negation:", 7, "the tag 'any' is missing"),
        (
            "  any:",
            "  negatoin: {occurrences: 1, gestures: {}}\n  any:",
            7,
            "no function is called 'negatoin'; did",
        ),
        ("left: 0.5", "left: 0.7", 5, "the shares sum to 1.200"),
        ("ME: 0.1", "YOU: 0.1", 7, "YOU is not among the lexemes of this profile"),
        ("gestures_per_minute: 12", "gestures_per_minute: -1", 2, "greater than 0"),
        ("tags:", "units: {joined: [0.5, 1.5]}\ntags:", 6, "less than or equal to 1"),
        ("size: 0.8", "sise: 0.8", 5, "unknown key"),
    ],
)
def test_mistakes_have_their_place(tmp_path: Path, old: str, new: str, line: int, told: str) -> None:
    with pytest.raises(AuthoringError) as raised:
        read_profile(_written(tmp_path, SMALL.replace(old, new)), {"BEAT", "ME", "YOU"}, {"negation"})
    assert any(each.line == line and told in each.message for each in raised.value.mistakes)


def test_rests_and_places_are_checked(tmp_path: Path) -> None:
    more = SMALL + "rests: {near: sleeping}\ndatabase:\n  - {lexeme: ME, hand: left, from: XP, to: XC YCC ZFar out}\n"
    with pytest.raises(AuthoringError) as raised:
        read_profile(_written(tmp_path, more))
    assert [(each.line, each.column) for each in raised.value.mistakes] == [(8, 15), (10, 36)]


def test_words_are_those_of_the_realizer() -> None:
    assert tuple(Sideways) == SIDEWAYS
    assert tuple(HeightSector) == HEIGHTS
    assert tuple(Depth) == DEPTHS
    assert set(RESTS) == set(POSES) - {*WAITS, LIFTED}  # between ideas, by level: not for authors to choose
