"""Reads the bodies of requests into memory: each within its size and time, and all of them together within a limit.

Nothing of a body is parsed here. One whose Content-Length is too large is refused unread; otherwise bytes count as
they arrive, whatever it says.
"""

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass

from starlette.datastructures import Headers
from starlette.requests import ClientDisconnect
from starlette.types import Message, Receive

from ..errors import ServiceError, SlowClientError, TooLargeError
from ..settings import Settings

_RETRY_AFTER_S = 2.0


@dataclass(frozen=True, slots=True)
class _Chunk:
    """What arrived, and whether more will."""

    content: bytes
    more: bool


class Uploads:
    """All bodies that are in memory now."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._held_bytes = 0

    @property
    def held_bytes(self) -> int:
        """The bytes of all bodies in memory."""
        return self._held_bytes

    @asynccontextmanager
    async def body(
        self, receive: Receive, *, most_bytes: int, declared_bytes: int | None = None
    ) -> AsyncIterator[bytearray]:
        """A request's body, which counts as held until the block ends; one that is declared as too large is not read.

        Raises TooLargeError `body_too_large`, ServiceError `uploads_full` when all bodies together are too large,
        SlowClientError `upload_slow`, and ClientDisconnect.
        """
        if declared_bytes is not None and declared_bytes > most_bytes:
            raise _too_large(most_bytes)
        body = bytearray()
        try:
            await self._read(receive, body, most_bytes)
            yield body
        finally:
            self._held_bytes -= len(body)

    async def _read(self, receive: Receive, body: bytearray, most_bytes: int) -> None:
        settings = self._settings
        try:
            async with asyncio.timeout(settings.upload_s):
                more = True
                while more:
                    chunk = await self._chunk(receive)
                    more = chunk.more
                    if len(body) + len(chunk.content) > most_bytes:
                        await self._drop(chunk, receive, most_bytes)
                        raise _too_large(most_bytes)
                    self._hold(chunk.content, body)
        except TimeoutError:
            message = f"the body did not arrive within {settings.upload_s:g} s, or nothing of it for "
            raise SlowClientError("upload_slow", f"{message}{settings.idle_s:g} s") from None

    def _hold(self, content: bytes, body: bytearray) -> None:
        if self._held_bytes + len(content) > self._settings.max_uploads_bytes:
            raise ServiceError(
                "uploads_full", "too much is being sent at once; try again in a moment", retry_after_s=_RETRY_AFTER_S
            )
        body += content
        self._held_bytes += len(content)

    async def _chunk(self, receive: Receive) -> _Chunk:
        async with asyncio.timeout(self._settings.idle_s):
            message: Message = await receive()
        if message["type"] == "http.disconnect":
            raise ClientDisconnect
        return _Chunk(message.get("body", b""), message.get("more_body", False))

    async def _drop(self, chunk: _Chunk, receive: Receive, most_bytes: int) -> None:
        """Reads on for as much again: a client that sends all before it listens then gets the answer instead of a
        broken connection."""
        dropped = 0
        while chunk.more and dropped <= most_bytes:
            chunk = await self._chunk(receive)
            dropped += len(chunk.content)


def declared_bytes(headers: Headers) -> int | None:
    """What Content-Length says, which the HTTP protocol has checked; None without one."""
    length = headers.get("content-length", "")
    return int(length) if length.isdecimal() else None


def _too_large(most_bytes: int) -> TooLargeError:
    return TooLargeError("body_too_large", f"the request has more than {most_bytes} bytes")
