"""YAML that is meant to exhaust whoever reads it, by each way in: told as a mistake, by a worker that goes on."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.settings import Settings

AUDIO = Path(__file__).parents[1] / "audio" / "figure8.flac"
HOSTILE = {
    "100,000 brackets": "[" * 100_000,
    "600 blocks": "\n".join(" " * n + "a:" for n in range(600)),
    "25,000 keys": "\n".join(f"k{n}: v" for n in range(25_000)),
    "24,900 keys": "\n".join(f"k{n}: v" for n in range(24_900)),
}
WORDS = "lexicon/en/spatial.yaml"


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1, deadline_s=60), nursery)) as client:
        yield client


def worker(client: TestClient) -> int:
    [only] = client.app.state.service.pool._workers()  # type: ignore[attr-defined]
    return int(only.process.pid)


@pytest.mark.parametrize("text", HOSTILE.values(), ids=HOSTILE)
def test_a_profile_is_told_as_wrong(client: TestClient, text: str) -> None:
    before = worker(client)
    files: dict[str, Any] = {"audio": AUDIO.read_bytes(), "text": b"eight", "profile": ("hostile.yaml", text.encode())}
    answer = client.post("/perform", files=files)
    assert (answer.status_code, answer.json()["code"]) == (422, "profile_wrong")
    assert worker(client) == before


@pytest.mark.parametrize("text", HOSTILE.values(), ids=HOSTILE)
def test_words_among_rules_are_told_as_wrong(client: TestClient, text: str) -> None:
    before = worker(client)
    told = client.post("/rules/check", json={"files": {WORDS: text}})
    assert told.status_code == 200
    assert 0 < len(told.json()["mistakes"]) <= 101
    assert worker(client) == before
