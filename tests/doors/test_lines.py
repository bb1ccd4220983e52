"""Every recorded line performs, from the command line and over HTTP, and its BML is what realizers accept."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

from tests.support.bml.bml_checker import check
from tests.support.shared_data import SHARED_LINES, needs
from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.bml.writing.writer import write_bml
from understudy.cli.main import main
from understudy.model import Channel, Line, Performance
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.settings import Settings

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "example.flac"
LINES = [EXAMPLE, *sorted(SHARED_LINES.glob("*.flac"))]


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


@pytest.fixture(scope="module")
def performances(understudy: Understudy) -> dict[Path, Performance]:
    return {path: perform(understudy, _line(path), Options()) for path in LINES}


@pytest.mark.parametrize("path", LINES, ids=lambda path: path.stem)
def test_every_line_performs_and_its_bml_passes_the_checker(performances: dict[Path, Performance], path: Path) -> None:
    performance = performances[path]
    assert check(write_bml(performance)) == []
    gestures = [each for each in performance.behaviors if each.kept and each.kind is Channel.GESTURE]
    assert gestures
    assert all(each.rule for each in gestures)


def test_what_is_shown_is_mostly_for_a_function(performances: dict[Path, Performance]) -> None:
    """A line may show only what was read in its words, which needs no function."""
    named = [any(each.kept and each.function for each in one.behaviors) for one in performances.values()]
    assert sum(named) >= len(named) - 1


@pytest.mark.parametrize("path", LINES, ids=lambda path: path.stem)
def test_every_line_performs_from_the_command_line(
    performances: dict[Path, Performance], path: Path, tmp_path: Path
) -> None:
    target = tmp_path / "out.bml"
    words = ["--text-file", str(path.with_suffix(".txt"))]
    assert main(["--quiet", "perform", str(path), *words, "-o", str(target)]) == 0
    assert target.read_bytes() == write_bml(performances[path])


def test_the_command_line_in_another_process_gives_the_same_bytes(
    performances: dict[Path, Performance], tmp_path: Path
) -> None:
    """Whatever the hash seed: that of this process is another, or drawn at random."""
    path = LINES[-1]
    assert _perform_elsewhere(path, tmp_path, "2") == write_bml(performances[path])


def test_every_line_performs_over_http(nursery: Nursery, performances: dict[Path, Performance]) -> None:
    """As JSON, which has the BML in it; `tests/api/test_routes.py` shows that it is what XML alone is."""
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        for path, performance in performances.items():
            line = _line(path)
            files = {"audio": (path.name, path.read_bytes())}
            answer = client.post(
                "/perform", files=files, data={"text": line.text}, headers={"Accept": "application/json"}
            )
            assert answer.status_code == 200, answer.text
            assert answer.json()["bml"].encode() == write_bml(performance)


@needs(SHARED_LINES)
@pytest.mark.parametrize("path", LINES, ids=lambda path: path.stem)
def test_no_filler_is_heard_in_what_is_read(performances: dict[Path, Performance], path: Path) -> None:
    """In "And so, my fellow Americans" the drawn out vowel of "so" is all its own."""
    assert performances[path].utterance.fillers == ()
