"""What was pointed at is pointed at again where the words point it out."""

import numpy as np
import pytest

from understudy import say
from understudy.behavior.reading.parallels import Ground
from understudy.behavior.reading.resumptions import ResumedStroke, resumed_strokes
from understudy.behavior.reading.word_times import usual_times_s
from understudy.library.language import find_functions
from understudy.model import Channel
from understudy.models import Understudy

DOOR = "That door is locked. Nobody has ever opened that door."
"""Word 1 and word 9."""


def resumed(
    understudy: Understudy, text: str, pointed: tuple[int, ...], *others: int, still: tuple[int, ...] = ()
) -> list[ResumedStroke]:
    """The strokes that are resumed, where these are taken and the words `pointed` point."""
    utterance = find_functions(understudy.language, text).utterance
    count = len(utterance.words)
    ground = Ground(usual_times_s(count), np.zeros(count, np.float32), still)
    return list(resumed_strokes(utterance.parse.tokens, pointed, sorted((*pointed, *others)), ground))


def test_a_thing_that_was_pointed_at_is_pointed_at_again(understudy: Understudy) -> None:
    assert resumed(understudy, DOOR, (1,)) == [ResumedStroke(9, 1)]
    assert resumed(understudy, DOOR, (1, 8)) == [ResumedStroke(8, 1)]


def test_a_stroke_beside_the_name_goes_to_it(understudy: Understudy) -> None:
    assert resumed(understudy, DOOR, (1, 7)) == [ResumedStroke(9, 1, instead=7)]


@pytest.mark.parametrize(
    ("text", "pointed"),
    [
        (DOOR, ()),
        ("That door is locked. Nobody has ever opened that window.", (1,)),
        ("That door is locked. Nobody has ever opened a door.", (1,)),
        ("That door is locked, so open that door.", (7,)),
    ],
)
def test_what_was_not_shown_or_not_pointed_out_is_not(
    understudy: Understudy, text: str, pointed: tuple[int, ...]
) -> None:
    assert resumed(understudy, text, pointed) == []


def test_there_is_time_for_it_beside_other_strokes(understudy: Understudy) -> None:
    assert resumed(understudy, DOOR, (1,), 8) == []
    assert resumed(understudy, DOOR, (1,), 4) == [ResumedStroke(9, 1)]
    assert resumed(understudy, DOOR, (1,), still=(9,)) == []


def test_the_plan_shows_it_and_says_why(understudy: Understudy) -> None:
    performance = say(understudy, "Do you see that bridge? The king was born under that bridge.")
    shown = (each for each in performance.behaviors if each.kept and each.slots)
    pointing = [each for each in shown if each.slots and each.slots.referent == "bridge"]
    assert [each.lexeme.startswith(("POINT", "THERE")) for each in pointing] == [True, True]
    (moment,) = (each for each in performance.moments if each.id == pointing[-1].moment)
    assert moment.channel is Channel.GESTURE
    assert moment.terms[0].name.startswith("pointed at on word ")
