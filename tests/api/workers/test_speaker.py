"""How the speaker usually sounds, sent with a line over HTTP: stored, recorded, and wrong."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from understudy.acoustic.stage import analyze_signal, make_reference
from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.models import Understudy
from understudy.schemas.references import to_json
from understudy.settings import Settings

AUDIO = Path(__file__).parents[2] / "audio" / "figure8.flac"
OTHER = AUDIO.with_name("numbers.flac")


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        yield client


@pytest.fixture(scope="module")
def stored(understudy: Understudy) -> bytes:
    return to_json(make_reference(understudy.acoustic, [analyze_signal(understudy.acoustic, OTHER.read_bytes())]))


def _told(client: TestClient, reference: tuple[str, bytes] | None, options: str = "{}") -> dict[str, Any]:
    files: dict[str, Any] = {
        "audio": ("a.flac", AUDIO.read_bytes()),
        "text": (None, AUDIO.with_suffix(".txt").read_text()),
        "options": (None, options),
    }
    sent = files | ({"reference": reference} if reference else {})
    told: dict[str, Any] = client.post("/perform", files=sent, headers={"Accept": "application/json"}).json()
    return told


def _memberships(told: dict[str, Any]) -> dict[str, float]:
    found: dict[str, float] = told["performance"]["memberships"]
    return found


def test_a_recording_and_what_is_stored_of_it_say_the_same_by_any_way(client: TestClient, stored: bytes) -> None:
    recorded = _memberships(_told(client, ("other.flac", OTHER.read_bytes())))
    assert recorded != _memberships(_told(client, None))
    assert recorded == _memberships(_told(client, ("ref.json", stored)))
    assert recorded == _memberships(_told(client, None, json.dumps({"reference": json.loads(stored)})))


@pytest.mark.parametrize(
    ("reference", "status", "code"),
    [
        (("ref.json", b"{}"), 422, "reference_unreadable"),
        (("other.flac", b"no sound"), 415, "audio_format_unsupported"),
    ],
)
def test_a_wrong_reference_is_told_by_its_field(
    client: TestClient, reference: tuple[str, bytes], status: int, code: str
) -> None:
    told = _told(client, reference)
    assert (told["status"], told["code"], told["field"]) == (status, code, "reference")


def test_two_references_are_one_too_many(client: TestClient, stored: bytes) -> None:
    told = _told(client, ("ref.json", stored), json.dumps({"reference": json.loads(stored)}))
    assert (told["status"], told["code"], told["field"]) == (422, "field_repeated", "reference")
