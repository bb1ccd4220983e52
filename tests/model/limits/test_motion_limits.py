"""How much motion an answer may hold: just under and just over each limit."""

import pytest

from understudy.errors import InputError
from understudy.model import Schedule
from understudy.model.limits.motion_limits import MotionLimits

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
