"""Limits on the motion in one response. All but that on bytes are checked before any motion is computed."""

import math
from dataclasses import dataclass

from ...errors import InputError
from ..schedule import Schedule


@dataclass(frozen=True, slots=True)
class MotionLimits:
    """The most behaviours, seconds, frames and bytes of a motion."""

    behaviors: int = 1000
    duration_s: float = 150.0
    frames: int = 9000
    content_bytes: int = 32 << 20

    def check_count(self, behaviors: int) -> None:
        """Raises InputError `motion_too_large` for too many behaviours, before their times are known."""
        self._check("behaviours", behaviors, self.behaviors)

    def check(self, schedule: Schedule, *, frame_rate_hz: int, tail_s: float = 0.0) -> None:
        """Raises InputError `motion_too_large` with the limit that the schedule exceeds."""
        end_s = max([schedule.duration_s, *(behavior.sync.end for behavior in schedule.behaviors)]) + tail_s
        self.check_count(len(schedule.behaviors))
        self._check("seconds", end_s, self.duration_s)
        self._check("frames", math.ceil(end_s * frame_rate_hz), self.frames)

    def check_content(self, content: bytes) -> None:
        """Raises InputError `motion_too_large` for too many bytes."""
        self._check("bytes", len(content), self.content_bytes)

    def _check(self, what: str, count: float, most: float) -> None:
        if count > most:
            message = f"the motion would have {count:,.10g} {what}; at most {most:,.10g} are answered"
            raise InputError("motion_too_large", message, field="bml")
