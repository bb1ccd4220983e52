"""Limits on connections, below HTTP requests: their number, the time for headers, and the time an answer may remain
unread. A connection that exceeds one is closed.
"""

import asyncio
from typing import Any

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

from ..settings import Settings
from .problems import bad_request, connections_full

MOST_HEADERS = 100
"""They are counted before they are parsed, which takes milliseconds for hundreds."""

HEADERS_IN = 2
"""A request's headers may take so many times `idle_s`."""


class LimitedProtocol(H11Protocol):
    """uvicorn's HTTP/1.1 protocol with the limits of `settings`."""

    settings: Settings

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        super().connection_made(transport)
        self._checking: asyncio.TimerHandle | None = None
        self._unread_bytes = 0
        self._headers_due_s = self.loop.time() + HEADERS_IN * self.settings.idle_s
        if len(self.connections) > self.settings.max_connections:
            transport.write(connections_full())
            transport.close()
            return
        self._check()

    def data_received(self, data: bytes) -> None:
        if self.transport.is_closing():
            return
        if self.conn.their_state is h11.IDLE and data.partition(b"\r\n\r\n")[0].count(b"\n") > MOST_HEADERS:
            self.send_400_response(f"a request has {MOST_HEADERS} headers at most")
            return
        if not self._is_in_request and self.timeout_keep_alive_task is not None:
            self._headers_due_s = self.loop.time() + HEADERS_IN * self.settings.idle_s
        super().data_received(data)

    def handle_websocket_upgrade(self, event: h11.Request) -> None:
        """From here on the limits of WebSockets apply (`websockets.py`). A body is refused: it would be read as
        messages."""
        headers = dict(self.headers)
        if b"transfer-encoding" in headers or headers.get(b"content-length", b"0") != b"0":
            self.send_400_response("an upgrade to a WebSocket has no body")
            return
        if self._checking is not None:
            self._checking.cancel()
        super().handle_websocket_upgrade(event)

    def send_400_response(self, msg: str) -> None:
        """Answers malformed HTTP with a problem document and closes the connection."""
        self.transport.write(bad_request(msg))
        self.transport.close()

    def connection_lost(self, exc: Exception | None) -> None:
        if self._checking is not None:
            self._checking.cancel()
        super().connection_lost(exc)

    @property
    def _is_in_request(self) -> bool:
        return self.cycle is not None and not self.cycle.response_complete

    def _check(self) -> None:
        """Periodically: aborts a connection whose headers are late, or whose client has read nothing since."""
        unread_bytes = self.transport.get_write_buffer_size()
        is_stuck = bool(unread_bytes) and unread_bytes == self._unread_bytes
        is_idle = self.timeout_keep_alive_task is not None
        is_late = not self._is_in_request and not is_idle and self.loop.time() > self._headers_due_s
        if is_stuck or (is_late and not unread_bytes):
            self.transport.abort()
            return
        self._unread_bytes = unread_bytes
        self._checking = self.loop.call_later(self.settings.idle_s, self._check)


def limited_protocol(settings: Settings) -> type[LimitedProtocol]:
    """The protocol class with these settings, for uvicorn."""
    members: dict[str, Any] = {"settings": settings}
    return type("LimitedProtocol", (LimitedProtocol,), members)
