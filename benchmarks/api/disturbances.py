"""What a service is put through while others ask honestly: on its connections, its streams, its processes.

A `Disturbance` goes on in a `with` block. All of them are bounded in number and time, and go to the service that
is given, which listens on loopback. What they do was found by attacking (issue 25, points 7 to 20).
"""

import json
import os
import random
import signal
import socket
import string
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from http.client import HTTPConnection
from secrets import token_hex

import psutil

from .asking import Client
from .attacks import Attack, form, line
from .lines import timed_line
from .raw_streams import LARGEST_RECEIVED, fill, opened, reset, say, upgrade
from .watching import HOST, Running

UPGRADES = 520
"""More than connections may be open at the same time."""

STREAMS, FEW_STREAMS = 14, 4
"""Nearly all places of two cores; and as many as these can make frames for beside other work."""

FEW_CONNECTIONS = 8

CROWD, OTHER_ADDRESS = 12, "127.0.0.2"
"""One more than wait and work on two cores; of loopback too, but another client's."""


_MASK = bytes(4)
EMPTY_FRAGMENT, EMPTY_SOUND, PING = b"\x00\x80" + _MASK, b"\x82\x80" + _MASK, b"\x89\x80" + _MASK
"""Frames of six bytes, in which nothing is masked."""

ONE_BYTE_CHUNK = b"1\r\n \r\n"


@dataclass(frozen=True, slots=True)
class Disturbance:
    """`begin` does it to a service, until the block ends."""

    name: str
    begin: Callable[[Running], AbstractContextManager[None]]


@contextmanager
def _held(connections: list[socket.socket]) -> Iterator[None]:
    try:
        yield
    finally:
        for each in connections:
            each.close()


def _upgrades(more: str) -> Callable[[Running], AbstractContextManager[None]]:
    def begin(service: Running) -> AbstractContextManager[None]:
        held = list[socket.socket]()
        for _ in range(UPGRADES):
            with suppress(OSError):
                held.append(upgrade(service.port, more))
        return _held(held)

    return begin


def _streams(service: Running, frames: int | None = None, most: int = STREAMS) -> list[socket.socket]:
    """As many streams as there are places, or fewer."""
    found = list[socket.socket]()
    for _ in range(most):
        with suppress(OSError):
            found.append(opened(service.port, {"frames": frames} if frames else None))
    return found


@contextmanager
def _left_full(message: dict[str, object] | bytes, service: Running) -> Iterator[None]:
    """Streams that are filled with what takes long, and then broken off."""
    for each in _streams(service, 60):
        fill(each, message, 200)
        reset(each)
    yield


@contextmanager
def _never_read(service: Running) -> Iterator[None]:
    streams = _streams(service, 60, FEW_STREAMS)
    for each in streams:
        fill(each, bytes(32_000), 40)
    with _held(streams):
        yield


@contextmanager
def _saying(message: dict[str, object], service: Running) -> Iterator[None]:
    streams = _streams(service)
    for each in streams:
        with suppress(OSError):
            say(each, message)
    with _held(streams):
        yield


def gibberish(seed: int = 0) -> str:
    """Two hundred words that nobody has heard, which take half a minute to pronounce."""
    rng = random.Random(seed)
    return " ".join("".join(rng.choices(string.ascii_lowercase, k=95)) for _ in range(200))


@contextmanager
def _repeated(attack: Attack, service: Running) -> Iterator[None]:
    """One client that asks the same again and again."""

    def ask(enough: threading.Event) -> None:
        with Client(service.port) as client:
            while not enough.is_set():
                client.ask(attack)

    with _meanwhile(ask):
        yield


@contextmanager
def _meanwhile(work: Callable[[threading.Event], None]) -> Iterator[None]:
    """Work in a thread, until the block ends and tells it that it is enough."""
    enough = threading.Event()
    thread = threading.Thread(target=work, args=(enough,))
    thread.start()
    try:
        yield
    finally:
        enough.set()
        thread.join()


@contextmanager
def _signalled(which: Callable[[Running], list[psutil.Process]], number: int, service: Running) -> Iterator[None]:
    for process in which(service):
        with suppress(psutil.NoSuchProcess):
            os.kill(process.pid, number)
    yield


@contextmanager
def _flooded(begin: Callable[[Running], socket.socket], piece: bytes, service: Running) -> Iterator[None]:
    """One connection on which pieces of a few bytes are sent without end, begun again whenever it is ended."""

    def send(enough: threading.Event) -> None:
        while not enough.is_set():
            with suppress(OSError), begin(service) as connection:
                connection.settimeout(1.0)
                while not enough.is_set():
                    connection.sendall(piece * 1000)

    with _meanwhile(send):
        yield


@contextmanager
def _churned(service: Running) -> Iterator[None]:
    """Streams that are begun and broken off without end, eight at a time."""

    def begin(enough: threading.Event) -> None:
        while not enough.is_set():
            with suppress(OSError):
                stream = opened(service.port)
                stream.recv(LARGEST_RECEIVED)
                reset(stream)

    with ExitStack() as stack:
        for _ in range(FEW_CONNECTIONS):
            stack.enter_context(_meanwhile(begin))
        yield


@contextmanager
def _asked_for_nothing(service: Running) -> Iterator[None]:
    """Requests that cost hardly anything, many at once and without end, on eight connections."""
    request = b"GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n"

    def ask(enough: threading.Event) -> None:
        while not enough.is_set():
            with suppress(OSError), socket.create_connection((HOST, service.port), timeout=1.0) as connection:
                while not enough.is_set():
                    connection.sendall(request * 50)
                    connection.recv(LARGEST_RECEIVED)

    with ExitStack() as stack:
        for _ in range(FEW_CONNECTIONS):
            stack.enter_context(_meanwhile(ask))
        yield


def _begun_body(service: Running) -> socket.socket:
    """A request whose body comes in chunks."""
    connection = socket.create_connection((HOST, service.port), timeout=5)
    head = "POST /functions HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json"
    connection.sendall(f"{head}\r\nTransfer-Encoding: chunked\r\n\r\n".encode())
    return connection


def _begun_message(service: Running) -> socket.socket:
    """A stream with the first fragment of a message of sound."""
    connection = opened(service.port)
    connection.sendall(b"\x02\x80" + _MASK)
    return connection


def _all_but_itself(service: Running) -> list[psutil.Process]:
    return service.family()[1:]


@contextmanager
def _odd_requests(service: Running) -> Iterator[None]:
    """Names, lengths and origins that cannot be right, on connections of their own."""
    requests = (
        "GET /studio/%00 HTTP/1.1\r\nHost: localhost\r\n\r\n",
        f"GET /studio/{'a' * 300} HTTP/1.1\r\nHost: localhost\r\n\r\n",
        "POST /perform HTTP/1.1\r\nHost: localhost\r\nContent-Length: 3\r\nTransfer-Encoding: chunked\r\n\r\nabc",
        "POST /perform HTTP/1.1\r\nHost: localhost\r\nOrigin: http://evil.example\r\nContent-Length: 0\r\n\r\n",
        "GET /opened/line HTTP/1.1\r\nHost: evil.example\r\n\r\n",
    )
    for each in requests * 40:
        with suppress(OSError), socket.create_connection((HOST, service.port), timeout=5) as connection:
            connection.sendall(each.encode())
            if b" 500 " in connection.recv(64):
                raise AssertionError(each[:60])
    yield


def _profile(text: str) -> Attack:
    return Attack("a profile", "/perform", lambda: line(profile=("p.yaml", text.encode())))


def _checked(text: str) -> Attack:
    files = {"app/rules/functions/lists.rules": text}
    return Attack("rules", "/rules/check", lambda: ("application/json", json.dumps({"files": files}).encode()))


EXPLODING = (
    "rule explodes\nforeach\n"
    + "".join(f"  word($w{n}, $s{n}, $e{n})\n" for n in range(8))
    + "assert\n  fcn(contrast, explicit, $s0, $e7, 1)\n"
)
"""A rule that joins every word of a line with every other, eight times."""


def _joined() -> tuple[str, bytes]:
    rules = json.dumps({"files": {"app/rules/functions/lists.rules": EXPLODING}})
    return line(text="no " * 40, rules=rules, words=("w.json", _forty_words()))


def _forty_words() -> bytes:
    words = [{"text": "no", "start_s": 0.05 * n, "end_s": 0.05 * n + 0.05} for n in range(40)]
    return json.dumps({"words": words}).encode()


def _hostile_glb() -> tuple[str, bytes]:
    """A few bytes that claim four thousand million keys."""
    accessor = {"componentType": 5126, "count": 4_000_000_000, "type": "VEC4", "sparse": {"count": 4_000_000_000}}
    document = {"asset": {"version": "2.0"}, "accessors": [accessor] * 50, "nodes": [{"children": [0]}] * 1000}
    content = json.dumps(document).encode().ljust(8, b" ")
    content += b" " * (-len(content) % 4)
    whole = b"glTF" + (2).to_bytes(4, "little") + (20 + len(content)).to_bytes(4, "little")
    whole += len(content).to_bytes(4, "little") + b"JSON" + content
    return form(bml=("b.bml", b"<bml/>"), avatar=("a.glb", whole))


@cache  # an attacker would not make it anew each time, which takes processor time from those who ask
def _json_of_36_mb() -> tuple[str, bytes]:
    return "application/json", b'{"text": "' + b"a" * 36_000_000 + b'"}'


@contextmanager
def _crowded(service: Running) -> Iterator[None]:
    """Connections from one other address that ask for lines again at once, each time under another id."""
    line = timed_line()

    def ask(enough: threading.Event) -> None:
        with suppress(OSError):
            while not enough.is_set():
                connection = HTTPConnection(HOST, service.port, timeout=60, source_address=(OTHER_ADDRESS, 0))
                media_type, body = line.make()
                while not enough.is_set():
                    connection.request(
                        "POST", line.path, body, {"Content-Type": media_type, "X-Request-ID": token_hex(8)}
                    )
                    connection.getresponse().read()

    with ExitStack() as stack:
        for _ in range(CROWD):
            stack.enter_context(_meanwhile(ask))
        yield


def _with(
    begin: Callable[..., AbstractContextManager[None]], *given: object
) -> Callable[[Running], AbstractContextManager[None]]:
    return lambda service: begin(*given, service)


CONNECTIONS = (
    Disturbance("520 upgrades with a length", _upgrades("Content-Length: 1\r\n\r\n")),
    Disturbance("520 chunked upgrades", _upgrades("Transfer-Encoding: chunked\r\n\r\n")),
    Disturbance("520 upgrades of 200 headers", _upgrades("".join(f"X-{n}: y\r\n" for n in range(200)) + "\r\n")),
    Disturbance("520 upgrades of 9 kB", _upgrades(f"X: {'y' * 9000}\r\n\r\n")),
    Disturbance("odd requests", _odd_requests),
    Disturbance("a body in chunks of one byte", _with(_flooded, _begun_body, ONE_BYTE_CHUNK)),
    Disturbance("a message in empty fragments", _with(_flooded, _begun_message, EMPTY_FRAGMENT)),
    Disturbance("empty messages of sound", _with(_flooded, lambda service: opened(service.port), EMPTY_SOUND)),
    Disturbance("pings without end", _with(_flooded, _begun_message, PING)),
    Disturbance("requests for nothing without end", _asked_for_nothing),
)
LIVE = (
    Disturbance("streams filled with sound, then reset", _with(_left_full, bytes(60_000))),
    Disturbance("streams of long silences, then reset", _with(_left_full, {"type": "silence", "duration_s": 60})),
    Disturbance("streams begun and left without end", _churned),
    Disturbance("streams that never read", _never_read),
    Disturbance(
        "a word of 100,000 s",
        _with(_saying, {"type": "words", "words": [{"text": "hello", "start_s": 0, "end_s": 1e5}]}),
    ),
    Disturbance("words that nobody has heard", _with(_saying, {"type": "words", "text": gibberish()})),
)
PROCESSES = (
    Disturbance("the nursery killed", _with(_signalled, Running.nursery, signal.SIGKILL)),
    Disturbance("the nursery stopped", _with(_signalled, Running.nursery, signal.SIGSTOP)),
    Disturbance("nursery and workers killed at once", _with(_signalled, _all_but_itself, signal.SIGKILL)),
)
REQUESTS = (
    Disturbance("a profile of 100,000 brackets", _with(_repeated, _profile("[" * 100_000))),
    Disturbance("a profile of 600 blocks", _with(_repeated, _profile("\n".join(" " * n + "a:" for n in range(600))))),
    Disturbance("a profile of 24,000 keys", _with(_repeated, _profile("\n".join(f"k{n}: v" for n in range(24_000))))),
    Disturbance("rules of 100,000 brackets", _with(_repeated, _checked("(" * 100_000))),
    Disturbance("a rule whose joins explode", _with(_repeated, Attack("joins", "/perform", _joined))),
    Disturbance("a GLB that claims everything", _with(_repeated, Attack("GLB", "/realize", _hostile_glb))),
    Disturbance("36 MB of JSON", _with(_repeated, Attack("JSON", "/functions", _json_of_36_mb))),
)
CROWDS = (Disturbance("a crowd that never waits, under new names", _crowded),)
DISTURBANCES = CONNECTIONS + LIVE + PROCESSES + REQUESTS + CROWDS
