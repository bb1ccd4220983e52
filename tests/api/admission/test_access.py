"""Every request is let in or told why not, gets its id, and leaves a line in the log without what it said."""

import logging
from typing import Any

import pytest
from fastapi import FastAPI, Request, WebSocket
from fastapi.testclient import TestClient
from pydantic import SecretStr
from starlette.testclient import WebSocketDenialResponse

from understudy.api.admission.access import Admission, guard, require_keys
from understudy.api.admission.headers import let_in_pages
from understudy.api.admission.rates import WRONG_A_MINUTE
from understudy.api.description import page
from understudy.api.problems import answer_errors_as_problems
from understudy.errors import InputError
from understudy.settings import Settings

KEY = "a-key-of-enough-characters"
WITH_KEY = {"Authorization": f"Bearer {KEY}"}
OPEN_PATHS = ("/healthz", "/readyz", "/docs", "/docs/page.js", "/openapi.json")
PATHS = ("/metrics", "/perform", "/characters", "/nothing")


def _client(port: int = 8000, host: str = "127.0.0.1", **settings: Any) -> TestClient:  # noqa: ANN401
    """A small application behind the door."""
    app = FastAPI(docs_url=None)
    app.include_router(page.router)
    answer_errors_as_problems(app)
    read = Settings.model_validate(settings)
    guard(app, Admission.of(read))
    if read.origins:
        let_in_pages(app, read.origins)

    async def told(request: Request) -> dict[str, str]:
        return {"path": request.url.path}

    async def fail() -> None:
        raise RuntimeError("the secret inside")

    async def live(socket: WebSocket) -> None:
        await socket.accept()
        await socket.close()

    for path in ("/healthz", "/readyz", "/metrics", "/perform", "/characters"):
        app.add_api_route(path, told, methods=["GET", "POST"], include_in_schema=False)
    app.add_api_route("/fail", fail)
    app.add_api_websocket_route("/live", live)
    return TestClient(app, base_url=f"http://{host}:{port}", raise_server_exceptions=False)


def _asked(client: TestClient, path: str = "/perform", **headers: str) -> tuple[int, str]:
    """Status and code, if there is one, of what is answered to a POST."""
    answer = client.post(path, headers={name.replace("_", "-"): value for name, value in headers.items()})
    return answer.status_code, answer.json().get("code", "")


def test_without_keys_anybody_may_come_in() -> None:
    client = _client()
    assert [client.get(path).status_code for path in (*OPEN_PATHS, *PATHS[:-1])] == [200] * 8


def test_with_keys_one_is_asked_for_but_by_probes_and_docs() -> None:
    client = _client(api_keys=SecretStr(KEY))
    for path in OPEN_PATHS:
        assert client.get(path).status_code == 200
    for path in PATHS:
        for headers in ({}, {"Authorization": "Bearer wrong"}):
            answer = client.get(path, headers=headers)
            assert (answer.status_code, answer.json()["code"]) == (401, "key_wrong")
            assert answer.headers["www-authenticate"] == "Bearer"
        assert client.get(path, headers=WITH_KEY).status_code == (404 if path == "/nothing" else 200)


def test_web_sockets_need_a_key_too() -> None:
    client = _client(api_keys=SecretStr(KEY))
    with pytest.raises(WebSocketDenialResponse) as refused, client.websocket_connect("/live"):
        pass
    assert (refused.value.status_code, refused.value.json()["code"]) == (401, "key_wrong")
    with client.websocket_connect("/live", headers=WITH_KEY):
        pass


def test_operators_have_a_port_of_their_own() -> None:
    settings: dict[str, Any] = {"operations_port": 9000, "api_keys": SecretStr(KEY)}
    public, operators = _client(8000, **settings), _client(9000, **settings)
    for path in ("/metrics", "/docs", "/docs/page.js", "/openapi.json"):
        assert public.get(path, headers=WITH_KEY).status_code == 404
        assert operators.get(path).status_code == 200
    assert operators.get("/characters", headers=WITH_KEY).status_code == 404
    assert public.get("/characters", headers=WITH_KEY).status_code == 200
    for client in (public, operators):
        assert client.get("/healthz").status_code == client.get("/readyz").status_code == 200


def test_metrics_and_docs_can_be_off() -> None:
    client = _client(closed="metrics, docs")
    for path in ("/metrics", "/docs", "/docs/page.js", "/openapi.json"):
        assert client.get(path).status_code == 404
    assert client.get("/characters").status_code == 200


def test_hosts_that_are_not_allowed_are_refused_but_for_probes() -> None:
    client = _client(host="evil.example", allowed_hosts="lines.example, .studio.example")
    answer = client.get("/characters")
    assert (answer.status_code, answer.json()["code"]) == (421, "host_unknown")
    assert client.get("/healthz").status_code == 200
    assert client.get("/characters", headers={"Host": "a.studio.example:80"}).status_code == 200


@pytest.mark.parametrize(
    "host", ["127.0.0.1:8000", "localhost", "a.localhost:1", "LOCALHOST.", "[::1]:8000", "127.9.9.9"]
)
def test_on_loopback_without_keys_its_own_names_are_right(host: str) -> None:
    assert _asked(_client(), Host=host)[0] == 200


@pytest.mark.parametrize(
    "host", ["evil.example", "127.0.0.1.evil.example", "localhost.evil.example", "localhost:8000.evil", "192.0.2.1", ""]
)
def test_on_loopback_without_keys_no_other_name_is(host: str) -> None:
    assert _asked(_client(), Host=host) == (421, "host_unknown")
    assert _asked(_client(api_keys=SecretStr(KEY)), Host=host, **WITH_KEY)[0] == 200
    assert _asked(_client(allow_anonymous=True), Host=host)[0] == 200
    assert _asked(_client(host="192.0.2.7"), Host=host)[0] == 200


OTHERS = [
    "http://evil.example",
    "null",
    "http://127.0.0.1:3000",
    "https://127.0.0.1:8000.evil.example",
    "x",
    "http://[",
    "",
]


@pytest.mark.parametrize("origin", OTHERS)
def test_pages_of_other_origins_neither_write_nor_work_nor_listen_in(origin: str) -> None:
    client = _client()
    assert _asked(client, Origin=origin) == (403, "origin_refused")
    with pytest.raises(WebSocketDenialResponse) as refused:
        client.websocket_connect("/live", headers={"Origin": origin}).__enter__()
    assert refused.value.json()["code"] == "origin_refused"
    read = client.get("/characters", headers={"Origin": origin})
    assert read.headers["cross-origin-resource-policy"] == "same-origin"
    assert "access-control-allow-origin" not in read.headers


@pytest.mark.parametrize(
    ("host", "origin"),
    [
        ("127.0.0.1:8000", "http://127.0.0.1:8000"),
        ("localhost", "http://localhost"),
        ("localhost", "https://localhost"),
        ("localhost:443", "https://LOCALHOST"),
        ("[::1]:80", "http://[::1]"),
    ],
)
def test_the_service_s_own_pages_may(host: str, origin: str) -> None:
    assert _asked(_client(), Host=host, Origin=origin)[0] == 200
    with _client().websocket_connect("/live", headers={"Host": host, "Origin": origin}):
        pass


def test_pages_that_are_named_may_and_read_what_is_answered_although_they_ask_without_a_key_first() -> None:
    page = "http://localhost:5173"
    client = _client(allowed_origins=f"{page}, https://game.example", api_keys=SecretStr(KEY))
    asked = {"Origin": page, "Access-Control-Request-Method": "POST", "Access-Control-Request-Headers": "authorization"}
    assert client.options("/perform", headers=asked).status_code == 200
    answer = client.post("/perform", headers={"Origin": page, **WITH_KEY})
    assert (answer.status_code, answer.headers["access-control-allow-origin"]) == (200, page)
    assert client.post("/perform", headers={"Origin": page}).headers["access-control-allow-origin"] == page
    assert _asked(client, Origin="http://evil.example", **WITH_KEY) == (403, "origin_refused")


def test_a_body_whose_length_is_said_in_two_ways_is_refused() -> None:
    answer = _client().post("/perform", headers={"Transfer-Encoding": "chunked", "Content-Length": "3"}, content=b"abc")
    assert (answer.status_code, answer.json()["code"], answer.headers["connection"]) == (400, "http_error", "close")


def test_who_guesses_keys_is_stopped_and_who_was_let_in_before_is_not() -> None:
    client = _client(api_keys=SecretStr(f"{KEY}, {KEY}2"))
    assert _asked(client, **WITH_KEY)[0] == 200
    for _ in range(WRONG_A_MINUTE):
        assert _asked(client, Authorization="Bearer wrong") == (401, "key_wrong")
    answer = client.post("/perform", headers={"Authorization": "Bearer wrong"})
    assert (answer.status_code, answer.json()["code"]) == (429, "too_many_wrong_keys")
    assert int(answer.headers["retry-after"]) <= 60
    assert _asked(client, Authorization=f"Bearer {KEY}2") == (429, "too_many_wrong_keys")
    assert _asked(client, **WITH_KEY)[0] == 200
    assert _asked(client) == (401, "key_wrong")


@pytest.mark.parametrize("path", ["/characters", "/nothing", "/fail", "/docs"])
def test_every_answer_is_marked(path: str) -> None:
    answer = _client().get(path, headers={"X-Request-ID": "game-7.42"})
    assert answer.headers["x-content-type-options"] == "nosniff"
    assert "default-src 'none'" in answer.headers["content-security-policy"]
    assert answer.headers["x-request-id"] == "game-7.42"
    assert "server" not in answer.headers


@pytest.mark.parametrize("sent", ["", "a b", "x" * 65, "a\tb", "a,b"])
def test_an_odd_id_is_replaced(sent: str) -> None:
    given = _client().get("/characters", headers={"X-Request-ID": sent}).headers["x-request-id"]
    assert given != sent
    assert len(given) == 32


def test_a_request_leaves_a_line_with_its_id_and_not_its_key(caplog: pytest.LogCaptureFixture) -> None:
    client = _client(api_keys=SecretStr(KEY))
    with caplog.at_level(logging.INFO, "understudy.requests"):
        client.post("/perform?text=secret", headers=WITH_KEY, content="secret words")
        client.get("/healthz")
        with client.websocket_connect("/live?key=secret", headers=WITH_KEY):
            pass
    record, stream = [record for record in caplog.records if record.name == "understudy.requests"]
    assert stream.getMessage().startswith("GET '/live' 101 in ")
    assert "secret" not in stream.getMessage()
    told = record.getMessage()
    assert told.startswith("POST '/perform' 200 in ")
    assert f"with key {record.__dict__['fields']['key']}" in told
    assert "secret" not in told
    assert KEY not in str(record.__dict__)


@pytest.mark.parametrize("address", ["127.0.0.1", "127.1.2.3", "::1"])
def test_on_loopback_no_key_is_needed(address: str) -> None:
    require_keys(Admission.of(Settings()), address, Settings())


@pytest.mark.parametrize("address", ["0.0.0.0", "::", "192.0.2.7", "fe80::1%eth0"])
def test_elsewhere_one_is_needed_unless_it_is_said_otherwise(address: str) -> None:
    with pytest.raises(InputError) as caught:
        require_keys(Admission.of(Settings()), address, Settings())
    assert caught.value.code == "key_missing"
    for settings in (Settings(api_keys=SecretStr(KEY)), Settings(allow_anonymous=True)):
        require_keys(Admission.of(settings), address, settings)
