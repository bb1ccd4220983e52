"""Multipart forms: what is read, and every way in which one can be wrong."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from understudy.acoustic.stage import analyze_signal, make_reference
from understudy.api.application import create_app
from understudy.api.workers.form import FormPart, read_form
from understudy.api.workers.processes import Nursery
from understudy.errors import InputError, TooLargeError, UndecodableError, UnderstudyError, UnsupportedFormatError
from understudy.models import Understudy
from understudy.schemas.references import to_json
from understudy.settings import Settings

BOUNDARY = "edge"
END = f"--{BOUNDARY}--\r\n".encode()


def _part(name: str, content: bytes, file_name: str | None = None) -> bytes:
    file = "" if file_name is None else f'; filename="{file_name}"'
    head = f'--{BOUNDARY}\r\nContent-Disposition: form-data; name="{name}"{file}\r\n\r\n'
    return head.encode() + content + b"\r\n"


def _read(
    body: bytes, media_type: str = f"multipart/form-data; boundary={BOUNDARY}", *, most_bytes: int = 1000
) -> dict[str, FormPart]:
    return read_form(media_type, body, {"audio": 1000, "text": most_bytes})


def test_parts_come_by_name_byte_for_byte() -> None:
    body = _part("audio", b"\x00\r\n--edg\xff", "a.wav") + _part("text", "héllo".encode()) + END
    whole = _read(body)
    assert whole == {
        "audio": FormPart("audio", b"\x00\r\n--edg\xff", "a.wav"),
        "text": FormPart("text", "héllo".encode(), None),
    }
    assert whole["text"].text == "héllo"


@pytest.mark.parametrize(
    ("body", "error", "code", "field"),
    [
        (_part("voice", b"") + END, InputError, "field_unknown", "voice"),
        (_part("text", b"a") + _part("text", b"b") + END, InputError, "field_repeated", "text"),
        (_part("text", b"a"), UndecodableError, "form_broken", None),
        (b"", UndecodableError, "form_broken", None),
        (b"not a form", UndecodableError, "form_broken", None),
        (b"--edge\r\nContent-Type: text/plain\r\n\r\nx\r\n" + END, InputError, "field_unknown", ""),
    ],
)
def test_wrong_forms_are_refused(body: bytes, error: type[UnderstudyError], code: str, field: str | None) -> None:
    with pytest.raises(error) as caught:
        _read(body)
    assert caught.value.code == code
    assert getattr(caught.value, "field", None) == field


@pytest.mark.parametrize("media_type", ["application/json", "", "multipart/mixed; boundary=edge"])
def test_another_media_type_is_refused(media_type: str) -> None:
    with pytest.raises(UnsupportedFormatError):
        _read(_part("text", b"a") + END, media_type)


@pytest.mark.parametrize("parameters", ["", "; boundary=", f"; boundary={'x' * 1000}"])
def test_an_impossible_boundary_is_refused(parameters: str) -> None:
    with pytest.raises(UndecodableError):
        _read(_part("text", b"a") + END, "multipart/form-data" + parameters)


@pytest.mark.parametrize("size", [5, 300_000])
def test_a_part_may_be_as_large_as_its_limit_and_no_larger(size: int) -> None:
    body = _part("text", b"a" * size) + END
    assert len(_read(body, most_bytes=size)["text"].content) == size
    with pytest.raises(TooLargeError) as caught:
        _read(body, most_bytes=size - 1)
    assert (caught.value.code, caught.value.field) == ("field_too_large", "text")


def test_text_that_is_not_utf_8_is_refused_and_surrogates_are_left_to_the_transcript() -> None:
    with pytest.raises(UndecodableError) as caught:
        _ = FormPart("text", b"caf\xe9", None).text
    assert caught.value.field == "text"
    assert FormPart("text", b"\xed\xa0\x80", None).text == "\ud800"


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
