"""A file is the old one or the new one, and nothing is left beside it."""

from pathlib import Path

import pytest

from understudy.files import replace_file


def test_a_file_is_replaced_and_keeps_its_mode(tmp_path: Path) -> None:
    target = tmp_path / "a.bml"
    target.write_bytes(b"old")
    target.chmod(0o600)
    replace_file(target, b"new")
    assert (target.read_bytes(), target.stat().st_mode & 0o777) == (b"new", 0o600)
    assert list(tmp_path.iterdir()) == [target]


def test_what_cannot_be_put_in_place_leaves_nothing_behind(tmp_path: Path) -> None:
    folder = tmp_path / "a.bml"
    folder.mkdir()
    with pytest.raises(OSError, match=r"a\.bml"):
        replace_file(folder, b"new", unfinished=tmp_path / "unfinished")
    assert list(tmp_path.iterdir()) == [folder]
