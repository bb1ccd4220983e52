"""A process is found with all that it started, whichever of its threads did."""

import subprocess
import sys

import psutil
import pytest

from understudy.api.workers.families import family_of

STARTS_FROM_A_THREAD = """
import subprocess, sys, threading
again = sys.argv[1:]
start = lambda: subprocess.Popen([sys.executable, "-c", again[0], *again[1:]] if again else ["sleep", "60"])
thread = threading.Thread(target=start)
thread.start()
thread.join()
print("started", flush=True)
sys.stdin.read()
"""


def test_all_generations_are_found_and_none_when_the_process_has_ended() -> None:
    command = [sys.executable, "-c", STARTS_FROM_A_THREAD, STARTS_FROM_A_THREAD]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert [process.stdout.readline() for _ in range(2)] == [b"started\n"] * 2
        whole = psutil.Process(process.pid)
        try:
            found = family_of(whole)
            assert found[0] == whole
            assert set(found[1:]) == set(whole.children(recursive=True))
            assert [each.name() for each in found[-1:]] == ["sleep"]
        finally:
            for each in family_of(whole):
                each.kill()
    with pytest.raises(psutil.NoSuchProcess):
        family_of(whole)
