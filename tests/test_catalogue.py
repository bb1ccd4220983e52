"""What authors edit is listed with its place, and checked with every mistake."""

from pathlib import Path

import pytest

from app.catalogue import Catalogue, Kind, check_files, check_files_in_use
from app.errors import AuthoringError, InputError

ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue.load()


def test_every_item_is_where_it_says(catalogue: Catalogue) -> None:
    lines: dict[str, list[str]] = {}
    for item in catalogue.items:
        text = lines.setdefault(item.file, (ROOT / item.file).read_text(encoding="utf-8").splitlines())
        name = item.name.split()[0]
        assert name.lower() in text[item.line - 1].lower(), item


def test_every_kind_is_listed_and_rules_have_distinct_names(catalogue: Catalogue) -> None:
    assert {item.kind for item in catalogue.items} == set(Kind)
    rules = [item.name for item in catalogue.items if item.kind in (Kind.FUNCTION, Kind.BEHAVIOR)]
    assert len(rules) == len(set(rules))


def test_words_are_found_whatever_their_capitals_and_unknown_names_are_told(catalogue: Catalogue) -> None:
    assert {item.kind for item in catalogue.named("NEVER")} == {Kind.WORD}
    with pytest.raises(InputError) as caught:
        catalogue.named("nevr")
    assert "never" in caught.value.message


def test_what_is_in_use_has_no_mistake() -> None:
    check_files_in_use()
    assert check_files([ROOT / "app" / "rules", ROOT / "lexicon"]) > 20


GOOD_RULE = """rule fine
foreach
  fcn(negation, plain, $start, $end, $p)
choose
  weight 1
    small_shake($start, $end)
"""

WRONG = {
    "rule.rules": (GOOD_RULE.replace("$end)", "$stop)"), 6),
    "vocabulary_unknown.rules": (GOOD_RULE.replace("fcn(", "function("), 3),
    "words.yaml": ("class: negation\ngroups:\n  - {words: [no], meaning: plain, example: '{} way'}\n", 3),
    "unread.yaml": ("words: [no]\n", 1),
    "abbreviations.yaml": ("anywhere: {dr: doctor}\n", 1),
    "conflicts.yaml": ("within_class: []\nbetween: none\n", 2),
    "behaviors.yaml": ("behaviors: {}\ntimings: {}\nmore: 1\n", 3),
}


@pytest.mark.parametrize("name", sorted(WRONG))
def test_a_mistake_is_told_with_its_line(name: str, tmp_path: Path) -> None:
    content, line = WRONG[name]
    (tmp_path / name).write_text(content)
    with pytest.raises(AuthoringError) as caught:
        check_files([tmp_path / name])
    assert line in {mistake.line for mistake in caught.value.mistakes}
    assert {mistake.path for mistake in caught.value.mistakes} == {tmp_path / name}


def test_the_mistakes_of_all_files_come_at_once(tmp_path: Path) -> None:
    for name, (content, _) in WRONG.items():
        if name != "unread.yaml":
            (tmp_path / name).write_text(content)
    with pytest.raises(AuthoringError) as caught:
        check_files([tmp_path])
    assert {mistake.path.name for mistake in caught.value.mistakes} == WRONG.keys() - {"unread.yaml"}


def test_good_files_are_counted(tmp_path: Path) -> None:
    (tmp_path / "fine.rules").write_text(GOOD_RULE)
    (tmp_path / "words.yaml").write_text("class: negation\ngroups:\n  - {words: [nay], example: '{}, I say'}\n")
    assert check_files([tmp_path]) == 2


def test_a_character_is_checked_against_the_table_beside_it(tmp_path: Path) -> None:
    (tmp_path / "characters").mkdir()
    sheet = tmp_path / "characters" / "shy.yaml"
    sheet.write_text("description: shy\nbehaviors:\n  no_such_movement: {amount: 0.1}\n")
    with pytest.raises(InputError) as missing:
        check_files([sheet])
    assert missing.value.code == "no_behavior_table"
    (tmp_path / "behaviors.yaml").write_bytes((ROOT / "lexicon" / "behaviors.yaml").read_bytes())
    with pytest.raises(AuthoringError) as caught:
        check_files([sheet])
    assert {mistake.path for mistake in caught.value.mistakes} == {sheet}


@pytest.mark.parametrize("content", [None, b"caf\xe9"])
def test_files_that_cannot_be_read_are_told(content: bytes | None, tmp_path: Path) -> None:
    path = tmp_path / "some.rules"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(InputError) as caught:
        check_files([path])
    assert str(path) in caught.value.message
