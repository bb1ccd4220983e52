"""What is made on demand is made once."""

from threading import Barrier, Thread

import pytest

from understudy.loading import OnDemand


def test_it_is_made_when_first_asked_for_and_once_for_all_threads() -> None:
    made: list[object] = []
    together = Barrier(4)

    def make() -> object:
        made.append(object())
        return made[-1]

    value, got = OnDemand(make), []

    def ask() -> None:
        together.wait()
        got.append(value.get())

    assert made == []
    threads = [Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(made) == 1
    assert got == made * 4


def test_what_could_not_be_made_is_made_again() -> None:
    tries = iter([ValueError("not yet"), None])

    def make() -> str:
        problem = next(tries)
        if problem:
            raise problem
        return "made"

    value = OnDemand(make)
    with pytest.raises(ValueError, match="not yet"):
        value.get()
    assert value.get() == "made"
