"""Files are replaced completely, keep their mode, and stay unchanged when they cannot be written."""

import os
import stat
from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path

import pytest

from understudy.cli.files import InputFile, OutputName, require_distinct, require_writable, write
from understudy.cli.main import main
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


EXAMPLES = Path(__file__).parents[2] / "examples"
LINE = ("perform", "a.flac", "--text", "No.")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A recording, a hard link to it and a symbolic link, and words in time."""
    (tmp_path / "a.flac").write_bytes((EXAMPLES / "example.flac").read_bytes())
    os.link(tmp_path / "a.flac", tmp_path / "hard.bml")
    (tmp_path / "soft.bml").symlink_to("a.flac")
    (tmp_path / "dangling.bml").symlink_to("later.bml")
    (tmp_path / "inner").mkdir()
    (tmp_path / "inner" / "report.csv").write_text("id,text\na,No.\n")
    (tmp_path / "soft.csv").symlink_to("inner/report.csv")
    (tmp_path / "w.json").write_text("{}")
    (tmp_path / "in.bml").write_text("<bml/>")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    "argv",
    [
        (*LINE, "-o", "a.flac"),
        (*LINE, "-o", "inner/../a.flac"),
        (*LINE, "-o", "hard.bml"),
        (*LINE, "-o", "soft.bml"),
        (*LINE, "--words", "w.json", "--trace", "w.json"),
        (*LINE, "--reference", "a.flac", "w.json", "--trace", "./w.json"),
        (*LINE, "-o", "new.bml", "--trace", "./new.bml"),
        (*LINE, "-o", "dangling.bml", "--trace", "later.bml"),
        (*LINE, "-o", "new.bml", "--listener", "bob", "--trace", "new.bob.bml"),
        (*LINE, "-o", "a.bml", "--realize", "m.json", "--trace", "m.json"),
        (*LINE, "--trace", "-"),
        ("realize", "in.bml", "-o", "m.bvh", "-o", "inner/../m.bvh"),
        ("realize", "in.bml", "--avatar", "a.glb", "-o", "a.glb"),
        ("analyze", *LINE[1:], "--plot", "a.flac"),
        ("reference", "a.flac", "-o", "hard.bml"),
        ("batch", "inner/report.csv", "--audio", ".", "--out", "inner"),
        ("batch", "soft.csv", "--audio", ".", "--out", "inner"),
    ],
    ids=" ".join,
)
def test_it_is_refused_and_nothing_changes(
    argv: Sequence[str], folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}
    assert main(argv) == 2
    [told] = capsys.readouterr().err.splitlines()
    assert "is the same file as" in told
    assert {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()} == before


def test_several_inputs_may_be_one_file_and_devices_may_be_named_often(folder: Path) -> None:
    inputs = [InputFile(folder / "a.flac"), InputFile(folder / "hard.bml")]
    outputs = [OutputName(os.devnull), OutputName(os.devnull), OutputName(folder / "a.bml")]
    require_distinct(Namespace(audio=inputs, realize=outputs, fps=30, words=None))


def test_names_made_of_others_are_outputs_too(folder: Path) -> None:
    arguments = Namespace(output=OutputName(folder / "a.bml"))
    require_distinct(arguments, [OutputName(folder / "b.bml")])
    with pytest.raises(InputError) as caught:
        require_distinct(arguments, [OutputName(folder / "inner" / ".." / "a.bml")])
    assert caught.value.code == "files_same"
