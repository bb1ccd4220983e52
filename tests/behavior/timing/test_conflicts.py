from dataclasses import replace
from itertools import combinations, permutations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from understudy.behavior.table.behavior_table import BriefGesture, PhaseDuration, Timing
from understudy.behavior.timing.anchoring import PlacedBehavior
from understudy.behavior.timing.conflicts import compete, resolve
from understudy.behavior.timing.phases import TimingBasis, Window, placed
from understudy.model import Behavior, Channel, Hand
from understudy.model.limits import ArmEnds, GestureForm
from understudy.model.tables import GLANCE, LOOK

GESTURE = Timing(PhaseDuration(0.2, 0.4), PhaseDuration(0.2, 0.4), PhaseDuration(0.0, 1.0), PhaseDuration(0.0, 0.5))
NOD = Timing(
    PhaseDuration(0.0604, 0.15),
    PhaseDuration(0.1404, 0.3333),
    PhaseDuration(0, 0),
    PhaseDuration(0.0, 0.2),
    alignment=0.6,
)


def candidate(
    name: str,
    at_s: float,
    priority: float = 1.0,
    *,
    kind: Channel = Channel.GESTURE,
    hand: Hand | None = Hand.RIGHT,
    hold_s: float = 0.2,
) -> PlacedBehavior:
    basis = TimingBasis(GESTURE if kind is Channel.GESTURE else NOD, at_s, at_s + hold_s, stroked=True)
    sync = placed(basis, Window())
    assert sync is not None
    hand = hand if kind is Channel.GESTURE else None
    return PlacedBehavior(Behavior(name, kind, "X", sync, 0, 0, priority, hand=hand), basis)


def resolved(*candidates: PlacedBehavior) -> dict[str, Behavior]:
    kept, lost = resolve(candidates)
    return {behavior.id: behavior for behavior in (*(each.behavior for each in kept), *lost)}


def test_behaviours_with_room_stay_as_they_are() -> None:
    one, two = candidate("one", 2.0), candidate("two", 5.0)
    assert resolved(one, two) == {"one": one.behavior, "two": two.behavior}


def test_the_higher_priority_stays_and_the_loser_tells_why() -> None:
    outcome = resolved(candidate("low", 2.0, 3), candidate("high", 2.1, 5))
    assert outcome["high"].kept
    assert not outcome["low"].kept
    assert outcome["low"].lost_to == "high"
    assert outcome["low"].reason == "too close to X, which has priority 5, not 3"


def test_of_equals_the_earlier_stays() -> None:
    outcome = resolved(candidate("later", 2.1), candidate("sooner", 2.0))
    assert [name for name, behavior in outcome.items() if behavior.kept] == ["sooner"]
    assert "also has priority 1" in (outcome["later"].reason or "")


def look(name: str, at_s: float, priority: float, direction: str | None = "LEFT") -> PlacedBehavior:
    found = candidate(name, at_s, priority, kind=Channel.GAZE)
    return replace(found, behavior=replace(found.behavior, lexeme=LOOK, direction=direction))


def test_a_look_aside_while_the_head_is_taken_goes_to_the_eyes_alone() -> None:
    outcome = resolved(candidate("nod", 2.0, 5, kind=Channel.HEAD), look("look", 2.1, 3))
    assert outcome["nod"].kept
    assert outcome["look"].kept
    assert outcome["look"].lexeme == GLANCE
    assert "eyes alone" in (outcome["look"].reason or "")


def test_a_nod_at_a_more_important_look_aside_loses() -> None:
    outcome = resolved(candidate("nod", 2.05, 3, kind=Channel.HEAD), look("look", 2.1, 5))
    assert outcome["look"].lexeme == LOOK
    assert (outcome["nod"].kept, outcome["nod"].lost_to) == (False, "look")


def test_a_head_movement_without_time_at_its_word_comes_on_another_of_its_words() -> None:
    nod, shake = candidate("nod", 2.0, 3, kind=Channel.HEAD), candidate("shake", 2.1, 5, kind=Channel.HEAD)
    assert not resolved(nod, shake)["nod"].kept
    outcome = resolved(replace(nod, elsewhere_s=(2.2, 3.0)), shake)
    assert outcome["shake"] == shake.behavior
    assert outcome["nod"].kept
    assert outcome["nod"].sync.start < 3.0 < outcome["nod"].sync.end
    assert outcome["nod"].reason == "on another of its words, to have time beside its neighbour"


@pytest.mark.parametrize(("at_s", "direction"), [(6.0, "LEFT"), (2.1, None)], ids=["later", "at the listener"])
def test_other_looks_leave_the_head_alone(at_s: float, direction: str | None) -> None:
    outcome = resolved(candidate("nod", 2.0, 5, kind=Channel.HEAD), look("look", at_s, 3, direction))
    assert outcome["look"].lexeme == LOOK
    assert outcome["look"].reason is None


def test_the_lower_is_shortened_where_that_suffices() -> None:
    high, low = candidate("high", 3.5, 5), candidate("low", 2.5, 3)
    outcome = resolved(high, low)
    assert outcome["high"] == high.behavior
    assert outcome["low"].kept
    assert outcome["low"].sync.end == high.behavior.sync.start < low.behavior.sync.end
    assert outcome["low"].reason == "shortened to make room for X"


def test_the_reason_names_the_neighbour_and_nobody_far_away() -> None:
    near, far = candidate("near", 3.5, 5), candidate("far", 30.0, 5)
    near = replace(near, behavior=replace(near.behavior, lexeme="NEAR"))
    for others in ((near, far), (far, near)):
        assert resolved(*others, candidate("low", 2.5, 3))["low"].reason == "shortened to make room for NEAR"
        assert resolved(*others, candidate("low", 3.4, 3))["low"].lost_to == "near"


def test_a_retraction_gives_way_to_the_next_preparation() -> None:
    high, low = candidate("high", 2.0, 5), candidate("low", 2.7, 3)
    outcome = resolved(high, low)
    assert outcome["low"].kept
    assert outcome["high"].sync.end == outcome["low"].sync.start
    assert outcome["high"].sync.relax == high.behavior.sync.relax
    assert outcome["low"].sync.stroke_end == low.behavior.sync.stroke_end


def test_a_hold_gives_way_where_the_retraction_is_not_enough() -> None:
    outcome = resolved(candidate("high", 2.0, 5, hold_s=0.4), candidate("low", 2.5, 3))
    assert outcome["low"].kept
    assert outcome["high"].sync.stroke_end == 2.0
    assert outcome["high"].sync.relax == outcome["high"].sync.end == outcome["low"].sync.start


def test_too_close_for_the_shortest_phases_is_a_conflict() -> None:
    just, not_quite = resolved(candidate("a", 2.0, 5), candidate("b", 2.4)), candidate("b", 2.39)
    assert just["b"].kept
    assert not resolved(candidate("a", 2.0, 5), not_quite)["b"].kept


@pytest.mark.parametrize(
    ("one", "other", "compete"),
    [
        (Hand.LEFT, Hand.RIGHT, False),
        (Hand.LEFT, Hand.LEFT, True),
        (Hand.LEFT, Hand.BOTH, True),
        (Hand.BOTH, Hand.RIGHT, True),
    ],
)
def test_gestures_compete_hand_by_hand(one: Hand, other: Hand, *, compete: bool) -> None:
    outcome = resolved(candidate("one", 2.0, 2, hand=one), candidate("other", 2.0, 1, hand=other))
    assert outcome["other"].kept is not compete


def test_channels_do_not_compete_with_each_other() -> None:
    outcome = resolved(candidate("hand", 2.0), candidate("head", 2.0, kind=Channel.HEAD))
    assert all(behavior.kept for behavior in outcome.values())


def test_a_both_handed_gesture_waits_for_both_hands() -> None:
    left, right = candidate("left", 2.0, 5, hand=Hand.LEFT, hold_s=0.4), candidate("right", 2.3, 5)
    outcome = resolved(left, right, candidate("both", 3.0, 3, hand=Hand.BOTH))
    assert outcome["both"].kept
    assert outcome["both"].sync.start >= max(outcome[name].sync.end for name in ("left", "right"))


def test_the_order_of_the_candidates_does_not_matter() -> None:
    candidates = [candidate(f"g{number}", 2.0 + 0.3 * number, number % 2) for number in range(4)]
    outcomes = [resolved(*order) for order in permutations(candidates)]
    assert all(outcome == outcomes[0] for outcome in outcomes)


@given(
    st.lists(
        st.tuples(
            st.floats(1, 8), st.integers(0, 3), st.sampled_from(Hand), st.sampled_from([Channel.GESTURE, Channel.HEAD])
        ),
        max_size=14,
    )
)
def test_what_is_kept_never_overlaps(drawn: list[tuple[float, int, Hand, Channel]]) -> None:
    candidates = [
        candidate(f"b{number}", round(at_s, 3), priority, kind=kind, hand=hand)
        for number, (at_s, priority, hand, kind) in enumerate(drawn)
    ]
    outcome = resolved(*candidates)
    assert len(outcome) == len(candidates)
    kept = [behavior for behavior in outcome.values() if behavior.kept]
    for one, other in combinations(kept, 2):
        if one.kind is other.kind and (one.hand is other.hand or Hand.BOTH in (one.hand, other.hand)):
            assert one.sync.end <= other.sync.start or other.sync.end <= one.sync.start
    for each in candidates:
        winner = outcome[each.behavior.id].lost_to
        assert winner is None or outcome[winner].kept
        assert winner is None or outcome[winner].priority >= each.behavior.priority
        if outcome[each.behavior.id].kept:
            sync = outcome[each.behavior.id].sync
            times = [time_s for _, time_s in sync.in_order()]
            assert times == sorted(times)


def test_a_mouth_and_brows_move_at_once_and_two_mouths_do_not() -> None:
    smile, press, frown = (
        replace(candidate(lexeme, 2.0, priority, kind=Channel.FACE).behavior, lexeme=lexeme)
        for priority, lexeme in enumerate(("RAISE_MOUTH_CORNERS", "PRESS_LIPS", "LOWER_BROWS"))
    )
    assert compete(smile, press)
    assert not compete(smile, frown)


FORM = GestureForm(0.3, 0.2, 1.0, {Hand.RIGHT: ArmEnds((0.15, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))})
"""Back to its start from its end takes .15 s, the least there is; its stroke takes .5 s, half of it when brief."""


def asked_for(name: str, at_s: float, priority: float = 1.0) -> PlacedBehavior:
    """A gesture that may be brief."""
    timing = replace(GESTURE, stroke=PhaseDuration(0.5, 0.5))
    brief = BriefGesture(replace(timing, stroke=PhaseDuration(0.25, 0.25)), {Hand.RIGHT: (FORM.brief(),)})
    basis = TimingBasis(timing, at_s, at_s, stroked=True)
    sync = placed(basis, Window())
    assert sync is not None
    behavior = Behavior(name, Channel.GESTURE, "X", sync, 0, 0, priority, hand=Hand.RIGHT)
    return PlacedBehavior(behavior, basis, {Hand.RIGHT: (FORM,)}, brief)


@pytest.mark.parametrize(
    ("apart_s", "priorities", "stroke_s"),
    [
        (0.7, (2.0, 1.0), 0.5),
        (0.7, (1.0, 2.0), 0.5),
        (0.56, (1.0, 2.0), 0.5),
        (0.56, (2.0, 1.0), 0.25),
        (0.45, (1.0, 2.0), 0.25),
        (0.45, (2.0, 1.0), 0.25),
    ],
)
def test_what_is_asked_for_is_made_brief_where_there_is_no_time_for_the_whole(
    apart_s: float, priorities: tuple[float, float], stroke_s: float
) -> None:
    """The second stroke has .65 s for the whole and the way there; the first, if it chooses last, may be early."""
    outcome = resolved(asked_for("one", 2.0, priorities[0]), asked_for("two", 2.0 + apart_s, priorities[1]))
    one, two = outcome["one"].sync, outcome["two"].sync
    assert outcome["one"].kept
    assert outcome["two"].kept
    assert (two.stroke_end or 0.0) - (two.stroke_start or 0.0) == pytest.approx(stroke_s)
    assert (two.stroke_start or 0.0) - (one.relax or 0.0) >= 0.15 - 1e-6
    assert one.end <= two.start


def test_one_loses_where_even_the_brief_stroke_has_no_time() -> None:
    outcome = resolved(asked_for("one", 2.0, 2.0), asked_for("two", 2.38))
    assert (outcome["one"].kept, outcome["two"].kept) == (True, False)


def test_what_was_planned_is_not_made_brief() -> None:
    planned = (replace(each, brief=None) for each in (asked_for("one", 2.0, 2.0), asked_for("two", 2.45)))
    assert not resolved(*planned)["two"].kept
