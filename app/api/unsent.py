"""What a live stream tells, while it waits for a client that reads more slowly: of frames only the newest are kept, and
the client is told how many were left out; everything else waits, and when there is too much of it, so does the stream.
"""

import asyncio
from collections import deque

from ..schemas.live import to_frames_skipped
from .workers.messages import LiveOutput

MOST_FRAMES, MOST_OTHERS = 32, 64
"""Outputs that may wait, of frames and of everything else. An output has the frames of one chunk of sound."""


class Unsent:
    """A queue of outputs and their lines, for one that puts and one that takes."""

    def __init__(self) -> None:
        self._waiting: deque[tuple[LiveOutput, str]] = deque()
        self._skipped = 0
        self._changed = asyncio.Condition()

    async def put(self, output: LiveOutput, lines: str) -> None:
        """Frames at once, in place of the oldest where there is no room; all else when there is room."""
        async with self._changed:
            await self._changed.wait_for(lambda: output.are_frames or self._count(are_frames=False) < MOST_OTHERS)
            self._waiting.append((output, lines))
            if self._count(are_frames=True) > MOST_FRAMES:
                self._skip()
            self._changed.notify_all()

    async def take(self) -> tuple[LiveOutput, str]:
        """The next, when there is one; where frames were left out, first how many."""
        async with self._changed:
            await self._changed.wait_for(lambda: self._waiting)
            if self._skipped:
                count, self._skipped = self._skipped, 0
                return LiveOutput(ended=False, are_frames=False), to_frames_skipped(count)
            taken = self._waiting.popleft()
            self._changed.notify_all()
            return taken

    def _count(self, *, are_frames: bool) -> int:
        return sum(output.are_frames is are_frames for output, _ in self._waiting)

    def _skip(self) -> None:
        """Leaves out the oldest frames."""
        oldest = next(place for place, (output, _) in enumerate(self._waiting) if output.are_frames)
        self._skipped += len(self._waiting[oldest][1].splitlines())
        del self._waiting[oldest]
