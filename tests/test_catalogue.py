"""What authors edit is listed with its place."""

from pathlib import Path

import pytest

from app.catalogue import Catalogue, Kind
from app.errors import InputError

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
