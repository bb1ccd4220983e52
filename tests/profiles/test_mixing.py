"""Profiles between two speakers."""

import pytest

from tests.support.annotations import SPARING, SWEEPING
from understudy.profiles.annotation.reading import read_annotations
from understudy.profiles.learning.learner import learn
from understudy.profiles.mixing import mix
from understudy.profiles.profile import Profile


@pytest.fixture(scope="module")
def both() -> tuple[Profile, Profile]:
    one, other = read_annotations([SWEEPING, SPARING])
    return learn([one], "one"), learn([other], "other")


def test_the_ends_are_the_speakers(both: tuple[Profile, Profile]) -> None:
    for share, whole in ((0.0, both[0]), (1.0, both[1])):
        made = mix(*both, share, name="m")
        assert made.gestures_per_minute == whole.gestures_per_minute
        assert made.units.merge_within_s == whole.units.merge_within_s
        assert made.units.joined == pytest.approx(whole.units.joined)
        assert made.rests == whole.rests
        for lexeme, habit in whole.lexemes.items():
            assert made.lexemes[lexeme].share == pytest.approx(habit.share)
        for tag, said in whole.tags.items():
            assert {name: p for name, p in made.tags[tag].lexemes.items() if p} == pytest.approx(said.lexemes)


def test_the_middle_lies_between(both: tuple[Profile, Profile]) -> None:
    made = mix(*both, 0.5, name="m")
    assert made.gestures_per_minute == pytest.approx(sum(each.gestures_per_minute for each in both) / 2)
    assert sum(habit.share for habit in made.lexemes.values()) == pytest.approx(1)
    sums = [sum(row.values()) for row in made.follows.values()]
    sums += [sum(row.values()) for row in made.hand_follows.values()]
    assert sums == pytest.approx([1.0] * len(sums))
    assert {each.lexeme for each in made.database} == {each.lexeme for one in both for each in one.database}
