"""Saved rules are in use at once; files with mistakes change nothing, and the service says so."""

import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from fastapi.testclient import TestClient
from starlette.datastructures import State

from understudy.api.application import create_app
from understudy.api.reloading import reloaded
from understudy.authoring.watching import QUIET_MS
from understudy.performance import Understudy
from understudy.settings import Settings

RULES = Path(__file__).resolve().parents[2] / "app" / "rules"
RULE = "\nrule spoon\nforeach\n  word(spoon, $s, $e)\nassert\n  fcn(negation, plain, $s, $e)\n"
PATIENCE_S = 20


@pytest.fixture
def rules(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of the rules, which the service reads again instead of our own."""
    copy = tmp_path / "rules"
    shutil.copytree(RULES, copy, ignore=shutil.ignore_patterns("*.py", "__pycache__"))
    for reader in ("understudy.loading", "understudy.authoring.watching"):
        monkeypatch.setattr(f"{reader}.RULES", copy)
    return copy


@pytest.fixture
def client(understudy: Understudy, rules: Path) -> Iterator[TestClient]:
    assert rules.is_dir()
    with TestClient(create_app(Settings(), understudy, reload=True)) as client:
        yield client


def functions(client: TestClient) -> list[str]:
    answer = client.post("/functions", json={"text": "spoon"})
    return [found["rule"] for found in answer.json()["functions"]]


def wait_until(holds: Callable[[], bool]) -> None:
    end_s = time.monotonic() + PATIENCE_S
    while not holds():
        assert time.monotonic() < end_s, "it never came to hold"
        time.sleep(0.02)


def test_saved_rules_are_used_and_mistakes_change_nothing(client: TestClient, rules: Path) -> None:
    file = rules / "functions" / "comparison.rules"
    written = file.read_text(encoding="utf-8")
    assert client.get("/readyz").json() == {"status": "ready"}
    assert "spoon" not in functions(client)
    file.write_text(written + RULE, encoding="utf-8")
    wait_until(lambda: "spoon" in functions(client))
    assert "spoon" in [rule["name"] for rule in client.get("/rules").json()["rules"]]

    file.write_text(written + RULE.replace("fcn", "fnc"), encoding="utf-8")
    wait_until(lambda: "not_reloaded" in client.get("/readyz").json())
    answer = client.get("/readyz")
    assert answer.status_code == 200
    assert f"{file}:" in answer.json()["not_reloaded"]
    assert "did you mean" in answer.json()["not_reloaded"]
    assert "spoon" in functions(client)

    file.write_text(written, encoding="utf-8")
    wait_until(lambda: client.get("/readyz").json() == {"status": "ready"})
    assert "spoon" not in functions(client)


def test_what_is_under_way_keeps_its_rules(client: TestClient, rules: Path) -> None:
    state: State = client.app.state  # type: ignore[attr-defined]
    old = state.service
    (rules / "functions" / "comparison.rules").write_text(RULE, encoding="utf-8")
    new = reloaded(old)
    assert [rule.name for rule in new.understudy.language.rules.program.rules if rule.name == "spoon"] == ["spoon"]
    assert all(rule.name != "spoon" for rule in old.understudy.language.rules.program.rules)
    assert new.understudy.acoustic is old.understudy.acoustic
    assert new.understudy.language.parser is old.understudy.language.parser
    assert new.capacity is old.capacity


def test_without_the_option_nothing_is_read_again(understudy: Understudy, rules: Path) -> None:
    with TestClient(create_app(Settings(), understudy)) as client:
        (rules / "functions" / "comparison.rules").write_text("rule", encoding="utf-8")
        time.sleep(5 * QUIET_MS / 1000)
        assert client.get("/readyz").json() == {"status": "ready"}
