"""A gesture profile's file given with a line, through either interface: the same bytes, and mistakes reported."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.cli.main import main
from understudy.settings import Settings

ROOT = Path(__file__).parents[2]
AUDIO = ROOT / "tests" / "audio" / "figure8.flac"
TEXT_FILE = AUDIO.with_suffix(".txt")
PROFILE = (ROOT / "lexicon" / "profiles" / "sweeping.yaml").read_text(encoding="utf-8")
Part = tuple[str | None, str | bytes]


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1, part_bytes=f"profile={len(PROFILE.encode())}"), nursery)) as client:
        yield client


def _form(profile: str, **parts: Part) -> dict[str, Part]:
    text = TEXT_FILE.read_text(encoding="utf-8")
    audio: dict[str, Part] = {"audio": (AUDIO.name, AUDIO.read_bytes()), "text": (None, text)}
    return {**audio, "profile": ("anna.yaml", profile), **parts}


def test_both_doors_make_the_same_of_the_same_file(client: TestClient, tmp_path: Path) -> None:
    (tmp_path / "anna.yaml").write_text(PROFILE, encoding="utf-8")
    out = tmp_path / "out.bml"
    line = (str(AUDIO), "--text-file", str(TEXT_FILE), "--profile", str(tmp_path / "anna.yaml"))
    assert main(["perform", *line, "-o", str(out)]) == 0
    answer = client.post("/perform", files=_form(PROFILE))
    assert answer.status_code == 200
    assert answer.content == out.read_bytes()
    assert answer.content != client.post("/perform", files={**_form(PROFILE), "profile": ("eva.yaml", PROFILE)}).content


@pytest.mark.parametrize(
    ("profile", "parts", "status", "code", "told"),
    [
        (PROFILE.replace("  BEAT:", "  BEET:", 1), {}, 422, "profile_wrong", "did you mean 'BEAT'?"),
        ("a: [", {}, 422, "profile_wrong", "not YAML"),
        (PROFILE, {"options": (None, '{"profile": "sparing"}')}, 422, "field_repeated", "send only one"),
        (PROFILE + "#", {}, 413, "field_too_large", "profile has more than"),
    ],
)
def test_what_is_wrong_with_it_is_told(
    client: TestClient, profile: str, parts: dict[str, Part], status: int, code: str, told: str
) -> None:
    answer = client.post("/perform", files=_form(profile, **parts))
    assert (answer.status_code, answer.json()["code"], answer.json()["field"]) == (status, code, "profile")
    assert told in answer.json()["detail"]
