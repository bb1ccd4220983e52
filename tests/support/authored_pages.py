"""Runs the examples of pages for authors: files that are written, and commands with a part of their output."""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

FOLLOW = """
import contextlib, functools, io, json, sys
from pathlib import Path
from understudy.cli.main import main
from understudy.syntax import parser
parser.load_pipeline = functools.cache(parser.load_pipeline)
before = {}
for line in sys.stdin:
    step = json.loads(line)
    if step.get("begins"):
        for path, content in before.items():
            path.unlink() if content is None else path.write_bytes(content)
        before.clear()
        continue
    if "file" in step:
        path = Path(step["file"])
        before.setdefault(path, path.read_bytes() if path.exists() else None)
        path.write_text(step["text"], encoding="utf-8")
        continue
    out, err = io.TextIOWrapper(io.BytesIO(), encoding="utf-8"), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        main(step["command"])
    sys.stdout.write(json.dumps(out.buffer.getvalue().decode() + err.getvalue()) + "\\n")
"""
"""Writes files and runs commands one after another, in one process that has loaded what they need; where a page begins,
files are as they were before those of the last."""


def examples_of(page: Path) -> list[tuple[str, str, str]]:
    """The kind, the file if it is one, and the text of each example."""
    return re.findall(r"```(\S+)(?: (\S+))?\n(.*?)```", page.read_text(encoding="utf-8"), flags=re.DOTALL)


def failed_commands(pages: Mapping[Path, int], folder: Path) -> list[str]:
    """The commands, of which each page has so many at least, whose output lacks a line of its page; in a copy of the
    checkout in `folder`."""
    steps: list[dict[str, object]] = []
    expected: list[tuple[str, list[str]]] = []
    for page, at_least in pages.items():
        of_page, told = _steps(page)
        assert len(told) >= at_least
        steps += [{"begins": page.name}, *of_page]
        expected += told
    answers = _answers(_copy(folder), steps)
    failed = []
    for answer, (command, lines) in zip(answers, expected, strict=True):
        said = " ".join(answer.split())
        if any(" ".join(line.split()) not in said for line in lines):
            failed.append(f"{command}\n{answer}")
    return failed


def _steps(page: Path) -> tuple[list[dict[str, object]], list[tuple[str, list[str]]]]:
    """What to write and to run, and what each command should say; an example that names no file is only shown."""
    steps: list[dict[str, object]] = []
    expected: list[tuple[str, list[str]]] = []
    for kind, file, text in examples_of(page):
        if kind == "console":
            told = [(command, lines) for command, *lines in map(str.splitlines, text.split("$ ")[1:])]
            expected += told
            steps += [{"command": shlex.split(command)[1:]} for command, _ in told]
        elif file:
            steps.append({"file": file, "text": text})
    return steps, expected


def _answers(copy: Path, steps: list[dict[str, object]]) -> list[str]:
    run = subprocess.run(
        [sys.executable, "-c", FOLLOW],
        cwd=copy,
        env={**os.environ, "PYTHONPATH": str(copy / "src")},
        input="".join(json.dumps(step) + "\n" for step in steps),
        text=True,
        capture_output=True,
        check=True,
    )
    return [json.loads(line) for line in run.stdout.splitlines()]


def _copy(folder: Path) -> Path:
    """With what Python has compiled, which would take longer than a page."""
    for part in ("app", "lexicon", "src"):
        shutil.copytree(ROOT / part, folder / part, symlinks=True)
    for part in ("models", "examples"):
        (folder / part).symlink_to(ROOT / part)
    return folder
