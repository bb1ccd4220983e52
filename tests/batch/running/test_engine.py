"""The supervisor's handling of jobs that end, fail, or lose their worker."""

from collections import Counter
from concurrent.futures import Future, ThreadPoolExecutor

import pytest

from understudy.batch.running.engine import WorkerDiedError, supervise
from understudy.errors import InputError, ServiceError, UnderstudyError


def test_jobs_are_taken_as_places_become_free() -> None:
    taken: list[int] = []
    under_way: list[int] = []

    def jobs() -> "list[int]":
        return list(range(20))

    with ThreadPoolExecutor(3) as threads:

        def submit(number: int) -> "Future[int]":
            taken.append(number)
            future = threads.submit(lambda: number)
            under_way.append(sum(not each.done() for each in futures))
            futures.append(future)
            return future

        futures: list[Future[int]] = []
        done = list(supervise(jobs(), submit, places=3))
    assert taken == list(range(20))
    assert max(under_way) < 3
    assert sorted(each.result or 0 for each in done) == taken


@pytest.mark.parametrize("error", [WorkerDiedError("gone"), ServiceError("aligner_crashed", "gone")])
def test_a_suspect_is_tried_again_alone_when_all_others_are_done(error: Exception) -> None:
    tries: list[str] = []

    def submit(name: str) -> "Future[str]":
        tries.append(name)
        future: Future[str] = Future()
        if name == "weak" and Counter(tries)["weak"] == 1:
            future.set_exception(error)
        else:
            future.set_result(name)
        return future

    done = list(supervise(["weak", "a", "b", "c"], submit, places=2))
    assert tries[-1] == "weak"
    assert Counter(tries)["weak"] == 2
    assert {each.result for each in done} == {"weak", "a", "b", "c"}
    assert not any(each.failure for each in done)


@pytest.mark.parametrize(
    ("error", "code", "tried"),
    [
        (InputError("text_empty", "no words"), "text_empty", 1),
        (ServiceError("aligner_crashed", "gone"), "aligner_crashed", 2),
        (WorkerDiedError("gone"), "worker_died", 2),
        (ValueError("a fault of ours"), "internal", 1),
    ],
)
def test_why_there_is_no_result(error: UnderstudyError | ValueError, code: str, tried: int) -> None:
    tries = 0

    def submit(_job: str) -> "Future[str]":
        nonlocal tries
        tries += 1
        future: Future[str] = Future()
        future.set_exception(error)
        return future

    (done,) = supervise(["x"], submit, places=1)
    assert done.failure is not None
    assert (done.failure.code, tries) == (code, tried)
