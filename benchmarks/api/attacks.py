"""The requests that froze or exhausted the service (issue 15, points 1 to 3 and 5), each small enough to send again.

An `Attack` is one HTTP request, made when it is asked for; `hold_uploads` and `hold_headers` are the attacks that are
no request, but connections that never finish one. Nothing here measures: `under_attack.py` does, and the drill.
"""

import json
import socket
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from functools import partial
from http.client import HTTPConnection
from pathlib import Path
from typing import TypeAlias

AUDIO = Path(__file__).resolve().parents[2] / "examples" / "example.flac"
BOUNDARY = "understudy-attack"
LARGE = 39_000_000
"""Bytes: just under the largest body that is accepted by default."""

Body: TypeAlias = tuple[str, bytes]
"""A content type and what is sent as that."""


@dataclass(frozen=True, slots=True)
class Attack:
    """One request; `make` gives its body, for it may be large."""

    name: str
    path: str
    make: Callable[[], Body]
    accept: str = "application/json"

    def send(self, host: str, port: int, *, timeout_s: float = 120.0) -> tuple[int, int]:
        """Status and bytes of the answer; raises OSError where there is none."""
        media_type, body = self.make()
        connection = HTTPConnection(host, port, timeout=timeout_s)
        try:
            connection.request("POST", self.path, body, {"Content-Type": media_type, "Accept": self.accept})
            answer = connection.getresponse()
            return answer.status, sum(map(len, iter(partial(answer.read, 1 << 20), b"")))
        finally:
            connection.close()


def form(**fields: str | bytes | tuple[str, bytes]) -> Body:
    """A multipart form; a pair is a file with its name."""
    parts = b""
    for name, value in fields.items():
        file_name, content = value if isinstance(value, tuple) else ("", value)
        content = content.encode() if isinstance(content, str) else content
        disposition = f'form-data; name="{name}"' + (f'; filename="{file_name}"' if file_name else "")
        parts += f"--{BOUNDARY}\r\nContent-Disposition: {disposition}\r\n\r\n".encode() + content + b"\r\n"
    return f"multipart/form-data; boundary={BOUNDARY}", parts + f"--{BOUNDARY}--\r\n".encode()


def line(**fields: str | bytes | tuple[str, bytes]) -> Body:
    """The form of a line: the bundled recording, with fields added or replaced."""
    line: dict[str, str | bytes | tuple[str, bytes]] = {"audio": ("a.flac", AUDIO.read_bytes()), "text": "No."}
    return form(**(line | fields))


def bml(inside: str) -> Body:
    """A BML block with its content."""
    begin = '<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="block" characterId="default">'
    return "application/xml", f"{begin}{inside}</bml>".encode()


def _listeners() -> Body:
    return line(options=json.dumps({"listener": [f"n{number}" for number in range(200_000)]}))


def _large_numbers(field: str, begin: str, end: str) -> Body:
    """A field of LARGE bytes of JSON."""
    content = (begin + "1," * ((LARGE - 4_000_000) // 2) + "1" + end).encode()
    return line(**{field: (f"{field}.json", content)})


def _large_text() -> Body:
    return "application/json", ('{"text":"No","x":[' + "1," * (LARGE // 2) + "1]}").encode()


def _text(text: str) -> Callable[[], Body]:
    return lambda: ("application/json", json.dumps({"text": text}).encode())


def _nods(count: int) -> Body:
    return bml("".join(f'<head id="h{n}" lexeme="NOD" start="{n % 50}" end="{n % 50 + 1}"/>' for n in range(count)))


def _gestures(count: int) -> Body:
    beats = (f'<gesture id="g{n}" lexeme="BEAT" start="{n % 50}" end="{n % 50 + 1}"/>' for n in range(count))
    return bml("".join(beats))


PARSING = (
    Attack("200,000 listeners", "/perform", _listeners),
    Attack("options of 39 MB", "/perform", lambda: _large_numbers("options", '{"x":[', "]}")),
    Attack("functions of 39 MB", "/perform", lambda: _large_numbers("functions", "[", "]")),
    Attack("words of 39 MB", "/perform", lambda: _large_numbers("words", '{"words":[', "]}")),
    Attack("direction of 39 MB", "/perform", lambda: _large_numbers("direction", '{"moments":[', "]}")),
    Attack("text with 39 MB beside it", "/functions", _large_text),
    Attack("BML of 39 MB", "/realize", lambda: bml("<a/>" * (LARGE // 4))),
)
"""Point 1."""

TEXTS = (
    Attack("a!…!b", "/functions", _text("a" + "!" * 19_900 + "b")),
    Attack('no!…!"…"x', "/functions", _text("no" + "!" * 9_000 + '"' * 9_000 + "x")),
    Attack("N with 19,000 accents", "/functions", _text("N" + "\u0301" * 19_000 + "o way")),
    Attack("an ellipsis of 19,000", "/functions", _text("No" + "." * 19_000 + '"' * 900 + " a b")),
    Attack("a stutter of 10,000", "/functions", _text("a" + "-a" * 9_900)),
    Attack("10,000 words", "/functions", _text("no " * 6_600)),
    Attack("6,000 quotations", "/functions", _text('"a" ' * 4_900)),
)
"""Point 2."""

ANSWERS = (
    Attack("a head until 1,000,000 s", "/realize", lambda: bml('<head id="h" lexeme="NOD" start="0" end="1000000"/>')),
    Attack("a head until 600 s", "/realize", lambda: bml('<head id="h" lexeme="NOD" start="0" end="600"/>')),
    Attack("15,000 nods", "/realize", lambda: _nods(15_000)),
    Attack("3,000 gestures", "/realize", lambda: _gestures(3_000)),
)
"""Point 3."""

NUMBERS = (
    Attack(
        "start_s of 5,000 digits",
        "/perform",
        lambda: line(words=("w.json", b'{"words":[{"text":"No.","start_s":' + b"1" * 5_000 + b',"end_s":2}]}')),
    ),
    Attack(
        "start_s of 10**400",
        "/perform",
        lambda: line(words=("w.json", b'{"words":[{"text":"No.","start_s":1' + b"0" * 400 + b',"end_s":2}]}')),
    ),
    Attack(
        "stress of 10**400",
        "/perform",
        lambda: line(
            words=(
                "w.json",
                b'{"words":[{"text":"No.","start_s":0,"end_s":1,'
                b'"phones":[{"label":"N","start_s":0,"end_s":1,"stress":1' + b"0" * 400 + b"}]}]}",
            )
        ),
    ),
    Attack("seed of 5,000 digits", "/perform", lambda: line(options='{"seed":' + "1" * 5_000 + "}")),
)
"""Point 7: what was answered 500."""

ATTACKS = PARSING + TEXTS + ANSWERS + NUMBERS


@contextmanager
def hold_uploads(host: str, port: int, *, count: int = 60, size: int = 38_000_000) -> Iterator[list[socket.socket]]:
    """Uploads that are never finished (point 5): as much of each as the service takes."""
    begin = (
        f"POST /perform HTTP/1.1\r\nHost: x\r\nContent-Type: multipart/form-data; boundary={BOUNDARY}\r\n"
        f"Content-Length: {size + 1000}\r\n\r\n--{BOUNDARY}\r\n"
        'Content-Disposition: form-data; name="audio"; filename="a.wav"\r\n\r\n'
    )
    with ExitStack() as stack:
        held = [stack.enter_context(socket.create_connection((host, port), timeout=5)) for _ in range(count)]
        for upload in held:
            _send_what_goes(upload, begin.encode() + bytes(size))
        yield held


@contextmanager
def hold_headers(host: str, port: int, *, count: int = 600) -> Iterator[list[socket.socket]]:
    """More connections than may be, whose requests never get past their headers (point 5)."""
    with ExitStack() as stack:
        held = []
        for _ in range(count):
            connection = stack.enter_context(socket.create_connection((host, port), timeout=5))
            _send_what_goes(connection, b"POST /perform HTTP/1.1\r\nHost: x\r\nX-A: ")
            held.append(connection)
        yield held


def _send_what_goes(connection: socket.socket, content: bytes) -> None:
    """Sends until the service takes no more for a second, or ends the connection."""
    connection.settimeout(1.0)
    rest = memoryview(content)
    try:
        while rest:
            rest = rest[connection.send(rest[: 1 << 20]) :]
    except OSError:
        return
