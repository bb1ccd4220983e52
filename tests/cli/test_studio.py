"""`understudy studio` serves the page and the line that it was given, on this machine alone."""

import json
import re
import subprocess
import sys
import urllib.request
from pathlib import Path

import pytest

from tests.support.python_page import ROOT
from understudy.cli.main import main


def test_words_without_a_recording_are_the_users_mistake(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["studio", "--text", "No."]) == 2
    assert "give AUDIO, too" in capsys.readouterr().err


def test_a_recording_that_cannot_be_read_is_told_before_loading(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["studio", "nothing.wav", "--no-browser"]) == 2
    assert "nothing.wav: cannot be read" in capsys.readouterr().err


def test_a_scene_is_opened_alone(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert main(["studio", "line.wav", "--scene", str(tmp_path)]) == 2
    assert "open one of them" in capsys.readouterr().err
    assert main(["studio", "--scene", str(tmp_path)]) == 2
    assert "give the folder that understudy batch wrote to" in capsys.readouterr().err


def test_it_serves_the_page_and_the_line(tmp_path: Path) -> None:
    words = tmp_path / "words.txt"
    words.write_text("No, never.\n", encoding="utf-8")
    line = [str(ROOT / "examples/example.flac"), "--text-file", str(words)]
    command = [sys.executable, "-m", "understudy.cli", "studio", *line, "--no-browser"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        try:
            assert process.stderr
            told = next(line for line in process.stderr if "the studio is at" in line)
            address = re.search(r"(http://127\.0\.0\.1:\d+)/\?line=opened", told)
            assert address
            assert b"Understudy studio" in _content(f"{address[1]}/")
            assert json.loads(_content(f"{address[1]}/opened/line")) == {"name": "example.flac", "text": "No, never."}
            assert _content(f"{address[1]}/opened/audio").startswith(b"fLaC")
        finally:
            process.terminate()


def _content(url: str) -> bytes:
    with urllib.request.urlopen(url) as answer:
        content: bytes = answer.read()
    return content
