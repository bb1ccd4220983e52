"""The shipped plan of plain lines, and properties of every plan."""

from itertools import pairwise

import pytest

from understudy.behavior.reading.decoding import STROKES_APART
from understudy.behavior.reading.planning import plan
from understudy.model import Channel, Moment, Parse, Utterance
from understudy.models import Understudy
from understudy.performance import find_functions

LINES = (
    "I have never, ever seen a dog that big in my life.",
    "You go down the hill, across the bridge, and it's right there on the left.",
    "Why would anyone in their right mind pay four hundred dollars for a lamp?",
    "Okay.",
)


def planned(understudy: Understudy, text: str, quantity: float = 1.0) -> tuple[Moment, ...]:
    analysis = find_functions(understudy.language, text)
    return plan(understudy.behavior.planner, analysis.utterance, analysis.functions, quantity=quantity)


@pytest.mark.parametrize("text", LINES)
def test_moments_are_in_order_within_the_line_and_strokes_are_apart(understudy: Understudy, text: str) -> None:
    moments = planned(understudy, text)
    count = len(text.split())
    assert all(0 <= each.first <= each.stroke <= each.last < count for each in moments)
    strokes = [each.stroke for each in moments if each.channel is Channel.GESTURE]
    assert all(later - earlier >= STROKES_APART for earlier, later in pairwise(strokes))
    assert len({each.id for each in moments}) == len(moments)


def test_a_denial_is_shown_on_the_word_that_denies_and_says_why(understudy: Understudy) -> None:
    moments = planned(understudy, "We absolutely never agreed to that.")
    shown = [each for each in moments if each.channel is Channel.GESTURE and "negation" in each.families[:2]]
    (moment,) = shown
    assert moment.stroke in (1, 2, 3)
    assert moment.terms
    assert all(term.weight for term in moment.terms)
    assert {family for each in moment.rejected for family in each.families} - {moment.families[0]}
    assert "shake" in {family for each in moments if each.channel is Channel.HEAD for family in each.families}


def test_how_much_is_done_follows_the_quantity(understudy: Understudy) -> None:
    def gestures(quantity: float) -> int:
        return sum(
            each.channel is Channel.GESTURE for text in LINES for each in planned(understudy, text, quantity=quantity)
        )

    counts = [gestures(quantity) for quantity in (0.0, 0.3, 1.0, 2.0)]
    assert counts == sorted(counts)
    assert counts[0] == 0
    assert counts[1] < counts[3]


def test_words_that_are_to_be_still_have_no_stroke(understudy: Understudy) -> None:
    analysis = find_functions(understudy.language, LINES[0])
    still = range(len(LINES[0].split()))
    moments = plan(understudy.behavior.planner, analysis.utterance, analysis.functions, still=still)
    assert not [each for each in moments if each.channel is Channel.GESTURE]


def test_nothing_is_planned_for_no_words(understudy: Understudy) -> None:
    assert plan(understudy.behavior.planner, Utterance((), Parse((), (), ())), ()) == ()


def test_a_mime_wants_a_word_that_says_what_is_mimed(understudy: Understudy) -> None:
    moments = planned(understudy, "So then he just drinks the whole bottle in one go.")
    mimed = [each for each in moments if each.families[0] == "emblem_other"]
    assert all(abs(each.stroke - 4) <= 3 for each in mimed)


@pytest.mark.parametrize(
    "text",
    [
        "The old house was dark and cold, but the new house is bright and warm.",
        "The soup is cheap but the wine is expensive.",
        "On the one hand it is quick, on the other hand it hurts for a week.",
    ],
)
def test_what_is_set_against_each_other_is_placed_left_then_right(understudy: Understudy, text: str) -> None:
    one, other = (each for each in planned(understudy, text) if each.set_against is not None)
    assert (one.families[:2], other.families[:2]) == (("contrast_sides", "left"), ("contrast_sides", "right"))
    assert (one.set_against, other.set_against) == (other.stroke, one.stroke)
    assert one.last < other.first
