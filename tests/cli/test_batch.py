"""`understudy batch` as its users call it: exit codes, messages, and continuing after a kill."""

import csv
import json
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import psutil
import pytest

from understudy.batch.planning import BatchRequest
from understudy.batch.whole_run import Nobody, run_batch
from understudy.cli.main import main
from understudy.models import Understudy
from understudy.settings import Settings

from ..support.batches import ThisProcess

AUDIO = Path(__file__).parents[1] / "audio"
TEXT = (AUDIO / "figure8.txt").read_text(encoding="utf-8").strip()
LINES = [f"l{number}" for number in range(5)]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "audio").mkdir()
    for name in LINES:
        shutil.copy(AUDIO / "figure8.flac", tmp_path / "audio" / f"{name}.flac")
    write(tmp_path, *([name, TEXT] for name in LINES))
    return tmp_path


def write(folder: Path, *rows: list[str]) -> None:
    with (folder / "lines.csv").open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([["id", "text"], *rows])


def call(folder: Path, *options: str) -> list[str]:
    return [
        "batch",
        str(folder / "lines.csv"),
        "--audio",
        str(folder / "audio"),
        "--out",
        str(folder / "out"),
        *options,
    ]


def content(folder: Path) -> dict[str, bytes]:
    files = [path for path in (folder / "out").rglob("*") if path.is_file()]
    return {path.name: path.read_bytes() for path in files if path.name not in {"manifest.sqlite", ".lock"}}


def test_a_dry_run_tells_what_is_missing_and_does_nothing(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write(folder, ["l1", TEXT], ["l02", TEXT], ["x", ""])
    assert main(call(folder, "--dry-run")) == 1
    told = capsys.readouterr().out
    assert "row 4, column B (text)" in told
    assert "l02, row 3: no recording; did you mean 'l2'?" in told
    assert "l2.flac: did you mean l02?" in told
    assert "1 lines with recordings" in told
    assert not (folder / "out").exists()
    write(folder, ["l1", TEXT])
    assert main(call(folder, "--dry-run")) == 0


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--format", "blm"], "did you mean 'bml'"),
        (["--layout", "x.{ext}"], "layout"),
        (["--workers", "0"], "workers"),
        (["--column", "txt=Words"], "did you mean 'text'"),
        (["--character", "nobody"], "nobody"),
        (["--service", "http://127.0.0.1:9"], "understudy serve"),
        (["--service", "http://127.0.0.1:9", "--format", "glb"], "glb"),
    ],
)
def test_what_cannot_be_begun_is_one_line_and_2(
    options: list[str], told: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*call(folder, *options), "--quiet"]) == 2
    err = capsys.readouterr().err
    assert told in err
    assert len(err.splitlines()) == 1


def test_killed_and_called_again_it_ends_with_the_bytes_of_an_undisturbed_run(
    folder: Path, understudy: Understudy
) -> None:
    command = [sys.executable, "-m", "understudy.cli", *call(folder, "--workers", "1", "--json-log")]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    assert process.stderr is not None
    told = (json.loads(line) for line in process.stderr)
    first = next(event for event in told if event["event"] == "line")
    os.kill(process.pid, signal.SIGSTOP)
    workers = psutil.Process(process.pid).children(recursive=True)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    process.stderr.close()
    assert first["state"] == "done"
    _gone, alive = psutil.wait_procs(workers, 120)  # they end when they see that their parent is gone
    assert alive == []

    request = BatchRequest(folder / "lines.csv", folder / "audio", folder / "out")
    again = ThisProcess(understudy)
    run_batch(request, Settings(), lambda: again, Nobody())
    assert first["id"] not in again.performed
    assert 0 < len(again.performed) < len(LINES)
    found = content(folder)
    shutil.rmtree(folder / "out")
    run_batch(request, Settings(), lambda: ThisProcess(understudy), Nobody())
    assert content(folder) == found
    assert len(found) == len(LINES) + 3
