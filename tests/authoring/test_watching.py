"""Saves of authored files are noticed once they are whole, whatever way they are saved."""

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from understudy.authoring.watching import saves


def looks(*between: Callable[[], object]) -> Callable[[], bool]:
    """Waits that do something instead; the last one ends."""
    waiting: Iterator[Callable[[], object]] = iter(between)

    def wait() -> bool:
        for do in waiting:
            do()
            return True
        return False

    return wait


def nothing() -> None:
    """Nobody saves."""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "words").mkdir()
    (tmp_path / "words" / "some.yaml").write_text("a: b")
    (tmp_path / "some.rules").write_text("")
    return tmp_path


def test_changed_new_and_removed_files_are_saves(folder: Path) -> None:
    words, new = folder / "words" / "some.yaml", folder / "new.rules"
    for save in (
        lambda: words.write_text("a: longer"),
        lambda: os.utime(words, ns=(1, 1)),
        lambda: new.write_text("# new"),
        new.unlink,
    ):
        assert len(list(saves([folder], looks(nothing, save, nothing, nothing)))) == 1
    assert len(list(saves([words], looks(lambda: words.write_text(""), nothing)))) == 1


def test_other_files_and_no_change_are_none(folder: Path) -> None:
    assert list(saves([folder], looks(lambda: (folder / "notes.txt").write_text("x"), nothing, nothing))) == []
    assert list(saves([folder / "nowhere"], looks(nothing))) == []


def test_a_file_is_told_when_it_is_whole(folder: Path) -> None:
    words = folder / "words" / "some.yaml"
    writing = [lambda text="x" * size: words.write_text(text) for size in (10, 20, 30)]
    found = saves([folder], looks(*writing, nothing, lambda: words.write_text("again"), nothing, nothing))
    assert [words.read_text() for _ in found] == ["x" * 30, "again"]
