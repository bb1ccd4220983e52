"""The forms of BML that either interface offers, and the lip sync of every performance."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from tests.support.bml.bml_checker import check
from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.bml.reading.reader import read_bml
from understudy.bml.writing.writer import write_bml, write_speech_file
from understudy.cli.main import main
from understudy.errors import InputError
from understudy.model import Line, Performance
from understudy.model.formats import BmlForm, DialectName, TimeForm, VisemeNames
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.schemas.options import read_options
from understudy.schemas.responses import PerformanceResponse
from understudy.settings import Settings

ROOT = Path(__file__).resolve().parents[2]
AUDIO = ROOT / "examples" / "example.flac"
TEXT = AUDIO.with_suffix(".txt")

Perform = Callable[..., bytes]


@pytest.fixture(scope="module")
def performance(understudy: Understudy) -> Performance:
    return perform(understudy, Line(AUDIO.read_bytes(), TEXT.read_text(encoding="utf-8")), Options())


@pytest.fixture
def from_command_line(tmp_path: Path) -> Perform:
    """The file that the command line writes."""

    def run(*options: str, name: str = "out.bml") -> bytes:
        target = tmp_path / name
        argv = ["--quiet", "perform", str(AUDIO), "--text-file", str(TEXT), "-o", str(target), *options]
        assert main(argv) == 0
        return target.read_bytes()

    return run


@pytest.mark.parametrize("dialect", DialectName)
@pytest.mark.parametrize("timing", TimeForm)
def test_the_options_of_the_service_are_those_of_the_command_line(dialect: DialectName, timing: TimeForm) -> None:
    content = json.dumps({"dialect": dialect.value, "timing": timing.value}).encode()
    assert read_options(content).form == BmlForm(dialect, timing)


@pytest.mark.parametrize(("name", "value"), [("dialect", "xml"), ("timing", "relative"), ("timing", 1)])
def test_other_forms_are_a_mistake_of_their_option(name: str, value: object) -> None:
    with pytest.raises(InputError) as caught:
        read_options(json.dumps({name: value}).encode())
    assert (caught.value.code, caught.value.field) == ("value_wrong", name)


@pytest.mark.parametrize("option", ["--dialect=xml", "--timing=relative"])
def test_other_forms_are_a_mistake_on_the_command_line(option: str) -> None:
    assert main(["--quiet", "perform", str(AUDIO), "--text", "hello", option]) == 2


def test_the_command_line_writes_the_form_asked_for(from_command_line: Perform, performance: Performance) -> None:
    form = BmlForm(DialectName.SMARTBODY, TimeForm.SYNC, "example")
    assert from_command_line("--dialect", "smartbody", "--timing", "sync") == write_bml(performance, form)


def test_smartbody_gets_its_speech_file_beside_the_act(
    from_command_line: Perform, performance: Performance, tmp_path: Path
) -> None:
    act = from_command_line("--dialect", "smartbody", "--visemes", "facefx", name="act.xml")
    form = BmlForm(DialectName.SMARTBODY, audio_file="example", visemes=VisemeNames.FACEFX)
    beside = write_speech_file(performance, form)
    assert beside is not None
    assert act == write_bml(performance, form)
    assert (tmp_path / "example.bml").read_bytes() == beside.content


def test_the_speech_file_is_not_written_over_the_act(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    argv = ["perform", str(AUDIO), "--text-file", str(TEXT), "--dialect", "smartbody"]
    assert main(["--quiet", *argv, "-o", str(tmp_path / "example.bml")]) == 2
    assert "is the same file as" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_ends_in_json_is_json(from_command_line: Perform, performance: Performance) -> None:
    told = json.loads(from_command_line(name="out.json"))
    assert told["dialect"] == "bml"
    kept = [behavior.id for behavior in performance.behaviors if behavior.kept]
    assert [part["attributes"]["id"] for part in told["root"]["content"]] == ["speech1", *kept]


def test_the_service_writes_the_form_asked_for(nursery: Nursery, performance: Performance) -> None:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        answer = client.post(
            "/perform",
            files={"audio": ("take 7.flac", AUDIO.read_bytes())},
            data={"text": TEXT.read_text(encoding="utf-8"), "options": '{"dialect": "smartbody"}'},
        )
    assert answer.status_code == 200, answer.text
    form = BmlForm(DialectName.SMARTBODY, audio_file="take 7.flac")
    assert answer.content == write_bml(performance, form)
    told = answer.headers["Understudy-Warnings"].split(", ")
    assert told[-1] == "speech_file_left_out"
    assert "smartbody_gaze" in told


def test_the_service_sends_the_speech_file_in_json(nursery: Nursery, performance: Performance) -> None:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        answer = client.post(
            "/perform",
            files={"audio": ("take 7.flac", AUDIO.read_bytes())},
            data={"text": TEXT.read_text(encoding="utf-8"), "options": '{"dialect": "smartbody"}'},
            headers={"Accept": "application/json"},
        )
    beside = write_speech_file(performance, BmlForm(DialectName.SMARTBODY, audio_file="take 7.flac"))
    assert beside is not None
    assert answer.json()["speech_file"] == {"name": "take 7.bml", "bml": beside.content.decode()}


@pytest.mark.parametrize("form", [BmlForm(dialect, timing) for dialect in DialectName for timing in TimeForm], ids=str)
def test_a_whole_line_comes_back_from_what_is_written(performance: Performance, form: BmlForm) -> None:
    written = write_bml(performance, form)
    document, notices = read_bml(written, Path("line.bml"))
    assert (document.dialect, notices) == (form.dialect, ())
    if form.dialect is DialectName.BML:
        assert check(written) == []


def test_the_performance_has_the_mouth_from_first_to_last(performance: Performance) -> None:
    told: dict[str, Any] = json.loads(PerformanceResponse.of_performance(performance).to_json())
    visemes = told["visemes"]
    assert visemes[0]["start_s"] == 0.0
    assert visemes[-1]["end_s"] == told["audio"]["duration_s"]
    assert {viseme["label"] for viseme in visemes} > {"sil", "nn", "E", "aa"}
    assert all(0 <= viseme["opening"] <= viseme["articulation"] <= 1 for viseme in visemes)
