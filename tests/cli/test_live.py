"""`understudy live`: a recording, raw samples from a file and from a stream, and what is refused."""

import io
import json
import socket
import sys
from pathlib import Path

import pytest
import soundfile
from pythonosc.osc_bundle import OscBundle

from tests.cli.test_cli import AUDIO
from understudy.cli.main import main

Captured = pytest.CaptureFixture[str]


@pytest.fixture
def raw() -> bytes:
    samples, rate_hz = soundfile.read(AUDIO, dtype="int16")
    assert rate_hz == 16000
    return bytes(samples.astype("<i2").tobytes())


def told(capture: Captured, *argv: str) -> list[dict[str, object]]:
    capture.readouterr()
    assert main(["live", *argv]) == 0
    return [json.loads(line) for line in capture.readouterr().out.splitlines()]


def test_a_recording_is_told_as_it_is_heard(capsys: Captured) -> None:
    first, *events, last = told(capsys, AUDIO)
    assert first == {"type": "ready", "sample_rate_hz": 16000, "character": "default"}
    assert {event["type"] for event in events} >= {"gesture", "mouth", "eyes"}
    assert last == {"type": "done", "duration_s": pytest.approx(soundfile.info(AUDIO).duration, abs=0.001)}


def test_raw_samples_are_the_same_speech(
    capsys: Captured, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, raw: bytes
) -> None:
    """From a file and as they come, where an odd byte at the end is dropped."""
    (tmp_path / "speech.raw").write_bytes(raw)
    expected = told(capsys, str(tmp_path / "speech.raw"), "--rate", "16000")
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(raw + b"\x07")))
    assert told(capsys, "-", "--rate", "16000") == expected


def test_frames_and_lines_in_a_file(capsys: Captured, tmp_path: Path) -> None:
    out = tmp_path / "live.jsonl"
    assert told(capsys, AUDIO, "--frames", "30", "-o", str(out)) == []
    lines = [json.loads(line) for line in out.read_text().splitlines()]
    frames = [line for line in lines if line["type"] == "frame"]
    assert len(frames) == pytest.approx(30 * lines[-1]["duration_s"], abs=2)
    assert {len(frame["rotations"]) for frame in frames} == {4 * len(lines[0]["joints"])}


@pytest.mark.parametrize("rate", ["0", "-16000", "10000000", "fast"])
def test_a_rate_that_cannot_be_is_refused(capsys: Captured, rate: str) -> None:
    assert main(["live", AUDIO, "--rate", rate]) == 2
    assert "rate" in capsys.readouterr().err


def test_what_is_no_audio_is_refused(capsys: Captured, tmp_path: Path) -> None:
    (tmp_path / "speech.wav").write_bytes(b"nothing of the kind")
    assert main(["live", str(tmp_path / "speech.wav")]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 1


def test_an_avatar_is_moved_in_time_with_the_recording(capsys: Captured, tmp_path: Path) -> None:
    """A tenth of a second: six frames, without a line of them."""
    (tmp_path / "short.raw").write_bytes(bytes(3200))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(5)
        host, port = receiver.getsockname()
        lines = told(
            capsys, str(tmp_path / "short.raw"), "--rate", "16000", "--vmc", f"{host}:{port}", "--vmc-face", "none"
        )
        assert [line["type"] for line in lines if line["type"] != "mouth"] == ["ready", "done"]
        assert OscBundle(receiver.recv(2000)).content(0).address == "/VMC/Ext/OK"


def test_a_face_is_moved_beside(capsys: Captured, tmp_path: Path) -> None:
    (tmp_path / "short.raw").write_bytes(bytes(3200))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(5)
        host, port = receiver.getsockname()
        told(capsys, str(tmp_path / "short.raw"), "--rate", "16000", "--live-link-face", f"{host}:{port}")
        frames = [receiver.recv(2000) for _ in range(6)]
    assert {len(each) for each in frames} == {len(frames[0])}
    assert {each[0] for each in frames} == {6}


@pytest.mark.parametrize("option", ["--vmc", "--live-link-face"])
@pytest.mark.parametrize("address", ["nowhere:port", ":39539", "host:0", "host:70000"])
def test_no_address(capsys: Captured, address: str, option: str) -> None:
    assert main(["live", AUDIO, option, address]) == 2
    assert "HOST:PORT" in capsys.readouterr().err


def test_a_microphone_or_a_file(capsys: Captured) -> None:
    assert main(["live"]) == 2
    assert "--microphone" in capsys.readouterr().err
