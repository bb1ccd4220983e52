"""`stillness` through every interface that performs or plays a line."""

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
TEXT = (AUDIO_FOLDER / "figure8.txt").read_text(encoding="utf-8")
BML = b"""<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b" characterId="default">
<gesture id="g" lexeme="BEAT" mode="RIGHT_HAND" start="0.2" stroke="1.0" relax="1.4"/></bml>"""


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        yield client


def _form(stillness: str) -> dict[str, tuple[str | None, str | bytes]]:
    options = f'{{"stillness": {stillness}, "listener": ["bob"]}}'
    return {"audio": ("a.flac", AUDIO.read_bytes()), "text": (None, TEXT), "options": (None, options)}


def _moving(behaviors: list[dict[str, object]]) -> set[object]:
    return {each["lexeme"] for each in behaviors if each["kept"]} - {"BLINK", "OPEN_LIPS"}


def test_over_http_nobody_moves_at_one(client: TestClient) -> None:
    answer = client.post("/perform", files=_form("1"), headers={"Accept": "application/json"}).json()
    told = answer["performance"]
    assert told["stillness"] == 1
    assert _moving(told["behaviors"]) == _moving(told["listeners"][0]["behaviors"]) == set()
    assert "<gesture" not in answer["bml"]


@pytest.mark.parametrize("wrong", ["1.5", "-1", "NaN", '"still"'])
def test_over_http_a_wrong_one_is_told(client: TestClient, wrong: str) -> None:
    told = client.post("/perform", files=_form(wrong), headers={"Accept": "application/json"}).json()
    assert (told["status"], told["code"], told["field"]) == (422, "value_wrong", "stillness")


def test_over_http_bml_is_played_as_still(client: TestClient) -> None:
    tracks = []
    for stillness in ("0", "1", "2"):
        form: dict[str, tuple[str | None, str | bytes]] = {
            "bml": ("b.bml", BML),
            "options": (None, f'{{"stillness": {stillness}, "fps": 30}}'),
        }
        answer = client.post("/realize", files=form, headers={"Accept": "application/json"})
        tracks.append(answer.json())
    assert len(tracks[0]["bones"]["rightHand"]) > 30
    assert len(tracks[1]["bones"]["rightHand"]) == 1
    assert (tracks[2]["status"], tracks[2]["field"]) == (422, "stillness")


def test_on_the_command_line(tmp_path: Path) -> None:
    target, trace = tmp_path / "a.bml", tmp_path / "a.json"
    line = [str(AUDIO), "--text", TEXT.strip(), "-o", str(target)]
    assert main(["--quiet", "perform", *line, "--stillness", "1", "--trace", str(trace)]) == 0
    assert _moving(json.loads(trace.read_bytes())["behaviors"]) == set()
    assert main(["--quiet", "perform", *line, "--stillness", "1.2"]) == 2
    (tmp_path / "b.bml").write_bytes(BML)
    clip = tmp_path / "clip.json"
    played = ["--quiet", "realize", str(tmp_path / "b.bml"), "-o", str(clip), "--fps", "30", "--stillness"]
    assert main([*played, "1"]) == 0
    assert len(json.loads(clip.read_bytes())["bones"]["rightHand"]) == 1
    assert main([*played, "-1"]) == 2
