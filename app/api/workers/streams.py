"""The processes of live streams: how many there may be, one for each client, ended with it."""

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from ...errors import ServiceError
from ...settings import Settings
from .pool import Pool
from .processes import Worker

_FORK_WITHIN_S = 10.0
_AGAIN_AFTER_S = 5.0


class Streams:
    """Gives each stream a process. Belongs to the event loop that made it."""

    def __init__(self, pool: Pool, settings: Settings) -> None:
        """The pool's nursery forks them; it replaces one that has ended."""
        self._pool, self._settings = pool, settings
        self._count = 0
        self._stopping = asyncio.Event()

    @property
    def count(self) -> int:
        """How many streams there are."""
        return self._count

    @asynccontextmanager
    async def process(self) -> AsyncIterator[Worker]:
        """A process for one stream, which ends with the block. Raises ServiceError `service_full`,
        `service_stopping`, `worker_lost`."""
        if self._stopping.is_set():
            raise stopping()
        if self._count >= self._settings.live_stream_count:
            message = f"{self._count} live streams are open, as many as may be; try again later"
            raise ServiceError("service_full", message, retry_after_s=_AGAIN_AFTER_S)
        self._count += 1
        try:
            worker = await self._forked()
            try:
                yield worker
            finally:
                worker.end()
        finally:
            self._count -= 1

    async def stopped(self) -> None:
        """Returns when the service is being stopped."""
        await self._stopping.wait()

    def stop(self) -> None:
        """Has all streams end, and none begin."""
        self._stopping.set()

    async def _forked(self) -> Worker:
        try:
            async with asyncio.timeout(_FORK_WITHIN_S):
                return await Worker.forked(self._pool.nursery, self._settings, is_live=True)
        except (OSError, EOFError, TimeoutError):
            message = "no process could be started for this stream; try again"
            raise ServiceError("worker_lost", message, retry_after_s=1.0) from None


def stopping() -> ServiceError:
    return ServiceError("service_stopping", "the service is stopping; try again in a moment", retry_after_s=5.0)
