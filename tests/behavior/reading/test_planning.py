"""The shipped plan of plain lines, and properties of every plan."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from understudy.behavior.reading import worths as weighing
from understudy.behavior.reading.planning import FORBIDDEN, Plan, Understood, plan
from understudy.behavior.reading.player import Player
from understudy.behavior.reading.strokes import STROKES_APART_S
from understudy.behavior.reading.supports import GREAT_SCALE, GREAT_WEIGHT, WEIGHT_SCALE
from understudy.behavior.reading.word_times import usual_times_s
from understudy.behavior.reading.worths import (
    BESIDE,
    JUST_BEFORE,
    JUST_SHOWN,
    JUST_SHOWN_S,
    USUAL_SUPPORT,
    KindWorths,
    after_what_was_shown,
)
from understudy.model import (
    DEFAULT_CHARACTER,
    Alternative,
    Analysis,
    BehaviorCandidates,
    Channel,
    Function,
    Moment,
    Movement,
    Parse,
    Utterance,
)
from understudy.models import Understudy
from understudy.rules.stage import find_functions

LINES = (
    "I have never, ever seen a dog that big in my life.",
    "You go down the hill, across the bridge, and it's right there on the left.",
    "Why would anyone in their right mind pay four hundred dollars for a lamp?",
    "Okay.",
)


def player(understudy: Understudy, quantity: float = 1.0, seed: int = 0) -> Player:
    behavior = understudy.behavior
    entries = behavior.characters.named(DEFAULT_CHARACTER).entries
    return Player(behavior.families, entries, seed, quantity)


def plan_of(understudy: Understudy, text: str, who: Player, still: Sequence[int] = ()) -> Plan:
    analysis = find_functions(understudy.language, text)
    line = Understood(analysis.utterance, analysis.functions)
    return plan(understudy.behavior.planner, line, who, still=still)


@pytest.mark.parametrize("kind", ["squint", "smile", "tilt"])
def test_a_face_or_head_that_its_author_weighs_heavily_is_made(understudy: Understudy, kind: str) -> None:
    """A squint too, which the reading alone never makes."""
    models = understudy.behavior
    planner = replace(models.planner, kind_weights={"subject(first person)": {kind: 8.0}})
    weighed = replace(understudy, behavior=replace(models, planner=planner))
    text, who = "I left the keys on the table.", player(understudy)
    made, usual = (
        {family for moment in plan_of(each, text, who).moments for family in moment.families}
        for each in (weighed, understudy)
    )
    assert kind in made
    assert "squint" not in usual


def planned(understudy: Understudy, text: str, quantity: float = 1.0) -> tuple[Moment, ...]:
    return plan_of(understudy, text, player(understudy, quantity)).moments


@pytest.mark.parametrize("text", LINES)
def test_moments_are_in_order_within_the_line_and_strokes_are_apart(understudy: Understudy, text: str) -> None:
    moments = planned(understudy, text)
    count = len(text.split())
    assert all(0 <= each.first <= each.stroke <= each.last < count for each in moments)
    times_s = usual_times_s(count)
    strokes = [times_s[each.stroke] for each in moments if each.channel is Channel.GESTURE]
    assert all(later - earlier >= STROKES_APART_S - 1e-6 for earlier, later in pairwise(strokes))
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
    moments = plan_of(understudy, LINES[0], player(understudy), still=range(len(LINES[0].split()))).moments
    assert not [each for each in moments if each.channel is Channel.GESTURE]


def test_nothing_is_planned_for_no_words(understudy: Understudy) -> None:
    nothing = Understood(Utterance((), Parse((), (), ())), ())
    assert plan(understudy.behavior.planner, nothing, player(understudy)).moments == ()


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


def test_the_parts_told_are_the_sum(understudy: Understudy) -> None:
    found = plan_of(understudy, LINES[0], player(understudy, seed=3))
    worths = found.worths
    assert worths is not None
    for moment in found.moments:
        if moment.channel is Channel.GESTURE and moment.set_against is None:
            by_lexeme = {each: worths.of(moment.stroke, each) or -99.0 for each in worths.lexemes}
            lexeme = max(by_lexeme, key=lambda each: by_lexeme[each])
            parts = worths.parts(moment.stroke, lexeme)
            assert sum(part.weight for part in parts) == pytest.approx(worths.of(moment.stroke, lexeme), abs=0.5)
            assert [abs(part.weight) for part in parts] == sorted((abs(part.weight) for part in parts), reverse=True)


def test_a_mapping_rules_weight_moves_its_gesture(understudy: Understudy) -> None:
    """The same gesture, offered with more weight for the same function, is planned where it was not."""
    analysis = find_functions(understudy.language, "Whatever you say, it goes in the book.")
    entry = understudy.behavior.characters.named(DEFAULT_CHARACTER).entries["gesture_dismiss"]
    function = Function("f1", "negation", "plain", 0, 0, 3.0, "own")

    def log_odds(weight: float) -> float:
        movement = Movement("gesture_dismiss", 0, 0, 3.0, "own", "f1")
        offer = BehaviorCandidates(function, (Alternative((movement,), weight, 1.0),))
        line = Understood(analysis.utterance, analysis.functions, (), (offer,))
        worths = plan(understudy.behavior.planner, line, player(understudy)).worths
        assert worths is not None
        return worths.of(0, entry.lexeme) or 0.0

    assert log_odds(10.0) - log_odds(1.0) == pytest.approx(WEIGHT_SCALE * math.log(10), abs=1e-3)
    of_great_weight = GREAT_SCALE * math.log(100 / GREAT_WEIGHT)
    assert log_odds(100.0) - log_odds(GREAT_WEIGHT) == pytest.approx(of_great_weight, abs=1e-3)


@pytest.mark.parametrize(("name", "least"), [("gesture_hold_idea", 4), ("gesture_able", 4), ("gesture_force", 2)])
def test_a_rule_is_seen_on_more_lines_the_more_it_weighs_and_on_most_with_100(
    understudy: Understudy, name: str, least: int
) -> None:
    """A fist, which hardly suits these words, on fewer."""
    lines = (
        "Nobody believed the gizmo would work.",
        "Then we bought another gizmo, and nothing changed.",
        "They told us about the gizmo last summer.",
        "He said the gizmo was broken before he came.",
        "She handed me a gizmo and left without a word.",
    )
    analyses = [find_functions(understudy.language, line) for line in lines]

    def seen(weight: float) -> int:
        return sum(_is_shown(understudy, analysis, name, "gizmo", weight) for analysis in analyses)

    counts = [seen(weight) for weight in (0.3, 1, 3, 8, 20, 30, 50, 100, 300)]
    assert counts == sorted(counts)
    assert counts[-2] >= least


def _is_shown(understudy: Understudy, analysis: Analysis, name: str, text: str, weight: float) -> bool:
    """Whether a stroke falls on the word because of a rule of this weight that offers the behaviour there."""
    word = next(each.index for each in analysis.utterance.words if each.text.startswith(text))
    function = Function("f1", "topic", "plain", word, word, 3.0, "own")
    offer = BehaviorCandidates(function, (Alternative((Movement(name, word, word, 3.0, "own", "f1"),), weight, 1.0),))
    line = Understood(analysis.utterance, analysis.functions, (), (offer,))
    moments = plan(understudy.behavior.planner, line, player(understudy)).moments
    strokes = [each for each in moments if each.channel is Channel.GESTURE and each.stroke == word]
    return any(term.name.startswith("rule own") for each in strokes for term in each.terms)


WHOLE = np.ones(1, np.float32)
"""The share of a stroke that has no other near it."""


def test_what_was_shown_just_before_is_worth_less_and_says_so(understudy: Understudy) -> None:
    found = plan_of(understudy, LINES[0], player(understudy))
    assert found.worths is not None
    before = replace(found.worths, just_shown={})
    lexeme = before.best(2)
    after = after_what_was_shown(before, dict.fromkeys((2, 6), WHOLE), [0.5 * word for word in range(12)])
    lost = (after.of(6, lexeme) or 0.0) - (before.of(6, lexeme) or 0.0)
    assert lost == pytest.approx(JUST_SHOWN * (1 - 2.0 / JUST_SHOWN_S), abs=1e-3)
    assert {part.name: part.weight for part in after.parts(6, lexeme)}[JUST_BEFORE] == pytest.approx(lost, abs=0.01)
    assert after.of(2, lexeme) == before.of(2, lexeme)


def test_what_would_only_be_shown_again_is_left_out(understudy: Understudy, monkeypatch: pytest.MonkeyPatch) -> None:
    avowed = "I love you, I love you, I love you, I love you."

    def gestures() -> int:
        found = plan_of(understudy, avowed, player(understudy))
        return sum(moment.channel is Channel.GESTURE for moment in found.moments)

    monkeypatch.setattr(weighing, "JUST_SHOWN", 0.0)
    repeated = gestures()
    monkeypatch.setattr(weighing, "JUST_SHOWN", -30.0)
    assert 1 <= gestures() < repeated


def test_a_number_is_counted_once_on_its_word(understudy: Understudy) -> None:
    moments = planned(understudy, "There were three of them.")
    assert [each.stroke for each in moments if each.families[0] == "count"] == [2]


def test_two_numbers_near_each_other_are_each_counted_by_their_own_stroke(understudy: Understudy) -> None:
    found = plan_of(understudy, "There are three doors, and only one of them is open.", player(understudy))
    assert found.worths is not None
    three, one = (each.stroke for each in found.moments if each.channel is Channel.GESTURE)
    odds = [[found.worths.of(word, lexeme) or 0.0 for lexeme in ("COUNT_THREE", "COUNT_ONE")] for word in (three, one)]
    assert [[each > FORBIDDEN for each in row] for row in odds] == [[True, False], [False, True]]


def test_left_and_right_are_shown_each_on_its_word(understudy: Understudy) -> None:
    moments = planned(understudy, "My brother went left, and I went right.")
    shown = [(each.families[0], each.stroke) for each in moments if each.channel is Channel.GESTURE]
    assert [stroke for _, stroke in shown] == [3, 7]
    assert shown[0][0] == "left"
    assert shown[1][0] != "left"


def test_what_lies_nearer_to_another_stroke_is_told(understudy: Understudy) -> None:
    found = plan_of(understudy, LINES[0], player(understudy))
    assert found.worths is not None
    before = replace(found.worths, just_shown={}, beside={})
    lexeme = before.best(2)
    half = np.full(len(before.lexemes), 0.5, np.float32)
    after = after_what_was_shown(before, {2: half}, [0.5 * word for word in range(12)])
    lost = (after.of(2, lexeme) or 0.0) - (before.of(2, lexeme) or 0.0)
    assert lost < 0
    assert {part.name: part.weight for part in after.parts(2, lexeme)}[BESIDE] == pytest.approx(lost, abs=0.01)


def test_nothing_is_lost_for_what_was_shown_long_before(understudy: Understudy) -> None:
    worths = plan_of(understudy, LINES[0], player(understudy)).worths
    assert worths is not None
    assert (
        after_what_was_shown(
            worths, dict.fromkeys((0, 6), WHOLE), [JUST_SHOWN_S * word for word in range(12)]
        ).just_shown
        == {}
    )


def test_a_rule_of_more_than_the_usual_weight_moves_the_head(understudy: Understudy) -> None:
    analysis = find_functions(understudy.language, "Whatever you say, it goes in the book.")
    function = Function("f1", "negation", "plain", 4, 7, 3.0, "own")
    movement = Movement("double_nod", 4, 7, 3.0, "own", "f1")

    def heads(weight: float) -> KindWorths:
        offer = BehaviorCandidates(function, (Alternative((movement,), weight, 1.0),))
        line = Understood(analysis.utterance, analysis.functions, (), (offer,))
        return plan(understudy.behavior.planner, line, player(understudy)).kinds[Channel.HEAD]

    usual, great = heads(3.0), heads(40.0)
    of_weight = WEIGHT_SCALE * math.log(GREAT_WEIGHT) + GREAT_SCALE * math.log(40 / GREAT_WEIGHT)
    surplus = of_weight - USUAL_SUPPORT
    assert great.margin("nod", 4, 7) - usual.margin("nod", 4, 7) == pytest.approx(surplus, abs=0.4)
    assert great.margin("tilt", 4, 7) == usual.margin("tilt", 4, 7)
    assert "rule own, above average" in {term.name for term in great.parts("nod", 5)}
    assert "rule own, above average" not in {term.name for term in usual.parts("nod", 5)}


def test_seed_0_is_the_best_take_and_others_are_drawn_near_it(understudy: Understudy) -> None:
    def strokes(seed: int) -> list[tuple[int, str]]:
        found = plan_of(understudy, LINES[2], player(understudy, seed=seed)).moments
        return [(each.stroke, each.families[0]) for each in found if each.channel is Channel.GESTURE]

    assert strokes(0) == strokes(0)
    assert strokes(5) == strokes(5)
    assert len({tuple(strokes(seed)) for seed in range(6)}) > 1
