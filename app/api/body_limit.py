"""Refuses request bodies that are too large, counted as they arrive whatever Content-Length says."""

from starlette.types import ASGIApp, Message, Receive, Scope, Send

from ..errors import TooLargeError


class BodyLimit:
    """ASGI middleware. Reading the body past `max_bytes` raises TooLargeError `body_too_large` in whoever reads it.

    What still arrives of such a body is read and dropped, up to `max_bytes` more: a client that sends all before it
    listens then gets the answer instead of a broken connection.
    """

    def __init__(self, app: ASGIApp, max_bytes: int) -> None:
        self._app = app
        self._max_bytes = max_bytes

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        received = 0

        async def counted() -> Message:
            nonlocal received
            message = await receive()
            received += len(message.get("body", b""))
            if received > self._max_bytes:
                await self._drop(message, receive)
                raise TooLargeError("body_too_large", f"the request has more than {self._max_bytes} bytes")
            return message

        await self._app(scope, counted, send)

    async def _drop(self, message: Message, receive: Receive) -> None:
        dropped = 0
        while message.get("more_body", False) and dropped <= self._max_bytes:
            message = await receive()
            dropped += len(message.get("body", b""))
