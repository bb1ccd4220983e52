"""`understudy studio` serves the page and the line that it was given, on this machine alone."""

import json
import re
import subprocess
import sys
import urllib.request
from os import environ
from pathlib import Path

import psutil
import pytest

from tests.support.python_page import ROOT
from understudy.cli.main import main

WORDS = "lexicon/en/thanks.yaml"
TWO_WORKERS = {"UNDERSTUDY_WORKERS": "2"}
PATIENCE_S = 60.0


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


def test_rules_are_saved_in_a_folder_that_is_there(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["studio", "--rules", "nowhere", "--no-browser"]) == 2
    assert "nowhere: no such folder" in capsys.readouterr().err


def test_it_serves_the_page_and_the_line_saves_rules_where_it_may_and_leaves_nothing_behind(tmp_path: Path) -> None:
    """Even where it is killed while none of its processes can be told so."""
    words = tmp_path / "words.txt"
    words.write_text("No, never.\n", encoding="utf-8")
    line = [str(ROOT / "examples/example.flac"), "--text-file", str(words), "--rules", str(tmp_path)]
    command = [sys.executable, "-m", "understudy.cli", "studio", *line, "--no-browser"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env=environ | TWO_WORKERS) as process:
        try:
            assert process.stderr
            told = next(line for line in process.stderr if "the studio is at" in line)
            address = re.search(r"(http://127\.0\.0\.1:\d+)/\?line=opened", told)
            assert address
            _require_served(address[1], tmp_path)
            family = psutil.Process(process.pid).children(recursive=True)
            assert len(family) >= 3
            for aligner in [each for each in family if "decoder_worker" in " ".join(each.cmdline())]:
                aligner.suspend()
        finally:
            process.kill()
    _gone, alive = psutil.wait_procs(family, PATIENCE_S)
    assert alive == []


def _require_served(address: str, folder: Path) -> None:
    """Raises AssertionError where the page, the line or what it saves in a folder is another."""
    assert b"Understudy studio" in _content(f"{address}/")
    assert json.loads(_content(f"{address}/opened/line")) == {"name": "example.flac", "text": "No, never."}
    assert _content(f"{address}/opened/audio").startswith(b"fLaC")
    saved = urllib.request.Request(f"{address}/rules/files/{WORDS}", b"class: thanks\n", method="PUT")
    assert json.loads(_content(saved))["saved"]
    assert (folder / WORDS).read_text(encoding="utf-8") == "class: thanks\n"


def _content(url: str | urllib.request.Request) -> bytes:
    with urllib.request.urlopen(url) as answer:
        content: bytes = answer.read()
    return content
