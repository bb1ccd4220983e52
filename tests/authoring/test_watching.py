"""Saves of authored files are noticed once they are complete, however they are made."""

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from queue import Empty, Queue
from threading import Event, Thread
from time import monotonic, sleep

import pytest

from understudy.authoring.watching import QUIET_MS, saves

SOON_S = 60.0
"""No save is told later, however busy the machine."""

NEVER_S = 1.0
"""What is not told by then never is: five times as long as a save lasts."""

Told = Queue[str]
WHOLE = "x" * 30


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "words").mkdir()
    (tmp_path / "words" / "some.yaml").write_text("a: b")
    (tmp_path / "some.rules").write_text("")
    return tmp_path


@pytest.fixture
def watching() -> Iterator[Callable[[Path, Path], Told]]:
    """Follows the saves in a path, telling what the file `shown` holds at each."""
    stop = Event()
    threads: list[Thread] = []

    def follow(path: Path, shown: Path) -> Told:
        told: Told = Queue()

        def run(saved: Iterator[None]) -> None:
            for _ in saved:
                told.put(shown.read_text() if shown.exists() else "gone")

        threads.append(Thread(target=run, args=(saves([path], stop),)))
        threads[-1].start()
        return told

    yield follow
    stop.set()
    for thread in threads:
        thread.join(SOON_S)
        assert not thread.is_alive()


def _nothing_more(told: Told) -> bool:
    with pytest.raises(Empty):
        told.get(timeout=NEVER_S)
    return True


def _is_told(told: Told, content: str) -> bool:
    """Waits until that is told; a save that took long may be told in the middle, and then once more."""
    while told.get(timeout=SOON_S) != content:
        pass
    return True


def test_changed_new_and_removed_files_are_saves(folder: Path, watching: Callable[[Path, Path], Told]) -> None:
    new = folder / "words" / "new.rules"
    told = watching(folder, new)
    (folder / "words" / "some.yaml").write_text("a: longer")
    assert _is_told(told, "gone")
    new.write_text("# new")
    assert _is_told(told, "# new")
    new.unlink()
    assert _is_told(told, "gone")


def test_a_file_that_another_takes_the_place_of_is_saved(folder: Path, watching: Callable[[Path, Path], Told]) -> None:
    words = folder / "words" / "some.yaml"
    told = watching(words, words)
    for text in ("a: second", "a: third"):
        beside = folder / "words" / ".some.yaml.swap"
        beside.write_text(text)
        os.replace(beside, words)
        assert _is_told(told, text)


def test_other_files_are_none(folder: Path, watching: Callable[[Path, Path], Told]) -> None:
    told = watching(folder / "words" / "some.yaml", folder / "some.rules")
    (folder / "words" / "notes.txt").write_text("x")
    (folder / "words" / "other.yaml").write_text("x: y")
    assert _nothing_more(told)


def test_nothing_is_told_of_what_is_not_there(folder: Path) -> None:
    assert list(saves([folder / "nowhere" / "some.yaml"])) == []


def test_a_file_is_told_when_it_is_whole(folder: Path, watching: Callable[[Path, Path], Told]) -> None:
    words = folder / "words" / "some.yaml"
    told = watching(folder, words)
    while not _was_quick(lambda: _write_in_steps(words)):
        sleep(NEVER_S)
        told.queue.clear()
    assert told.get(timeout=SOON_S) == WHOLE


def _write_in_steps(file: Path) -> None:
    for size in (10, 20, len(WHOLE)):
        file.write_text(WHOLE[:size])
        sleep(QUIET_MS / 1000 / 10)


def _was_quick(work: Callable[[], None]) -> bool:
    """Whether the machine was not so busy that the steps were saves of their own."""
    began_s = monotonic()
    work()
    return monotonic() - began_s < QUIET_MS / 1000
