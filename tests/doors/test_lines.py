"""Every recorded line performs, from the command line and over HTTP, and its BML is what realizers accept."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from tests.conftest import SHARED_LINES
from tests.support.bml_checker import check
from understudy.api.application import create_app
from understudy.cli.main import main
from understudy.performance import Line, Options, Understudy, perform, write_bml
from understudy.settings import Settings

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "example.flac"
LINES = [EXAMPLE, *sorted(SHARED_LINES.glob("*.flac"))]

needs_shared = pytest.mark.skipif(not SHARED_LINES.is_dir(), reason="needs the lines of ../shared/data/speech")


def _line(path: Path) -> Line:
    return Line(path.read_bytes(), path.with_suffix(".txt").read_text(encoding="utf-8"))


def _perform_elsewhere(path: Path, folder: Path, hash_seed: str) -> bytes:
    """The BML of a fresh process of the command line, with a hash seed of its own."""
    target = folder / f"{path.stem}.{hash_seed}.bml"
    command = [sys.executable, "-m", "understudy.cli", "--quiet", "perform", str(path)]
    subprocess.run(
        [*command, "--text-file", str(path.with_suffix(".txt")), "-o", str(target)],
        check=True,
        env={**os.environ, "PYTHONHASHSEED": hash_seed},
    )
    return target.read_bytes()


@pytest.mark.parametrize("path", LINES, ids=lambda path: path.stem)
def test_every_line_performs_and_its_bml_passes_the_checker(understudy: Understudy, path: Path) -> None:
    performance = perform(understudy, _line(path), Options())
    assert check(write_bml(performance)) == []
    assert [behavior for behavior in performance.behaviors if behavior.kept and behavior.function]


@pytest.mark.parametrize("path", LINES, ids=lambda path: path.stem)
def test_every_line_performs_from_the_command_line(understudy: Understudy, path: Path, tmp_path: Path) -> None:
    target = tmp_path / "out.bml"
    words = ["--text-file", str(path.with_suffix(".txt"))]
    assert main(["--quiet", "perform", str(path), *words, "-o", str(target)]) == 0
    assert target.read_bytes() == write_bml(perform(understudy, _line(path), Options()))


@needs_shared
def test_the_command_line_in_other_processes_gives_the_same_bytes(understudy: Understudy, tmp_path: Path) -> None:
    path = LINES[-1]
    here = write_bml(perform(understudy, _line(path), Options()))
    assert _perform_elsewhere(path, tmp_path, "1") == here
    assert _perform_elsewhere(path, tmp_path, "2") == here


@needs_shared
def test_every_line_performs_over_http(understudy: Understudy) -> None:
    with TestClient(create_app(Settings())) as client:
        for path in LINES:
            line = _line(path)
            files = {"audio": (path.name, line.audio)}
            xml = client.post("/perform", files=files, data={"text": line.text})
            assert xml.status_code == 200, xml.text
            assert xml.content == write_bml(perform(understudy, line, Options()))
            answer = client.post(
                "/perform", files=files, data={"text": line.text}, headers={"Accept": "application/json"}
            )
            assert json.loads(answer.content)["bml"].encode() == xml.content


@needs_shared
@pytest.mark.parametrize("path", LINES, ids=lambda path: path.stem)
def test_no_filler_is_heard_in_what_is_read(path: Path, understudy: Understudy) -> None:
    """In "And so, my fellow Americans" the drawn out vowel of "so" is all its own."""
    assert perform(understudy, _line(path), Options()).utterance.fillers == ()
