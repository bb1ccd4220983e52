"""Finding the behaviour an edit refers to after the choice has changed; a missing one is reported."""

from dataclasses import replace

import pytest

from understudy.edits.finding import find_behaviors
from understudy.model import Channel, Performance
from understudy.model.edits import BehaviorEdit, BehaviorReference, WordReference

from ..support.edits import reference_to


def test_every_behaviour_is_found_by_what_an_author_writes_of_it(performance: Performance) -> None:
    kept = [each for each in performance.behaviors if each.kept]
    edits = [BehaviorEdit(of=reference_to(each, performance), lexeme="X") for each in kept]
    found = find_behaviors(performance, edits)
    assert found.notices == ()
    assert [found.behaviors[number].id for number in range(len(edits))] == [each.id for each in kept]


@pytest.mark.parametrize(
    "change",
    [{"lexeme": "ANOTHER"}, {"function": None}, {"function": "nothing", "family": None}, {"offset_s": None}],
)
def test_one_thing_in_common_is_enough(performance: Performance, change: dict[str, str | None]) -> None:
    gesture = next(each for each in performance.behaviors if each.kept and each.function and each.moment)
    reference = replace(reference_to(gesture, performance), **change)  # type: ignore[arg-type]
    assert find_behaviors(performance, [BehaviorEdit(of=reference, lexeme="X")]).behaviors == {0: gesture}


@pytest.mark.parametrize(
    ("reference", "code"),
    [
        (BehaviorReference(Channel.GESTURE, WordReference(0, "Yes"), lexeme="NEGATION"), "edit_word_gone"),
        (BehaviorReference(Channel.GESTURE, WordReference(0, "No,"), lexeme="GREETING"), "edit_behavior_gone"),
        (BehaviorReference(Channel.POSTURE, WordReference(0, "No,"), function="negation"), "edit_behavior_gone"),
    ],
)
def test_what_is_gone_is_told(performance: Performance, reference: BehaviorReference, code: str) -> None:
    found = find_behaviors(performance, [BehaviorEdit(of=reference, lexeme="X")])
    assert found.behaviors == {}
    assert [notice.code for notice in found.notices] == [code]
    assert found.notices[0].message.startswith("behaviors[0]: ")


def test_a_locked_one_that_is_gone_is_no_conflict(performance: Performance) -> None:
    reference = BehaviorReference(Channel.GESTURE, WordReference(0, "No,"), lexeme="GREETING")
    assert find_behaviors(performance, [BehaviorEdit(of=reference, lock=True)]).notices == ()


def test_two_edits_do_not_mean_the_same_behaviour(performance: Performance) -> None:
    gesture = next(each for each in performance.behaviors if each.kept and each.kind is Channel.GESTURE)
    edits = [BehaviorEdit(of=reference_to(gesture, performance), lexeme="X")] * 2
    found = find_behaviors(performance, edits)
    assert list(found.behaviors) == [0]
    assert [notice.code for notice in found.notices] == ["edit_behavior_gone"]
