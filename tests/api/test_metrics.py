"""The service's figures: what is counted under which path, and that clients cannot make up paths."""

import re

import pytest
from fastapi.testclient import TestClient
from pydantic import SecretStr
from starlette.websockets import WebSocketDisconnect

from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.settings import Settings


def figure(text: str, name: str) -> float:
    found = re.search(rf"^{re.escape(name)} (\S+)$", text, re.MULTILINE)
    assert found, f"{name} is not in\n{text}"
    return float(found[1])


def test_requests_are_counted_by_path_and_status(nursery: Nursery) -> None:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        client.get("/healthz")
        client.get("/healthz")
        client.post("/functions", json={"text": "No."})
        client.post("/functions", json={})
        client.get("/made/up")
        answer = client.get("/metrics")
    assert answer.headers["content-type"].startswith("text/plain")
    counted = 'understudy_requests_total{{method="{}",path="{}",status="{}"}}'
    assert figure(answer.text, counted.format("GET", "/healthz", 200)) == 2
    assert figure(answer.text, counted.format("POST", "/functions", 200)) == 1
    assert figure(answer.text, counted.format("POST", "/functions", 422)) == 1
    assert figure(answer.text, counted.format("GET", "other", 404)) == 1
    assert figure(answer.text, 'understudy_request_seconds_count{path="/functions"}') == 2
    assert figure(answer.text, "understudy_lines_in_work") == 0
    assert "made" not in answer.text


def test_streams_and_refused_keys_are_counted(nursery: Nursery) -> None:
    key = "a-key-of-the-tests"
    with_key = {"Authorization": f"Bearer {key}"}
    with TestClient(create_app(Settings(workers=1, api_keys=SecretStr(key)), nursery)) as client:
        client.get("/characters")
        client.post("/functions", headers={"Authorization": "Bearer wrong"})
        with pytest.raises(WebSocketDisconnect), client.websocket_connect("/live"):
            pass
        with client.websocket_connect("/live", headers=with_key) as stream:
            stream.send_json({"type": "start"})
            assert stream.receive_json()["type"] == "ready"
            assert figure(client.get("/metrics", headers=with_key).text, "understudy_live_streams") == 1
            stream.send_json({"type": "end"})
            assert stream.receive_json()["type"] == "done"
            with pytest.raises(WebSocketDisconnect):
                stream.receive_json()
        text = client.get("/metrics", headers=with_key).text
    assert figure(text, "understudy_keys_refused_total") == 3
    assert figure(text, 'understudy_live_streams_ended_total{end="401"}') == 1
    assert figure(text, 'understudy_live_streams_ended_total{end="1000"}') == 1


def test_two_services_in_one_process_count_for_themselves(nursery: Nursery) -> None:
    apps = [create_app(Settings(workers=1), nursery) for _ in "12"]
    with TestClient(apps[0]) as one, TestClient(apps[1]) as other:
        one.get("/healthz")
        with pytest.raises(AssertionError):
            figure(other.get("/metrics").text, 'understudy_requests_total{method="GET",path="/healthz",status="200"}')
