"""The outgoing queue of a live stream. A slow client gets only the newest frames and a count of the skipped ones; other
messages queue, and when the queue is full the stream blocks.
"""

import asyncio
from collections import deque

from ..schemas.live import to_frames_skipped
from .workers.messages import LiveOutput

MOST_FRAMES, MOST_OTHERS = 32, 64
"""Outputs that may wait, of frames and of everything else. An output has the frames of one chunk of sound."""


class OutgoingQueue:
    """A queue of outputs and their lines, for one producer and one consumer."""

    def __init__(self) -> None:
        self._waiting: deque[tuple[LiveOutput, str]] = deque()
        self._skipped = 0
        self._changed = asyncio.Condition()

    async def put(self, output: LiveOutput, lines: str) -> None:
        """Frames never wait: the oldest give way. Everything else waits for room."""
        async with self._changed:
            await self._changed.wait_for(lambda: output.are_frames or self._count(are_frames=False) < MOST_OTHERS)
            self._waiting.append((output, lines))
            if self._count(are_frames=True) > MOST_FRAMES:
                self._skip()
            self._changed.notify_all()

    async def take(self) -> tuple[LiveOutput, str]:
        """The next output, when there is one; after frames were skipped, first their number."""
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
