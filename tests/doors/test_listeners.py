"""Listeners and modes through both interfaces: each listener has a BML document."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from tests.support.bml.bml_checker import check
from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.bml.writing.writer import write_listener
from understudy.cli.main import main
from understudy.model import Channel, Line, Mode
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.settings import Settings

AUDIO = Path(__file__).parents[1] / "audio" / "figure8.flac"
EXAMPLES = Path(__file__).parents[2] / "examples"
TEXT_FILE = AUDIO.with_suffix(".txt")
LINE = Line(AUDIO.read_bytes(), TEXT_FILE.read_text(encoding="utf-8"))
COMMAND = ("perform", str(AUDIO), "--text-file", str(TEXT_FILE), "--quiet")


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        yield client


def _post(client: TestClient, accept: str, **options: Any) -> Any:  # noqa: ANN401
    files: dict[str, Any] = {
        "audio": ("a.flac", LINE.audio),
        "text": (None, LINE.text),
        "options": (None, json.dumps(options)),
    }
    return client.post("/perform", files=files, headers={"Accept": accept})


def test_each_listener_is_a_character_in_bml_of_his_own(understudy: Understudy) -> None:
    options = Options(listeners=("reserved", "bob"))
    performance = perform(understudy, LINE, options)
    assert [notice.code for notice in performance.notices] == ["listener_unknown"]
    for listening in performance.listeners:
        bml = write_listener(performance, listening, options.form)
        assert list(check(bml)) == []
        assert f'characterId="{listening.name}"'.encode() in bml
        assert b"<speech" not in bml
        assert b'target="default"' in bml


def test_a_listener_of_another_name_moves_as_a_character_and_nothing_is_warned_of(client: TestClient) -> None:
    answer = _post(client, "application/json", listener=["Ann=reserved"]).json()
    assert set(answer["listeners"]) == {"Ann"}
    assert not [each for each in answer["warnings"] if each["code"] == "listener_unknown"]
    unknown = _post(client, "application/json", listener=["Ann=nobody"]).json()["warnings"]
    assert "no character is called 'nobody'" in next(each["message"] for each in unknown)


def test_listeners_do_not_change_the_speaker(understudy: Understudy) -> None:
    alone, heard = (perform(understudy, LINE, Options(listeners=names)) for names in ((), ("reserved",)))
    assert alone.behaviors == heard.behaviors


def test_modes_change_the_gestures_alone(understudy: Understudy) -> None:
    """On a line with words that stand out, without which there is nothing to beat on."""
    line = Line((EXAMPLES / "example.flac").read_bytes(), (EXAMPLES / "example.txt").read_text(encoding="utf-8"))
    performances = [perform(understudy, line, Options(mode=mode)) for mode in Mode]
    gestures = [
        [each.lexeme for each in performance.behaviors if each.kept and each.kind is Channel.GESTURE]
        for performance in performances
    ]
    assert set(gestures[1]) == {"BEAT"}
    assert len({tuple(each) for each in gestures}) == 3


def test_the_command_line_writes_listeners_beside(tmp_path: Path) -> None:
    out = tmp_path / "out.bml"
    assert main([*COMMAND, "-o", str(out), "--listener", "Zoë", "--listener", "reserved"]) == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.Zoë.bml", "out.bml", "out.reserved.bml"]


def test_a_listeners_act_ends_as_the_speakers(tmp_path: Path) -> None:
    act = tmp_path / "act.xml"
    assert main([*COMMAND, "-o", str(act), "--dialect", "smartbody", "--listener", "anna"]) == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["act.anna.xml", "act.xml", "figure8.bml"]


@pytest.mark.parametrize(
    "arguments",
    [("--listener", "bob"), ("-o", "o.bml", "--listener", "../b"), ("-o", "o.bml", *("--listener", "bob") * 2)],
)
def test_listeners_that_cannot_be_are_the_callers_mistake(
    tmp_path: Path, arguments: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main([*COMMAND, *arguments]) == 2
    assert list(tmp_path.iterdir()) == []


def test_the_service_answers_listeners_in_json_alone(client: TestClient) -> None:
    answer = _post(client, "*/*", listener=["bob"], mode="prosody").json()
    assert answer["listeners"].keys() == {"bob"}
    assert list(check(answer["listeners"]["bob"].encode())) == []
    assert [each["name"] for each in answer["performance"]["listeners"]] == ["bob"]
    refused = _post(client, "application/xml", listener=["bob"])
    assert refused.status_code == 406
    assert "application/json" in refused.json()["detail"]


@pytest.mark.parametrize("options", [{"listener": "bob"}, {"listener": [1]}, {"listener": ["a b"]}, {"mode": "loud"}])
def test_wrong_options_are_named(client: TestClient, options: dict[str, Any]) -> None:
    answer = _post(client, "application/json", **options)
    assert (answer.status_code, answer.json()["code"]) == (422, "value_wrong")
    assert answer.json()["field"].split(".")[0] in options
