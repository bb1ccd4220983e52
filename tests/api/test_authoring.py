"""The paths for authors, from outside: gestures checked, played and taken from poses, rules tried and, by a service
with a folder for them, saved."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from tests.authoring.test_rule_edits import AGREEMENT, WORDS, text_of
from tests.support.motion.gesture_files import gesture
from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.settings import Settings

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
AUDIO = (AUDIO_FOLDER / "figure8.flac").read_bytes()
TEXT = (AUDIO_FOLDER / "figure8.txt").read_text(encoding="utf-8")
LINE: dict[str, tuple[str | None, str | bytes]] = {"audio": ("a.flac", AUDIO), "text": (None, TEXT)}


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    app = create_app(Settings(workers=1), nursery)
    with TestClient(app, raise_server_exceptions=False) as client:
        yield client


def test_a_gesture_is_values_and_text_and_the_same_again(client: TestClient) -> None:
    found = client.post("/gestures/check", json={"text": gesture()}).json()
    assert found["mistakes"] == []
    again = client.post("/gestures/check", json={"gestures": found["gestures"]}).json()
    assert again["gestures"] == found["gestures"]
    assert client.post("/gestures/check", json={"text": again["text"]}).json() == again


def test_mistakes_are_answered_with_their_places_and_not_as_an_error(client: TestClient) -> None:
    answer = client.post("/gestures/check", json={"text": gesture("ARMS three")})
    assert answer.status_code == 200
    [mistake] = answer.json()["mistakes"]
    assert (mistake["line"], mistake["column"], mistake["source_line"]) == (4, 6, "ARMS three")


@pytest.mark.parametrize("level", ["low", "medium", "high"])
@pytest.mark.parametrize(("accept", "begins"), [("application/json", b"{"), ("model/gltf-binary", b"glTF")])
def test_a_gesture_is_played_at_each_level(client: TestClient, level: str, accept: str, begins: bytes) -> None:
    asked = {"text": gesture(), "level": level, "fps": 30, "character": "reserved"}
    answer = client.post("/gestures/motion", json=asked, headers={"Accept": accept})
    assert answer.status_code == 200, answer.text
    assert answer.content.startswith(begins)


def test_the_pose_of_a_played_gesture_is_taken_back(client: TestClient) -> None:
    asked = {"text": gesture(), "fps": 30}
    glb = client.post("/gestures/motion", json=asked, headers={"Accept": "model/gltf-binary"}).content
    files: dict[str, tuple[str | None, str | bytes]] = {
        "avatar": ("posed.glb", glb),
        "options": (None, json.dumps({"time_s": 1.5})),
    }
    answer = client.post("/gestures/pose", files=files)
    assert answer.status_code == 200, answer.text
    joints = answer.json()["arms"]["right"]
    lines = "\n  ".join(f"JOINT {name} {' '.join(map(str, degrees))}" for name, degrees in joints.items())
    found = client.post("/gestures/check", json={"text": gesture(first=f"FRAMETYPE stroke_start\n  {lines}")}).json()
    assert found["mistakes"] == []


@pytest.mark.parametrize(
    ("path", "body", "code"),
    [
        ("/gestures/motion", {"text": "GESTURECLASS beat"}, "gesture_wrong"),
        ("/gestures/motion", {"text": gesture("LEVELS high"), "level": "low"}, "unfit_gesture"),
        ("/gestures/motion", {"text": gesture(), "character": "nobody"}, "unknown_character"),
        ("/gestures/check", {}, "value_wrong"),
        ("/rules/check", {"files": {"/etc/passwd": ""}}, "unknown_file"),
        ("/rules/explain", {"name": "no_such_rule"}, "unknown_name"),
        ("/rules/compare", {"files": {WORDS: "clas: x\n"}}, "rules_wrong"),
    ],
)
def test_what_cannot_be_answered_is_told(client: TestClient, path: str, body: object, code: str) -> None:
    answer = client.post(path, json=body)
    assert (answer.status_code, answer.json()["code"]) == (422, code)


def test_a_pose_needs_a_file_that_is_an_avatar(client: TestClient) -> None:
    assert client.post("/gestures/pose", files={"options": (None, "{}")}).json()["code"] == "field_missing"
    assert client.post("/gestures/pose", files={"avatar": ("a.glb", b"glTF")}).status_code == 400


def test_the_files_of_rules_are_read_by_their_names(client: TestClient) -> None:
    listed = client.get("/rules/files").json()
    assert WORDS in listed["files"]
    assert (listed["saved"], listed["writable"]) == ([], False)
    assert client.get(f"/rules/files/{WORDS}").json()["text"] == text_of(WORDS)
    for name in ("pyproject.toml", "lexicon/en/%2e%2e/behaviors.yaml", "", "a" * 300, "%00"):
        assert client.get(f"/rules/files/{name}").status_code == 404


def test_a_rule_is_explained(client: TestClient) -> None:
    [item] = client.post("/rules/explain", json={"name": "show_affirmation"}).json()["items"]
    assert item["file"] == AGREEMENT
    assert text_of(AGREEMENT).splitlines()[item["line"] - 1] == "rule show_affirmation"
    assert "big_nod" in {one["name"] for one in item["leads_to"]}
    assert {one["class"] for one in item["comes_from"]} == {"affirmation"}


def test_an_edited_rule_is_explained_where_its_author_wrote_it(client: TestClient) -> None:
    asked = {"name": "show_affirmation", "files": {AGREEMENT: "# Edited.\n" + text_of(AGREEMENT)}}
    [item] = client.post("/rules/explain", json=asked).json()["items"]
    [before] = client.post("/rules/explain", json={"name": "show_affirmation"}).json()["items"]
    assert (item["file"], item["line"]) == (AGREEMENT, before["line"] + 1)


def test_a_line_is_performed_by_edited_rules_and_the_next_by_those_in_use(client: TestClient) -> None:
    accept = {"Accept": "application/json"}
    before = client.post("/perform", files=LINE, headers=accept).json()["performance"]
    rules = [function["rule"] for function in before["functions"]]
    name = next(item["file"] for item in client.get("/rules").json()["rules"] if item["name"] == rules[0])
    renamed = client.get(f"/rules/files/{name}").json()["text"].replace(f"rule {rules[0]}\n", "rule renamed_here\n")
    edits = {"files": {name: renamed}}
    files = dict(LINE)
    files["rules"] = (None, json.dumps(edits))
    edited = client.post("/perform", files=files, headers=accept)
    assert edited.status_code == 200, edited.text
    assert "renamed_here" in {function["rule"] for function in edited.json()["performance"]["functions"]}
    assert client.post("/perform", files=LINE, headers=accept).json()["performance"] == before


def test_a_line_is_not_performed_by_wrong_rules(client: TestClient) -> None:
    files = dict(LINE)
    files["rules"] = (None, json.dumps({"files": {AGREEMENT: "rule"}}))
    answer = client.post("/perform", files=files)
    assert (answer.status_code, answer.json()["code"], answer.json()["field"]) == (422, "rules_wrong", "rules")
    assert answer.json()["detail"].startswith(f"{AGREEMENT}:")


def test_a_service_saves_no_rules_unless_it_has_a_folder_for_them(client: TestClient) -> None:
    answer = client.put(f"/rules/files/{WORDS}", content="class: thanks\n")
    assert (answer.status_code, answer.json()["code"]) == (403, "rules_read_only")


@pytest.fixture
def saving(nursery: Nursery, tmp_path: Path) -> FastAPI:
    return create_app(Settings(workers=1), nursery, author_folder=tmp_path)


def test_rules_are_saved_in_the_folder_and_in_use_stay_those_that_were(saving: FastAPI, tmp_path: Path) -> None:
    in_use = text_of(WORDS)
    with TestClient(saving, "http://127.0.0.1", client=("127.0.0.1", 50000)) as client:
        assert client.put(f"/rules/files/{WORDS}", content="class: thanks\n").status_code == 200
        assert client.put("/rules/files/lexicon/new.yaml", content="x").status_code == 404
        assert client.get("/rules/files").json()["saved"] == [WORDS]
        assert client.get(f"/rules/files/{WORDS}").json() == {"name": WORDS, "text": "class: thanks\n", "saved": True}
    assert (tmp_path / WORDS).read_text() == "class: thanks\n"
    assert text_of(WORDS) == in_use


def test_gestures_and_characters_are_saved_as_they_were_read_and_without_mistakes(
    saving: FastAPI, tmp_path: Path
) -> None:
    path, own = "/lexicon/files/lexicon/characters/reserved.yaml", tmp_path / "lexicon/characters/reserved.yaml"
    with TestClient(saving, "http://127.0.0.1", client=("127.0.0.1", 50000)) as client:
        assert client.get("/lexicon/files").json()["writable"]
        read = client.get(path)
        changed = read.json()["text"].replace("description: ", "description: Very ", 1)
        match = {"If-Match": read.headers["ETag"]}
        assert client.put(path, content=changed, headers=match).status_code == 200
        again = client.put(path, content=changed, headers=match)
        assert (again.status_code, again.json()["code"]) == (412, "file_changed")
        wrong = client.put(path, content=changed.replace("handedness", "handednes"))
        assert (wrong.status_code, wrong.json()["code"]) == (422, "file_wrong")
        assert wrong.json()["detail"].startswith("lexicon/characters/reserved.yaml:")
        made = client.put("/lexicon/files/gestures/own.gesture", content=gesture())
        assert made.json() == {"name": "lexicon/gestures/own.gesture", "text": gesture(), "saved": True}
        assert client.put("/lexicon/files/lexicon/face.yaml", content="").status_code == 404
        assert len(client.get("/lexicon/files").json()["saved"]) == 2
    assert own.read_text(encoding="utf-8") == changed


def test_new_gestures_and_characters_are_checked_with_those_in_use(client: TestClient) -> None:
    small = client.get("/lexicon/files/lexicon/gestures/small.gesture").json()["text"]
    texts = {"characters/shy.yaml": "description: Shy.\n", "gestures/again.gesture": small}
    mistakes = client.post("/rules/check", json={"files": texts}).json()["mistakes"]
    assert any(each["file"] == "lexicon/characters/shy.yaml" and "handedness" in each["message"] for each in mistakes)
    assert any("lexicon/gestures/again.gesture" in each["message"] for each in mistakes)


def test_rules_are_saved_from_this_machine_alone(saving: FastAPI, tmp_path: Path) -> None:
    elsewhere = [
        ("http://127.0.0.1", "192.0.2.7"),
        ("http://127.0.0.1", "nobody"),
        ("http://rebound.example", "127.0.0.1"),
    ]
    for address, host in elsewhere:
        with TestClient(saving, address, client=(host, 50000)) as client:
            assert client.put(f"/rules/files/{WORDS}", content="class: thanks\n").status_code == 403
            assert client.put("/lexicon/files/gestures/own.gesture", content=gesture()).status_code == 403
    assert list(tmp_path.iterdir()) == []


def test_a_file_to_be_saved_is_text_within_the_limit(nursery: Nursery, tmp_path: Path) -> None:
    app = create_app(Settings(workers=1, part_bytes="rules=100"), nursery, author_folder=tmp_path)
    with TestClient(app, "http://localhost", client=("127.0.0.1", 50000)) as client:
        assert client.put(f"/rules/files/{WORDS}", content=b"\xff").json()["code"] == "text_not_utf8"
        assert client.put(f"/rules/files/{WORDS}", content=b"x" * 101).status_code == 413
        assert client.put(f"/rules/files/{WORDS}", content=b"#" * 100).status_code == 200
