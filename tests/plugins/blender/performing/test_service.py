"""The service's client against a server that answers what Understudy's service answers."""

import json
import threading
from collections.abc import Iterator
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import ClassVar

import pytest

from plugins.blender.performing.requests import CancelledError, Line, PerformingError, Remark, Sheet
from plugins.blender.performing.service import Service, is_local

Answer = tuple[int, dict[str, str], bytes]
PROBLEM = {"type": "about:blank", "title": "Wrong", "detail": "seed: must be an integer", "code": "value_wrong"}


@dataclass
class Answering:
    """What is answered, in turn, and what was asked."""

    answers: list[Answer]
    asked: list[tuple[str, dict[str, str], bytes]] = field(default_factory=list)


class Handler(BaseHTTPRequestHandler):
    """Answers posts."""

    answering: ClassVar[Answering]

    def do_POST(self) -> None:
        body = self.rfile.read(int(self.headers["Content-Length"]))
        self.answering.asked.append((self.path, dict(self.headers), body))
        status, headers, content = self.answering.answers.pop(0)
        self.send_response(status)
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, format: str, *_arguments: object) -> None:  # noqa: A002 -- the name is http.server's
        """Nothing is logged."""


@pytest.fixture
def server() -> Iterator[tuple[str, Answering]]:
    answering = Answering([])
    handler = type("Answers", (Handler,), {"answering": answering})
    with HTTPServer(("127.0.0.1", 0), handler) as serving:
        thread = threading.Thread(target=serving.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        yield f"http://127.0.0.1:{serving.server_port}/", answering
        serving.shutdown()
        thread.join()


@pytest.fixture
def line(tmp_path: Path) -> Line:
    audio = tmp_path / "line.wav"
    audio.write_bytes(b"RIFF")
    return Line(audio, "No, not those.", {"seed": 2}, {"behaviors": []})


def ignored(_stage: str) -> None:
    """Nobody watches."""


def never() -> bool:
    return False


def test_a_line_is_posted_and_its_answer_read(server: tuple[str, Answering], line: Line) -> None:
    url, answering = server
    answer = {
        "bml": "<bml/>",
        "performance": {"words": []},
        "warnings": [{"code": "x", "message": "a guess"}],
        "listeners": {"ann": "<bml id='ann'/>"},
    }
    answering.answers.append((200, {}, json.dumps(answer).encode()))
    performed = Service(url, "secret").perform(line, ignored, never)
    assert (performed.bml, performed.warnings) == (b"<bml/>", (Remark("x", "a guess"),))
    assert performed.listeners == {"ann": b"<bml id='ann'/>"}
    path, headers, body = answering.asked[0]
    assert (path, headers["Authorization"], headers["Accept"]) == ("/perform", "Bearer secret", "application/json")
    for part in (b'name="text"\r\n\r\nNo, not those.', b'{"seed": 2}', b'filename="line.wav"', b'name="edits"'):
        assert part in body


def test_a_problem_is_told_in_the_services_words(server: tuple[str, Answering], line: Line) -> None:
    url, answering = server
    answering.answers.append((422, {}, json.dumps(PROBLEM).encode()))
    with pytest.raises(PerformingError, match=r"^seed: must be an integer$"):
        Service(url).perform(line, ignored, never)


def test_a_full_service_is_asked_again(server: tuple[str, Answering]) -> None:
    url, answering = server
    answering.answers += [(503, {"Retry-After": "0"}, b""), (429, {"Retry-After": "0"}, b""), (200, {}, b"glb")]
    assert Service(url).mannequin("default") == b"glb"
    assert [path for path, _headers, _body in answering.asked] == ["/realize"] * 3


def test_what_is_no_answer_of_ours_is_told_by_its_status(server: tuple[str, Answering]) -> None:
    url, answering = server
    answering.answers.append((404, {}, b"<html>"))
    with pytest.raises(PerformingError, match="the service answered 404"):
        Service(url).realize(Sheet(b"<bml/>"), ignored, never)


def test_an_answer_that_is_no_longer_wanted_is_left(server: tuple[str, Answering]) -> None:
    url, answering = server
    answering.answers.append((200, {}, b"{}"))
    with pytest.raises(CancelledError):
        Service(url).realize(Sheet(b"<bml/>"), ignored, lambda: True)


@pytest.mark.parametrize("url", ["http://127.0.0.1:9", "no url"])
def test_where_nothing_answers_it_says_what_to_do(url: str) -> None:
    with pytest.raises(PerformingError, match="understudy serve"):
        Service(url).mannequin("default")


@pytest.mark.parametrize(
    ("url", "local"), [("http://localhost:8000", True), ("http://[::1]:1/", True), ("https://example.org", False)]
)
def test_a_service_on_this_machine_needs_no_network(url: str, local: bool) -> None:
    assert is_local(url) is local
