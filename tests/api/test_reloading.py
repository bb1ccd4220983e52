"""Saved rules are in use at once; files with mistakes change nothing, and the service says so."""

import shutil
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.settings import Settings

RULES = Path(__file__).resolve().parents[2] / "app" / "rules"
RULE = "\nrule spoon\nforeach\n  word(spoon, $s, $e)\nassert\n  fcn(negation, plain, $s, $e)\n"
PATIENCE_S = 60


@pytest.fixture
def rules(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of the rules, which the service reads again instead of our own."""
    copy = tmp_path / "rules"
    shutil.copytree(RULES, copy, ignore=shutil.ignore_patterns("*.py", "__pycache__"))
    monkeypatch.setattr("understudy.authoring.watching.RULES", copy)
    return copy


@pytest.fixture
def reading(rules: Path) -> Iterator[Nursery]:
    """One of our own, which reads the copy."""
    code = (
        "import pathlib, socket, sys, understudy.models as loading\n"
        f"loading.RULES = pathlib.Path({str(rules)!r})\n"
        "from understudy.api.workers.nursery import main\n"
        "main(socket.socket(fileno=int(sys.argv[1])))"
    )
    with Nursery.start(Settings(), command=(sys.executable, "-c", code)) as nursery:
        yield nursery


@pytest.fixture
def client(reading: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), reading, reload=True)) as client:
        yield client


def functions(client: TestClient) -> list[str]:
    answer = client.post("/functions", json={"text": "spoon"})
    return [found["rule"] for found in answer.json()["functions"]]


def wait_until(holds: Callable[[], bool]) -> None:
    end_s = time.monotonic() + PATIENCE_S
    while not holds():
        assert time.monotonic() < end_s, "it never came to hold"
        time.sleep(0.02)


def test_mistakes_change_nothing_and_saved_rules_are_used(client: TestClient, rules: Path) -> None:
    file = rules / "functions" / "comparison.rules"
    written = file.read_text(encoding="utf-8")
    assert client.get("/readyz").json() == {"status": "ready"}
    assert "spoon" not in functions(client)
    file.write_text(written + RULE.replace("fcn", "fnc"), encoding="utf-8")
    wait_until(lambda: "not_reloaded" in client.get("/readyz").json())
    answer = client.get("/readyz")
    assert answer.status_code == 200
    assert f"{file}:" in answer.json()["not_reloaded"]
    assert "did you mean" in answer.json()["not_reloaded"]
    assert "spoon" not in functions(client)

    file.write_text(written + RULE, encoding="utf-8")
    wait_until(lambda: "spoon" in functions(client))
    assert "spoon" in [rule["name"] for rule in client.get("/rules").json()["rules"]]
    wait_until(lambda: client.get("/readyz").json() == {"status": "ready"})
