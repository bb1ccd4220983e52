"""Workers that die: only the call during which they died is lost; and none outlives the process that started it."""

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import Future, wait
from contextlib import closing
from pathlib import Path

import pytest

from understudy.batch.running.engine import WORKER_DIED, supervise
from understudy.batch.running.local import Processes
from understudy.errors import InputError

KILLER = 13
PATIENCE_S = 120.0
"""What is not over by then never is, however busy the machine."""


def square(number: int) -> int:
    if number == KILLER:
        os.kill(os.getpid(), signal.SIGKILL)
    return number * number


def refuse(_number: int) -> int:
    raise InputError("text_empty", "no words", field="text")


def test_a_killing_job_fails_alone_and_all_others_are_done() -> None:
    with closing(Processes(2)) as processes:
        done = list(supervise(range(200), lambda number: processes.call(square, number), places=2))
    assert sorted(each.job for each in done) == list(range(200))
    assert [(each.job, each.failure) for each in done if each.failure] == [(KILLER, WORKER_DIED)]
    assert all(each.result == each.job**2 for each in done if each.job != KILLER)


def test_an_error_crosses_from_the_worker_whole() -> None:
    with closing(Processes(1)) as processes, pytest.raises(InputError) as raised:
        processes.call(refuse, 1).result()
    assert (raised.value.code, raised.value.message, raised.value.field) == ("text_empty", "no words", "text")


def test_closing_ends_what_is_under_way() -> None:
    processes = Processes(1)
    processes.call(square, 2).result()
    sleeping: Future[None] = processes.call(time.sleep, 600.0)
    processes.close()
    assert wait([sleeping], timeout=PATIENCE_S).done == {sleeping}


def test_workers_end_with_a_killed_parent(tmp_path: Path) -> None:
    told = tmp_path / "pid"
    script = tmp_path / "parent.py"
    script.write_text(
        "import os, time\n"
        "from understudy.batch.running.local import Processes\n"
        "if __name__ == '__main__':\n"
        "    processes = Processes(1)\n"
        f"    open({str(told)!r}, 'w').write(str(processes.call(os.getpid).result()))\n"
        "    processes.call(time.sleep, 600.0)\n"
        "    os.kill(os.getpid(), 9)\n"
    )
    subprocess.run([sys.executable, str(script)], check=False, timeout=PATIENCE_S)
    worker = int(told.read_text())
    deadline_s = time.monotonic() + PATIENCE_S
    while time.monotonic() < deadline_s and _lives(worker):
        time.sleep(0.05)
    assert not _lives(worker)


def _lives(process: int) -> bool:
    """A zombie that nobody waited for does not."""
    try:
        return "\nState:\tZ" not in Path(f"/proc/{process}/status").read_text()
    except FileNotFoundError:
        return False
