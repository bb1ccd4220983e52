"""The local install, by commands that stand in for one: what is told of errors, and that work is ended."""

import os
from pathlib import Path

import pytest

from plugins.blender.performing.local_install import LocalInstall
from plugins.blender.performing.requests import CancelledError, Line, PerformingError, Remark, Sheet


def command(folder: Path, script: str) -> LocalInstall:
    path = folder / "understudy"
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)
    return LocalInstall(str(path))


def ignored(_stage: str) -> None:
    """Nobody watches."""


def never() -> bool:
    return False


def test_a_line_is_asked_for_by_the_options_of_the_command_line(tmp_path: Path) -> None:
    writes = 'echo "$@" > ' + str(tmp_path / "asked") + '; shift 5; echo "<bml/>" > "$1"; echo "{}" > "$3"'
    events = r"""echo '{"event": "stage", "stage": "align"}' >&2
echo '{"event": "warning", "code": "x", "message": "warning: a guess"}' >&2"""
    options = {"seed": 3, "lead_in_s": 0.5, "listener": [], "targets": {"door": (1.0, 1.5, 2.0)}, "character": "formal"}
    stages: list[str] = []
    line = Line(Path("line.wav"), "No.", options, {"behaviors": []})
    performed = command(tmp_path, f"{writes}\n{events}").perform(line, stages.append, never)
    asked = (tmp_path / "asked").read_text()
    assert "--seed 3 --lead-in 0.5 --target door=1,1.5,2 --character formal --json-log" in asked
    assert "--edits" in asked
    assert (performed.bml, stages, performed.warnings) == (b"<bml/>\n", ["align"], (Remark("x", "a guess"),))


def test_an_error_is_told_in_understudys_words(tmp_path: Path) -> None:
    error = (
        r"""echo '{"event": "error", "code": "empty", "field": null, "message": "there are no words"}' >&2; exit 2"""
    )
    with pytest.raises(PerformingError, match=r"^there are no words$"):
        command(tmp_path, error).realize(Sheet(b"<bml/>"), ignored, never)


def test_a_command_that_fails_without_a_word_is_told_by_its_code(tmp_path: Path) -> None:
    with pytest.raises(PerformingError, match="ended with code 3"):
        command(tmp_path, "exit 3").mannequin("default")


def test_a_command_that_is_not_there_is_named() -> None:
    with pytest.raises(PerformingError, match="/nowhere/understudy cannot be run"):
        LocalInstall("/nowhere/understudy").mannequin("default")


def test_what_is_cancelled_is_ended(tmp_path: Path) -> None:
    process = tmp_path / "process"
    slow = command(tmp_path, f"echo $$ > {process}; exec sleep 60")
    with pytest.raises(CancelledError):
        slow.realize(Sheet(b"<bml/>"), ignored, lambda: process.exists() and process.read_text().endswith("\n"))
    with pytest.raises(ProcessLookupError):
        os.kill(int(process.read_text()), 0)
