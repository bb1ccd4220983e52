"""Reading and saving an author's files."""

from pathlib import Path

import pytest

from tests.authoring.test_rule_edits import WORDS, text_of
from understudy.authored_folders import laid_over
from understudy.authoring.saved_files import LEXICON_FILES, RULE_FILES, read_text, saved_names, write_text
from understudy.errors import ChangedError, ForbiddenError, InputError


def test_what_is_saved_is_read_instead_of_what_is_in_use(tmp_path: Path) -> None:
    assert read_text(RULE_FILES, WORDS, tmp_path).text == text_of(WORDS)
    write_text(RULE_FILES, WORDS, "class: thanks\n", tmp_path)
    found = read_text(RULE_FILES, WORDS, tmp_path)
    assert (found.text, found.saved) == ("class: thanks\n", True)
    assert saved_names(RULE_FILES, tmp_path) == (WORDS,)
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == ["thanks.yaml"]


def test_without_a_folder_nothing_is_written_or_saved() -> None:
    with pytest.raises(ForbiddenError) as caught:
        write_text(RULE_FILES, WORDS, "", None)
    assert caught.value.code == "rules_read_only"
    assert saved_names(RULE_FILES, None) == ()


@pytest.mark.parametrize(
    "name", ["../outside.rules", "app/rules/new.rules", "lexicon/characters/stern.yaml", "lexicon/en/../../x.yaml"]
)
def test_no_file_is_written_that_is_not_there(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputError) as caught:
        write_text(RULE_FILES, name, "", tmp_path / "inside")
    assert caught.value.code == "unknown_file"
    assert list(tmp_path.rglob("*")) == []


def test_what_was_saved_and_cannot_be_read_is_told(tmp_path: Path) -> None:
    (tmp_path / WORDS).parent.mkdir(parents=True)
    (tmp_path / WORDS).write_bytes(b"class: \xff")
    with pytest.raises(InputError) as caught:
        read_text(RULE_FILES, WORDS, tmp_path)
    assert caught.value.code == "rules_unreadable"
    assert "byte 7" in caught.value.message


def test_a_folder_in_the_place_of_a_file_is_left_as_it_is(tmp_path: Path) -> None:
    (tmp_path / WORDS).mkdir(parents=True)
    assert not read_text(RULE_FILES, WORDS, tmp_path).saved
    with pytest.raises(ForbiddenError) as caught:
        write_text(RULE_FILES, WORDS, "class: thanks\n", tmp_path)
    assert caught.value.code == "rules_read_only"
    assert list((tmp_path / WORDS).parent.iterdir()) == [tmp_path / WORDS]


def test_a_file_that_changed_since_it_was_read_is_not_replaced(tmp_path: Path) -> None:
    first = read_text(RULE_FILES, WORDS, tmp_path)
    second = write_text(RULE_FILES, WORDS, "class: thanks\n", tmp_path, version=first.version)
    with pytest.raises(ChangedError) as caught:
        write_text(RULE_FILES, WORDS, "class: apology\n", tmp_path, version=first.version)
    assert caught.value.code == "file_changed"
    assert read_text(RULE_FILES, WORDS, tmp_path) == second


@pytest.mark.parametrize("name", ["gestures/own.gesture", "characters/own.yaml", "lexicon/profiles/own.yaml"])
def test_new_files_of_the_lexicon_have_their_shorter_names_too(tmp_path: Path, name: str) -> None:
    assert write_text(LEXICON_FILES, name, "# mine\n", tmp_path).saved
    full = f"lexicon/{name.removeprefix('lexicon/')}"
    assert saved_names(LEXICON_FILES, tmp_path) == (full,)
    assert (tmp_path / full).read_text(encoding="utf-8") == "# mine\n"


def test_a_file_in_the_authors_folder_is_saved_where_it_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UNDERSTUDY_CACHE", str(tmp_path / "cache"))
    own = tmp_path / "own" / "characters" / "stern.yaml"
    own.parent.mkdir(parents=True)
    own.write_text("description: Stern.\n", encoding="utf-8")
    with laid_over([tmp_path / "own"]):
        write_text(LEXICON_FILES, "characters/stern.yaml", "description: Sterner.\n", tmp_path / "own")
    assert own.read_text(encoding="utf-8") == "description: Sterner.\n"
    assert list((tmp_path / "own").rglob("*.*")) == [own]
