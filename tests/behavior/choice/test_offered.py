"""What was offered and is not shown names what has its place, or what forbade it."""

import pytest

from tests.behavior.candidates.test_demands import spoken
from understudy.model import Demand, Direction
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis

LINE = "No, I never said that it was the biggest house in town."


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


def test_what_is_forbidden_names_who_forbade_it(understudy: Understudy) -> None:
    direction = Direction(demands=(Demand("gesture_negation", 0, 11, always=False, by="the note never[0]"),))
    behaviors = perform_analysis(understudy, spoken(understudy, LINE), Options(), direction).behaviors
    (told, *_) = [each for each in behaviors if each.lexeme == "NEGATION" and not each.kept]
    assert (told.limit, told.reason) == ("never", "never, by the note never[0]")


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
