"""What begins or ends at another time than it was asked for is told."""

import pytest

from understudy.model import Behavior, Channel, Hand, Schedule, SyncPoints
from understudy.models import load_realizer
from understudy.realizer.body.motion import Decision
from understudy.realizer.realizing import realize
from understudy.realizer.scheduling.deviations import timing_deviations

ASKED = Behavior("g1", Channel.GESTURE, "BEAT", SyncPoints(1.0, 3.0), 0, 0, 1.0, hand=Hand.RIGHT)


def test_a_beat_for_which_two_seconds_were_asked_says_what_it_takes() -> None:
    motion = realize(load_realizer(), Schedule((ASKED,), 4.0), frame_rate_hz=30)
    made = motion.realized["g1"]
    told = [each for each in motion.decisions if each.action == "timed"]
    parts = []
    if abs(made.start - 1.0) >= 0.05:
        parts.append(f"begins at {made.start:.2f} s, not at 1.00 s")
    if abs(made.end - 3.0) >= 0.05:
        parts.append(f"ends at {made.end:.2f} s, not at 3.00 s")
    assert parts
    assert told == [Decision("g1", "timed", "; ".join(parts))]


@pytest.mark.parametrize(
    ("made", "decided", "told"),
    [
        (SyncPoints(1.04, 2.96), None, []),
        (SyncPoints(1.1, 3.0), None, ["begins at 1.10 s, not at 1.00 s"]),
        (SyncPoints(0.9, 3.2), None, ["begins at 0.90 s, not at 1.00 s; ends at 3.20 s, not at 3.00 s"]),
        (SyncPoints(0.9, 3.2), "held", ["begins at 0.90 s, not at 1.00 s"]),
        (SyncPoints(1.2, 3.2), "blended", ["ends at 3.20 s, not at 3.00 s"]),
        (SyncPoints(1.2, 3.2), "dropped", []),
    ],
)
def test_what_is_told_is_not_told_twice(made: SyncPoints, decided: str | None, told: list[str]) -> None:
    decisions = [Decision("g1", decided, "why")] if decided else []
    assert [each.reason for each in timing_deviations([ASKED], {"g1": made}, decisions)] == told
