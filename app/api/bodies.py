"""The bodies of requests: which parts they may have and how large, and how they are read into memory.

Each body has a limit of size and time, and all of them together have one of size. Nothing of a body is parsed here. One
whose Content-Length is too large is refused unread; otherwise bytes count as they arrive.
"""

import asyncio
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from dataclasses import dataclass

from starlette.datastructures import Headers
from starlette.requests import ClientDisconnect
from starlette.types import Message, Receive

from ..errors import ServiceError, SlowClientError, TooLargeError
from ..settings import Settings
from .negotiation import JSON, XML
from .workers.messages import Task

BML_TYPES = frozenset({XML, "text/xml"})
_FORM_ROOM = 64 * 1024
"""Bytes of a form besides the contents of its fields."""


def media_type_of(content_type: str) -> str:
    """The media type of a Content-Type header, without parameters."""
    return content_type.partition(";")[0].strip().lower()


def form_limits(task: Task, settings: Settings) -> Mapping[str, int]:
    """The fields that a form may have, and the most bytes of each."""
    limits = settings.part_limits
    return {name: limits[name] for name in FORM_FIELDS.get(task, ())}


FORM_FIELDS: Mapping[Task, tuple[str, ...]] = {
    Task.PERFORM: (
        *("audio", "text", "options", "words", "functions", "direction", "edits", "profile", "reference", "rules"),
    ),
    Task.REALIZE: ("bml", "audio", "avatar", "motion_model", "scenario", "options"),
    Task.GESTURE_POSE: ("avatar", "options"),
}
"""The tasks that take a form."""


def body_limit(task: Task, content_type: str, settings: Settings) -> int:
    """The most bytes of a body: of a form as much as its fields may have together, if no setting says less."""
    sent = media_type_of(content_type)
    if sent == "multipart/form-data":
        return min(settings.max_body_bytes, sum(form_limits(task, settings).values()) + _FORM_ROOM)
    if sent == JSON:
        return min(settings.max_body_bytes, settings.part_limits["json"])
    return min(settings.max_body_bytes, settings.part_limits["bml"])


_RETRY_AFTER_S = 2.0


@dataclass(frozen=True, slots=True)
class _Chunk:
    """Received bytes, and whether more follow."""

    content: bytes
    more: bool


class Uploads:
    """All request bodies in memory."""

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
        """A request's body, which counts as held until the block ends; one declared too large is not read.

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
                "uploads_full", "too many uploads at once; try again in a moment", retry_after_s=_RETRY_AFTER_S
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
        """Reads and discards up to the limit once more, so that a client that sends everything before it reads gets the
        answer instead of a broken connection."""
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
