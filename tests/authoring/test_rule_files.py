"""Reading and saving an author's files of rules."""

from pathlib import Path

import pytest

from tests.authoring.test_rule_edits import WORDS, text_of
from understudy.authoring.rule_files import read_rule_text, saved_names, write_rule_text
from understudy.errors import ForbiddenError, InputError


def test_what_is_saved_is_read_instead_of_what_is_in_use(tmp_path: Path) -> None:
    assert read_rule_text(WORDS, tmp_path).text == text_of(WORDS)
    write_rule_text(WORDS, "class: thanks\n", tmp_path)
    found = read_rule_text(WORDS, tmp_path)
    assert (found.text, found.saved) == ("class: thanks\n", True)
    assert saved_names(tmp_path) == (WORDS,)
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == ["thanks.yaml"]


def test_without_a_folder_nothing_is_written_or_saved() -> None:
    with pytest.raises(ForbiddenError) as caught:
        write_rule_text(WORDS, "", None)
    assert caught.value.code == "rules_read_only"
    assert saved_names(None) == ()


@pytest.mark.parametrize("name", ["../outside.rules", "app/rules/new.rules", "lexicon/en/../../x.yaml"])
def test_no_file_is_written_that_is_not_there(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputError) as caught:
        write_rule_text(name, "", tmp_path / "inside")
    assert caught.value.code == "unknown_file"
    assert list(tmp_path.rglob("*")) == []


def test_what_was_saved_and_cannot_be_read_is_told(tmp_path: Path) -> None:
    (tmp_path / WORDS).parent.mkdir(parents=True)
    (tmp_path / WORDS).write_bytes(b"class: \xff")
    with pytest.raises(InputError) as caught:
        read_rule_text(WORDS, tmp_path)
    assert caught.value.code == "rules_unreadable"
    assert "byte 7" in caught.value.message


def test_a_folder_in_the_place_of_a_file_is_left_as_it_is(tmp_path: Path) -> None:
    (tmp_path / WORDS).mkdir(parents=True)
    assert not read_rule_text(WORDS, tmp_path).saved
    with pytest.raises(ForbiddenError) as caught:
        write_rule_text(WORDS, "class: thanks\n", tmp_path)
    assert caught.value.code == "rules_read_only"
    assert list((tmp_path / WORDS).parent.iterdir()) == [tmp_path / WORDS]
