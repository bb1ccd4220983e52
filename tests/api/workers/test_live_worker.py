"""How far sound may run ahead of the clock, and how much of a processor a stream may take."""

import pytest

from understudy.api.workers.live_worker import takes_too_much, too_soon_s

HOUR_S, AHEAD_S = 3600.0, 10.0


@pytest.mark.parametrize("clock", [0.995, 0.9998, 1.0, 1.0002, 1.005])
def test_a_sender_whose_clock_drifts_is_not_held_back_in_four_hours(clock: float) -> None:
    assert not any(too_soon_s(clock * hours * HOUR_S, hours * HOUR_S, AHEAD_S) for hours in (0.1, 1, 4))


def test_what_was_late_may_come_at_once() -> None:
    assert too_soon_s(30.0, 30.0, 0.0) == too_soon_s(30.0, 29.5, AHEAD_S) == 0.0


def test_what_comes_much_too_soon_waits() -> None:
    assert too_soon_s(30.0, 10.0, AHEAD_S) == pytest.approx(9.8)


@pytest.mark.parametrize(
    ("processor_s", "passed_s", "too_much"), [(4, 1, False), (9, 10, False), (11, 10, True), (6, 1, True)]
)
def test_a_stream_gives_way_that_takes_more_than_a_voice_needs(
    processor_s: float, passed_s: float, too_much: bool
) -> None:
    assert takes_too_much(processor_s, passed_s) is too_much
