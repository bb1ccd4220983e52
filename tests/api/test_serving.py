"""The service as it is started, and how it ends when it is told to; `tests/cli/test_studio.py` kills one."""

import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from http.client import HTTPConnection
from os import environ
from pathlib import Path

import psutil
import pytest
import uvicorn
from fastapi import FastAPI, Request
from fastapi.testclient import TestClient

from tests.support.jobs import LONG_BML
from understudy.api.serving import configuration
from understudy.settings import Settings

PATIENCE_S = 60.0


@dataclass(frozen=True, slots=True)
class _Served:
    process: subprocess.Popen[bytes]
    port: int
    log: Path

    def ask(self, method: str, path: str, body: bytes | None = None) -> tuple[int, bytes]:
        connection = HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE_S)
        try:
            connection.request(method, path, body, {"Content-Type": "application/xml"})
            answer = connection.getresponse()
            return answer.status, answer.read()
        finally:
            connection.close()


@contextmanager
def _serving(folder: Path, **settings: str) -> Iterator[_Served]:
    log = folder / "log"
    command = [sys.executable, "-m", "understudy.cli", "serve", "--port", "0"]
    with log.open("wb") as out:
        process = subprocess.Popen(command, stderr=out, env=environ | settings)
    try:
        yield _Served(process, _port(process, log), log)
    finally:
        process.kill()
        process.wait()


def _port(process: subprocess.Popen[bytes], log: Path) -> int:
    while process.poll() is None:
        found = re.search(r"listening on http://[^:]+:(\d+)", log.read_text())
        if found:
            return int(found[1])
        time.sleep(0.05)
    raise AssertionError(log.read_text())


def _wait_until_gone(family: list[psutil.Process]) -> None:
    _gone, alive = psutil.wait_procs(family, PATIENCE_S)
    assert alive == []


def test_told_to_stop_it_refuses_finishes_within_the_grace_and_leaves_nothing_behind(tmp_path: Path) -> None:
    settings = {"GRACE_S": "2", "WORKERS": "1", "QUEUE": "20", "QUEUE_S": "600", "DEADLINE_S": "600"}
    with _serving(tmp_path, **{f"UNDERSTUDY_{name}": value for name, value in settings.items()}) as served:
        family = psutil.Process(served.process.pid).children(recursive=True)
        answers: list[tuple[int, bytes]] = []
        asking = [
            threading.Thread(target=lambda: answers.append(served.ask("POST", "/realize", LONG_BML))) for _ in range(6)
        ]
        for each in asking:
            each.start()
        while b"understudy_lines_in_work 1.0" not in served.ask("GET", "/metrics")[1]:
            time.sleep(0.02)
        served.process.send_signal(signal.SIGTERM)
        while served.ask("GET", "/readyz")[0] != 503:
            time.sleep(0.02)
        answers.append(served.ask("POST", "/realize", LONG_BML))
        for each in asking:
            each.join()
        refused = [body for status, body in answers if status != 200]
        assert refused
        assert all(status in (200, 503) for status, _body in answers)
        assert all(b"service_stopping" in body for body in refused)
        assert served.process.wait(PATIENCE_S) == 0
        _wait_until_gone(family)
        assert "Traceback" not in served.log.read_text()


@pytest.mark.parametrize(("trusted", "address"), [(None, "127.0.0.1"), ("127.0.0.1", "192.0.2.7"), ("*", "192.0.2.7")])
def test_only_a_proxy_that_is_named_says_who_calls(
    monkeypatch: pytest.MonkeyPatch, trusted: str | None, address: str
) -> None:
    monkeypatch.delenv("FORWARDED_ALLOW_IPS", raising=False)
    if trusted:
        monkeypatch.setenv("FORWARDED_ALLOW_IPS", trusted)
    app = FastAPI()

    @app.get("/")
    def caller(request: Request) -> str:
        return request.client.host if request.client else ""

    loaded: uvicorn.Config = configuration(app, Settings(), {"version": 1, "disable_existing_loggers": False})
    loaded.load()
    client = TestClient(loaded.loaded_app, client=("127.0.0.1", 1))
    assert client.get("/", headers={"X-Forwarded-For": "192.0.2.7"}).json() == address
