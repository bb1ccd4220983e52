"""A director's notes given with a line, through either interface: conflicts are reported, a mistake names its part."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.cli.main import main
from understudy.settings import Settings

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
AUDIO = AUDIO_FOLDER / "figure8.flac"
TEXT_FILE = AUDIO_FOLDER / "figure8.txt"
AT_ODDS = (
    '{"moments": [{"first": 0, "last": 1, "stroke": 1, "gesture": ["self"]}, '
    '{"first": 1, "last": 2, "stroke": 1, "gesture": ["beat"]}]}'
)
NOT_OF_THE_LINE = AT_ODDS.replace('"last": 2', '"last": 200')
UNKNOWN = AT_ODDS.replace("beat", "baet")


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        yield client


def _form(direction: str) -> dict[str, tuple[str | None, str | bytes]]:
    text = TEXT_FILE.read_text(encoding="utf-8")
    return {"audio": ("a.flac", AUDIO.read_bytes()), "text": (None, text), "direction": ("d.json", direction)}


def test_over_http_conflicts_come_with_the_answer(client: TestClient) -> None:
    answer = client.post("/perform", files=_form(AT_ODDS))
    assert answer.status_code == 200
    assert "direction_strokes" in answer.headers["Understudy-Warnings"]


@pytest.mark.parametrize(
    ("direction", "status", "code"),
    [
        ("{", 400, "not_json"),
        ("[]", 422, "not_an_object"),
        ('{"moment": []}', 422, "direction_wrong"),
        (NOT_OF_THE_LINE, 422, "direction_span"),
        (UNKNOWN, 422, "direction_family"),
    ],
)
def test_over_http_a_mistake_names_them(client: TestClient, direction: str, status: int, code: str) -> None:
    told = client.post("/perform", files=_form(direction)).json()
    assert (told["status"], told["code"], told["field"]) == (status, code, "direction")


def _perform(tmp_path: Path, direction: str) -> int:
    path = tmp_path / "direction.json"
    path.write_text(direction)
    line = [str(AUDIO), "--text-file", str(TEXT_FILE), "--direction", str(path)]
    return main(["perform", *line, "-o", str(tmp_path / "out.bml"), "--json-log"])


def _codes(told: bytes, event: str) -> list[str]:
    return [line["code"] for line in map(json.loads, told.splitlines()) if line["event"] == event]


def test_on_the_command_line_conflicts_are_told(capfdbinary: pytest.CaptureFixture[bytes], tmp_path: Path) -> None:
    assert _perform(tmp_path, AT_ODDS) == 0
    assert "direction_strokes" in _codes(capfdbinary.readouterr().err, "warning")


@pytest.mark.parametrize(("direction", "code"), [("[]", "not_an_object"), (UNKNOWN, "direction_family")])
def test_on_the_command_line_a_mistake_is_one_line(
    direction: str, code: str, capfdbinary: pytest.CaptureFixture[bytes], tmp_path: Path
) -> None:
    assert _perform(tmp_path, direction) == 2
    assert _codes(capfdbinary.readouterr().err, "error") == [code]
