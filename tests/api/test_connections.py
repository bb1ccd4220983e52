"""Limits on connections, over a socket: how many there are, how long headers take, answers that nobody reads."""

import json
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, contextmanager, suppress
from http.client import HTTPConnection

import h11
import psutil
import pytest
import uvicorn
from starlette.types import ASGIApp, Receive, Scope, Send

from understudy.api import connections
from understudy.api.connections import (
    HEADERS_IN,
    MOST_HEADERS,
    READ_BYTES,
    READ_IN,
    READ_IN_PARTS_BYTES,
    UNWANTED_BYTES,
    UNWANTED_REST_S,
    limited_protocol,
)
from understudy.settings import Settings

GET = b"GET / HTTP/1.1\r\nHost: x\r\n\r\n"
LARGE = 64 << 20
"""Bytes: more than the buffers of two sockets hold."""
BUFFERED = 16 << 20
"""More than those buffers hold."""
SMALL = 12 << 20
KEPT = 3 << 20
"""What a kernel may take all of, so that the server is done with it."""

LONGEST_S = 60.0
SOON_S = 0.1
SLOW_LINE_S = 0.2
SENT_WITHIN_S = 2.0
"""In which time a small request is sent, however busy the machine."""


async def answer(scope: Scope, receive: Receive, send: Send) -> None:
    """Reads the body, and answers many bytes at /large, fewer at /small and /kept, two elsewhere."""
    while (await receive()).get("more_body"):
        pass
    await send({"type": "http.response.start", "status": 200})
    sizes = {"/large": LARGE, "/small": SMALL, "/kept": KEPT}
    await send({"type": "http.response.body", "body": b"x" * sizes[scope["path"]] if scope["path"] in sizes else b"ok"})


@contextmanager
def served(app: ASGIApp = answer, **limits: float) -> Iterator[tuple[uvicorn.Server, Callable[[], socket.socket]]]:
    """A server within these limits, and what connects to it."""
    settings = Settings.model_validate(limits)
    config = uvicorn.Config(
        app, port=0, log_config=None, lifespan="off", http=limited_protocol(settings), timeout_keep_alive=60
    )
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run)
    thread.start()
    while not server.started:
        thread.join(0.02)
    address = server.servers[0].sockets[0].getsockname()
    try:
        yield server, lambda: socket.create_connection(address, timeout=LONGEST_S)
    finally:
        server.should_exit = server.force_exit = True
        thread.join()


BEGUN = b"POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 2\r\nExpect: 100-continue\r\n\r\n"


def test_one_connection_more_is_refused_with_a_problem() -> None:
    with served(max_connections=1) as (_server, connect), connect() as first:
        first.sendall(BEGUN)
        assert first.recv(100).startswith(b"HTTP/1.1 100")
        with connect() as second:
            head, _, body = b"".join(iter(lambda: second.recv(4096), b"")).partition(b"\r\n\r\n")
    assert head.startswith(b"HTTP/1.1 503 ")
    assert b"retry-after: 1" in head
    assert json.loads(body)["code"] == "connections_full"


def test_those_that_hold_connections_without_a_request_keep_nobody_out() -> None:
    """The one whose request has been awaited longest is closed for each that comes; one that is answered stays."""
    with served(max_connections=3) as (_server, connect), connect() as working, ExitStack() as stack:
        working.sendall(BEGUN)
        assert working.recv(100).startswith(b"HTTP/1.1 100")
        held = [stack.enter_context(connect()) for _ in range(2)]
        for each in held:
            each.sendall(GET[:-4])
        with connect() as honest:
            honest.sendall(GET)
            assert honest.recv(100).startswith(b"HTTP/1.1 200")
            assert is_ended(held[0])
        held[1].sendall(GET[-4:])
        assert held[1].recv(100).startswith(b"HTTP/1.1 200")
        working.sendall(b"ok")
        assert working.recv(100).startswith(b"HTTP/1.1 200")


def is_ended(connection: socket.socket) -> bool:
    """Whether the other side has ended it."""
    try:
        return connection.recv(100) == b""
    except ConnectionResetError:
        return True


def test_what_is_no_http_is_answered_with_a_problem() -> None:
    with served() as (_server, connect), connect() as client:
        client.sendall(b"no such thing\r\n\r\n")
        head, _, body = b"".join(iter(lambda: client.recv(4096), b"")).partition(b"\r\n\r\n")
    assert head.startswith(b"HTTP/1.1 400 ")
    assert b"application/problem+json" in head
    assert json.loads(body)["code"] == "http_error"


@pytest.mark.parametrize(("headers", "status"), [(MOST_HEADERS - 1, b"200"), (MOST_HEADERS + 1, b"400")])
def test_so_many_headers_and_no_more(headers: int, status: bytes) -> None:
    with served() as (_server, connect), connect() as client:
        more = b"".join(b"X-%d: y\r\n" % number for number in range(headers - 1))
        client.sendall(GET.replace(b"\r\n\r\n", b"\r\n" + more + b"\r\n"))
        assert client.recv(4096).startswith(b"HTTP/1.1 " + status)


@pytest.mark.parametrize("begun", [b"", b"POST / HTTP/1.1\r\nHost: x\r\nX-A: "])
def test_headers_that_take_too_long_end_the_connection(begun: bytes) -> None:
    with served(idle_s=SOON_S) as (_server, connect), connect() as client:
        with suppress(ConnectionError):
            client.sendall(begun)
        assert ended(client)


def test_an_answer_that_nobody_reads_ends_the_connection() -> None:
    with served(idle_s=SOON_S) as (server, connect), connect() as client:
        client.sendall(GET.replace(b"/ ", b"/large "))
        ends_s = time.monotonic() + LONGEST_S
        while not server.server_state.total_requests or server.server_state.connections:
            assert time.monotonic() < ends_s
            time.sleep(0.02)
        assert sum(map(len, received(client))) < LARGE


def test_an_answer_that_is_read_a_few_bytes_at_a_time_ends_the_connection() -> None:
    with served(idle_s=SOON_S) as (server, connect), connect() as client:
        client.sendall(GET.replace(b"/ ", b"/large "))
        ends_s = time.monotonic() + LONGEST_S
        while not server.server_state.total_requests or server.server_state.connections:
            with suppress(ConnectionError):
                client.recv(2)
            assert time.monotonic() < ends_s
            time.sleep(0.02)


@pytest.mark.skipif(not hasattr(socket, "TCP_USER_TIMEOUT"), reason="Linux only")
@pytest.mark.parametrize(("path", "more"), [(b"/large ", b""), (b"/kept ", b"Connection: close\r\n")])
def test_the_kernel_does_not_keep_what_nobody_reads(path: bytes, more: bytes) -> None:
    with served(idle_s=SOON_S) as (_server, connect), connect() as client:
        client.sendall(GET.replace(b"/ ", path).replace(b"\r\n\r\n", b"\r\n" + more + b"\r\n"))
        ends_s = time.monotonic() + LONGEST_S / 6  # a kernel gives up by itself after minutes
        while any(each.raddr == client.getsockname() for each in psutil.net_connections("tcp")):
            assert time.monotonic() < ends_s
            time.sleep(0.1)


def test_a_client_with_a_slow_line_gets_the_whole_answer() -> None:
    """It takes so little that the kernel makes room for more only now and then. Where this machine is so busy that the
    client itself was late, this says nothing, and the line and the limit are slower the next time."""
    for idle_s in (SLOW_LINE_S, 3 * SLOW_LINE_S, 10 * SLOW_LINE_S):
        size, latest_s = taken_slowly(idle_s)
        if size > SMALL or latest_s < LATE_S:
            break
    assert size > SMALL


LATE_S = 0.05
"""A client that sleeps for .01 s and is this late has not had its processor."""


def taken_slowly(idle_s: float) -> tuple[int, float]:
    """How many bytes of the answer come to a client that takes 4 kB at a time, and then the rest; and the longest that
    it took between two."""
    with served(idle_s=idle_s) as (_server, connect), connect() as client:
        client.sendall(GET.replace(b"/ ", b"/small ").replace(b"\r\n\r\n", b"\r\nConnection: close\r\n\r\n"))
        began_s = before_s = time.monotonic()
        size, latest_s = 0, 0.0
        while before_s < began_s + 3 * READ_IN * idle_s:
            with suppress(ConnectionError):
                size += len(client.recv(1 << 12))
            time.sleep(0.01)
            latest_s, before_s = max(latest_s, time.monotonic() - before_s), time.monotonic()
        return size + sum(map(len, received(client))), latest_s


FRESH = 20


def answered(client: socket.socket) -> bytes:
    """One answer, which comes in chunks."""
    come = b""
    while not come.endswith(b"0\r\n\r\n"):
        come += client.recv(100)
    return come


def test_many_new_connections_at_once_take_little_of_a_turn_from_others(monkeypatch: pytest.MonkeyPatch) -> None:
    """All of them send in one turn; with time for one a turn, another connection is not answered after them."""
    monkeypatch.setattr(connections, "BEGINNINGS_S", 1e-9)
    order, may_go_on = list[str](), threading.Event()

    async def noted(scope: Scope, receive: Receive, send: Send) -> None:
        order.append(scope["path"])
        await answer(scope, receive, send)

    with served(noted) as (server, connect), connect() as known, ExitStack() as stack:
        known.sendall(GET)
        assert answered(known).startswith(b"HTTP/1.1 200")
        fresh = [stack.enter_context(connect()) for _ in range(FRESH)]
        while len(server.server_state.connections) <= FRESH:
            time.sleep(0.01)
        server.servers[0].get_loop().call_soon_threadsafe(may_go_on.wait)
        for each in fresh:
            each.sendall(GET.replace(b"/ ", b"/fresh "))
        known.sendall(GET.replace(b"/ ", b"/known "))
        may_go_on.set()
        for each in (known, *fresh):
            assert answered(each).startswith(b"HTTP/1.1 200")
    assert order.count("/fresh") == FRESH
    assert order.index("/known") < FRESH / 2


@pytest.mark.parametrize(
    ("headers", "body", "most_bytes"),
    [
        (b"Transfer-Encoding: chunked", b"1\r\nx\r\n" * 20_000 + b"0\r\n\r\n", READ_IN_PARTS_BYTES),
        (b"Content-Length: 120000", b"x" * 120_000, READ_BYTES),
    ],
)
def test_what_comes_all_at_once_is_parsed_a_little_at_a_time(
    monkeypatch: pytest.MonkeyPatch, headers: bytes, body: bytes, most_bytes: int
) -> None:
    parsed, receive_data = list[int](), h11.Connection.receive_data

    def receive(connection: h11.Connection, data: bytes) -> None:
        parsed.append(len(data))
        receive_data(connection, data)

    monkeypatch.setattr(h11.Connection, "receive_data", receive)
    with served() as (_server, connect), connect() as client:
        client.sendall(b"POST / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n" + headers + b"\r\n\r\n")
        time.sleep(SOON_S)
        client.sendall(body)
        assert b"".join(received(client)).startswith(b"HTTP/1.1 200")
    assert sum(parsed) > len(body)
    assert max(parsed) <= most_bytes


def test_a_body_in_tiny_chunks_leaves_the_event_loop_to_others() -> None:
    """Its pieces, in each of which there are hundreds of chunks, take a quarter of the time, and others are answered
    between them; the body is read to its end, whatever comes when it is not to be read."""
    with served() as (_server, connect), connect() as client, closing(HTTPConnection("x")) as other:
        other.sock = connect()
        client.sendall(b"POST / HTTP/1.1\r\nHost: x\r\nConnection: close\r\nTransfer-Encoding: chunked\r\n\r\n")
        began_s, before_s = time.monotonic(), time.process_time()
        client.sendall(b"1\r\nx\r\n" * 20_000 + b"0\r\n\r\n")
        other.request("GET", "/")
        assert other.getresponse().read() == b"ok"
        assert b"".join(received(client)).startswith(b"HTTP/1.1 200")
        passed_s = time.monotonic() - began_s
    assert passed_s > 2 * (time.process_time() - before_s)


async def refuse(_scope: Scope, _receive: Receive, send: Send) -> None:
    """Answers before the body is read."""
    await send({"type": "http.response.start", "status": 413})
    await send({"type": "http.response.body", "body": b"too large"})


def test_the_rest_of_a_body_that_was_answered_is_read_slowly_and_then_the_answer() -> None:
    """A client that sends all before it reads gets its answer. What buffers hold is sent at once, the rest as it is
    read; no machine is faster than that."""
    with served(refuse) as (_server, connect), closing(connect()) as client:
        began_s = time.monotonic()
        client.sendall(b"POST / HTTP/1.1\r\nHost: x\r\nContent-Length: %d\r\n\r\n" % (2 * BUFFERED))
        client.sendall(bytes(2 * BUFFERED))
        took_s = time.monotonic() - began_s
        assert client.recv(1000).startswith(b"HTTP/1.1 413")
        client.sendall(GET)
        assert b"413" in client.recv(1000)
    assert took_s > UNWANTED_REST_S * BUFFERED / UNWANTED_BYTES


def test_who_asks_too_often_waits_and_is_answered(monkeypatch: pytest.MonkeyPatch) -> None:
    """Twenty at once, of whom ten wait for .05 s each, on one connection."""
    monkeypatch.setattr(connections, "REQUESTS_A_SECOND", 20.0)
    monkeypatch.setattr(connections, "REQUESTS_AT_ONCE", 10)
    with served(workers=1) as (_server, connect), connect() as client:
        began_s = time.monotonic()
        client.sendall(GET * 19 + GET.replace(b"\r\n\r\n", b"\r\nConnection: close\r\n\r\n"))
        assert b"".join(received(client)).count(b"HTTP/1.1 200") == 20
        assert time.monotonic() - began_s > 0.4


def test_who_asks_too_often_waits_on_a_new_connection_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(connections, "REQUESTS_A_SECOND", 5.0)
    monkeypatch.setattr(connections, "REQUESTS_AT_ONCE", 1)
    with served(workers=1) as (_server, connect):
        began_s = time.monotonic()
        for _ in range(4):
            with connect() as client:
                client.sendall(GET.replace(b"\r\n\r\n", b"\r\nConnection: close\r\n\r\n"))
                assert b"".join(received(client)).startswith(b"HTTP/1.1 200")
        assert time.monotonic() - began_s > 0.4


def test_a_kept_connection_may_ask_again_after_longer_than_headers_may_take() -> None:
    with served(idle_s=SENT_WITHIN_S / HEADERS_IN) as (_server, connect), closing(HTTPConnection("x")) as client:
        client.sock = kept = connect()
        for wait_s in (1.1 * SENT_WITHIN_S, 0.0):
            client.request("GET", "/")
            assert client.getresponse().read() == b"ok"
            time.sleep(wait_s)
        assert client.sock is kept


def ended(client: socket.socket) -> bool:
    try:
        return client.recv(1) == b""
    except ConnectionResetError:
        return True


def received(client: socket.socket) -> Iterator[bytes]:
    """What comes until the connection ends."""
    try:
        yield from iter(lambda: client.recv(1 << 20), b"")
    except ConnectionResetError:
        return
