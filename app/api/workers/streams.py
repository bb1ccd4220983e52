"""The processes of live streams, limited in number, of each caller and of all; each ends with its stream."""

import asyncio
from collections import Counter
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from ...errors import ServiceError, TooManyError
from ...settings import Settings
from ..admission.rates import Frequency
from .pool import Pool
from .processes import Worker

_AGAIN_AFTER_S = 5.0
_A_SECOND = 8.0
"""A process is forked in .01 s; a caller that begins more streams a second than this waits, after as many at once as
there are places."""


class Streams:
    """Gives each stream a process. Belongs to one event loop."""

    def __init__(self, pool: Pool, settings: Settings) -> None:
        """The pool forks the processes."""
        self._pool, self._settings = pool, settings
        self._open = Counter[str]()
        self._stopping = asyncio.Event()
        self._frequency = Frequency(_A_SECOND, settings.live_stream_count)

    @property
    def count(self) -> int:
        """The number of open streams."""
        return self._open.total()

    @asynccontextmanager
    async def process(self, caller: str) -> AsyncIterator[Worker]:
        """A process for one stream of a caller, which ends with the block. Raises ServiceError `service_full`,
        `service_stopping`, `worker_lost`, TooManyError `too_many_streams`."""
        self._require_place(caller)
        self._open[caller] += 1
        try:
            await asyncio.sleep(self._frequency.wait_s(caller))
            worker = await self._forked()
            try:
                yield worker
            finally:
                worker.end()
        finally:
            self._open[caller] -= 1
            if not self._open[caller]:
                del self._open[caller]

    async def stopped(self) -> None:
        """Returns when the service is being stopped."""
        await self._stopping.wait()

    def stop(self) -> None:
        """Ends all streams, and refuses new ones."""
        self._stopping.set()

    def _require_place(self, caller: str) -> None:
        if self._stopping.is_set():
            raise stopping()
        if self.count >= self._settings.live_stream_count:
            message = f"{self.count} live streams are open, which is the limit; try again later"
            raise ServiceError("service_full", message, retry_after_s=_AGAIN_AFTER_S)
        if self._open[caller] >= self._settings.live_streams_each:
            message = f"{self._open[caller]} live streams of this key or address are open, which is the limit for one"
            raise TooManyError("too_many_streams", message, retry_after_s=_AGAIN_AFTER_S)

    async def _forked(self) -> Worker:
        try:
            async with asyncio.timeout(self._settings.deadline_s):  # long enough to restart a nursery
                return await self._pool.forked(is_live=True)
        except TimeoutError:
            message = "no process could be started for this stream; try again"
            raise ServiceError("worker_lost", message, retry_after_s=1.0) from None


def stopping() -> ServiceError:
    return ServiceError("service_stopping", "the service is stopping; try again in a moment", retry_after_s=5.0)
