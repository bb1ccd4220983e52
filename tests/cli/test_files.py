"""Files are replaced completely, keep their mode, and stay unchanged when they cannot be written."""

import os
import stat
from pathlib import Path

import pytest

from understudy.cli.files import require_writable, write
from understudy.errors import InputError


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o664, 0o755])
def test_a_file_that_is_replaced_keeps_its_mode(tmp_path: Path, mode: int) -> None:
    target = tmp_path / "a.bml"
    target.write_bytes(b"old")
    target.chmod(mode)
    write(str(target), b"new")
    assert (target.read_bytes(), stat.S_IMODE(target.stat().st_mode)) == (b"new", mode)
    assert os.listdir(tmp_path) == ["a.bml"]


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "a.bml").write_bytes(b"old")
    (tmp_path / "link.bml").symlink_to("a.bml")
    write(str(tmp_path / "link.bml"), b"new")
    assert (tmp_path / "link.bml").is_symlink()
    assert (tmp_path / "a.bml").read_bytes() == b"new"


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write to everything")
def test_a_protected_file_is_not_replaced(tmp_path: Path) -> None:
    target = tmp_path / "a.bml"
    target.touch(mode=0o444)
    with pytest.raises(InputError) as caught:
        require_writable(str(target), field="output")
    assert caught.value.code == "file_unwritable"
