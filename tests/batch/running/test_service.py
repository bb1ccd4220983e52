"""The service as an engine, over HTTP: the same bytes as local workers, its problems, and `Retry-After`."""

import threading
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import replace
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
import uvicorn
from pydantic import SecretStr

from tests.support.annotations import SWEEPING
from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.batch.audio import AudioSource
from understudy.batch.running.service import ServiceEngine, require_served
from understudy.batch.work.formats import LineFormat
from understudy.batch.work.jobs import Failure, LineJob, OutputTarget
from understudy.batch.work.performing import perform_job
from understudy.errors import InputError
from understudy.model import Channel, DirectedMoment, Direction, Target
from understudy.model.edits import BehaviorEdit, Edits, WordReference
from understudy.model.formats import BmlForm, DialectName, MotionFormat
from understudy.models import Understudy
from understudy.options import Options
from understudy.profiles.annotation.reading import read_annotations
from understudy.profiles.files.reading import read_profile_text
from understudy.profiles.files.writing import profile_yaml
from understudy.profiles.learning.learner import learn
from understudy.settings import Settings

AUDIO = Path(__file__).parents[2] / "audio"
JOB = LineJob(
    "one",
    (AUDIO / "figure8.txt").read_text(encoding="utf-8"),
    AudioSource(AUDIO / "figure8.flac"),
    Options(seed=3, listeners=("default",), stillness=0.1, targets=(Target("lights", (1.0, 2.0, 3.0)),)).with_edits(
        Edits(behaviors=(BehaviorEdit(add=Channel.HEAD, on=WordReference(4), lexeme="NOD"),))
    ),
    tuple(OutputTarget(form, f"one.{form}") for form in (LineFormat.BML, LineFormat.PERFORMANCE)),
    direction=Direction(moments=(DirectedMoment(0, 2, stroke=2, importance=3, gesture=("negation",)),)),
)


KEY = SecretStr("a-key-of-the-team-alone")


@pytest.fixture(scope="module")
def url(nursery: Nursery) -> Iterator[str]:
    app = create_app(Settings(workers=1, api_keys=KEY), nursery)
    server = uvicorn.Server(uvicorn.Config(app, port=0, log_config=None))
    thread = threading.Thread(target=server.run)
    thread.start()
    while not server.started:
        thread.join(0.02)
    yield f"http://127.0.0.1:{server.servers[0].sockets[0].getsockname()[1]}"
    server.should_exit = True
    thread.join()


@pytest.mark.parametrize(
    ("dialect", "paths"),
    [
        (DialectName.BML, ["one.bml", "one.default.bml"]),
        (DialectName.SMARTBODY, ["one.bml", "one.xml", "one.default.xml"]),
    ],
)
def test_a_line_is_performed_there_as_here(
    url: str, understudy: Understudy, dialect: DialectName, paths: list[str]
) -> None:
    job = replace(JOB, options=replace(JOB.options, form=BmlForm(dialect, audio_file="figure8.flac")))
    with closing(ServiceEngine(url, 2, Settings(api_key=KEY))) as engine:
        there = engine.submit(job).result()
    assert there.failure is None, there.failure
    here = perform_job(job, understudy)
    assert [file for file in there.files if file.form is LineFormat.BML] == [
        file for file in here.files if file.form is LineFormat.BML
    ]
    assert [file.path for file in here.files if file.form is LineFormat.BML] == paths
    assert there.measures is not None
    assert here.measures is not None
    assert replace(here.measures, pitch_spread_st=None) == there.measures
    assert there.notices == here.notices


def test_a_profile_of_ones_own_is_sent(url: str, understudy: Understudy) -> None:
    """One that is a file here is known there by what it says, for the service has none of its name."""
    own = read_profile_text(profile_yaml(learn(read_annotations([SWEEPING]), "anna")).decode(), "anna")
    job = replace(JOB, options=Options(seed=3, profile=own), direction=None)
    with closing(ServiceEngine(url, 1, Settings(api_key=KEY))) as engine:
        there = engine.submit(job).result()
    here = perform_job(job, understudy)
    bml = [[file.content for file in each.files if file.form is LineFormat.BML] for each in (there, here)]
    assert bml[0] == bml[1]
    assert b"profile_anna" in (here.files[-1].content or b"")


def test_what_the_line_has_wrong_is_its_failure(url: str) -> None:
    with closing(ServiceEngine(url, 1, Settings(api_key=KEY))) as engine:
        outcome = engine.submit(replace(JOB, text=" ", direction=None)).result()
    assert outcome.failure is not None
    assert outcome.failure.code == "text_empty"


def test_a_full_service_is_asked_again_when_it_says() -> None:
    answers = [
        (503, "0", b"{}"),
        (429, "Thu, 01 Jan 1970 00:00:00 GMT", b"{}"),
        (422, "", b'{"code":"x","detail":"y"}'),
    ]
    with _answering(answers) as server, closing(ServiceEngine(server, 1, Settings())) as engine:
        outcome = engine.submit(JOB).result(timeout=120)
    assert answers == []
    assert outcome.failure == Failure("x", "y")


@pytest.mark.parametrize("settings", [Settings(), Settings(api_key=SecretStr("another-key-of-somebody"))])
def test_a_service_that_wants_another_key_is_told_before_any_line(url: str, settings: Settings) -> None:
    with pytest.raises(InputError, match="UNDERSTUDY_API_KEY") as raised:
        ServiceEngine(url, 1, settings)
    assert raised.value.code == "key_wrong"


def test_no_service_is_told() -> None:
    with pytest.raises(InputError) as raised:
        ServiceEngine("http://127.0.0.1:9", 1, Settings())
    assert raised.value.code == "service_unreachable"


def test_formats_that_are_not_served_are_told() -> None:
    require_served((LineFormat.BML,))
    with pytest.raises(InputError, match="glb"):
        require_served((LineFormat.BML, MotionFormat.GLB))


@contextmanager
def _answering(answers: list[tuple[int, str, bytes]]) -> Iterator[str]:
    """A server that answers posts with one after another: status, `Retry-After`, content."""

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:  # the library's name
            self._answer(200, "", b"{}")

        def do_POST(self) -> None:
            self.rfile.read(int(self.headers["Content-Length"]))
            self._answer(*answers.pop(0))

        def log_message(self, format: str, *args: object) -> None:  # noqa: A002
            pass

        def _answer(self, status: int, retry_after: str, content: bytes) -> None:
            self.send_response(status)
            if retry_after:
                self.send_header("Retry-After", retry_after)
            self.send_header("Content-Length", str(len(content)))
            self.end_headers()
            self.wfile.write(content)

    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{server.server_address[1]}"
        server.shutdown()
        thread.join()
