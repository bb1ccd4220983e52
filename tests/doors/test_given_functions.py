"""Functions given with a line, through either interface: they are performed, and a mistake in them names its part."""

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
GIVEN = '[{"class": "valence", "subtype": "negative", "first": 7, "last": 7}]'
NOT_OF_THE_LINE = GIVEN.replace("7", "99")


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        yield client


def _given(performance: dict[str, list[dict[str, object]]]) -> list[tuple[object, ...]]:
    return [
        (function["class"], function["first"], function["kept"])
        for function in performance["functions"]
        if function["rule"] == "given"
    ]


def _form(functions: str) -> dict[str, tuple[str | None, str | bytes]]:
    text = TEXT_FILE.read_text(encoding="utf-8")
    return {"audio": ("a.flac", AUDIO.read_bytes()), "text": (None, text), "functions": ("f.json", functions)}


def test_over_http_they_are_in_the_performance(client: TestClient) -> None:
    answer = client.post("/perform", files=_form(GIVEN), headers={"Accept": "application/json"}).json()
    assert _given(answer["performance"]) == [("valence", 7, True)]


@pytest.mark.parametrize(
    ("functions", "status", "code"),
    [("[", 400, "not_json"), ("{}", 422, "functions_wrong"), (NOT_OF_THE_LINE, 422, "functions_span")],
)
def test_over_http_a_mistake_names_them(client: TestClient, functions: str, status: int, code: str) -> None:
    told = client.post("/perform", files=_form(functions)).json()
    assert (told["status"], told["code"], told["field"]) == (status, code, "functions")


def test_on_the_command_line_they_are_in_the_analysis(
    capfdbinary: pytest.CaptureFixture[bytes], tmp_path: Path
) -> None:
    functions = tmp_path / "functions.json"
    functions.write_text(GIVEN)
    assert main(["analyze", str(AUDIO), "--text-file", str(TEXT_FILE), "--functions", str(functions)]) == 0
    assert _given(json.loads(capfdbinary.readouterr().out)) == [("valence", 7, True)]


@pytest.mark.parametrize(("functions", "code"), [("{}", "functions_wrong"), (NOT_OF_THE_LINE, "functions_span")])
def test_on_the_command_line_a_mistake_is_one_line(
    functions: str, code: str, capfdbinary: pytest.CaptureFixture[bytes], tmp_path: Path
) -> None:
    path = tmp_path / "functions.json"
    path.write_text(functions)
    line = [str(AUDIO), "--text-file", str(TEXT_FILE), "--functions", str(path)]
    assert main(["perform", *line, "-o", str(tmp_path / "out.bml"), "--json-log"]) == 2
    told = [json.loads(line) for line in capfdbinary.readouterr().err.splitlines()]
    assert [one["code"] for one in told if one["event"] == "error"] == [code]
