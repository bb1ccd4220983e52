"""What is kept is found by its time, in the order in which it was kept, whatever was changed meanwhile."""

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from tests.behavior.timing.test_conflicts import candidate
from understudy.behavior.timing.anchoring import PlacedBehavior
from understudy.behavior.timing.time_index import TimeIndex

AT_S = st.floats(1.0, 40.0).map(lambda at_s: round(at_s, 1))


def _later(placed: PlacedBehavior) -> PlacedBehavior:
    sync = placed.behavior.sync
    return replace(placed, behavior=replace(placed.behavior, sync=replace(sync, start=(sync.start + sync.end) / 2)))


@given(st.lists(AT_S, max_size=30), st.floats(-5.0, 50.0), st.floats(0.0, 20.0))
def test_near_is_all_that_is_under_way(times_s: list[float], from_s: float, for_s: float) -> None:
    kept, expected = TimeIndex(), list[PlacedBehavior]()
    for number, at_s in enumerate(times_s):
        added = candidate(f"b{number}", at_s, 5)
        changed = [(expected[-1], _later(expected[-1]))] if number % 3 == 2 else []
        before, kept = kept, kept.with_one_more(added, changed)
        assert list(before) == expected
        expected = [*expected[: len(expected) - len(changed)], *(after for _, after in changed), added]
    assert list(kept) == expected
    under_way = [
        each for each in expected if each.behavior.sync.end > from_s and each.behavior.sync.start < from_s + for_s
    ]
    assert list(kept.near(from_s, from_s + for_s)) == under_way
    if expected:
        assert list(kept.without(expected[0])) == expected[1:]
