"""The examples of docs/authoring.md, run in order in a copy of the checkout, give the printed results."""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "authoring.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"```(\S+)(?: (\S+))?\n(.*?)```", PAGE, flags=re.DOTALL)

FOLLOW = """
import contextlib, io, json, sys
from pathlib import Path
from understudy.cli.main import main
for line in sys.stdin:
    step = json.loads(line)
    if "file" in step:
        Path(step["file"]).write_text(step["text"], encoding="utf-8")
        continue
    out, err = io.TextIOWrapper(io.BytesIO(), encoding="utf-8"), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        main(step["command"])
    sys.stdout.write(json.dumps(out.buffer.getvalue().decode() + err.getvalue()) + "\\n")
"""
"""Writes files and runs commands one after another, in one process that has loaded what they need."""


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    for folder in ("app", "lexicon", "src"):
        shutil.copytree(ROOT / folder, tmp_path / folder, symlinks=True, ignore=shutil.ignore_patterns("__pycache__"))
    for folder in ("models", "examples"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    return tmp_path


def test_every_command_answers_what_the_page_says(copy: Path) -> None:
    steps: list[dict[str, object]] = []
    expected: list[tuple[str, list[str]]] = []
    for kind, file, text in EXAMPLES:
        if kind == "console":
            told = [(command, lines) for command, *lines in map(str.splitlines, text.split("$ ")[1:])]
            expected += told
            steps += [{"command": shlex.split(command)[1:]} for command, _ in told]
        else:
            steps.append({"file": file, "text": text})
    run = subprocess.run(
        [sys.executable, "-c", FOLLOW],
        cwd=copy,
        env={**os.environ, "PYTHONPATH": str(copy / "src")},
        input="".join(json.dumps(step) + "\n" for step in steps),
        text=True,
        capture_output=True,
        check=True,
    )
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    assert len(answers) == len(expected) > 8
    for answer, (command, lines) in zip(answers, expected, strict=True):
        said = " ".join(answer.split())
        assert [line for line in lines if " ".join(line.split()) not in said] == [], f"{command}\n{answer}"


def test_every_example_is_run() -> None:
    assert PAGE.count("```") == 2 * len(EXAMPLES)
    assert {kind for kind, *_ in EXAMPLES} == {"yaml", "rules", "gesture", "console"}
