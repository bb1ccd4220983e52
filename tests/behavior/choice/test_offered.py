"""What was offered and is not shown names what has its place, or what forbade it."""

from itertools import combinations
from math import inf
from typing import Literal

import pytest

from tests.behavior.candidates.test_demands import spoken
from understudy.behavior.choice.offered import is_offered
from understudy.model import Demand, Direction, Line, Mode
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis, perform_line

LINE = "No, I never said that it was the biggest house in town."
NOTHING = Line(None, "")


def test_each_offer_that_is_not_shown_says_why(understudy: Understudy) -> None:
    behaviors = perform_analysis(understudy, spoken(understudy, LINE), Options()).behaviors
    kept = {each.id: each for each in behaviors if each.kept}
    offered = [each for each in behaviors if ".offered" in each.id]
    assert offered
    for each in offered:
        assert not each.kept
        assert (each.lost_to is None) != (each.limit is None)
        assert each.reason
        if each.lost_to is not None:
            assert kept[each.lost_to].kind is each.kind


@pytest.mark.parametrize(
    "options",
    [
        Options(),
        Options(choice="priority"),
        Options(character="reserved", seed=4),
        Options(stillness=0.6),
        Options(mode=Mode.PROSODY),
        Options(mode=Mode.RANDOM, choice="priority"),
    ],
)
def test_whatever_is_not_kept_lost_to_something_or_has_a_limit(understudy: Understudy, options: Options) -> None:
    lines = (
        "Thank you so much, and please, sit down.",
        "I don't know, maybe we could meet over there, you and I.",
        LINE,
    )
    dropped = [
        each
        for line in lines
        for each in perform_analysis(understudy, spoken(understudy, line), options).behaviors
        if not each.kept
    ]
    assert dropped
    assert [each for each in dropped if not each.reason or (each.lost_to is None and each.limit is None)] == []


@pytest.mark.parametrize("choice", ["terms", "priority"])
def test_the_parts_of_a_worth_are_in_order_and_a_function_that_is_named_is_among_them(
    understudy: Understudy, choice: Literal["terms", "priority"]
) -> None:
    for line in (LINE, "No, no, no, that is three times bigger than what I asked for!"):
        performance = perform_analysis(understudy, spoken(understudy, line), Options(choice=choice))
        for each in performance.behaviors:
            weights = [abs(part.weight) for part in each.decided_by]
            assert weights == sorted(weights, reverse=True)
            if each.kept and each.function and each.decided_by:
                (shown,) = [function for function in performance.functions if function.id == each.function]
                named = " ".join(part.name for part in each.decided_by)
                assert f"rule {each.rule}" in named or shown.class_name in named


def test_what_is_forbidden_names_who_forbade_it(understudy: Understudy) -> None:
    direction = Direction(demands=(Demand("gesture_negation", 0, 11, always=False, by="the note never[0]"),))
    behaviors = perform_analysis(understudy, spoken(understudy, LINE), Options(), direction).behaviors
    (told, *_) = [each for each in behaviors if each.lexeme == "NEGATION" and not each.kept]
    assert (told.limit, told.reason) == ("never", "excluded by the note never[0]")


def test_a_function_is_named_only_where_its_rule_had_a_part(understudy: Understudy) -> None:
    for each in perform_analysis(understudy, spoken(understudy, LINE), Options()).behaviors:
        if each.kept and each.moment and each.function:
            assert each.rule
            assert not each.rule.startswith(("gesture_family", "head_family", "face_family"))


@pytest.mark.parametrize("seed", [0, 1])
def test_planned_movements_name_what_decided_them_largest_first(understudy: Understudy, seed: int) -> None:
    performance = perform_analysis(understudy, spoken(understudy, LINE), Options(seed=seed))
    gestures = [each for each in performance.behaviors if each.kept and each.moment and each.kind == "gesture"]
    assert gestures
    for each in gestures:
        weights = [abs(part.weight) for part in each.decided_by]
        assert weights
        assert weights[:-1] == sorted(weights[:-1], reverse=True)


def test_a_movement_that_is_offered_several_times_for_an_idea_is_told_once(understudy: Understudy) -> None:
    analysis = spoken(understudy, LINE)
    behaviors = perform_line(understudy, NOTHING, Options(), analysis=analysis, near=inf)
    offered = [each for each in behaviors.performance.behaviors if is_offered(each)]
    assert not any("inf" in (each.reason or "") for each in offered)
    for one, other in combinations(offered, 2):
        same = (one.kind, one.lexeme) == (other.kind, other.lexeme)
        assert not same or one.last < other.first or other.last < one.first
    assert any("also offered by" in (each.reason or "") for each in offered)


def test_what_is_shown_is_not_told_as_offered_too(understudy: Understudy) -> None:
    behaviors = perform_analysis(understudy, spoken(understudy, LINE), Options()).behaviors
    shown = [each for each in behaviors if each.kept and each.rule]
    for each in filter(is_offered, behaviors):
        assert not [
            one for one in shown if one.lexeme == each.lexeme and one.first <= each.last >= each.first >= one.last
        ]


def test_only_what_came_near_is_told(understudy: Understudy) -> None:
    told = possible = 0
    for text in (LINE, "You can take the left one, or you can take the right one.", "We should all go home now."):
        analysis = spoken(understudy, text)
        near = perform_analysis(understudy, analysis, Options()).behaviors
        every = perform_line(understudy, NOTHING, Options(), analysis=analysis, near=inf).performance.behaviors
        told, possible = told + sum(map(is_offered, near)), possible + sum(map(is_offered, every))
        assert [each for each in near if not is_offered(each)] == [each for each in every if not is_offered(each)]
    assert told < 0.5 * possible


@pytest.mark.parametrize("choice", ["terms", "priority"])
def test_every_movement_for_a_function_names_what_decided_it(
    understudy: Understudy, choice: Literal["terms", "priority"]
) -> None:
    analysis = spoken(understudy, "I really think that you know it, and I know why.")
    for each in perform_analysis(understudy, analysis, Options(choice=choice)).behaviors:
        assert each.function is None or each.decided_by


def test_where_functions_decide_the_parts_are_their_priority_and_the_rules_weight(understudy: Understudy) -> None:
    performance = perform_analysis(understudy, spoken(understudy, LINE), Options(choice="priority"))
    functions = {each.id: each for each in performance.functions}
    shown = [each for each in performance.behaviors if each.kept and each.function]
    assert shown
    for each in shown:
        function = functions[each.function or ""]
        parts = {part.name: part.weight for part in each.decided_by}
        assert parts[f"priority {function.priority:g} of {function.class_name}"] == function.priority
        assert any(name.startswith(f"rule {each.rule}, weight ") for name in parts)
