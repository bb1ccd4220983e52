"""Limits on WebSockets, over a socket: upgrades that cannot finish, and clients that have left or read nothing."""

import json
import logging
import socket
import struct
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

import pytest
import uvicorn
from starlette.types import Receive, Scope, Send

from understudy.api.connections import limited_protocol
from understudy.api.websockets import GONE, limited_websocket
from understudy.settings import Settings

LONGEST_S = 60.0
SOON_S = 0.2
HEAD = (
    b"GET /live?token=secret HTTP/1.1\r\nHost: x\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
    b"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
)
MESSAGE = b"x" * 100_000


class Application:
    """Accepts each WebSocket but at /late, and then reads nothing; at /flood it sends without end, at /heard it reads.
    `left` counts the connections that were told to be gone, `heard` are the messages."""

    def __init__(self) -> None:
        self.left = 0
        self.heard: list[bytes] = []

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        await receive()
        if scope["path"] == "/late":
            await scope["extensions"][GONE].wait()
            self.left += 1
            return
        await send({"type": "websocket.accept"})
        with suppress(OSError):
            while scope["path"] == "/flood":
                await send({"type": "websocket.send", "bytes": MESSAGE})
            while scope["path"] == "/heard" and "bytes" in (message := await receive()):
                self.heard.append(message["bytes"])
            await scope["extensions"][GONE].wait()
        self.left += 1


@contextmanager
def served(**limits: float) -> Iterator[tuple[uvicorn.Server, Application, Callable[[], socket.socket]]]:
    """A server within these limits, and what connects to it."""
    settings, application = Settings.model_validate(limits), Application()
    config = uvicorn.Config(
        application,
        port=0,
        log_config=None,
        lifespan="off",
        http=limited_protocol(settings),
        ws=limited_websocket(settings),
        ws_ping_interval=None,
    )
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run)
    thread.start()
    while not server.started:
        thread.join(0.02)
    address = server.servers[0].sockets[0].getsockname()
    try:
        yield server, application, lambda: socket.create_connection(address, timeout=LONGEST_S)
    finally:
        server.should_exit = server.force_exit = True
        thread.join()


def until(holds: Callable[[], bool]) -> None:
    ends_s = time.monotonic() + LONGEST_S
    while not holds():
        assert time.monotonic() < ends_s
        time.sleep(0.02)


@pytest.mark.parametrize(
    "more",
    [
        b"Content-Length: 1\r\n\r\n",
        b"Transfer-Encoding: chunked\r\n\r\n",
        b"".join(b"X-%d: y\r\n" % number for number in range(200)) + b"\r\n",
        b"X: %s\r\n\r\n" % (b"y" * 9000),
        b"Sec-WebSocket-Version: 12\r\n\r\n",
    ],
    ids=["length", "chunked", "200 headers", "9 kB", "two versions"],
)
def test_an_upgrade_that_cannot_finish_is_refused_and_its_connection_closed(more: bytes) -> None:
    with served() as (server, _application, connect), connect() as client:
        client.sendall(HEAD + more)
        head, _, body = b"".join(iter(lambda: client.recv(4096), b"")).partition(b"\r\n\r\n")
        assert head.startswith(b"HTTP/1.1 400 ")
        assert json.loads(body)["code"] == "http_error"
        until(lambda: not server.server_state.connections)


def test_a_method_that_cannot_be_upgraded_is_refused() -> None:
    with served() as (server, _application, connect), connect() as client:
        client.sendall(HEAD.replace(b"GET", b"POST") + b"\r\n")
        head, _, body = b"".join(iter(lambda: client.recv(4096), b"")).partition(b"\r\n\r\n")
        assert head.startswith(b"HTTP/1.1 400 ")
        assert "unsupported HTTP method: POST" in json.loads(body)["detail"]
        until(lambda: not server.server_state.connections)


def test_an_upgrade_that_nobody_answers_in_time_is_cut_off() -> None:
    with served(idle_s=SOON_S) as (server, application, connect), connect() as client:
        client.sendall(HEAD.replace(b"/live", b"/late") + b"\r\n")
        until(lambda: application.left == 1)
        until(lambda: not server.server_state.connections)


def test_a_client_that_resets_its_connection_is_noticed_though_nothing_is_read_from_it() -> None:
    with served() as (server, application, connect):
        client = connect()
        client.sendall(HEAD + b"\r\n")
        assert b"101" in client.recv(4096)
        client.settimeout(SOON_S)
        frame = b"\x82\xfe" + struct.pack("!H", 60_000) + b"\0\0\0\0" + bytes(60_000)
        with suppress(TimeoutError):
            while True:
                client.sendall(frame)
        assert not application.left
        client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        client.close()
        until(lambda: application.left == 1)
        until(lambda: not server.server_state.connections)


def test_a_client_that_reads_nothing_is_cut_off() -> None:
    with served(idle_s=SOON_S) as (server, application, connect), connect() as client:
        client.sendall(HEAD.replace(b"/live", b"/flood") + b"\r\n")
        until(lambda: application.left == 1)
        until(lambda: not server.server_state.connections)


def test_a_client_that_reads_a_byte_now_and_then_is_cut_off() -> None:
    with served(idle_s=SOON_S) as (server, application, connect), connect() as client:
        client.sendall(HEAD.replace(b"/live", b"/flood") + b"\r\n")

        def is_over_once_another_byte_is_read() -> bool:
            with suppress(ConnectionError):
                client.recv(1)
            return application.left == 1 and not server.server_state.connections

        until(is_over_once_another_byte_is_read)


def test_tiny_messages_leave_the_event_loop_to_others_and_none_is_lost() -> None:
    """A connection is not read for a while after each piece with hundreds of them."""
    sent = [struct.pack("!H", number) for number in range(20_000)]
    with served() as (_server, application, connect), connect() as client:
        client.sendall(HEAD.replace(b"/live", b"/heard") + b"\r\n")
        assert b"101" in client.recv(4096)
        began_s, before_s = time.monotonic(), time.process_time()
        client.sendall(b"".join(b"\x82\x82\0\0\0\0" + each for each in sent))
        until(lambda: len(application.heard) == len(sent))
        assert time.monotonic() - began_s > 1.5 * (time.process_time() - before_s)
    assert application.heard == sent


def test_the_query_of_a_web_socket_is_not_logged(caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.DEBUG), served() as (_server, application, connect):
        with connect() as client:
            client.sendall(HEAD + b"\r\n")
            assert b"101" in client.recv(4096)
        until(lambda: application.left == 1)
    assert "secret" not in caplog.text
