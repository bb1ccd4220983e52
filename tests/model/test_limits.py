"""The limits of arms, by their arithmetic."""

import pytest

from understudy.errors import InputError
from understudy.model import Hand, Level, Schedule
from understudy.model.figure import GestureManner
from understudy.model.limits import (
    BRIEFEST_SHARE,
    EASY_TRANSITION_S,
    SHORTEST_STROKE_S,
    SHORTEST_TRANSITION_S,
    SLOWEST_STROKE_M_S,
    TOP_STROKE_SPEED_M_S,
    ArmEnds,
    GestureForm,
    GestureTable,
    MotionLimits,
    brief_share,
    equal_transition_s,
    is_brief,
    playable_size,
    shortest_transition_s,
    size_of,
    transition_times,
)


def form(
    start_m: float = 0.0, relax_m: float = 0.3, *arms: Hand, speed_m_s: float = 0.6, before_s: float = 0.3
) -> GestureForm:
    """A stroke outwards."""
    ends = ArmEnds((start_m, 0.0, 0.0), (relax_m, 0.0, 0.0), (relax_m, 0.0, 0.0))
    return GestureForm(before_s, 0.2, speed_m_s, dict.fromkeys(arms or (Hand.RIGHT,), ends))


def test_a_way_may_be_faster_than_the_stroke_by_the_threshold_and_never_shorter_than_a_hand_can_turn() -> None:
    assert shortest_transition_s(0.44, 0.6) == pytest.approx(0.4)
    assert shortest_transition_s(0.0, 0.6) == SHORTEST_TRANSITION_S


def test_a_way_as_fast_as_the_stroke_takes_its_length_by_that_speed() -> None:
    assert equal_transition_s(0.3, 0.6) == pytest.approx(0.5)
    assert equal_transition_s(0.06, 0.6) == EASY_TRANSITION_S


def test_size_grows_with_the_root_of_the_amount_until_the_stroke_is_too_fast() -> None:
    assert size_of(None) == size_of(0.5) == 1.0
    assert size_of(1.0) == pytest.approx(2**0.5)
    assert playable_size(1.2, 0.5) == pytest.approx(1.2)
    assert playable_size(2.0, 0.8) * 0.8 == pytest.approx(TOP_STROKE_SPEED_M_S)


def test_the_way_between_two_gestures_is_that_of_the_arms_that_make_both() -> None:
    """From .3 m out back to 0, at .6 m/s: .3 / 1.1 s at least, .5 s to be as fast."""
    times = transition_times((form(),), (form(0.0, 0.3, Hand.LEFT, Hand.RIGHT),))
    assert [times.shortest_s, times.equal_s] == pytest.approx([0.3 / 1.1, 0.5])
    apart = transition_times((form(0.0, 0.3, Hand.LEFT),), (form(),))
    assert (apart.shortest_s, apart.equal_s) == (0.0, 0.0)


def test_the_form_that_takes_longest_counts() -> None:
    near, far = form(start_m=0.3), form(start_m=-0.3)
    assert transition_times((form(),), (near, far)) == transition_times((form(),), (far,))


def test_a_small_gesture_is_reached_from_nearer_and_a_stroke_without_speed_is_slow() -> None:
    """An amount of an eighth is half the size: .15 m at .3 m/s."""
    small = transition_times((form(),), (form(),), amounts=(0.125, 0.125))
    assert small.shortest_s == pytest.approx(0.15 / 0.8)
    assert form(speed_m_s=0.0).speed_m_s(None) == SLOWEST_STROKE_M_S


def test_a_lexeme_that_is_not_in_the_table_has_no_forms() -> None:
    table = GestureTable({("BEAT", Level.LOW, Hand.RIGHT): (form(),)})
    assert table.of("BEAT", Level.LOW) == {Hand.RIGHT: (form(),)}
    assert table.of("BEAT", Level.HIGH) == table.of("WAVE", Level.LOW) == {}


def test_who_gestures_wide_and_fast_has_strokes_and_ways_of_his_own() -> None:
    """As the realizer makes clips in a manner: times by pace, ways by space, speeds by both."""
    form = GestureForm(0.4, 0.2, 0.6, {Hand.LEFT: ArmEnds((0.1, 0.0, 0.0), (0.0, 0.2, 0.0), (0.0, 0.2, 0.0))})
    own = form.in_manner(GestureManner(space=1.2, pace=1.25))
    assert (own.before_s, own.after_s) == pytest.approx((0.32, 0.16))
    assert own.stroke_speed_m_s == pytest.approx(0.6 * 1.2 * 1.25)
    assert own.arms[Hand.LEFT].relax == pytest.approx((0.0, 0.24, 0.0))


def test_a_brief_form_begins_nearer_to_its_end_and_is_as_fast() -> None:
    whole = GestureForm(0.4, 0.2, 0.6, {Hand.LEFT: ArmEnds((0.4, 0.0, 0.2), (0.0, 0.2, 0.2), (0.0, 0.1, 0.0))})
    brief = whole.brief()
    assert brief.stroke_s == pytest.approx(BRIEFEST_SHARE * whole.stroke_s)
    assert brief.before_s / brief.after_s == pytest.approx(whole.before_s / whole.after_s)
    assert brief.stroke_speed_m_s == whole.stroke_speed_m_s
    assert brief.arms[Hand.LEFT].stroke_start == pytest.approx((0.2, 0.1, 0.2))
    assert brief.arms[Hand.LEFT].relax == whole.arms[Hand.LEFT].relax


def test_no_stroke_is_briefer_than_peoples() -> None:
    assert brief_share(0.4) * 0.4 == pytest.approx(SHORTEST_STROKE_S)
    assert brief_share(0.25) == brief_share(0.1) == 1.0


@pytest.mark.parametrize(("longest_s", "brief"), [(0.6, False), (0.48, False), (0.47, True), (0.3, True), (0.2, False)])
def test_a_stroke_is_brief_where_it_has_half_to_four_fifths_of_its_time(longest_s: float, *, brief: bool) -> None:
    assert is_brief(0.6, longest_s) is brief


LIMITS = MotionLimits(behaviors=0, duration_s=10.0, frames=600, content_bytes=5)


def test_a_motion_at_its_limits_passes() -> None:
    LIMITS.check(Schedule((), 10.0), frame_rate_hz=60)
    LIMITS.check(Schedule((), 9.0), frame_rate_hz=60, tail_s=1.0)
    LIMITS.check_content(b"12345")


@pytest.mark.parametrize(
    ("duration_s", "frame_rate_hz", "tail_s", "what"),
    [(10.1, 30, 0.0, "seconds"), (9.5, 60, 0.6, "seconds"), (9.0, 90, 0.0, "frames"), (1e300, 60, 0.0, "seconds")],
)
def test_more_is_refused_with_the_limit(duration_s: float, frame_rate_hz: int, tail_s: float, what: str) -> None:
    with pytest.raises(InputError, match=f"{what}; at most") as caught:
        LIMITS.check(Schedule((), duration_s), frame_rate_hz=frame_rate_hz, tail_s=tail_s)
    assert caught.value.code == "motion_too_large"


def test_a_file_too_large_is_refused() -> None:
    with pytest.raises(InputError, match="6 bytes; at most 5"):
        LIMITS.check_content(b"123456")
