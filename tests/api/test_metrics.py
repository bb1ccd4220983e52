"""The service's figures: what is counted under which path, and that clients cannot make up paths."""

import re

import pytest
from fastapi.testclient import TestClient

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


def test_two_services_in_one_process_count_for_themselves(nursery: Nursery) -> None:
    apps = [create_app(Settings(workers=1), nursery) for _ in "12"]
    with TestClient(apps[0]) as one, TestClient(apps[1]) as other:
        one.get("/healthz")
        with pytest.raises(AssertionError):
            figure(other.get("/metrics").text, 'understudy_requests_total{method="GET",path="/healthz",status="200"}')
