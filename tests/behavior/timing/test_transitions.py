import pytest

from understudy.behavior.table.behavior_table import PhaseDuration, Timing
from understudy.behavior.timing.anchoring import PlacedBehavior
from understudy.behavior.timing.phases import Placing, Window, placed
from understudy.behavior.timing.transitions import SHORTEST_HOLD_S, eased
from understudy.model import Behavior, Channel, Hand
from understudy.model.limits import ArmEnds, GestureForm

TIMING = Timing(PhaseDuration(0.2, 0.2), PhaseDuration(0.5, 0.5), PhaseDuration(0.0, 2.0), PhaseDuration(0.0, 0.0))
RIGHT = GestureForm(0.3, 0.2, 0.6, {Hand.RIGHT: ArmEnds((0.0, 0.0, 0.0), (0.3, 0.0, 0.0), (0.3, 0.0, 0.0))})
"""Back over its .3 m at .6 m/s takes .5 s."""


def gesture(name: str, at_s: float, until_s: float, hand: Hand = Hand.RIGHT) -> PlacedBehavior:
    """A stroke of .5 s that ends at `at_s`, held until `until_s`; its preparation takes .2 s."""
    placing = Placing(TIMING, at_s, until_s, stroked=True)
    sync = placed(placing, Window())
    assert sync is not None
    behavior = Behavior(name, Channel.GESTURE, "X", sync, 0, 0, 1.0, hand=hand)
    return PlacedBehavior(behavior, placing, dict.fromkeys((hand, Hand.RIGHT), (RIGHT,)))


def test_a_hold_gives_way_to_a_transition_as_fast_as_the_next_stroke() -> None:
    """The second stroke starts at 3.5 s, so the first relaxes at 3.0 s, not at 3.3 s."""
    first, second = eased((gesture("one", 2.0, 3.3), gesture("two", 4.0, 4.5)))
    assert first.behavior.sync.relax == first.behavior.sync.end == second.behavior.sync.start == pytest.approx(3.0)
    assert second.behavior.sync.stroke_start == pytest.approx(3.5)


def test_some_of_a_hold_is_left() -> None:
    first, second = eased((gesture("one", 2.9, 3.3), gesture("two", 4.0, 4.5)))
    assert first.behavior.sync.relax == second.behavior.sync.start == pytest.approx(2.9 + SHORTEST_HOLD_S)


def test_gestures_that_are_not_joined_stay_as_they_are() -> None:
    apart = (gesture("one", 2.0, 3.0), gesture("two", 4.0, 4.5))
    assert eased(apart) == apart


def test_a_hand_that_is_still_busy_keeps_a_gesture_of_both_where_it_is() -> None:
    busy = (
        gesture("left", 2.6, 3.2, Hand.LEFT),
        gesture("one", 2.0, 3.3),
        gesture("both", 4.0, 4.5, Hand.BOTH),
    )
    assert eased(busy) == busy
