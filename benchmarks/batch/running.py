"""Runs the command `understudy batch` and watches it from outside: time, processor, memory, kills."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from dataclasses import dataclass
from pathlib import Path

SAMPLE_S = 0.25


@dataclass(frozen=True, slots=True)
class Run:
    """A run: how it ended, seconds on the clock from start to end, to the first line, and from there to the last,
    processor seconds of all its processes, and the most megabytes that a worker with its aligner had (proportional set
    size)."""

    code: int
    seconds: float
    first_s: float
    steady_s: float
    processor_s: float
    worker_mb: float
    lines: int


def command(script: Path, out: Path, workers: int, *options: str) -> list[str]:
    """The command for a script whose recordings are beside it."""
    named = [str(script), "--audio", str(script.parent / "audio"), "--out", str(out), "--workers", str(workers)]
    return [sys.executable, "-m", "understudy.cli", "batch", *named, "--json-log", *options]


def run(called: list[str]) -> Run:
    """Runs a command to its end."""
    start_s = time.perf_counter()
    process = subprocess.Popen(called, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    most = _Most(process.pid)
    assert process.stderr is not None
    times_s = [time.perf_counter() for line in process.stderr if json.loads(line)["event"] == "line"]
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    process.stderr.close()
    most.end()
    seconds = time.perf_counter() - start_s
    first_s, steady_s = (times_s[0] - start_s, times_s[-1] - times_s[0]) if times_s else (seconds, 0.0)
    processor_s = usage.ru_utime + usage.ru_stime
    return Run(process.returncode, seconds, first_s, steady_s, processor_s, most.megabytes, len(times_s))


def run_and_kill(called: list[str], after_s: float) -> bool:
    """Runs a command and kills it after some time; whether it was still running."""
    process = subprocess.Popen(called, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        process.wait(after_s)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGKILL)
        process.wait()
        return True
    return False


class _Most:
    """Samples the memory of a process's workers until it is ended."""

    def __init__(self, process: int) -> None:
        self.megabytes = 0.0
        self._process = process
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._sample)
        self._thread.start()

    def end(self) -> None:
        self._ended.set()
        self._thread.join()

    def _sample(self) -> None:
        while not self._ended.wait(SAMPLE_S):
            for worker in _children(self._process):
                parts = [worker, *_children(worker)]
                self.megabytes = max(self.megabytes, sum(_megabytes(part) for part in parts))


def _children(process: int) -> list[int]:
    try:
        tasks = Path(f"/proc/{process}/task").iterdir()
        return [int(child) for task in tasks for child in (task / "children").read_text().split()]
    except OSError:
        return []


def _megabytes(process: int) -> float:
    """What is shared counts by halves, thirds, …"""
    try:
        rows = Path(f"/proc/{process}/smaps_rollup").read_text().splitlines()
    except OSError:
        return 0.0
    return sum(int(row.split()[1]) for row in rows if row.startswith("Pss:")) / 1024
