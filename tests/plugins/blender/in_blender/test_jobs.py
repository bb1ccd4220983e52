"""Work in a thread, as the modal operators have it: its stages, its end, its errors, and that it can be cancelled."""

import importlib
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.plugins.blender.in_blender.conftest import ADDON


@pytest.fixture
def jobs(extension: Path) -> Any:
    assert extension.exists()
    return importlib.import_module(f"{ADDON}.interface.jobs")


def ended(job: Any) -> Any:
    for _try in range(500):
        if not job.running:
            return job
        time.sleep(0.01)
    raise TimeoutError


def test_stages_are_told_while_it_works(jobs: Any) -> None:
    told, go_on = threading.Event(), threading.Event()

    def work(progress: Callable[[str], None], _cancelled: Callable[[], bool]) -> str:
        progress("align")
        told.set()
        go_on.wait(5)
        return "done"

    job = jobs.Job(work)
    job.start()
    told.wait(5)
    assert (job.stage, job.running, job.result) == ("align", True, None)
    assert 0 < job.done < 1
    go_on.set()
    assert ended(job).result == "done"


def test_what_goes_wrong_is_kept_for_the_person(jobs: Any) -> None:
    def work(_progress: Callable[[str], None], _cancelled: Callable[[], bool]) -> None:
        raise ValueError("there are no words")

    job = jobs.Job(work)
    job.start()
    assert str(ended(job).error) == "there are no words"


def test_what_is_cancelled_is_told_to_end(jobs: Any) -> None:
    def work(_progress: Callable[[str], None], cancelled: Callable[[], bool]) -> str:
        while not cancelled():
            time.sleep(0.01)
        return "ended"

    job = jobs.Job(work)
    job.start()
    job.cancel()
    assert ended(job).result == "ended"


def test_without_windows_what_is_invoked_works_at_once(blender: Any, mannequin: Any, line: Any) -> None:
    assert line.text
    assert blender.ops.understudy.perform("INVOKE_DEFAULT") == {"FINISHED"}
    assert mannequin.animation_data.nla_tracks
    assert not blender.context.window_manager.understudy.running
