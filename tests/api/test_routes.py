"""The service from outside: what it answers, its limits just under and just over, and one shape for every error."""

import gc
import json
import os
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient
from httpx2 import Response

from tests.support.jobs import LONG, LONG_BML
from understudy.acoustic.stage import align
from understudy.api.application import create_app
from understudy.api.bodies import FORM_FIELDS
from understudy.api.workers.limits import Deadline
from understudy.api.workers.messages import Task
from understudy.api.workers.pool import Pool
from understudy.api.workers.processes import Nursery
from understudy.model import Line
from understudy.models import Understudy
from understudy.schemas.options import PerformOptions
from understudy.schemas.responses import AlignResponse
from understudy.settings import Settings

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
AUDIO = (AUDIO_FOLDER / "figure8.flac").read_bytes()
TEXT = (AUDIO_FOLDER / "figure8.txt").read_text(encoding="utf-8")
Field = str | bytes | tuple[str, str | bytes] | None
JSON = {"Accept": "application/json"}


@contextmanager
def _served(nursery: Nursery, **settings: Any) -> Iterator[TestClient]:  # noqa: ANN401
    app = create_app(Settings(**({"workers": 1} | settings)), nursery)

    @app.get("/mistake-of-ours")
    def mistake_of_ours() -> None:
        raise RuntimeError("the secret inside")

    with TestClient(app, raise_server_exceptions=False) as client:
        yield client


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with _served(nursery) as client:
        yield client


def _post(client: TestClient, headers: dict[str, str] | None = None, **fields: Field) -> Response:
    """A line posted as a form; a field of None is left out, a pair is a file with its name."""
    sent = {"audio": ("a.flac", AUDIO), "text": TEXT} | fields
    files = {
        name: value if isinstance(value, tuple) else (None, value) for name, value in sent.items() if value is not None
    }
    return client.post("/perform", files=files, headers=headers)


def _require_problem(answer: Response, status: int, code: str, field: str | None) -> None:
    """The one shape of every error."""
    assert answer.status_code == status, answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    told = answer.json()
    assert told.keys() - {"field"} == {"type", "title", "status", "code", "detail"}
    assert (told["status"], told["code"], told.get("field")) == (status, code, field)
    assert told["type"] == f"urn:understudy:error:{code}"
    assert told["detail"]
    assert "\n" not in told["detail"]
    assert "Traceback" not in answer.text
    assert ("retry-after" in answer.headers) == (status == 503)


def test_a_line_comes_back_as_bml_and_in_json_with_the_same_bml(client: TestClient) -> None:
    xml = _post(client)
    assert (xml.status_code, xml.headers["content-type"], xml.headers["vary"]) == (200, "application/xml", "Accept")
    answer = _post(client, headers=JSON).json()
    assert answer.keys() == {"bml", "performance", "warnings"}
    assert answer["bml"].encode() == xml.content
    codes = [warning["code"] for warning in answer["warnings"]]
    assert xml.headers.get("understudy-warnings", "") == ", ".join(dict.fromkeys(codes))
    assert [word["text"] for word in answer["performance"]["words"]] == TEXT.split()


def test_contours_are_told_where_they_are_asked_for(client: TestClient) -> None:
    contours = _post(client, headers=JSON, options='{"contours": true}').json()["contours"]
    assert contours["frame_shift_s"] == 0.01
    assert len(contours["f0_hz"]) == len(contours["energy_db"]) > 100
    assert 60 < max(contours["f0_hz"]) < 500
    assert min(contours["f0_hz"]) == 0


def test_options_say_how_it_is_performed(client: TestClient) -> None:
    told = _post(client, headers=JSON, options='{"agitation": "high", "seed": 9}').json()["performance"]
    assert (told["agitation"], told["seed"]) == ("high", 9)


def test_every_wrong_option_is_told_and_a_character_that_does_not_exist_with_them(client: TestClient) -> None:
    asked = '{"agitation": "hi", "caracter": "bob", "character": "bob", "seed": "x"}'
    told = _post(client, options=asked).json()
    assert (told["code"], told["field"]) == ("value_wrong", "agitation")
    for part in ("agitation: ", "caracter: ", "seed: ", "'bob'"):
        assert part in told["detail"]


def test_words_timed_elsewhere_are_taken_as_they_are(client: TestClient, understudy: Understudy) -> None:
    words = json.loads(AlignResponse.of(align(understudy.acoustic, Line(AUDIO, TEXT))).to_json())["words"]
    words[0]["start_s"] += 0.012
    timed = json.dumps({"words": [{key: word[key] for key in ("text", "start_s", "end_s")} for word in words]})
    told = _post(client, headers=JSON, words=("w.json", timed)).json()["performance"]
    assert told["words"][0]["start_s"] == pytest.approx(words[0]["start_s"])


def test_functions_of_a_text(client: TestClient) -> None:
    answer = client.post("/functions", json={"text": "No.", "id": "a"}).json()
    assert answer.keys() == {"id", "functions"}
    assert "negation" in {function["class"] for function in answer["functions"]}


@pytest.mark.parametrize("path", ["/healthz", "/readyz", "/openapi.json", "/characters", "/rules", "/lexicon"])
def test_it_tells_what_it_is_and_knows(client: TestClient, path: str) -> None:
    answer = client.get(path)
    assert answer.status_code == 200
    assert answer.json()


def test_its_paths_are_described(client: TestClient) -> None:
    assert client.get("/docs").status_code == 200
    paths = client.get("/openapi.json").json()["paths"]
    assert {"/perform", "/functions", "/healthz", "/readyz", "/characters", "/rules", "/lexicon"} <= paths.keys()
    perform = paths["/perform"]["post"]
    assert perform["requestBody"]["content"].keys() == {"multipart/form-data"}
    assert perform["responses"]["200"]["content"].keys() == {"application/xml", "application/json"}


def _form(**fields: Field) -> Callable[[TestClient], Response]:
    return lambda client: _post(client, None, **fields)


def _functions(content: bytes, media_type: str = "application/json") -> Callable[[TestClient], Response]:
    return lambda client: client.post("/functions", content=content, headers={"Content-Type": media_type})


ERRORS: list[tuple[str, Callable[[TestClient], Response], int, str, str | None]] = [
    ("no path", lambda client: client.get("/nothing"), 404, "not_found", None),
    ("method", lambda client: client.get("/perform"), 405, "method_not_allowed", None),
    ("accept", lambda client: _post(client, headers={"Accept": "text/html"}), 406, "not_acceptable", None),
    ("ours", lambda client: client.get("/mistake-of-ours"), 500, "internal_error", None),
    ("no form", lambda client: client.post("/perform", json={"text": "No."}), 415, "media_type", None),
    ("no body", lambda client: client.post("/perform"), 415, "media_type", None),
    ("tags", _form(audio=None, text="<speak>No."), 422, "tags_wrong", "text"),
    ("no text", _form(text=None), 422, "field_missing", "text"),
    ("field", _form(voice="x"), 422, "field_unknown", "voice"),
    ("empty audio", _form(audio=("a.wav", b"")), 422, "audio_empty", "audio"),
    ("no sound file", _form(audio=("a.wav", b"hello" * 1000)), 415, "audio_format_unsupported", "audio"),
    ("cut audio", _form(audio=("a.flac", AUDIO[: len(AUDIO) // 2])), 400, "audio_truncated", "audio"),
    ("empty text", _form(text=" \n"), 422, "text_empty", "text"),
    ("control", _form(text="No\x00."), 422, "text_control_character", "text"),
    ("surrogate", _form(text=b"No \xed\xa0\x80."), 422, "text_surrogate", "text"),
    ("latin text", _form(text=b"caf\xe9"), 400, "text_not_utf8", "text"),
    ("option", _form(options='{"agitation": "mid"}'), 422, "value_wrong", "agitation"),
    ("options", _form(options="agitation=low"), 400, "not_json", "options"),
    ("character", _form(options='{"character": "nobody"}'), 422, "unknown_character", "character"),
    ("words' format", _form(words=("w.txt", b"x")), 415, "timings_format", "words"),
    ("functions' type", _functions(b"No.", "text/plain"), 415, "media_type", None),
    ("functions' JSON", _functions(b"{"), 400, "not_json", "body"),
    ("functions' shape", _functions(b"[]"), 422, "not_an_object", "body"),
    ("functions' text", _functions(b"{}"), 422, "value_wrong", "text"),
    ("functions' control", _functions(b'{"text": "\\u0007"}'), 422, "text_control_character", "text"),
    ("functions' surrogate", _functions(b'{"text": "\\ud800"}'), 422, "text_surrogate", "body"),
]


@pytest.mark.parametrize(("_name", "ask", "status", "code", "field"), ERRORS, ids=[error[0] for error in ERRORS])
def test_every_error_has_one_shape(
    client: TestClient,
    _name: str,
    ask: Callable[[TestClient], Response],
    status: int,
    code: str,
    field: str | None,
) -> None:
    _require_problem(ask(client), status, code, field)


def test_a_mistake_of_ours_tells_nothing_of_the_inside(client: TestClient) -> None:
    assert "secret" not in client.get("/mistake-of-ours").text


def test_a_refused_method_says_which_are_allowed(client: TestClient) -> None:
    answer = client.get("/perform")
    assert answer.headers["allow"] == "POST"
    assert answer.json()["detail"] == "'/perform' does not support 'GET'; send POST"


@pytest.mark.parametrize(
    ("path", "told"),
    [
        ("/preform", "no such path: '/preform'; did you mean /perform?"),
        ("/gestures/chek", "no such path: '/gestures/chek'; did you mean /gestures/check?"),
        ("/studio/nothing.js", "no such path: '/studio/nothing.js'"),
        ("/%00", "no such path: '/\\x00'"),
    ],
)
def test_a_misspelt_path_is_told_which_is_near(client: TestClient, path: str, told: str) -> None:
    assert client.get(path).json()["detail"] == told


def test_little_is_told_of_a_long_path(client: TestClient) -> None:
    assert len(client.get("/" + "x" * 20_000).json()["detail"]) < 300


@pytest.mark.parametrize(
    ("part", "limit"),
    [
        ("audio", len(AUDIO)),
        ("text", len(TEXT.encode())),
    ],
)
def test_the_limits_of_the_parts(nursery: Nursery, part: str, limit: int) -> None:
    for allowed, status in ((limit, 200), (limit - 1, 413)):
        with _served(nursery, part_bytes=f"{part}={allowed}") as client:
            answer = _post(client)
        assert answer.status_code == status, answer.text
    _require_problem(answer, 413, "field_too_large", part)


def test_the_limit_of_the_body_with_and_without_its_length(nursery: Nursery) -> None:
    body = json.dumps({"text": "No."}).encode()
    headers = {"Content-Type": "application/json"}

    def in_chunks() -> Iterator[bytes]:
        yield from (body[:5], body[5:])

    for allowed, status in ((len(body), 200), (len(body) - 1, 413)):
        with _served(nursery, max_body_bytes=allowed) as client:
            for content in (body, in_chunks()):
                answer = client.post("/functions", content=content, headers=headers)
                assert answer.status_code == status
    _require_problem(answer, 413, "body_too_large", None)


def test_a_request_past_the_places_is_told_to_come_again(nursery: Nursery) -> None:
    with _served(nursery, queue=0) as client:
        pool: Pool = client.app.state.service.pool  # type: ignore[attr-defined]
        assert client.portal
        busy = client.portal.start_task_soon(pool.run, LONG, LONG_BML, Deadline.starting_now(600))
        while pool.busy == 0:
            time.sleep(0.01)
        _require_problem(_post(client), 503, "service_full", None)
        assert client.get("/healthz").status_code == 200
        busy.cancel()


def test_a_request_past_its_deadline_is_answered(nursery: Nursery) -> None:
    with _served(nursery, deadline_s=1e-6) as client:
        _require_problem(_post(client), 504, "deadline_passed", None)


def test_one_address_may_not_ask_too_often(nursery: Nursery) -> None:
    with _served(nursery, rate_per_minute=1) as client:
        asked = [client.post("/functions", json={"text": "No."}) for _ in "12"]
    assert asked[0].status_code == 200
    assert (asked[1].status_code, asked[1].json()["code"]) == (429, "too_many_requests")
    assert 1 <= int(asked[1].headers["retry-after"]) <= 60


def test_uploads_need_no_disk(client: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tempfile, "tempdir", "/nowhere")
    _require_problem(_post(client, audio=("a.wav", b"no sound" * 500_000)), 415, "audio_format_unsupported", "audio")


def test_no_file_stays_open(client: TestClient) -> None:
    def ask() -> int:
        for options in ("{", '{"agitation": "low"}'):
            _post(client, options=options)
        return _open_files()

    gc.collect()
    before = ask()
    assert [ask() for _ in range(3)] == [before] * 3


def _open_files() -> int:
    """How many files and sockets this process has open, but for what the service's watch reads of its processes now and
    then."""
    found = 0
    for descriptor in os.listdir("/proc/self/fd"):
        with suppress(FileNotFoundError):
            found += not os.readlink(f"/proc/self/fd/{descriptor}").startswith("/proc/")
    return found


def test_the_interface_description_names_every_part_and_option_of_a_performance(client: TestClient) -> None:
    described = client.get("/openapi.json").json()["paths"]["/perform"]["post"]
    form = described["requestBody"]["content"]["multipart/form-data"]["schema"]["properties"]
    assert form.keys() == set(FORM_FIELDS[Task.PERFORM])
    assert [name for name in PerformOptions.model_fields if name not in described["description"]] == []
