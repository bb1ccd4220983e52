"""Limits on connections, below HTTP requests: their number, the time for headers, the time an answer may remain unread,
and their part of a turn of the event loop. A connection that exceeds one is closed or waits; of too many, one that
waits for its next request is closed. Those that become WebSockets: `websockets.py`.
"""

import asyncio
import socket
import struct
import sys
import time
from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

from ..settings import Settings
from .admission.rates import Frequency
from .problems import bad_request, connections_full

MOST_HEADERS = 100
"""They are counted before they are parsed, which takes milliseconds for hundreds."""

HEADERS_IN = 2
"""A request's headers may take so many times `idle_s`."""

SLOWEST_BYTES_PER_S = 1024
"""A client that takes less of an answer, over `READ_IN` times `idle_s`, is disconnected. What it takes is known in
pieces, as its kernel makes room: up to some hundred kilobytes."""

READ_IN = 2

_ACKED = slice(120, 128)
"""Where `tcpi_bytes_acked` stands in Linux's `struct tcp_info`."""


READ_BYTES, READ_IN_PARTS_BYTES = 1 << 13, 1 << 11
"""So much of a connection is read in a turn of the event loop, and of a body or message that comes in parts: there may
be hundreds of tiny ones in it, and all other connections wait until they are parsed."""

UNWANTED_BYTES, UNWANTED_REST_S = 1 << 16, 0.004
"""So much is read in a turn of a body that is answered already, and then nothing for so long: 16 MB a second. A client
that sends everything before it reads gets its answer, and who sends much again and again takes nothing from others."""

SLOWEST_UNWANTED_BYTES_PER_S = 1 << 20
"""Each piece of it gives the connection so much more time, as long as a body may take in all."""

REQUESTS_A_SECOND, REQUESTS_AT_ONCE = 150.0, 1000
"""More requests than these from one address, a second for each worker, wait, whatever they ask for: answering them
would take the event loop from others. A page of the studio asks for some two hundred files."""

BEGINNINGS_S = 0.005
"""So much processor time of a turn of the event loop goes to connections that have not asked for anything yet. Hundreds
may come at once, and an upgrade takes a millisecond: they wait a few turns, those that have made requests do not."""

LONG_PIECE_S, RESTS = 0.0003, 3
"""After a piece in parts that took longer to parse, in processor time, its connection is not read for so many times as
long, and for each other that rests as long again: all of them together have a third of the event loop at most."""


class ReadInTurns(asyncio.BufferedProtocol, ABC):
    """A protocol whose data comes in pieces of `read_bytes`."""

    transport: asyncio.Transport
    loop: asyncio.AbstractEventLoop
    connections: set[Any]
    read_bytes = READ_IN_PARTS_BYTES
    is_resting = False
    _buffer: memoryview | None = None
    _unparsed: tuple[bytes, ...] = ()

    def get_buffer(self, sizehint: int) -> memoryview:  # noqa: ARG002 - asyncio's signature
        if self._buffer is None or len(self._buffer) < self.read_bytes:
            self._buffer = memoryview(bytearray(max(READ_BYTES, self.read_bytes)))
        return self._buffer[: self.read_bytes]

    def buffer_updated(self, nbytes: int) -> None:
        assert self._buffer is not None, "data was read into it"
        piece = bytes(self._buffer[:nbytes])
        if self.is_resting:  # uvicorn has made it read again meanwhile
            self._unparsed += (piece,)
            self.transport.pause_reading()
        else:
            self._parse(piece)

    def _parse(self, piece: bytes) -> None:
        began_s = time.thread_time()
        self.data_received(piece)
        took_s = time.thread_time() - began_s
        is_over = self.transport.is_closing() or self.transport.get_protocol() is not self
        if took_s > LONG_PIECE_S and self.read_bytes == READ_IN_PARTS_BYTES and not is_over:
            others = sum(isinstance(each, ReadInTurns) and each.is_resting for each in self.connections)
            self._rest((1 + others) * RESTS * took_s)

    def _rest(self, rest_s: float) -> None:
        self.is_resting = True
        self.transport.pause_reading()
        self.loop.call_later(rest_s, self._go_on)

    def _go_on(self) -> None:
        self.is_resting = False
        while self._unparsed and not self.is_resting and not self.transport.is_closing():
            piece, *rest = self._unparsed
            self._unparsed = tuple(rest)
            self._parse(piece)
        if not (self.is_resting or self.is_paused or self.transport.is_closing()):
            self.transport.resume_reading()

    @property
    @abstractmethod
    def is_paused(self) -> bool:
        """Whether uvicorn does not want to read, because what was read waits."""

    @abstractmethod
    def data_received(self, data: bytes) -> None:
        """Takes a piece."""


class Beginnings:
    """Shares `BEGINNINGS_S` of each turn of the event loop among new connections, first come first served."""

    def __init__(self) -> None:
        self._left_s = BEGINNINGS_S
        self._waiting: deque[Callable[[], None]] = deque()
        self._next_turn: asyncio.Handle | None = None

    @property
    def have_time(self) -> bool:
        return self._left_s > 0 and not self._waiting

    def took(self, seconds: float, loop: asyncio.AbstractEventLoop) -> None:
        """So much of this turn's time was used."""
        self._left_s -= seconds
        self._next_turn = self._next_turn or loop.call_soon(self._go_on, loop)

    def wait(self, go_on: Callable[[], None], loop: asyncio.AbstractEventLoop) -> None:
        """Calls `go_on`, which tells what it `took`, in one of the next turns."""
        self._waiting.append(go_on)
        self.took(0.0, loop)

    def _go_on(self, loop: asyncio.AbstractEventLoop) -> None:
        self._next_turn, self._left_s = None, BEGINNINGS_S
        while self._waiting and self._left_s > 0:
            self._waiting.popleft()()
        if self._waiting:
            self.took(0.0, loop)


class LimitedProtocol(H11Protocol, ReadInTurns):
    """uvicorn's HTTP/1.1 protocol with the limits of `settings`."""

    settings: Settings
    frequency: Frequency
    beginnings: Beginnings

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        super().connection_made(transport)
        self._checking: asyncio.TimerHandle | None = None
        self._taken_bytes, self._read_until_s, self._answered_s = 0, 0.0, 0.0
        self._headers_due_s = self.loop.time() + HEADERS_IN * self.settings.idle_s
        if not self._has_room():
            transport.write(connections_full())
            transport.close()
            return
        self._check()
        wait_s = self.frequency.wait_s(self._address, times=0)
        if wait_s:
            transport.pause_reading()
            self.loop.call_later(wait_s, self._read)

    def _read(self) -> None:
        if not self.transport.is_closing():
            self.transport.resume_reading()

    @property
    def _address(self) -> str:
        return self.client[0] if self.client else ""

    def _has_room(self) -> bool:
        """Whether there are no more connections than may be, once the one is closed whose request has been awaited
        longest; who only holds connections keeps nobody out."""
        if len(self.connections) <= self.settings.max_connections:
            return True
        open_ = [each for each in self.connections if not each.transport.is_closing()]
        if len(open_) <= self.settings.max_connections:
            return True
        awaited = [each for each in open_ if isinstance(each, LimitedProtocol) and not each._is_in_request]
        oldest = min(awaited, key=lambda each: each._headers_due_s)
        if oldest is not self:
            oldest.transport.abort()
        return oldest is not self

    def buffer_updated(self, nbytes: int) -> None:
        if self.cycle is not None or self.is_resting or self.beginnings.have_time:
            super().buffer_updated(nbytes)
            return
        assert self._buffer is not None, "data was read into it"
        self._unparsed += (bytes(self._buffer[:nbytes]),)
        self.is_resting = True
        self.transport.pause_reading()
        self.beginnings.wait(self._go_on, self.loop)

    def _parse(self, piece: bytes) -> None:
        is_beginning, began_s = self.cycle is None, time.thread_time()
        super()._parse(piece)
        if is_beginning:
            self.beginnings.took(time.thread_time() - began_s, self.loop)
        if self._is_unwanted and not self.is_resting and not self.transport.is_closing():
            due_s = self._headers_due_s + len(piece) / SLOWEST_UNWANTED_BYTES_PER_S
            self._headers_due_s = min(due_s, self._answered_s + self.settings.upload_s)
            self._rest(UNWANTED_REST_S * len(piece) / UNWANTED_BYTES)

    def data_received(self, data: bytes) -> None:
        if self.transport.is_closing():
            return
        if self.conn.their_state is h11.IDLE and data.partition(b"\r\n\r\n")[0].count(b"\n") > MOST_HEADERS:
            self.send_400_response(f"a request has {MOST_HEADERS} headers at most")
            return
        if not self._is_in_request and self.timeout_keep_alive_task is not None:
            self._headers_due_s = self.loop.time() + HEADERS_IN * self.settings.idle_s
        super().data_received(data)
        is_in_parts = self._is_in_request and any(name == b"transfer-encoding" for name, _ in self.headers)
        whole_bytes = UNWANTED_BYTES if self._is_unwanted else READ_BYTES
        self.read_bytes = READ_IN_PARTS_BYTES if is_in_parts else whole_bytes

    def handle_websocket_upgrade(self, event: h11.Request) -> None:
        """From here on the limits of WebSockets apply (`LimitedWebSocket`). A body is refused: it would be read as
        messages."""
        headers = dict(self.headers)
        if b"transfer-encoding" in headers or headers.get(b"content-length", b"0") != b"0":
            self.send_400_response("an upgrade to a WebSocket has no body")
            return
        if self._checking is not None:
            self._checking.cancel()
        super().handle_websocket_upgrade(event)

    def on_response_complete(self) -> None:
        """The next request of an address that asks too often is read later."""
        self._answered_s = self.loop.time()
        wait_s = self.frequency.wait_s(self._address)
        if wait_s:
            self._headers_due_s = self.loop.time() + wait_s + HEADERS_IN * self.settings.idle_s
            self.loop.call_later(wait_s, super().on_response_complete)
        else:
            super().on_response_complete()

    def send_400_response(self, msg: str) -> None:
        """Answers malformed HTTP with a problem document and closes the connection."""
        self.transport.write(bad_request(msg))
        self.transport.close()

    def connection_lost(self, exc: Exception | None) -> None:
        if self._checking is not None:
            self._checking.cancel()
        forget_unread(self.transport, self.settings)
        super().connection_lost(exc)

    @property
    def is_paused(self) -> bool:
        return self.flow.read_paused

    @property
    def _is_in_request(self) -> bool:
        return self.cycle is not None and not self.cycle.response_complete

    @property
    def _is_unwanted(self) -> bool:
        """Whether what arrives is the rest of a body that is answered already."""
        return self.conn.our_state is h11.DONE and self.conn.their_state is h11.SEND_BODY

    def _check(self) -> None:
        """Periodically: aborts a connection whose headers are late, or whose client reads nothing, or hardly."""
        now_s, is_unread = self.loop.time(), self.transport.get_write_buffer_size() > 0
        is_idle = self.timeout_keep_alive_task is not None
        is_late = not self._is_in_request and not is_idle and now_s > self._headers_due_s
        self._extend_reading(now_s, is_unread)
        if now_s > self._read_until_s or (is_late and not is_unread):
            cut_off(self.transport)
            return
        self._checking = self.loop.call_later(self.settings.idle_s, self._check)

    def _extend_reading(self, now_s: float, is_unread: bool) -> None:
        """Each byte that the client has taken gives it more time for the others."""
        before_bytes, self._taken_bytes = self._taken_bytes, _taken_bytes(self.transport)
        longest_s = now_s + READ_IN * self.settings.idle_s
        given_s = (self._taken_bytes - before_bytes) / SLOWEST_BYTES_PER_S
        self._read_until_s = min(self._read_until_s + given_s, longest_s) if is_unread else longest_s


def _taken_bytes(transport: asyncio.Transport) -> int:
    """How many bytes the client has acknowledged; where only Linux says that, less for more in our own buffer."""
    if not hasattr(socket, "TCP_INFO"):
        return -transport.get_write_buffer_size()
    told = transport.get_extra_info("socket").getsockopt(socket.IPPROTO_TCP, socket.TCP_INFO, _ACKED.stop)
    return int.from_bytes(told[_ACKED], sys.byteorder)


def cut_off(transport: asyncio.Transport) -> None:
    """Cuts a client off. What it has not read is dropped, which the kernel would keep as long as it says it lives."""
    transport.get_extra_info("socket").setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    transport.abort()


def forget_unread(transport: asyncio.Transport, settings: Settings) -> None:
    """Before a connection is closed: has the kernel keep what is unread only as long as we would. It took all of it, up
    to megabytes, so that we do not know of it. Only Linux has this."""
    if hasattr(socket, "TCP_USER_TIMEOUT"):
        keep_ms = round(READ_IN * settings.idle_s * 1000)
        with suppress(OSError):  # closed already
            transport.get_extra_info("socket").setsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT, keep_ms)


def limited_protocol(settings: Settings) -> type[LimitedProtocol]:
    """The protocol class with these settings, for uvicorn."""
    frequency = Frequency(REQUESTS_A_SECOND * settings.worker_count, REQUESTS_AT_ONCE)
    members: dict[str, Any] = {"settings": settings, "frequency": frequency, "beginnings": Beginnings()}
    return type("LimitedProtocol", (LimitedProtocol,), members)
