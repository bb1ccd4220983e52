"""`lexicon/tags.yaml`, and mistakes in it."""

from pathlib import Path

import pytest

from understudy.errors import AuthoringError
from understudy.models import load_tag_table
from understudy.text.tag_table import TagTable

CLASSES = {"greeting": {"plain": 5.0}, "deixis": {"place": 2.0}}


def test_the_shipped_table_names_classes_that_there_are() -> None:
    assert list(load_tag_table().functions_of("performative", {"type": "Greet"})) == [("greeting", "plain")]


def test_theme_and_rheme_are_functions_whatever_their_attributes() -> None:
    table = load_tag_table()
    assert [table.function_named(tag) for tag in ("theme", "rheme", "emphasis")] == [
        ("information", "theme"),
        ("information", "rheme"),
        None,
    ]


def test_every_mistake_is_told_with_its_place(tmp_path: Path) -> None:
    file = tmp_path / "tags.yaml"
    file.write_text(
        "functions:\n  a:\n    b:\n      c: greetin\n      d: deixis.plac\nby_name:\n  e: deixi\n", encoding="utf-8"
    )
    with pytest.raises(AuthoringError) as wrong:
        TagTable.load(file, CLASSES)
    assert [(each.line, each.column) for each in wrong.value.mistakes] == [(4, 10), (5, 10), (7, 6)]
    assert "did you mean 'greeting'" in wrong.value.mistakes[0].message
