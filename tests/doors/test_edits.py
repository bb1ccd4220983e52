"""An author's edits given with a line, through either interface: the same bytes, conflicts and mistakes reported."""

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
LINE = (str(AUDIO), "--text-file", str(TEXT_FILE))
WORDS = TEXT_FILE.read_text(encoding="utf-8").split()
Part = tuple[str | None, str | bytes]
NOT_THERE = {"of": {"channel": "gesture", "at": {"word": 0, "text": "perhaps"}, "lexeme": "BEAT"}, "omit": "deleted"}
ADDED = {"add": "gesture", "on": {"word": 8, "text": WORDS[8]}, "lexeme": "POINT_FRONT", "hand": "left"}
EDITS = {
    "line": {"seed": 3, "stillness": 0.1, "agitation": "high"},
    "words": [{"at": {"word": 2, "text": WORDS[2]}, "mark": "important"}],
    "behaviors": [ADDED, NOT_THERE],
}


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        yield client


@pytest.fixture
def edits_file(tmp_path: Path) -> Path:
    path = tmp_path / "line.edits.json"
    path.write_text(json.dumps(EDITS), encoding="utf-8")
    return path


def _form(edits: object, **parts: Part) -> dict[str, Part]:
    text = TEXT_FILE.read_text(encoding="utf-8")
    audio: dict[str, Part] = {"audio": (AUDIO.name, AUDIO.read_bytes()), "text": (None, text)}
    return {**audio, "edits": ("e.json", json.dumps(edits)), **parts}


def test_both_doors_make_the_same_of_the_same_edits(client: TestClient, edits_file: Path) -> None:
    out = edits_file.with_name("out.bml")
    assert main(["perform", *LINE, "--edits", str(edits_file), "-o", str(out)]) == 0
    answer = client.post("/perform", files=_form(EDITS))
    assert answer.status_code == 200
    assert answer.content == out.read_bytes()
    assert b'lexeme="POINT_FRONT" mode="LEFT_HAND"' in answer.content
    assert answer.headers["Understudy-Warnings"].split(", ").count("edit_word_gone") == 1


def test_known_times_of_words_change_nothing(client: TestClient) -> None:
    """A page sends the words as it got them, so that nothing is aligned again."""
    told = client.post("/perform", files=_form({}), headers={"Accept": "application/json"}).json()
    words = ("heard.json", json.dumps(told["performance"]))
    again = client.post("/perform", files=_form(EDITS, words=words)).content
    assert again == client.post("/perform", files=_form(EDITS)).content


def test_the_motion_of_the_written_bml_is_that_of_the_performance(edits_file: Path) -> None:
    out, direct, again = (edits_file.with_name(name) for name in ("out.bml", "direct.bvh", "again.bvh"))
    arguments = ["--edits", str(edits_file), "--realize", str(direct), "-o", str(out)]
    assert main(["perform", *LINE, *arguments]) == 0
    assert main(["realize", str(out), "-o", str(again)]) == 0
    assert again.read_bytes() == direct.read_bytes()


def test_no_edits_change_nothing_byte_for_byte(client: TestClient) -> None:
    form = _form({})
    without = {name: part for name, part in form.items() if name != "edits"}
    headers = {"Accept": "application/json"}
    with_none, plain = (client.post("/perform", files=each, headers=headers) for each in (form, without))
    assert with_none.content == plain.content


def test_the_answer_says_which_behaviour_an_edit_made(client: TestClient) -> None:
    told = client.post("/perform", files=_form(EDITS), headers={"Accept": "application/json"}).json()
    [made] = [each for each in told["performance"]["behaviors"] if each.get("edit") == 0]
    assert (made["lexeme"], made["hand"], made["first"]) == ("POINT_FRONT", "left", 8)


@pytest.mark.parametrize(
    ("edits", "status", "code", "field"),
    [
        ([], 422, "not_an_object", "edits"),
        ({"behaviors": [{}]}, 422, "edits_wrong", "edits"),
        ({"line": {"character": "nobody"}}, 422, "unknown_character", "character"),
    ],
)
def test_over_http_a_mistake_names_them(client: TestClient, edits: object, status: int, code: str, field: str) -> None:
    told = client.post("/perform", files=_form(edits)).json()
    assert (told["status"], told["code"], told["field"]) == (status, code, field)


def test_on_the_command_line_a_mistake_is_one_line(tmp_path: Path, capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    path = tmp_path / "edits.json"
    path.write_text('{"behaviors": [{}], "words": [{"at": {}}]}')
    assert main(["perform", *LINE, "--edits", str(path)]) == 2
    told = capfdbinary.readouterr().err.decode()
    assert "behaviors[0]: give either `of`, or both `add` and `on`" in told
    assert "words[0].at.word: field required" in told
    assert told.count("\n") == 1
