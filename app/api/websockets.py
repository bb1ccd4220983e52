"""Limits on WebSockets, below their messages: the time for a handshake, and the time in which a client reads nothing.

The kernel is polled for those that their clients have left, which are thus noticed even while nothing is read from the
socket. The ASGI scope has an event for it under the extension `GONE`.
"""

import asyncio
import logging
import select
import socket
from asyncio.transports import BaseTransport
from http import HTTPStatus
from typing import Any

from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol

from ..errors import LONGEST_SHOWN
from ..settings import Settings
from .connections import HEADERS_IN, ReadInTurns, cut_off, forget_unread
from .problems import bad_request

GONE = "understudy.gone"
"""The ASGI scope extension with the event that is set when the connection is lost."""

LOOK_EVERY_S = 1.0
SENT_AHEAD_BYTES = 1 << 18
"""The kernel's send buffer: seconds of frames. By default it would hold a minute, and hide that a client reads
nothing."""

_LOGGER = logging.getLogger("uvicorn.error.websocket")
_LOGGER.setLevel(logging.WARNING)  # at INFO uvicorn logs queries, which may hold keys

_LEFT = select.POLLHUP | select.POLLERR | getattr(select, "POLLRDHUP", 0)
"""Poll events of a connection that its client has closed or reset; POLLRDHUP is Linux only."""


class LimitedWebSocket(WebSocketsSansIOProtocol, ReadInTurns):
    """uvicorn's WebSocket protocol with the limits of `settings`."""

    settings: Settings

    def __init__(self, *arguments: Any, **named: Any) -> None:  # noqa: ANN401 - uvicorn's signature
        super().__init__(*arguments, **named)
        self.logger = _LOGGER
        self.conn.logger, self.conn.debug = _LOGGER, False  # which would log headers
        self._gone = asyncio.Event()
        self._stuck_since_s: float | None = None
        self._looking: asyncio.TimerHandle | None = None

    def connection_made(self, transport: BaseTransport) -> None:
        super().connection_made(transport)
        transport.get_extra_info("socket").setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, SENT_AHEAD_BYTES)
        self._due_s = self.loop.time() + HEADERS_IN * self.settings.idle_s
        self._look()

    def connection_lost(self, exc: Exception | None) -> None:
        if self._looking is not None:
            self._looking.cancel()
        forget_unread(self.transport, self.settings)
        self._gone.set()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """The first data is the whole head of the request, as read by the HTTP protocol."""
        if self.handshake_initiated:
            super().data_received(data)
            return
        self.conn.receive_data(data)
        self.handle_events()
        if not self.handshake_initiated:
            self._refuse(str(self.conn.parser_exc or "its head is incomplete"))

    def handle_connect(self, event: Any) -> None:  # noqa: ANN401 - of websockets
        """Refuses a wrong handshake with a problem document, in place of the library's own answer."""
        if self.conn.accept(event).status_code != HTTPStatus.SWITCHING_PROTOCOLS:
            self.handshake_initiated = self.handshake_complete = self.close_sent = True
            self._refuse(str(self.conn.handshake_exc))
            return
        super().handle_connect(event)
        if not self.close_sent:
            self.scope["extensions"][GONE] = self._gone  # type: ignore[assignment]

    @property
    def is_paused(self) -> bool:
        return self.read_paused

    def pause_writing(self) -> None:
        self._stuck_since_s = self.loop.time()
        super().pause_writing()

    def resume_writing(self) -> None:
        self._stuck_since_s = None
        super().resume_writing()

    async def send(self, message: Any) -> None:  # noqa: ANN401 - of ASGI
        """Marks a handshake refused by an HTTP answer as complete, which uvicorn does not."""
        await super().send(message)
        if self.close_sent:
            self.handshake_complete = True

    def _refuse(self, why: str) -> None:
        self.transport.write(bad_request(f"this request cannot become a WebSocket: {why[:LONGEST_SHOWN]}"))
        self.transport.close()

    def _look(self) -> None:
        """Periodically: aborts a connection whose handshake is late, or whose client is stuck or gone."""
        now_s = self.loop.time()
        if self.transport.is_closing() and self._stuck_since_s is None:
            self._stuck_since_s = now_s
        is_late = not self.handshake_complete and now_s > self._due_s
        is_stuck = self._stuck_since_s is not None and now_s > self._stuck_since_s + self.settings.idle_s
        if is_late or is_stuck or self._client_has_left():
            cut_off(self.transport)
            return
        self._looking = self.loop.call_later(min(LOOK_EVERY_S, self.settings.idle_s), self._look)

    def _client_has_left(self) -> bool:
        poller = select.poll()
        poller.register(self.transport.get_extra_info("socket").fileno(), _LEFT)
        return bool(poller.poll(0))


def limited_websocket(settings: Settings) -> type[LimitedWebSocket]:
    """The protocol class with these settings, for uvicorn."""
    members: dict[str, Any] = {"settings": settings}
    return type("LimitedWebSocket", (LimitedWebSocket,), members)
