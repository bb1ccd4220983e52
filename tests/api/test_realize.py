"""`POST /realize` and `GET /gestures` from outside."""

import json
from collections.abc import Iterator
from math import ceil
from pathlib import Path

import pytest
from fastapi.testclient import TestClient
from httpx2 import Response

import understudy as package
from tests.cli.test_realize import BEAT
from tests.support.bml.bml_records import without_record
from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.bml.writing.writer import write_bml
from understudy.model import Line
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.settings import Settings

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
AUDIO = (AUDIO_FOLDER / "figure8.flac").read_bytes()
TEXT = (AUDIO_FOLDER / "figure8.txt").read_text(encoding="utf-8")
XML = {"Content-Type": "application/xml"}


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), nursery), raise_server_exceptions=False) as client:
        yield client


@pytest.mark.parametrize(
    ("accept", "begins"),
    [
        ("application/json", b"{"),
        ("model/gltf-binary", b"glTF"),
        ("text/x-bvh", b"HIERARCHY"),
        ("application/vnd.pixar.opentimelineio+json", b'{\n "OTIO_SCHEMA"'),
        ("text/praat-textgrid", b'File type = "ooTextFile"'),
        ("text/x-eaf+xml", b"<?xml"),
        ("text/csv", b"tier,id,label"),
        ("model/vnd.vrm-animation", b"glTF"),
        ("text/x-arkit-csv", b"Timecode,BlendShapeCount"),
        ("text/x-bap", b"3.1 "),
        ("text/x-fap", b"2.1 "),
        ("*/*", b"{"),
    ],
)
def test_accept_tells_the_form_of_the_motion(client: TestClient, accept: str, begins: bytes) -> None:
    answer = client.post("/realize", content=BEAT, headers={**XML, "Accept": accept})
    assert answer.status_code == 200, answer.text
    assert answer.content.startswith(begins)
    assert accept == "*/*" or answer.headers["content-type"].startswith(accept)


def test_a_form_takes_the_recording_and_options(client: TestClient, understudy: Understudy) -> None:
    bml = write_bml(perform(understudy, Line(AUDIO, TEXT), Options()))
    options = json.dumps({"fps": 30, "seed": 4, "agitation": "high", "skeleton": "vrm"})
    files: dict[str, tuple[str | None, str | bytes]] = {
        "bml": ("a.bml", bml),
        "audio": ("a.flac", AUDIO),
        "options": (None, options),
    }
    answer = client.post("/realize", files=files)
    assert answer.status_code == 200, answer.text
    clip = answer.json()
    assert clip["frame_rate_hz"] == 30
    assert "Understudy-Warnings" not in answer.headers


def test_files_are_written_as_asked(client: TestClient) -> None:
    options = {"fps": 30, "t_pose": True, "tail_s": 1.0, "keys": "sparse"}
    files = {"bml": ("a.bml", BEAT), "options": (None, json.dumps(options))}
    plain = client.post("/realize", content=BEAT, headers={**XML, "Accept": "text/x-bvh"})
    bvh = client.post("/realize", files=files, headers={"Accept": "text/x-bvh"})
    frames = [int(answer.text.partition("Frames: ")[2].split()[0]) for answer in (bvh, plain)]
    assert frames[0] == ceil((frames[1] + 60) / 2) + 1
    assert b'"name":"face"' in client.post("/realize", files=files, headers={"Accept": "model/gltf-binary"}).content


def test_a_body_has_mass_if_asked_for(client: TestClient) -> None:
    clips = []
    for physics in (True, False, None):
        files = {"bml": ("a.bml", BEAT), "options": (None, json.dumps({"fps": 30, "physics": physics}))}
        answer = client.post("/realize", files=files)
        assert answer.status_code == 200, answer.text
        clips.append(answer.json())
    moved, plain, usual = clips
    assert moved["duration_s"] == plain["duration_s"]
    assert moved != plain == usual


def test_a_speech_without_its_recording_is_warned_of(client: TestClient, understudy: Understudy) -> None:
    bml = without_record(write_bml(perform(understudy, Line(AUDIO, TEXT), Options())))
    answer = client.post("/realize", content=bml, headers=XML)
    assert answer.headers["Understudy-Warnings"] == "lips_unheard"


@pytest.mark.parametrize(
    ("sent", "status", "code"),
    [
        ({"content": b"<bml", "headers": XML}, 422, "bml_wrong"),
        ({"content": BEAT, "headers": {"Content-Type": "text/plain"}}, 415, "media_type"),
        ({"content": BEAT, "headers": {**XML, "Accept": "image/png"}}, 406, "not_acceptable"),
        ({"files": {"audio": ("a.flac", b"x")}}, 422, "field_missing"),
        ({"files": {"bml": ("a", BEAT), "options": (None, '{"fps": 25}')}}, 422, "value_wrong"),
        ({"files": {"bml": ("a", BEAT), "options": (None, '{"skeleton": "biped"}')}}, 422, "unknown_skeleton"),
        ({"files": {"bml": ("a", BEAT), "options": (None, '{"tail_s": 99}')}}, 422, "value_wrong"),
        ({"files": {"bml": ("a", BEAT), "options": (None, '{"keys": "few"}')}}, 422, "value_wrong"),
        ({"files": {"bml": ("a", BEAT), "audio": ("a.flac", b"noise")}}, 415, "audio_format_unsupported"),
    ],
)
def test_every_mistake_is_a_problem_that_names_it(
    client: TestClient, sent: dict[str, object], status: int, code: str
) -> None:
    answer = client.post("/realize", **sent)  # type: ignore[arg-type]
    assert answer.status_code == status, answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    assert answer.json()["code"] == code


def test_the_library_of_gestures_is_listed(client: TestClient) -> None:
    listed = client.get("/gestures").json()["gestures"]
    assert any("BEAT" in gesture["categories"] for gesture in listed)


def _by_model(client: TestClient, bml: bytes, *, audio: bool = True, **fields: str) -> Response:
    files = {"bml": ("line.bml", bml), **({"audio": ("line.flac", AUDIO)} if audio else {})}
    accept = {"Accept": "text/x-bvh"}
    return client.post("/realize", files=files, data={"options": json.dumps({"fps": 30}), **fields}, headers=accept)


def test_a_motion_model_moves_the_body_to_the_recording(client: TestClient, understudy: Understudy) -> None:
    """As the library does by the same model; what is wrong is told by its field."""
    performance = perform(understudy, Line(AUDIO, TEXT), Options())
    bml = write_bml(performance)
    answer = _by_model(client, bml, motion_model="default", scenario="S4")
    assert answer.status_code == 200, answer.text
    moved = package.realize_by_model(understudy, performance, AUDIO, scenario="S4", fps=30)
    assert answer.content == package.write_motion(understudy, moved, "bvh")
    assert answer.content != _by_model(client, bml).content
    for wrong, field, told in (
        (_by_model(client, bml, motion_model="defualt"), "motion_model", "did you mean 'default'"),
        (_by_model(client, bml, motion_model="default", scenario="S9"), "scenario", "give one of S1"),
        (_by_model(client, bml, scenario="S4"), "scenario", "send motion_model too"),
        (_by_model(client, bml, audio=False, motion_model="default"), "audio", "to a recording's voice"),
    ):
        assert wrong.status_code == 422
        assert wrong.json()["field"] == field
        assert told in wrong.json()["detail"]
